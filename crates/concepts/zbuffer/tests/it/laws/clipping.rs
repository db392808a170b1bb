//! What is cut off, and that no crack opens.

use geometry::Triangle;
use glam::{DVec2, DVec3, I64Vec2, Vec3, Vec4, vec3};
use proptest::prelude::*;
use testkit::{Law, ensure, ensure_close, strategy};
use transforms::{Camera, Pipeline, ViewVolume, viewport::window_point};
use zbuffer::clip::GUARD_BAND;
use zbuffer::{ScreenTriangle, ScreenVertex, project, project_clip};

use super::{HEIGHT, WIDTH, coverage, triangulation};

/// Corners in clip space: about the volume, far from it, or any bits at all.
fn clip_corner() -> impl Strategy<Value = Vec4> + Clone {
    use proptest::num::f32::ANY;
    let near_by = (-3.0_f32..3.0, -3.0_f32..3.0, -2.0_f32..2.0, -2.0_f32..1.0)
        .prop_map(|(x, y, z, w)| Vec4::new(x, y, z, w));
    let far_out = (near_by.clone(), 0..60).prop_map(|(p, k)| p * 2.0_f32.powi(k));
    let any = (ANY, ANY, ANY, ANY).prop_map(|(x, y, z, w)| Vec4::new(x, y, z, w));
    let at_infinity = (-3.0_f32..3.0, -3.0_f32..3.0).prop_map(|(x, y)| Vec4::new(x, y, 0.0, 0.0));
    prop_oneof![8 => near_by, 4 => far_out, 2 => any, 1 => at_infinity, 1 => Just(Vec4::ZERO)]
}

#[test]
fn only_sound_vertices_leave() {
    Law::new("projected vertices are finite, near enough and in range, whatever goes in")
        .cases(20_000)
        .demand("something is left", 0.2)
        .demand("something was cut", 0.1)
        .demand("a corner is not finite", 0.001)
        .holds_for([clip_corner(), clip_corner(), clip_corner()], |corners, seen| {
            let polygon = project_clip(corners.map(|c| c.as_dvec4()), WIDTH, HEIGHT);
            let count = polygon.vertices().len();
            seen.class("something is left", count > 0);
            seen.class("something was cut", count > 3);
            seen.class("a corner is not finite", !corners.iter().all(|c| c.is_finite()));
            let sound = |v: &ScreenVertex| {
                let weights = v.weights.to_vec3();
                v.position.truncate().abs().max_element() <= GUARD_BAND
                    && v.position.z.abs() <= 1.0
                    && v.inv_w < 0.0
                    && v.inv_w.is_finite()
                    && weights.min_element() >= 0.0
                    // Each cut rounds a weighted mean in 64 bits; that vanishes in the rounding to 32.
                    && (weights.element_sum() - 1.0).abs() <= 2.0 * f32::EPSILON
            };
            ensure(count == 0 || count >= 3, || format!("{count} vertices"))?;
            ensure(polygon.vertices().iter().all(sound), || format!("{polygon:?}"))?;
            // Nor does the rasterizer refuse them.
            coverage(polygon.triangles());
            Ok(())
        });
}

#[test]
fn a_triangle_inside_the_volume_goes_where_the_pipeline_says() {
    let camera = strategy::camera();
    Law::new("without clipping, vertices are those of the pipeline").demand("uncut", 0.2).holds_for(
        (camera, strategy::view_volume(), strategy::triangle(1.0), 0.2_f32..0.8),
        |(camera, volume, shape, depth), seen| {
            // The shape is put somewhere between the planes.
            let middle = vec3(0.3, 0.2, volume.near + depth * (volume.far - volume.near));
            let corners =
                shape.corners().map(|p| camera.world_from_camera().transform_point3(0.3 * p + middle));
            let triangle = Triangle::new(corners[0], corners[1], corners[2]);
            let view = Pipeline::new(camera, volume, WIDTH, HEIGHT).expect("a valid volume");
            let polygon = project(&view.clip_from_world(), WIDTH, HEIGHT, &triangle);
            let inside = corners
                .map(|p| view.trace(p))
                .iter()
                .all(|t| t.canonical.is_some_and(|p| p.z.abs() < 0.99) && t.clip.w < 0.0);
            seen.class("uncut", inside);
            if !inside {
                return Ok(());
            }
            for (vertex, p_world) in polygon.vertices().iter().zip(corners) {
                let traced = view.trace(p_world);
                // The product of the two matrices rounds otherwise than one after the other: some twenty roundings of
                // numbers as large as the world's coordinates (20) times the matrix, against w.
                let size = 20.0
                    * view.clip_from_world().to_cols_array().iter().fold(0.0, |m: f32, x| m.max(x.abs()));
                let bound = 20.0 * f32::EPSILON * size / traced.clip.w.abs()
                    * WIDTH as f32
                    * (1.0 + traced.canonical.unwrap_or_default().length());
                ensure_close(
                    "position",
                    vertex.position.as_vec3(),
                    traced.screen.expect("w is not 0"),
                    bound,
                )?;
            }
            Ok(())
        },
    );
}

#[test]
fn a_shared_edge_is_cut_at_the_same_points_from_both_sides() {
    let corner = || {
        let extent = prop_oneof![Just(1.0_f32), Just(1e3), Just(1e7)];
        // Anywhere, before the near plane (z < w), or beyond the far one (z > −w).
        let side = prop_oneof![Just(None), Just(Some(1.0_f32)), Just(Some(-1.0))];
        ((-3.0_f32..3.0, -3.0_f32..3.0, 0.0_f32..2.0, -2.0_f32..0.5), extent, side).prop_map(
            |((x, y, z, w), far, side)| Vec4::new(far * x, y, side.map_or(z - 1.0, |side| side * (w - z)), w),
        )
    };
    Law::new(
        "two triangles get bitwise the same vertices on their common edge, whichever way they run along it",
    )
    .cases(5000)
    .demand("the edge is cut", 0.3)
    .demand("the edge is cut twice", 0.1)
    .holds_for([corner(), corner(), corner(), corner()], |[p, q, r, s], seen| {
        // Vertices without a share of the third corner lie on the edge.
        let on_edge = |corners: [Vec4; 3], third: usize| {
            let polygon = project_clip(corners.map(|c| c.as_dvec4()), WIDTH, HEIGHT);
            let mut bits: Vec<_> = polygon
                .vertices()
                .iter()
                .filter(|v| v.weights.to_vec3()[third] == 0.0)
                .map(|v| (v.position.to_array().map(f64::to_bits), v.inv_w.to_bits()))
                .collect();
            bits.sort_unstable();
            bits.dedup();
            bits
        };
        let one = on_edge([p, q, r], 2);
        let ends = [p, q].map(|end| project_clip([end.as_dvec4(); 3], WIDTH, HEIGHT).vertices().len());
        seen.class("the edge is cut", !one.is_empty() && ends.contains(&0));
        seen.class("the edge is cut twice", !one.is_empty() && ends == [0, 0]);
        for (corners, third) in [([q, p, s], 2), ([p, s, q], 1), ([s, q, p], 0), ([r, p, q], 0)] {
            let other = on_edge(corners, third);
            ensure(one == other, || format!("{one:?}\n{other:?}"))?;
        }
        Ok(())
    });
}

/// A square of a plane that passes near a camera at the origin looking along −z.
#[derive(Clone, Copy, Debug)]
struct Ground {
    origin: DVec3,
    right: DVec3,
    up: DVec3,
    half: f64,
}

impl Ground {
    /// The square's coordinates, −1 to 1, where the ray through the screen point (x, y) meets the volume's part of the
    /// plane.
    fn seen_through(&self, volume: &ViewVolume, x: f32, y: f32) -> Option<DVec2> {
        let window = window_point(volume, WIDTH, HEIGHT, glam::vec2(x, y));
        let s = window.extend(volume.near).as_dvec3();
        let n = self.right.cross(self.up);
        let t = n.dot(self.origin) / n.dot(s);
        let offset = t * s - self.origin;
        let inside = 1.0 < t && t < f64::from(volume.far / volume.near);
        inside.then(|| DVec2::new(offset.dot(self.right), offset.dot(self.up)) / self.half)
    }

    fn point(&self, p: DVec2) -> Vec3 {
        (self.origin + self.half * (p.x * self.right + p.y * self.up)).as_vec3()
    }
}

fn ground() -> impl Strategy<Value = Ground> {
    let half = prop_oneof![2.0_f64..50.0, 1e3..1e5];
    (strategy::unit_vector(), 0.5_f32..30.0, -0.7_f32..0.7, half).prop_map(|(normal, depth, slope, half)| {
        let (right, up) = normal.any_orthonormal_pair();
        let origin = vec3(slope * depth, -0.3 * depth, -depth).as_dvec3();
        Ground { origin, right: right.as_dvec3(), up: up.as_dvec3(), half }
    })
}

#[test]
fn no_crack_and_no_overlap_in_a_clipped_triangulation() {
    const GRID: i64 = 1 << 12;
    let volume = ViewVolume { left: -1.1, right: 0.9, bottom: -0.7, top: 0.8, near: -0.5, far: -60.0 };
    let camera = Camera::look_at(Vec3::ZERO, vec3(0.0, 0.0, -1.0), Vec3::Y).expect("a fixed camera");
    let view = Pipeline::new(camera, volume, WIDTH, HEIGHT).expect("a valid volume");
    let point = (-GRID..=GRID, -GRID..=GRID).prop_map(|(x, y)| I64Vec2::new(x, y));
    Law::new(
        "a triangulated plane through the eye's surroundings covers each sample on it once, and none twice",
    )
    .cases(2000)
    .demand("a triangle crosses the near plane", 0.3)
    .demand("an uncut vertex would lie beyond the guard band", 0.1)
    .demand("samples well inside", 0.4)
    .demand("no sliver turned over", 0.7)
    .holds_for((ground(), proptest::collection::vec(point, 1..16)), |(ground, points), seen| {
        let corners: Vec<[Vec3; 3]> = triangulation(I64Vec2::splat(-GRID), I64Vec2::splat(GRID), &points)
            .into_iter()
            .map(|t| t.map(|p| ground.point(p.as_dvec2() / GRID as f64)))
            .collect();
        let polygons = || {
            corners
                .iter()
                .map(|[a, b, c]| project(&view.clip_from_world(), WIDTH, HEIGHT, &Triangle::new(*a, *b, *c)))
        };
        // Snapping may turn a sliver thinner than 1/256 pixel over, so that it lies on its neighbours. Counted with
        // the sign of its orientation, each sample is covered once all the same: there is never a hole.
        let eye_side = -ground.right.cross(ground.up).dot(ground.origin);
        let upright = |t: &ScreenTriangle| (t.doubled_area() > 0) == (eye_side > 0.0);
        let (turned, upright): (Vec<_>, Vec<_>) = polygons()
            .flat_map(|polygon| polygon.triangles())
            .filter(|t| t.doubled_area() != 0)
            .partition(|t| !upright(t));
        seen.class("no sliver turned over", turned.is_empty());
        let (turned, upright) = (coverage(turned), coverage(upright));
        let crosses =
            |t: &[Vec3; 3]| t.iter().any(|p| p.z > volume.near) && t.iter().any(|p| p.z < volume.near);
        seen.class("a triangle crosses the near plane", corners.iter().any(crosses));
        let at_guard = |v: &ScreenVertex| v.position.truncate().abs().max_element() > 0.99 * GUARD_BAND;
        seen.class(
            "an uncut vertex would lie beyond the guard band",
            polygons().any(|p| p.vertices().iter().any(at_guard)),
        );
        let mut well_inside = 0;
        for j in 0..HEIGHT {
            for i in 0..WIDTH {
                // If the square covers all of a pixel and more, it covers its centre: it is convex on the screen.
                let around = [(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)];
                let inside = around.iter().all(|(dx, dy)| {
                    let hit = ground.seen_through(&volume, i as f32 + dx, j as f32 + dy);
                    hit.is_some_and(|p| p.abs().max_element() < 0.999)
                });
                well_inside += u32::from(inside);
                let k = (j * WIDTH + i) as usize;
                let count = i64::from(upright[k]) - i64::from(turned[k]);
                ensure(count.abs() <= 1, || format!("({i}, {j}) is drawn {count} times"))?;
                ensure(count == 1 || !inside, || format!("a hole at ({i}, {j})"))?;
            }
        }
        seen.class("samples well inside", well_inside > 20);
        Ok(())
    });
}
