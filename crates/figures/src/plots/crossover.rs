//! Which loop is faster, and from how many triangles on? (L21)

use std::sync::Arc;
use std::time::Instant;

use canvas::Rgb;
use geometry::{Mesh, shapes};
use glam::{Mat4, Vec3, vec3};
use lighting::{Highlight, Light, Material};
use raytrace::{Shape, Surface, TracedMesh};
use shading::{Shading, Visibility};
use transforms::{Camera, Pipeline, ViewVolume};

use crate::figure::{Drawing, Drawn, Figure, Text, Words};
use crate::parameter::{Parameter, Values};
use crate::sheet::Ink;
use crate::sheet::plot::{Axis, Plot, Series};

pub(super) static FIGURE: Figure = Figure {
    numbers: &["L21"],
    name: "crossover",
    title: Text { en: "z-buffer against ray tracer", nl: "z-buffer tegen ray tracer" },
    caption: Text {
        en: "Time for one small picture of a ball, measured while this page was made. The z-buffer touches every triangle, so its time grows with their number; the ray tracer asks a hierarchy for each pixel, which hardly grows, once the hierarchy has been built.",
        nl: "Tijd voor één klein plaatje van een bol, gemeten toen deze pagina werd gemaakt. De z-buffer raakt elke driehoek aan, dus zijn tijd groeit met hun aantal; de ray tracer vraagt voor elke pixel een hiërarchie, en dat groeit nauwelijks, als de hiërarchie er eenmaal is.",
    },
    parameters: &[Parameter::count(
        "subdivision",
        Text { en: "greatest subdivision", nl: "grootste onderverdeling" },
        7.0,
        2.0,
        8.0,
    )],
    size: (640, 480),
    draw,
};

/// Pixels along each side of the picture.
const SIDE: u32 = 128;

/// The best of so many runs counts: what is slower was disturbed.
const RUNS: u32 = 3;

fn draw(values: &Values) -> Drawn {
    let mut times: [Vec<(f64, f64)>; 3] = Default::default();
    for level in 1..=values.count("subdivision") {
        let ball = shapes::icosphere(level)?;
        let count = ball.len() as f64;
        for (list, milliseconds) in times.iter_mut().zip(measured(ball)?) {
            list.push((count, milliseconds));
        }
    }
    let last = times.each_ref().map(|list| list[list.len() - 1]);
    let [z_buffer, traced, with_build] = times;
    let series = |en, nl, ink, points| Series { name: Words::new(en, nl), ink, points, is_theory: false };
    let plot = Plot {
        x: Axis::logarithmic(Words::new("triangles", "driehoeken")),
        y: Axis::logarithmic(Words::new("milliseconds a picture", "milliseconden per plaatje")),
        series: vec![
            series("z-buffer", "z-buffer", Ink::B, z_buffer),
            series("ray tracer", "ray tracer", Ink::A, traced),
            series("… and building", "… en bouwen", Ink::D, with_build),
        ],
    };
    let alt = Words::new(
        format!(
            "With {} triangles the z-buffer takes {:.1} ms, the ray tracer {:.1} ms, and {:.1} ms with building its hierarchy.",
            last[0].0, last[0].1, last[1].1, last[2].1
        ),
        format!(
            "Met {} driehoeken kost de z-buffer {:.1} ms, de ray tracer {:.1} ms, en {:.1} ms met het bouwen van de hiërarchie.",
            last[0].0, last[0].1, last[1].1, last[2].1
        ),
    );
    Ok(vec![Drawing::diagram("", alt.clone(), plot.svg(&alt))])
}

/// Milliseconds for z-buffer, ray tracer, and ray tracer with building the hierarchy.
fn measured(ball: Mesh) -> Result<[f64; 3], Box<dyn std::error::Error + Send + Sync>> {
    let camera = Camera::look_at(vec3(1.0, 2.0, 4.0), Vec3::ZERO, Vec3::Y)?;
    let pipeline = Pipeline::new(camera, ViewVolume::from_fov_y(0.5, 1.0, -1.0, -9.0)?, SIDE, SIDE)?;
    let material = Material::default();
    let lights = [Light::Directional { to_light: vec3(0.6, 0.48, 0.64), color: Rgb::splat(0.8) }];
    let objects =
        [shading::Object { mesh: &ball, world_from_object: Mat4::IDENTITY, materials: &[material] }];
    let world = shading::World {
        objects: &objects,
        lights: &lights,
        background: Rgb::ZERO,
        highlight: Highlight::Blinn,
    };
    let z_buffer = best(|| shading::render(&world, &pipeline, Shading::Phong, Visibility::default()));

    let build = || -> Result<raytrace::World, raytrace::ObjectError> {
        let shape = Shape::Mesh(Arc::new(TracedMesh::new(ball.clone())));
        let object = raytrace::Object::new(shape, Mat4::IDENTITY, vec![Surface::opaque(material)])?;
        Ok(raytrace::World::new(vec![object], lights.to_vec()))
    };
    let start = Instant::now();
    let traced_world = build()?;
    let building = milliseconds(start);
    let settings = raytrace::Settings { shadows: false, ..raytrace::Settings::default() };
    let traced = best(|| raytrace::render(&traced_world, &pipeline, &settings, &|_| ()));
    Ok([z_buffer, traced, traced + building])
}

/// The shortest time of some runs, in milliseconds.
fn best<T>(mut work: impl FnMut() -> T) -> f64 {
    let time = |_| {
        let start = Instant::now();
        std::hint::black_box(work());
        milliseconds(start)
    };
    (0..RUNS).map(time).fold(f64::INFINITY, f64::min)
}

fn milliseconds(start: Instant) -> f64 {
    1000.0 * start.elapsed().as_secs_f64()
}
