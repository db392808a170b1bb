//! The fast picture is the slide's, but for rounding in the colours.

use canvas::{Image, Rgb};
use glam::Vec3;
use lighting::Material;
use proptest::prelude::*;
use rayon::ThreadPoolBuilder;
use shading::fast::{Faces, Renderer};
use shading::{Facet, Frame, Lighting, Shading, Visibility, Visible, World, fast, render};
use testkit::{Law, ensure};

use crate::model::model;

fn shading() -> impl Strategy<Value = Shading> {
    prop_oneof![Just(Shading::Flat), Just(Shading::Gouraud), Just(Shading::Phong)]
}

/// How far two colours may be apart that the same model gave: the cosine of a highlight is rounded some ten times on either way, each time
/// by at most 2⁻²⁴ of a number up to 2, together 2⁻¹⁹; to the power of p that is p times as much, and the power itself adds
/// 2⁻²¹. Two lights of up to 1, so twice that.
fn bound(material: &Material) -> f32 {
    (material.exponent + 2.0) * 2.0_f32.powi(-18)
}

/// Whether rounding may decide if a light is before or behind the surface: there the highlight jumps.
fn is_at_horizon(lighting: &Lighting, p_world: Vec3, n: Vec3) -> bool {
    let lights = lighting.lights.iter().filter_map(|light| light.illumination(p_world));
    lights.into_iter().any(|light| n.dot(light.to_light).abs() < 1e-5)
}

fn explained(
    world: &World,
    lighting: &Lighting,
    shading: Shading,
    visible: &Visible,
    ours: Rgb,
    theirs: Rgb,
) -> bool {
    let facet = Facet::new(&world.objects[visible.object], visible.triangle, lighting.eye);
    let horizon = match shading {
        Shading::Flat => false,
        Shading::Gouraud => {
            let corners = facet.corners.corners();
            (0..3).any(|k| is_at_horizon(lighting, corners[k], facet.corner_normals[k]))
        }
        Shading::Phong => is_at_horizon(lighting, facet.corners.point(visible.weights), visible.n_world),
    };
    ours.abs_diff_eq(theirs, bound(&facet.material)) || horizon
}

#[test]
fn every_pixel_has_the_slides_color_but_for_rounding() {
    Law::new("the fast picture is the slide's but for rounding")
        .cases(400)
        .demand("Gouraud", 0.2)
        .demand("an object is seen", 0.8)
        .demand("background", 0.3)
        .holds_for((model(), shading()), |(model, shading), seen| {
            model.show(|world| {
                let theirs: Frame = render(world, &model.pipeline, shading, Visibility::default());
                let ours = fast::render(world, &model.pipeline, shading);
                let lighting = world.lighting(&model.pipeline);
                seen.class("Gouraud", shading == Shading::Gouraud);
                seen.class("an object is seen", theirs.visible.iter().any(Option::is_some));
                seen.class("background", theirs.visible.iter().any(Option::is_none));
                let pixels = ours.pixels().iter().zip(theirs.image.pixels()).zip(&theirs.visible);
                for (k, ((ours, theirs), visible)) in pixels.enumerate() {
                    let fine = match visible {
                        None => ours == theirs,
                        Some(visible) => explained(world, &lighting, shading, visible, *ours, *theirs),
                    };
                    ensure(fine, || format!("{shading:?}, pixel {k}: {ours}, not {theirs}: {visible:?}"))?;
                }
                Ok(())
            })
        });
}

#[test]
fn the_number_of_threads_and_what_was_drawn_before_do_not_matter() {
    let pools = [1, 2, 5].map(|threads| ThreadPoolBuilder::new().num_threads(threads).build().unwrap());
    let mut renderer = std::sync::Mutex::new(Renderer::new());
    Law::new("the fast picture depends on the world alone")
        .cases(60)
        .demand("an object is seen", 0.8)
        .holds_for((model(), shading()), |(model, shading), seen| {
            model.show(|world| {
                let fresh = fast::render(world, &model.pipeline, shading);
                seen.class(
                    "an object is seen",
                    fresh.pixels().iter().any(|color| *color != world.background),
                );
                for pool in &pools {
                    let mut image = Image::new(45, 37, Rgb::new(7.0, 8.0, 9.0));
                    let renderer: &mut Renderer = &mut renderer.lock().unwrap();
                    pool.install(|| {
                        renderer.render_into(world, &model.pipeline, shading, Faces::Both, &mut image);
                    });
                    ensure(image == fresh, || "another picture".to_owned())?;
                }
                Ok(())
            })
        });
    renderer.get_mut().unwrap();
}

#[test]
fn on_closed_surfaces_fronts_alone_give_the_same_picture() {
    use geometry::shapes::{icosphere, torus};
    use glam::{Mat4, vec3};
    use lighting::{Highlight, Light};
    use shading::Object;
    use transforms::{Camera, Pipeline, ViewVolume};
    let meshes = [icosphere(3).unwrap(), torus(1.2, 0.4, 3).unwrap()];
    let mirrored = Mat4::from_scale(vec3(-1.0, 1.3, 0.8)) * Mat4::from_rotation_x(0.7);
    let materials = [Material::new(vec3(0.7, 0.3, 0.1), 40.0)];
    let objects: Vec<Object> = meshes
        .iter()
        .zip([Mat4::from_translation(vec3(0.2, 0.1, -0.3)), mirrored])
        .map(|(mesh, world_from_object)| Object { mesh, world_from_object, materials: &materials })
        .collect();
    let lights = [Light::Directional { to_light: vec3(0.6, 0.0, 0.8), color: Rgb::ONE }];
    let world =
        World { objects: &objects, lights: &lights, background: Rgb::ZERO, highlight: Highlight::Blinn };
    let camera = Camera::look_at(vec3(1.0, 2.0, 4.0), Vec3::ZERO, Vec3::Y).unwrap();
    let pipeline =
        Pipeline::new(camera, ViewVolume::from_fov_y(0.8, 1.5, -1.0, -9.0).unwrap(), 150, 100).unwrap();
    for shading in [Shading::Flat, Shading::Gouraud, Shading::Phong] {
        let both = fast::render(&world, &pipeline, shading);
        let mut fronts = both.clone();
        Renderer::new().render_into(&world, &pipeline, shading, Faces::Front, &mut fronts);
        // Along outlines a back may be nearer by rounding in a pixel whose front it touches.
        let differ =
            both.pixels().iter().zip(fronts.pixels()).filter(|(a, b)| !a.abs_diff_eq(**b, 1e-3)).count();
        assert!(differ <= 15, "{shading:?}: {differ} pixels");
        assert!(both.pixels().iter().filter(|color| **color != Rgb::ZERO).count() > 3000);
    }
}
