//! Which triangles are on the screen? All of the world's, in drawing order, a few thousand at a time.

use std::ops::Range;

use glam::{DVec4, Vec3};
use rayon::prelude::*;
use transforms::Pipeline;
use zbuffer::{ScreenTriangle, project_clip};

use crate::{Object, World};

/// How many triangles are projected before they are drawn: enough work for many cores, and few megabytes however large
/// the world is.
const AT_ONCE: usize = 1 << 16;

/// How many triangles one task projects: a tenth of a millisecond's work.
const IN_A_BATCH: usize = 1 << 10;

/// How many vertices one task transforms at least.
const VERTICES_IN_A_TASK: usize = 1 << 12;

/// What clipping left of a triangle of an object, or a part of it.
pub(crate) struct Projected {
    pub(crate) object: usize,
    pub(crate) triangle: usize,
    pub(crate) on_screen: ScreenTriangle,
    /// Its pixels lie in these rows j, if it has any.
    pub(crate) rows: Range<u32>,
}

/// Triangles that stand side by side in a mesh, and therefore mostly on the screen too.
pub(crate) struct Batch {
    pub(crate) triangles: Vec<Projected>,
    /// The rows that any of them reaches.
    pub(crate) rows: Range<u32>,
}

/// Calls `draw` with all triangles that are on the screen, in drawing order. Each vertex is transformed once.
pub(crate) fn in_batches(world: &World, pipeline: &Pipeline, mut draw: impl FnMut(&[Batch])) {
    let mut pending = Vec::new();
    let mut count = 0;
    for (index, object) in world.objects.iter().enumerate() {
        let corners_clip = clip_from_object(object, pipeline);
        for (k, triangles) in object.mesh.triangles().chunks(AT_ONCE).enumerate() {
            let batch = |(m, triangles): (usize, &[[u32; 3]])| {
                let first = k * AT_ONCE + m * IN_A_BATCH;
                Batch::new(index, first, triangles, &corners_clip, pipeline)
            };
            pending.par_extend(triangles.par_chunks(IN_A_BATCH).enumerate().map(batch));
            count += triangles.len();
            if AT_ONCE <= count {
                draw(&pending);
                pending.clear();
                count = 0;
            }
        }
    }
    draw(&pending);
}

/// Each position of the mesh in clip space: through the world, as one triangle alone would go.
fn clip_from_object(object: &Object, pipeline: &Pipeline) -> Vec<DVec4> {
    let clip_from_world = pipeline.clip_from_world().as_dmat4();
    let positions = object.mesh.positions().par_iter().with_min_len(VERTICES_IN_A_TASK);
    let p_world = |p: &Vec3| object.world_from_object.transform_point3(*p);
    positions.map(|p| clip_from_world * p_world(p).as_dvec3().extend(1.0)).collect()
}

impl Batch {
    fn new(
        object: usize,
        first: usize,
        triangles: &[[u32; 3]],
        corners_clip: &[DVec4],
        pipeline: &Pipeline,
    ) -> Self {
        let (width, height) = (pipeline.width(), pipeline.height());
        // No rows yet: the start moves down and the end moves up with each triangle.
        let no_rows = Range { start: u32::MAX, end: 0 };
        let mut batch = Self { triangles: Vec::with_capacity(triangles.len()), rows: no_rows };
        for (triangle, corners) in (first..).zip(triangles) {
            let corners = corners.map(|index| corners_clip[index as usize]);
            for on_screen in project_clip(corners, width, height).triangles() {
                let Some(rows) = rows_of(&on_screen, width, height) else {
                    continue;
                };
                batch.rows = batch.rows.start.min(rows.start)..batch.rows.end.max(rows.end);
                batch.triangles.push(Projected { object, triangle, on_screen, rows });
            }
        }
        batch
    }
}

/// The rows that a triangle can have pixels in, or a few more; `None` if it has no pixel for certain.
fn rows_of(triangle: &ScreenTriangle, width: u32, height: u32) -> Option<Range<u32>> {
    let [a, b, c] = triangle.vertices.map(|v| v.position.truncate());
    // Snapping moves a vertex by less than a pixel.
    let (least, greatest) = (a.min(b).min(c) - 1.0, a.max(b).max(c) + 1.0);
    let is_beside =
        greatest.x < 0.0 || f64::from(width) <= least.x || greatest.y < 0.0 || f64::from(height) <= least.y;
    // `as` turns negative numbers into 0.
    let rows = least.y as u32..(greatest.y as u32 + 1).min(height);
    (!is_beside && triangle.doubled_area() != 0).then_some(rows)
}

/// Whether two ranges of rows have a row in common.
pub(crate) fn overlap(a: &Range<u32>, b: &Range<u32>) -> bool {
    a.start.max(b.start) < a.end.min(b.end)
}
