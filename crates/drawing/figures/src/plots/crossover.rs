//! Which is faster, the z-buffer or the ray tracer? It depends on the number of triangles (L21).

use std::error::Error;
use std::sync::Arc;
use std::time::{Duration, Instant};

use canvas::Rgb;
use geometry::Mesh;
use geometry::shapes::icosphere;
use glam::{Mat4, Vec3, vec3};
use lighting::{Highlight, Light, Material};
use raytrace::{Search, Shape, TracedMesh};
use shading::Shading;
use sheet::Ink;
use sheet::plot::{Axis, Kind, Plot, Series};
use transforms::{Camera, Pipeline, ViewVolume};

use crate::figure::{Drawing, Drawn, Figure, Text, Words};
use crate::handle::without_handles;
use crate::parameter::{Parameter, Values};

pub(super) static FIGURE: Figure = Figure {
    numbers: &["L21"],
    name: "crossover",
    title: Text { en: "z-buffer versus ray tracing", nl: "z-buffer versus ray tracing" },
    caption: Text {
        en: "Time for one picture of a ball, measured on this machine while drawing: the best of three. The z-buffer visits every triangle once; the slide's ray tracer visits every triangle for every pixel; with a hierarchy of boxes a ray visits a few. Building the hierarchy is not counted.",
        nl: "Tijd voor één beeld van een bol, gemeten op deze machine tijdens het tekenen: de beste van drie. De z-buffer bezoekt elke driehoek eenmaal; de raytracer van de slide elke driehoek voor elke pixel; met een hiërarchie van dozen bezoekt een straal er enkele. Het bouwen van de hiërarchie telt niet mee.",
    },
    parameters: &[
        Parameter::count(
            "side",
            Text { en: "side of the picture, pixels", nl: "zijde van het beeld, pixels" },
            96.0,
            32.0,
            192.0,
        ),
        Parameter::count(
            "level",
            Text { en: "greatest subdivision of the ball", nl: "grootste onderverdeling van de bol" },
            5.0,
            1.0,
            6.0,
        ),
    ],
    size: (640, 480),
    draw,
    handles: without_handles,
};

/// The slide's loop takes pixels × triangles steps; beyond this subdivision it would take seconds.
const GREATEST_BRUTE_LEVEL: u32 = 2;
const COLOR: Rgb = Rgb::new(0.7, 0.2, 0.1);
const TO_LIGHT: Vec3 = vec3(0.48, 0.64, 0.6);

fn draw(values: &Values) -> Drawn {
    let side = values.count("side");
    let camera = Camera::look_at(vec3(0.0, 0.0, 4.0), Vec3::ZERO, Vec3::Y)?;
    let pipeline = Pipeline::new(camera, ViewVolume::from_fov_y(0.6, 1.0, -1.0, -9.0)?, side, side)?;
    let [mut buffered, mut searched, mut looped] = [Vec::new(), Vec::new(), Vec::new()];
    for level in 0..=values.count("level") {
        let mesh = icosphere(level)?;
        let triangles = mesh.len() as f64;
        buffered.push((triangles, z_buffer_time(&mesh, &pipeline)));
        let world = traced_world(mesh)?;
        searched.push((triangles, ray_time(&world, &pipeline, Search::Hierarchy)));
        if level <= GREATEST_BRUTE_LEVEL {
            looped.push((triangles, ray_time(&world, &pipeline, Search::BruteForce)));
        }
    }
    let alt = alt(&buffered, &searched);
    let series = |en: &str, nl: &str, ink, points| Series {
        name: Words::new(en, nl),
        ink,
        points,
        kind: Kind::Measured,
    };
    let plot = Plot {
        x: Axis::logarithmic(Words::new("triangles", "driehoeken")),
        y: Axis::logarithmic(Words::new(
            "time for a picture, milliseconds",
            "tijd voor een beeld, milliseconden",
        )),
        series: vec![
            series("z-buffer", "z-buffer", Ink::A, buffered),
            series("rays, hierarchy", "stralen, hiërarchie", Ink::B, searched),
            series("rays, slide's loop", "stralen, slide-lus", Ink::C, looped),
        ],
    };
    Ok(vec![Drawing::only(alt, |alt| plot.svg(alt))])
}

fn lights() -> Vec<Light> {
    vec![Light::Directional { to_light: TO_LIGHT, color: Rgb::ONE }]
}

fn z_buffer_time(mesh: &Mesh, pipeline: &Pipeline) -> f64 {
    let materials = [Material::matt(COLOR)];
    let objects = [shading::Object { mesh, world_from_object: Mat4::IDENTITY, materials: &materials }];
    let lights = lights();
    let world = shading::World {
        objects: &objects,
        lights: &lights,
        background: Rgb::ZERO,
        highlight: Highlight::default(),
    };
    milliseconds(|| shading::fast::render(&world, pipeline, Shading::Phong))
}

fn traced_world(mesh: Mesh) -> Result<raytrace::World, Box<dyn Error + Send + Sync>> {
    let shape = Shape::Mesh(Arc::new(TracedMesh::new(mesh)));
    let surface = raytrace::Surface::opaque(Material::matt(COLOR));
    let ball = raytrace::Object::new(shape, Mat4::IDENTITY, vec![surface])?;
    Ok(raytrace::World::new(vec![ball], lights()))
}

/// Without shadow rays: the z-buffer has none.
fn ray_time(world: &raytrace::World, pipeline: &Pipeline, search: Search) -> f64 {
    let settings = raytrace::Settings { shadows: false, search, ..Default::default() };
    milliseconds(|| raytrace::render(world, pipeline, &settings, &|_| ()))
}

/// The best of three: whatever else the machine does only makes it slower.
fn milliseconds<T>(mut work: impl FnMut() -> T) -> f64 {
    let mut best = Duration::MAX;
    for _ in 0..3 {
        let start = Instant::now();
        std::hint::black_box(work());
        best = best.min(start.elapsed());
    }
    1e3 * best.as_secs_f64()
}

fn alt(buffered: &[(f64, f64)], searched: &[(f64, f64)]) -> Words {
    let [(few, first), (many, last)] =
        [0, buffered.len() - 1].map(|k| (buffered[k].0, buffered[k].1 / searched[k].1));
    Words::new(
        format!(
            "Rising lines. With {few} triangles the z-buffer takes {first:.2} times the time of the ray tracer with a hierarchy, with {many} triangles {last:.2} times."
        ),
        format!(
            "Stijgende lijnen. Met {few} driehoeken kost de z-buffer {first:.2} maal de tijd van de raytracer met hiërarchie, met {many} driehoeken {last:.2} maal."
        ),
    )
}
