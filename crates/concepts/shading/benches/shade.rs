//! What do the three shadings cost (L37, L38, L40), and what does computing only the visible colours save (E16)?
//!
//! `cargo bench -p shading -- shadings` runs one question alone; the others are `overdraw` and `normals`. All of it runs on one
//! thread: what more of them gain hangs on the machine.

use std::hint::black_box;
use std::time::Duration;

use canvas::{Image, Rgb};
use criterion::{Criterion, criterion_group, criterion_main};
use geometry::shapes::teapot;
use glam::{Mat4, Vec3, vec3};
use lighting::{Highlight, Light, Material};
use shading::fast::{self, Faces};
use shading::{Object, Shading, Visibility, World, render, render_plain, vertex_normals};
use transforms::{Camera, Pipeline, ViewVolume};
use zbuffer::DepthFormat;

fn pipeline() -> Pipeline {
    let camera =
        Camera::look_at(vec3(2.0, 4.0, 8.0), vec3(0.0, 1.5, 0.0), Vec3::Y).expect("eye and target differ");
    let volume = ViewVolume::from_fov_y(0.6, 1.0, -1.0, -20.0).expect("a sound volume");
    Pipeline::new(camera, volume, 512, 512).expect("a sound pipeline")
}

fn with_world(measure: impl FnOnce(&World)) {
    // Four pots in a row, the farthest first: three quarters of what the slide's loop computes are hidden later.
    let mesh = teapot(3).expect("a level in range");
    let material = [Material::new(vec3(0.6, 0.3, 0.1), 60.0)];
    let pot = |k: f32| {
        let world_from_object = Mat4::from_translation(k * vec3(0.25, 0.5, 1.0) - vec3(0.75, 1.5, 3.0));
        Object { mesh: &mesh, world_from_object, materials: &material }
    };
    let objects = [0.0, 1.0, 2.0, 3.0].map(pot);
    let lights = [
        Light::Ambient { color: Rgb::splat(0.1) },
        Light::Point { position: vec3(4.0, 8.0, 6.0), color: Rgb::ONE },
        Light::Directional { to_light: vec3(-0.6, 0.8, 0.0), color: Rgb::splat(0.4) },
    ];
    measure(&World {
        objects: &objects,
        lights: &lights,
        background: Rgb::ZERO,
        highlight: Highlight::Blinn,
    });
}

const SHADINGS: [Shading; 3] = [Shading::Flat, Shading::Gouraud, Shading::Phong];

fn one_thread() -> rayon::ThreadPool {
    rayon::ThreadPoolBuilder::new().num_threads(1).build().expect("a thread")
}

/// The three of them, by the slide's loop and by the fast version.
fn shadings(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("shadings, 4 × 16,256 triangles, 512 × 512");
    let pool = one_thread();
    for shading in SHADINGS {
        with_world(|world| {
            let pipeline = pipeline();
            group.bench_function(format!("slide, {shading:?}"), |b| {
                b.iter(|| render_plain(black_box(world), &pipeline, shading, DepthFormat::F32));
            });
            let mut renderer = fast::Renderer::new();
            let mut image = Image::new(512, 512, Rgb::ZERO);
            let mut draw =
                || renderer.render_into(black_box(world), &pipeline, shading, Faces::Both, &mut image);
            group.bench_function(format!("fast, {shading:?}"), |b| pool.install(|| b.iter(&mut draw)));
        });
    }
    group.finish();
}

/// Phong shading inside the loop and after it, by the same rasterizer; then by the fast one.
fn overdraw(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("overdraw, Phong, 4 × 16,256 triangles, 512 × 512");
    let pool = one_thread();
    with_world(|world| {
        let pipeline = pipeline();
        group.bench_function("shaded in the loop (slide)", |b| {
            b.iter(|| render_plain(black_box(world), &pipeline, Shading::Phong, DepthFormat::F32));
        });
        let render = || render(black_box(world), &pipeline, Shading::Phong, Visibility::default());
        group.bench_function("what is visible shaded", |b| pool.install(|| b.iter(render)));
    });
    group.finish();
}

fn normals(criterion: &mut Criterion) {
    let mesh = teapot(3).expect("a level in range");
    criterion.bench_function("normals of vertices, 16,256 triangles", |b| {
        b.iter(|| vertex_normals(black_box(&mesh), shading::CREASE_ANGLE));
    });
}

criterion_group! {
    name = benches;
    config = Criterion::default()
        .sample_size(20)
        .warm_up_time(Duration::from_millis(300))
        .measurement_time(Duration::from_secs(1));
    targets = shadings, overdraw, normals
}
criterion_main!(benches);
