//! Mirror, glass and a chequered floor: `cargo run --release -p raytrace --example mirror [FILE.png]`.

use std::sync::Arc;

use canvas::Rgb;
use geometry::{Mesh, Sphere, shapes};
use glam::{Mat4, Vec3, vec3};
use lighting::{Light, Material};
use raytrace::{Object, Optics, Settings, Shape, Surface, TracedMesh, World, render};
use transforms::{Camera, Pipeline, ViewVolume};

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let mut world = World::new(objects()?, lights());
    world.background = Rgb::new(0.25, 0.42, 0.7);

    let camera = Camera::look_at(vec3(0.4, 2.2, 7.5), vec3(0.1, 0.9, 0.0), Vec3::Y)?;
    let volume = ViewVolume::from_fov_y(0.62, 1.5, -1.0, -60.0)?;
    let pipeline = Pipeline::new(camera, volume, 900, 600)?;
    let settings = Settings { samples: 3, max_depth: 8, ..Settings::default() };
    let image = render(&world, &pipeline, &settings, &|_| ());

    let path = std::env::args().nth(1).unwrap_or_else(|| "mirror.png".to_owned());
    let format = canvas::Format::from_path(std::path::Path::new(&path))?;
    std::fs::write(&path, canvas::codec::encode(&image, format)?)?;
    Ok(())
}

fn objects() -> Result<Vec<Object>, Box<dyn std::error::Error>> {
    let mirror = Surface {
        material: Material { diffuse: Rgb::splat(0.02), specular: Rgb::splat(0.6), exponent: 400.0 },
        optics: Optics::Mirror { reflectance: Rgb::new(0.9, 0.87, 0.8) },
    };
    let glass = Surface {
        material: Material { diffuse: Rgb::ZERO, specular: Rgb::splat(0.6), exponent: 400.0 },
        optics: Optics::Glass { refractive_index: 1.5, transmittance: Rgb::new(0.93, 0.98, 0.95) },
    };
    let glazed = Surface::opaque(Material::new(Rgb::new(0.65, 0.12, 0.05), 90.0));

    let ball = |at: Vec3, radius: f32, surface| {
        Object::new(Shape::Sphere(Sphere::new(at, radius)), Mat4::IDENTITY, vec![surface])
    };
    let teapot = Arc::new(TracedMesh::new(shapes::teapot(3)?));
    let pot = |at: Vec3, turn: f32| {
        let map =
            Mat4::from_translation(at) * Mat4::from_rotation_y(turn) * Mat4::from_scale(Vec3::splat(0.35));
        Object::new(Shape::Mesh(teapot.clone()), map, vec![glazed])
    };
    Ok(vec![
        floor()?,
        ball(vec3(-1.5, 1.0, -0.6), 1.0, mirror)?,
        ball(vec3(0.9, 0.75, 1.2), 0.75, glass)?,
        pot(vec3(1.6, 0.0, -1.4), 0.5)?,
        pot(vec3(-0.6, 0.0, 2.2), 2.6)?,
    ])
}

/// Fields of two materials.
fn floor() -> Result<Object, Box<dyn std::error::Error>> {
    const FIELDS: u32 = 24;
    let side = FIELDS + 1;
    let corner = |k: u32| vec3((k % side) as f32 - 12.0, 0.0, 12.0 - (k / side) as f32);
    let corners = (0..side * side).map(corner).collect();
    let fields = (0..FIELDS * FIELDS).map(|k| (k % FIELDS, k / FIELDS));
    let (mut triangles, mut materials) = (Vec::new(), Vec::new());
    for (column, row) in fields {
        let first = row * side + column;
        triangles.extend([[first, first + 1, first + side + 1], [first, first + side + 1, first + side]]);
        materials.extend([(row + column) % 2; 2]);
    }
    let mesh = Mesh::new(corners, triangles)?.with_materials(materials)?;
    let matt = |grey: f32| Surface::opaque(Material::matt(Rgb::splat(grey)));
    Ok(Object::new(
        Shape::Mesh(Arc::new(TracedMesh::new(mesh))),
        Mat4::IDENTITY,
        vec![matt(0.7), matt(0.15)],
    )?)
}

fn lights() -> Vec<Light> {
    vec![
        Light::Ambient { color: Rgb::splat(0.25) },
        Light::Directional { to_light: vec3(0.5, 0.8, 0.45).normalize(), color: Rgb::new(0.6, 0.58, 0.5) },
        Light::Point { position: vec3(-5.0, 6.0, 5.0), color: Rgb::new(0.25, 0.27, 0.3) },
    ]
}
