//! Why is the highlight on a red apple white? (L29)

use canvas::{Image, Rgb};
use geometry::{Mesh, shapes};
use glam::{Mat4, Quat, Vec3, vec3};
use lighting::{Highlight, Light, Material};
use shading::{CREASE_ANGLE, Object, Shading, Visibility, World, render, with_vertex_normals};
use transforms::{Camera, Pipeline, ViewVolume};

use super::studio::Fault;
use crate::figure::{Drawing, Drawn, Figure, Text};
use crate::handle::without_handles;
use crate::parameter::{Parameter, Values};

pub(super) static FIGURE: Figure = Figure {
    numbers: &["L29"],
    name: "apple",
    title: Text { en: "The apple's highlight", nl: "De glansplek op de appel" },
    caption: Text {
        en: "A red apple in white light and in yellow light. What is scattered takes the apple's colour; the highlight takes the light's.",
        nl: "Een rode appel in wit licht en in geel licht. Wat verstrooid wordt neemt de kleur van de appel aan; de glansplek die van het licht.",
    },
    parameters: &[Parameter::number(
        "p",
        Text { en: "Phong exponent p", nl: "Phong-exponent p" },
        90.0,
        0.0,
        2000.0,
    )],
    size: (360, 360),
    draw,
    handles: without_handles,
};

fn draw(values: &Values) -> Drawn {
    let p = values.number("p");
    let white = picture(values.size(), Rgb::splat(0.8), p)?;
    let yellow = picture(values.size(), Rgb::new(0.85, 0.65, 0.1), p)?;
    Ok(vec![
        Drawing::picture(
            "white-light",
            Text { en: "A red apple with a white highlight.", nl: "Een rode appel met een witte glansplek." },
            white,
        ),
        Drawing::picture(
            "yellow-light",
            Text { en: "A red apple with a yellow highlight.", nl: "Een rode appel met een gele glansplek." },
            yellow,
        ),
    ])
}

fn picture((width, height): (u32, u32), color: Rgb, p: f32) -> Result<Image, Fault> {
    /// Samples along each side of a pixel.
    const FINER: u32 = 2;
    let (apple, stem) = (apple()?, shapes::uv_sphere(4)?);
    let red = [Material { diffuse: vec3(0.55, 0.03, 0.03), specular: Rgb::splat(0.9), exponent: p }];
    let brown = [Material::matt(vec3(0.16, 0.09, 0.04))];
    let stem_place = Mat4::from_scale_rotation_translation(
        vec3(0.045, 0.3, 0.045),
        Quat::from_rotation_z(-0.2),
        vec3(0.05, 0.82, 0.0),
    );
    let objects = [
        Object { mesh: &apple, world_from_object: Mat4::IDENTITY, materials: &red },
        Object { mesh: &stem, world_from_object: stem_place, materials: &brown },
    ];
    let lights = [
        Light::Ambient { color: 0.25 * color },
        Light::Directional { to_light: vec3(-0.55, 0.75, 0.9).normalize(), color },
    ];
    let world = World {
        objects: &objects,
        lights: &lights,
        background: vec3(0.55, 0.58, 0.6),
        highlight: Highlight::Phong,
    };
    let camera = Camera::look_at(vec3(0.0, 2.6, 6.0), vec3(0.0, 0.03, 0.0), Vec3::Y)?;
    let aspect = width as f32 / height as f32;
    let fov = 2.0 * (0.19 / aspect.min(1.0)).atan();
    let volume = ViewVolume::from_fov_y(fov, aspect, -4.0, -9.0)?;
    let pipeline = Pipeline::new(camera, volume, FINER * width, FINER * height)?;
    Ok(render(&world, &pipeline, Shading::Phong, Visibility::default()).image.box_downsampled(FINER))
}

/// A ball with a deep dimple at the top and a shallow one below, narrower towards the bottom.
fn apple() -> Result<Mesh, Fault> {
    let ball = shapes::icosphere(5)?.without_normals();
    let moved = ball.positions().iter().map(|d| {
        let from_top = d.y.clamp(-1.0, 1.0).acos();
        let from_bottom = std::f32::consts::PI - from_top;
        let dimple = |angle: f32, depth: f32, width: f32| depth * (-(angle / width).powi(2)).exp();
        let radius = 1.0 - dimple(from_top, 0.5, 0.5) - dimple(from_bottom, 0.2, 0.45);
        let taper = 1.0 + 0.1 * d.y;
        radius * vec3(taper * d.x, 0.92 * d.y, taper * d.z)
    });
    let moved = moved.collect();
    Ok(with_vertex_normals(ball.with_positions(moved)?, CREASE_ANGLE))
}
