//! Which way is up, right and near? In every renderer the same way.

use std::sync::Arc;

use canvas::{Image, Rgb};
use geometry::Mesh;
use glam::{Mat4, Vec3, vec3};
use lighting::{Highlight, Light, Material};
use shading::{Shading, Visibility};
use transforms::{Camera, Pipeline, ViewVolume};
use zbuffer::DepthFormat;

const RED: Rgb = Rgb::new(1.0, 0.0, 0.0);
const GREEN: Rgb = Rgb::new(0.0, 1.0, 0.0);
const BLUE: Rgb = Rgb::new(0.0, 0.0, 1.0);
const YELLOW: Rgb = Rgb::new(1.0, 1.0, 0.0);

/// A triangle around `center` in a plane z = constant, drawn in its diffuse colour alone.
fn marker(center: Vec3, size: f32, color: Rgb) -> (Mesh, Material) {
    let corners = [vec3(-1.0, -1.0, 0.0), vec3(1.0, -1.0, 0.0), vec3(0.0, 1.0, 0.0)];
    let positions = corners.map(|corner| center + size * corner).to_vec();
    (Mesh::new(positions, vec![[0, 1, 2]]).expect("a mesh"), Material::matt(color))
}

/// The same things drawn by z-buffer, painter and ray tracer, seen by a camera at z = 10 that looks along −z with y up.
fn pictures(things: &[(Mesh, Material)]) -> Vec<(&'static str, Image)> {
    let camera = Camera::look_at(vec3(0.0, 0.0, 10.0), Vec3::ZERO, Vec3::Y).expect("a camera");
    let volume = ViewVolume { left: -1.0, right: 1.0, bottom: -0.75, top: 0.75, near: -1.0, far: -40.0 };
    let pipeline = Pipeline::new(camera, volume, 80, 60).expect("a pipeline");
    let lights = [Light::Ambient { color: Rgb::ONE }];

    let objects: Vec<shading::Object> = things
        .iter()
        .map(|(mesh, material)| shading::Object {
            mesh,
            world_from_object: Mat4::IDENTITY,
            materials: std::slice::from_ref(material),
        })
        .collect();
    let world = shading::World {
        objects: &objects,
        lights: &lights,
        background: Rgb::ZERO,
        highlight: Highlight::Blinn,
    };
    let draw = |visibility| shading::render(&world, &pipeline, Shading::Phong, visibility).image;

    let traced = things.iter().map(|(mesh, material)| {
        let shape = raytrace::Shape::Mesh(Arc::new(raytrace::TracedMesh::new(mesh.clone())));
        raytrace::Object::new(shape, Mat4::IDENTITY, vec![raytrace::Surface::opaque(*material)])
            .expect("an object")
    });
    let traced = raytrace::World::new(traced.collect(), lights.to_vec());
    let settings = raytrace::Settings::default();
    vec![
        ("z-buffer", draw(Visibility::ZBuffer(DepthFormat::F32))),
        ("painter", draw(Visibility::Painter)),
        ("ray tracer", raytrace::render(&traced, &pipeline, &settings, &|_| ())),
    ]
}

#[test]
fn x_is_to_the_right_and_y_is_up() {
    let things = [marker(vec3(4.0, 0.0, 0.0), 1.5, RED), marker(vec3(0.0, 4.0, 0.0), 1.5, GREEN)];
    for (renderer, image) in pictures(&things) {
        // x = 4 at distance 10 is 0.4 of a window from −1 to 1 over 80 pixels: 0.7 · 80 − ½. Likewise up.
        assert_eq!(image.get(55, 29), RED, "{renderer}: right");
        assert_eq!(image.get(39, 45), GREEN, "{renderer}: up");
        assert_eq!(image.get(23, 29), Rgb::ZERO, "{renderer}: left");
        assert_eq!(image.get(39, 13), Rgb::ZERO, "{renderer}: down");
    }
}

#[test]
fn up_is_the_first_row_of_a_file() {
    let things = [marker(vec3(0.0, 5.0, 0.0), 2.0, GREEN)];
    for (renderer, image) in pictures(&things) {
        let green_row =
            image.pixels().chunks(80).position(|row| row.contains(&GREEN)).expect("something green");
        assert!(green_row < 30, "{renderer}: green first appears in row {green_row} from the top");
    }
}

#[test]
fn what_has_the_larger_z_is_nearer_whichever_is_drawn_last() {
    // The camera looks along −z: z = 2 is nearer than z = −3.
    let (near, far) = (marker(vec3(0.0, 0.0, 2.0), 2.0, BLUE), marker(vec3(0.0, 0.0, -3.0), 4.0, YELLOW));
    for things in [[near.clone(), far.clone()], [far, near]] {
        for (renderer, image) in pictures(&things) {
            assert_eq!(image.get(39, 29), BLUE, "{renderer}: in the middle");
            assert_eq!(image.get(39, 18), YELLOW, "{renderer}: beside the nearer one");
        }
    }
}

#[test]
fn what_is_behind_the_eye_or_beyond_the_far_plane_is_not_seen() {
    let things = [marker(vec3(0.0, 0.0, 15.0), 5.0, RED), marker(vec3(0.0, 0.0, -35.0), 20.0, GREEN)];
    for (renderer, image) in pictures(&things) {
        assert!(image.pixels().iter().all(|c| *c == Rgb::ZERO), "{renderer}");
    }
}

#[test]
fn both_sides_of_a_triangle_are_drawn() {
    let (mesh, material) = marker(Vec3::ZERO, 3.0, RED);
    let turned = Mesh::new(mesh.positions().to_vec(), vec![[0, 2, 1]]).expect("a mesh");
    for (renderer, image) in pictures(&[(turned, material)]) {
        assert_eq!(image.get(39, 29), RED, "{renderer}");
    }
}
