//! What do the three shadings cost, and what does computing only the visible colours save?

use std::hint::black_box;
use std::time::Duration;

use canvas::Rgb;
use criterion::{Criterion, criterion_group, criterion_main};
use geometry::shapes::teapot;
use glam::{Mat4, Vec3, vec3};
use lighting::{Highlight, Light, Material};
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

fn shadings(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("shadings, 4 × 16,256 triangles, 512 × 512");
    for shading in [Shading::Flat, Shading::Gouraud, Shading::Phong] {
        with_world(|world| {
            let pipeline = pipeline();
            group.bench_function(format!("{shading:?}"), |b| {
                b.iter(|| render(black_box(world), &pipeline, shading, Visibility::default()));
            });
        });
    }
    group.finish();
}

fn plain_and_fast(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("Phong shading, 4 × 16,256 triangles, 512 × 512");
    with_world(|world| {
        let pipeline = pipeline();
        group.bench_function("plain", |b| {
            b.iter(|| render_plain(black_box(world), &pipeline, Shading::Phong, DepthFormat::F32));
        });
        group.bench_function("fast", |b| {
            b.iter(|| render(black_box(world), &pipeline, Shading::Phong, Visibility::default()));
        });
    });
    group.finish();
}

fn normals(criterion: &mut Criterion) {
    let mesh = teapot(3).expect("a level in range");
    criterion.bench_function("vertex normals, 16,256 triangles", |b| {
        b.iter(|| vertex_normals(black_box(&mesh), shading::CREASE_ANGLE));
    });
}

criterion_group! {
    name = benches;
    config = Criterion::default()
        .sample_size(20)
        .warm_up_time(Duration::from_millis(300))
        .measurement_time(Duration::from_secs(2));
    targets = shadings, plain_and_fast, normals
}
criterion_main!(benches);
