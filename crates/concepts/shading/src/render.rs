//! How does the same picture come out faster? First find what each pixel shows, then colour only that.

use canvas::Rgb;
use rayon::prelude::*;
use transforms::Pipeline;
use zbuffer::depth_buffer::DepthBand;
use zbuffer::{DepthBuffer, DepthFormat, Fragment, painter};

use crate::projected::{Batch, Projected, in_batches, overlap};
use crate::{Facet, Frame, Lighting, Object, PainterReport, Shading, Surface, Visible, World};

/// How what is visible is found.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Visibility {
    /// By a depth buffer (L16) of this precision; the first drawn of two equally near surfaces stays.
    ZBuffer(DepthFormat),
    /// By drawing from back to front (L13), with polygons cut where no order exists (L14). Which of two equally near
    /// surfaces is seen is not determined by the order in the world.
    Painter,
}

impl Default for Visibility {
    fn default() -> Self {
        Self::ZBuffer(DepthFormat::F32)
    }
}

/// Draws the world. The same frame, bit for bit, as [`crate::render_plain`] if visibility is by z-buffer.
///
/// 1. Project all triangles, each shared vertex once.
/// 2. Find for each pixel which triangle is seen there, and where in it; bands of rows go to different threads.
/// 3. Compute the colours of what is seen, and of nothing else: what the slide's loop computes in vain (E16) is only
///    counted, in [`Frame::shaded`].
///
/// Each pixel sees the triangles in drawing order, so the result does not depend on the number of threads.
///
/// ```
/// use canvas::Rgb;
/// use geometry::shapes::icosphere;
/// use glam::{Mat4, Vec3, vec3};
/// use lighting::{Highlight, Light, Material};
/// use shading::{Object, Shading, Visibility, World, render};
/// use transforms::{Camera, Pipeline, ViewVolume};
///
/// let ball = icosphere(2)?;
/// let objects = [Object {
///     mesh: &ball,
///     world_from_object: Mat4::from_translation(vec3(0.5, 0.0, -1.0)),
///     materials: &[Material::new(vec3(0.7, 0.1, 0.05), 64.0)],
/// }];
/// let lights = [Light::Point { position: vec3(2.0, 4.0, 6.0), color: Rgb::ONE }];
/// let world = World { objects: &objects, lights: &lights, background: Rgb::ZERO, highlight: Highlight::Blinn };
/// let camera = Camera::look_at(vec3(0.0, 0.0, 4.0), Vec3::ZERO, Vec3::Y)?;
/// let pipeline = Pipeline::new(camera, ViewVolume::from_fov_y(0.7, 1.5, -1.0, -9.0)?, 60, 40)?;
///
/// let frame = render(&world, &pipeline, Shading::Phong, Visibility::default());
/// assert_eq!(frame.visible_at(34, 19).unwrap().object, 0);
/// assert_eq!(frame.visible_at(2, 38), None);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Panics
/// If an object's matrix is not finite, or if the screen is too large for [`zbuffer::project`].
#[must_use]
pub fn render(world: &World, pipeline: &Pipeline, shading: Shading, visibility: Visibility) -> Frame {
    world.check();
    let mut frame = Frame::new(pipeline.width(), pipeline.height(), world.background);
    match visibility {
        Visibility::ZBuffer(format) => find_nearest(world, pipeline, format, &mut frame),
        Visibility::Painter => paint(world, pipeline, &mut frame),
    }
    color_what_is_visible(world, world.lighting(pipeline), shading, &mut frame);
    frame
}

/// How many pairs of polygons the painter's algorithm compares before it gives up: a few seconds' work.
pub const MOST_COMPARISONS: u64 = 30_000_000;

/// How many rows a thread draws at a time: few enough to share out evenly, enough that most small triangles lie in one band.
const ROWS_IN_A_BAND: u32 = 16;

/// Some rows of the frame, for one thread.
struct Band<'f> {
    depth: DepthBand<'f>,
    visible: &'f mut [Option<Visible>],
    shaded: &'f mut [u32],
}

/// Steps 1 and 2 by a depth buffer.
fn find_nearest(world: &World, pipeline: &Pipeline, format: DepthFormat, frame: &mut Frame) {
    let width = pipeline.width();
    let mut depth = DepthBuffer::new(width, pipeline.height(), format);
    let pixels = width as usize * ROWS_IN_A_BAND as usize;
    let parts = frame.visible.chunks_mut(pixels).zip(frame.shaded.chunks_mut(pixels));
    let bands = depth.bands_mut(ROWS_IN_A_BAND).zip(parts);
    let mut bands: Vec<_> = bands.map(|(depth, (visible, shaded))| Band { depth, visible, shaded }).collect();
    in_batches(world, pipeline, |batches| bands.par_iter_mut().for_each(|band| band.draw(batches, width)));
}

impl Band<'_> {
    fn draw(&mut self, batches: &[Batch], width: u32) {
        let rows = self.depth.rows();
        for batch in batches.iter().filter(|batch| overlap(&batch.rows, &rows)) {
            for triangle in batch.triangles.iter().filter(|triangle| overlap(&triangle.rows, &rows)) {
                zbuffer::rasterize_rows(&triangle.on_screen, width, rows.clone(), |fragment| {
                    self.test(triangle, &fragment);
                });
            }
        }
    }

    fn test(&mut self, triangle: &Projected, fragment: &Fragment) {
        let Fragment { i, j, z, .. } = *fragment;
        if self.depth.test_and_set(i, j, z) {
            let pixel = self.depth.index(i, j);
            self.visible[pixel] = Some(Visible::of_fragment((triangle.object, triangle.triangle), fragment));
            self.shaded[pixel] += 1;
        }
    }
}

/// Steps 1 and 2 by the painter's algorithm: what is drawn last is seen.
fn paint(world: &World, pipeline: &Pipeline, frame: &mut Frame) {
    let (mut names, mut triangles) = (Vec::new(), Vec::new());
    in_batches(world, pipeline, |batches| {
        for t in batches.iter().flat_map(|batch| &batch.triangles) {
            names.push((t.object, t.triangle));
            triangles.push(t.on_screen);
        }
    });
    let Some(plan) = painter::plan_within(&triangles, MOST_COMPARISONS) else {
        frame.painter = Some(PainterReport { gave_up: true, ..PainterReport::default() });
        return;
    };
    painter::for_each_fragment(&plan, &triangles, pipeline.width(), pipeline.height(), |k, fragment| {
        let pixel = frame.index(fragment.i, fragment.j);
        frame.visible[pixel] = Some(Visible::of_fragment(names[k], &fragment));
        frame.shaded[pixel] += 1;
    });
    let cycles = plan.cycles.iter().map(|cycle| cycle.polygons.iter().map(|k| names[*k]).collect()).collect();
    frame.painter = Some(PainterReport { cycles, splits: plan.splits, gave_up: false });
}

/// Step 3: colours and normals of what is visible, row by row.
fn color_what_is_visible(world: &World, lighting: Lighting, shading: Shading, frame: &mut Frame) {
    let width = frame.image.width() as usize;
    let rows = frame.image.pixels_mut().par_chunks_mut(width).zip(frame.visible.par_chunks_mut(width));
    rows.for_each(|(colors, row)| color_row(world.objects, lighting, shading, colors, row));
}

fn color_row(
    objects: &[Object],
    lighting: Lighting,
    shading: Shading,
    colors: &mut [Rgb],
    row: &mut [Option<Visible>],
) {
    // Neighbours mostly show the same triangle: what is computed once a triangle is kept until another one comes.
    let mut last = None;
    for (color, visible) in colors.iter_mut().zip(row) {
        let Some(visible) = visible else { continue };
        let name = (visible.object, visible.triangle);
        last.take_if(|(known, _)| *known != name);
        let (_, surface) = last.get_or_insert_with(|| {
            let facet = Facet::new(&objects[visible.object], visible.triangle, lighting.eye);
            (name, Surface::new(shading, facet, lighting))
        });
        visible.n_world = surface.normal(visible.weights);
        *color = surface.color(visible.weights);
    }
}
