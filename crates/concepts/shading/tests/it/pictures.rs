//! Laws of whole pictures: the fast renderer, threads, and the painter's algorithm.

use geometry::shapes::icosphere;
use glam::{Mat4, Vec3, vec3};
use lighting::{Highlight, Light};
use proptest::prelude::*;
use rayon::ThreadPoolBuilder;
use shading::{Frame, Object, Shading, Visibility, World, render, render_plain, with_vertex_normals};
use testkit::{Law, ensure};
use transforms::{Camera, Pipeline, ViewVolume};
use zbuffer::DepthFormat;
use zbuffer::painter::DEPTH_TOLERANCE;

use crate::model::model;

fn shading() -> impl Strategy<Value = Shading> {
    prop_oneof![Just(Shading::Flat), Just(Shading::Gouraud), Just(Shading::Phong)]
}

fn format() -> impl Strategy<Value = DepthFormat> {
    prop_oneof![Just(DepthFormat::F32), Just(DepthFormat::Bits24), Just(DepthFormat::Bits16)]
}

/// The bits of a picture, so that −0 is not 0.
fn bits(frame: &Frame) -> Vec<[u32; 3]> {
    frame.image.pixels().iter().map(|color| color.to_array().map(f32::to_bits)).collect()
}

#[test]
fn the_fast_renderer_gives_the_frame_of_the_plain_one_for_any_number_of_threads() {
    let pools = [1, 2, 5].map(|threads| ThreadPoolBuilder::new().num_threads(threads).build().unwrap());
    let law = Law::new("fast = plain, whatever the number of threads").cases(48);
    let law = law.demand("overdrawn", 0.5).demand("background", 0.3).demand("many colours", 0.5);
    law.holds_for((model(), shading(), format()), |(model, shading, format), seen| {
        let plain = model.show(|world| render_plain(world, &model.pipeline, shading, format));
        seen.class("overdrawn", plain.shaded.iter().any(|count| *count > 1));
        seen.class("background", plain.visible.iter().any(Option::is_none));
        let mut colors = bits(&plain);
        colors.sort_unstable();
        colors.dedup();
        seen.class("many colours", colors.len() > 8);
        for pool in &pools {
            let fast = model.show(|world| {
                pool.install(|| render(world, &model.pipeline, shading, Visibility::ZBuffer(format)))
            });
            ensure(bits(&fast) == bits(&plain), || "the pictures differ".to_owned())?;
            ensure(fast == plain, || "the records differ".to_owned())?;
        }
        Ok(())
    });
}

#[test]
fn the_painter_gives_the_same_frame_for_any_number_of_threads() {
    let pools = [1, 5].map(|threads| ThreadPoolBuilder::new().num_threads(threads).build().unwrap());
    Law::new("the painter does not count threads").cases(16).demand("polygons were cut", 0.3).holds_for(
        (model(), shading()),
        |(model, shading), seen| {
            let frames = pools.each_ref().map(|pool| {
                model.show(|world| {
                    pool.install(|| render(world, &model.pipeline, shading, Visibility::Painter))
                })
            });
            seen.class(
                "polygons were cut",
                frames[0].painter.as_ref().is_some_and(|report| report.splits > 0),
            );
            ensure(bits(&frames[0]) == bits(&frames[1]) && frames[0] == frames[1], || {
                "frames differ".to_owned()
            })
        },
    );
}

#[test]
fn painter_and_z_buffer_show_the_same_where_no_two_depths_are_equal() {
    let law = Law::new("painter = z-buffer but for equal depths").cases(64);
    let law = law.demand("overdrawn", 0.5).demand("polygons were cut", 0.2).demand("an order exists", 0.2);
    law.holds_for((model(), shading()), |(model, shading), seen| {
        let picture = |visibility| model.show(|world| render(world, &model.pipeline, shading, visibility));
        let (nearest, painted) = (picture(Visibility::default()), picture(Visibility::Painter));
        let report = painted.painter.as_ref().unwrap();
        seen.class("overdrawn", nearest.shaded.iter().any(|count| *count > 1));
        seen.class("polygons were cut", report.splits > 0);
        seen.class("an order exists", report.cycles.is_empty());
        let pixels =
            nearest.visible.iter().zip(&painted.visible).zip(bits(&nearest).into_iter().zip(bits(&painted)));
        for ((nearest, painted), (color, painted_color)) in pixels {
            match (nearest, painted) {
                (Some(nearest), Some(painted)) if nearest != painted => {
                    // The painter tells depths apart down to its tolerance; the records round them to f32.
                    let nearer = f64::from(nearest.z) - f64::from(painted.z);
                    let bound = DEPTH_TOLERANCE + f64::from(f32::EPSILON);
                    ensure(nearer.abs() <= bound, || {
                        format!("{nearest:?} is nearer than {painted:?} by {nearer}")
                    })?;
                }
                _ => ensure(nearest == painted && color == painted_color, || {
                    format!("{nearest:?}, {painted:?}")
                })?,
            }
        }
        Ok(())
    });
}

fn view(width: u32, height: u32) -> Pipeline {
    let camera = Camera::look_at(vec3(0.5, 1.0, 5.0), Vec3::ZERO, Vec3::Y).unwrap();
    let volume = ViewVolume::from_fov_y(0.5, width as f32 / height as f32, -1.0, -9.0).unwrap();
    Pipeline::new(camera, volume, width, height).unwrap()
}

#[test]
fn meshes_larger_than_a_batch_are_drawn_in_order_too() {
    // 2 · 81,920 triangles, more than are projected at a time. Both balls are the same: of equal depths the first stays.
    let ball = icosphere(6).unwrap();
    let object = Object { mesh: &ball, world_from_object: Mat4::IDENTITY, materials: &[] };
    let (lights, objects) = ([Light::Directional { to_light: Vec3::Z, color: Vec3::ONE }], [object; 2]);
    let world =
        World { objects: &objects, lights: &lights, background: Vec3::ZERO, highlight: Highlight::Blinn };
    let fast = render(&world, &view(70, 50), Shading::Flat, Visibility::default());
    assert_eq!(fast, render_plain(&world, &view(70, 50), Shading::Flat, DepthFormat::F32));
    assert!(fast.visible.iter().flatten().all(|visible| visible.object == 0));
}

/// The greatest angle between the normal that was used and the radius there, over all pixels of a ball without given
/// normals.
fn greatest_error(level: u32, shading: Shading) -> f32 {
    let ball = with_vertex_normals(icosphere(level).unwrap().without_normals(), std::f32::consts::PI);
    let objects = [Object { mesh: &ball, world_from_object: Mat4::IDENTITY, materials: &[] }];
    let world = World { objects: &objects, lights: &[], background: Vec3::ZERO, highlight: Highlight::Blinn };
    let frame = render(&world, &view(90, 90), shading, Visibility::default());
    let error = |visible: &shading::Visible| {
        visible.n_world.angle_between(ball.triangle(visible.triangle).point(visible.weights))
    };
    frame.visible.iter().flatten().map(error).fold(0.0, f32::max)
}

#[test]
fn the_normals_of_a_ball_get_better_with_each_level_and_interpolated_ones_are_better_throughout() {
    // A face is perpendicular to the axis of the circle around it: the error reaches the circle's angular radius at the
    // corners, and that halves with each level. The interpolated normal is off by what the vertex normals are.
    let flat: Vec<_> = (0..5).map(|level| greatest_error(level, Shading::Flat)).collect();
    let phong: Vec<_> = (0..5).map(|level| greatest_error(level, Shading::Phong)).collect();
    for level in 0..4 {
        assert!(flat[level + 1] < 0.7 * flat[level], "{flat:?}");
        assert!(phong[level] < 0.2 * flat[level], "{phong:?} {flat:?}");
    }
    // Around each vertex of the two coarsest balls the faces are mirror images: the normals are exact. On finer ones they
    // are not, and the error falls with the size of the faces.
    assert!(phong[0].max(phong[1]) < 1e-3, "{phong:?}"); // √(8 · 2⁻²³): an angle from a cosine off by four roundings
    assert!(phong[3] < 0.6 * phong[2] && phong[4] < 0.6 * phong[3], "{phong:?}");
}

#[test]
fn what_lies_behind_is_shaded_in_vain_by_the_slides_loop_only_if_it_comes_first() {
    // E16: three walls over all pixels. Drawn from front to back each pixel is shaded once, from back to front three times.
    let wall = geometry::Mesh::new(
        vec![vec3(-9.0, -9.0, 0.0), vec3(9.0, -9.0, 0.0), vec3(0.0, 12.0, 0.0)],
        vec![[0, 1, 2]],
    )
    .unwrap();
    let at = |z: f32| Object {
        mesh: &wall,
        world_from_object: Mat4::from_translation(z * Vec3::Z),
        materials: &[],
    };
    let shaded = |objects: &[Object]| {
        let world = World { objects, lights: &[], background: Vec3::ZERO, highlight: Highlight::Blinn };
        render(&world, &view(20, 20), Shading::Flat, Visibility::default()).shaded
    };
    assert!(shaded(&[at(0.5), at(0.0), at(-0.75)]).iter().all(|count| *count == 1));
    assert!(shaded(&[at(-0.75), at(0.0), at(0.5)]).iter().all(|count| *count == 3));
}
