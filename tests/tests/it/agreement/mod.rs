//! Do rasterizer and ray tracer draw the same picture? (L21)
//!
//! They share the vocabulary, the conventions and the lighting equation, but nothing that decides what a pixel shows. So
//! for random scenes the same triangle must win in every pixel, and the colours must agree, but for pixels where the
//! rasterizer's snapping to 1/256 pixel can decide: those whose centre lies within [`snapping::SNAP`] of an edge, or where two
//! surfaces pass through each other, so that their depths differ by less than what [`snapping::SNAP`] makes of their slopes.
//! How many those are is counted and bounded too.

mod compare;
mod scenes;
mod snapping;
mod stage;

use std::cell::RefCell;

use canvas::Rgb;
use glam::{Mat4, Vec3, vec3};
use lighting::{Light, Material};
use proptest::prelude::*;
use shading::{Shading, Visibility};
use testkit::Law;
use transforms::{Camera, Pipeline, ViewVolume};
use zbuffer::DepthFormat;

use self::compare::{Tally, compare_colors, compare_winners};
use self::scenes::{curved_shapes, triangle_soup};
use self::stage::Stage;

const MODES: [(Shading, raytrace::Interpolation); 3] = [
    (Shading::Flat, raytrace::Interpolation::Flat),
    (Shading::Gouraud, raytrace::Interpolation::Gouraud),
    (Shading::Phong, raytrace::Interpolation::Phong),
];

fn agreement(sentence: &str, cases: u32, stages: impl Strategy<Value = Stage>) {
    let tally = RefCell::new(Tally::default());
    let law = Law::new(sentence).cases(cases).demand("much is seen", 0.5).demand("one hides another", 0.3);
    law.holds_for(stages, |stage, seen| {
        let z_buffered = stage.rasterized(Shading::Phong, Visibility::ZBuffer(DepthFormat::F32));
        let painted = stage.rasterized(Shading::Phong, Visibility::Painter);
        let world = stage.traceable(raytrace::Interpolation::Phong);
        let hits = raytrace::visible(&world, &stage.pipeline);

        let drawn = z_buffered.shaded.iter().filter(|n| **n > 0).count();
        seen.class("much is seen", 5 * drawn > hits.len());
        seen.class("one hides another", painted.shaded.iter().any(|n| *n > 1));

        let by_z = |k: usize| z_buffered.visible[k].map(|v| (v.object, v.triangle));
        let by_order = |k: usize| painted.visible[k].map(|v| (v.object, v.triangle));
        let by_ray = |k: usize| hits[k].map(|hit| (hit.object, hit.triangle));
        compare_winners(&stage, by_z, by_ray, &mut tally.borrow_mut())?;
        compare_winners(&stage, by_order, by_ray, &mut tally.borrow_mut())?;

        for (shading, interpolation) in MODES {
            let frame = stage.rasterized(shading, Visibility::ZBuffer(DepthFormat::F32));
            let world = stage.traceable(interpolation);
            compare_colors(&stage, &frame, &world, &hits, &mut tally.borrow_mut())?;
        }
        Ok(())
    });
    let Tally { pixels, different, edge_area, colors_left_to_snapping } = tally.into_inner();
    println!(
        "{sentence}: of {pixels} pixels {different} winners and {colors_left_to_snapping} colours left to snapping"
    );
    assert!(
        (different as f64) <= edge_area,
        "{different} of {pixels} winners differ, more than the {edge_area:.0} expected within reach of snapping"
    );
    // A pixel's colour must change by 1/255 over 1/181 pixel: by 0.7 a pixel, which only silhouettes and gleams do.
    assert!(
        1000 * colors_left_to_snapping <= pixels,
        "{colors_left_to_snapping} colours of {pixels} pixels differ by more than 1/255"
    );
}

#[test]
fn loose_triangles_win_the_same_pixels_in_every_renderer() {
    agreement("all renderers see the same triangle, loose ones", 96, triangle_soup());
}

#[test]
fn curved_shapes_win_the_same_pixels_in_every_renderer() {
    agreement("all renderers see the same triangle, curved shapes", 64, curved_shapes());
}

#[test]
fn a_renderer_with_another_light_is_noticed() {
    let camera = Camera::look_at(vec3(0.5, 1.0, 5.0), Vec3::ZERO, Vec3::Y).expect("a camera");
    let volume = ViewVolume::from_fov_y(0.8, 1.0, -0.5, -30.0).expect("a volume");
    let sphere = geometry::shapes::icosphere(2).expect("a sphere");
    let stage = |red: f32| Stage {
        meshes: vec![(sphere.clone(), Mat4::IDENTITY, Material::default())],
        lights: vec![Light::Directional { to_light: vec3(0.0, 0.6, 0.8), color: Rgb::new(red, 0.5, 0.5) }],
        pipeline: Pipeline::new(camera, volume, 48, 48).expect("a pipeline"),
    };
    let world = stage(0.5).traceable(raytrace::Interpolation::Phong);
    let hits = raytrace::visible(&world, &stage(0.5).pipeline);
    let outcome = |red: f32| {
        let frame = stage(red).rasterized(Shading::Phong, Visibility::ZBuffer(DepthFormat::F32));
        compare_colors(&stage(0.5), &frame, &world, &hits, &mut Tally::default())
    };
    assert!(outcome(0.5).is_ok());
    assert!(outcome(0.52).is_err());
}

#[test]
fn a_renderer_that_is_half_a_pixel_off_is_noticed() {
    // The comparison must be able to fail: a camera moved by half a pixel's width gives other winners, away from edges.
    let look = |eye: Vec3| Camera::look_at(eye, vec3(eye.x, 0.0, 0.0), Vec3::Y).expect("a camera");
    let volume = ViewVolume::from_fov_y(0.8, 1.0, -0.5, -30.0).expect("a volume");
    let sphere = geometry::shapes::icosphere(2).expect("a sphere");
    let stage = |shift: f32| Stage {
        meshes: vec![(sphere.clone(), Mat4::IDENTITY, Material::default())],
        lights: Vec::new(),
        pipeline: Pipeline::new(look(vec3(shift, 0.0, 5.0)), volume, 48, 48).expect("a pipeline"),
    };
    // The window at distance 4 (the sphere's front) is 2 · 4 · tan 0.4 high, over 48 pixels.
    let half_a_pixel = 4.0 * 0.4_f32.tan() / 48.0;
    let frame = stage(0.0).rasterized(Shading::Phong, Visibility::ZBuffer(DepthFormat::F32));
    let hits = raytrace::visible(
        &stage(half_a_pixel).traceable(raytrace::Interpolation::Phong),
        &stage(half_a_pixel).pipeline,
    );
    let outcome = compare_winners(
        &stage(0.0),
        |k| frame.visible[k].map(|v| (v.object, v.triangle)),
        |k| hits[k].map(|hit| (hit.object, hit.triangle)),
        &mut Tally::default(),
    );
    assert!(outcome.is_err());
}
