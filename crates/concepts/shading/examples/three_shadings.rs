//! A coarse ball, flat, with Gouraud and with Phong shading (L41, Figs 8.13 and 8.14): writes `three_shadings.png`, or
//! the file that the first argument names.

use std::error::Error;

use canvas::{Rgb, codec, side_by_side};
use geometry::shapes::icosphere;
use glam::{Mat4, Vec3, vec3};
use lighting::{Highlight, Light, Material};
use shading::{Object, Shading, Visibility, World, render};
use transforms::{Camera, Pipeline, ViewVolume};

fn main() -> Result<(), Box<dyn Error>> {
    let file = std::env::args().nth(1).unwrap_or_else(|| "three_shadings.png".to_owned());
    let ball = icosphere(1)?;
    let objects = [Object {
        mesh: &ball,
        world_from_object: Mat4::from_rotation_y(0.3),
        materials: &[Material::new(vec3(0.6, 0.12, 0.08), 60.0)],
    }];
    let lights = [
        Light::Ambient { color: Rgb::splat(0.15) },
        Light::Point { position: vec3(3.0, 4.0, 6.0), color: Rgb::ONE },
    ];
    let background = Rgb::splat(0.02);
    let world = World { objects: &objects, lights: &lights, background, highlight: Highlight::Blinn };
    let camera = Camera::look_at(vec3(0.0, 0.0, 5.0), Vec3::ZERO, Vec3::Y)?;
    let pipeline = Pipeline::new(camera, ViewVolume::from_fov_y(0.5, 1.0, -1.0, -9.0)?, 400, 400)?;

    let picture = |shading| render(&world, &pipeline, shading, Visibility::default()).image;
    let [flat, gouraud, phong] = [Shading::Flat, Shading::Gouraud, Shading::Phong].map(picture);
    let strip = side_by_side(&[&flat, &gouraud, &phong], 4, Rgb::ONE);
    std::fs::write(&file, codec::encode(&strip, canvas::Format::from_path(file.as_ref())?)?)?;
    println!("{file}: flat, Gouraud, Phong");
    Ok(())
}
