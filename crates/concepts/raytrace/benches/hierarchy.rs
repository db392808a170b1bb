//! What does the hierarchy save? The nearest hit by the slide's loop and through boxes as the mesh grows (L43); what eight
//! rays gain that go together; and whole pictures both ways (L55).
//!
//! `cargo bench -p raytrace -- nearest` runs one question alone; the others are `together`, `build` and `picture`. All of it
//! runs on one thread: what more of them gain hangs on the machine.

use std::hint::black_box;
use std::sync::Arc;
use std::time::Duration;

use canvas::Rgb;
use criterion::{BenchmarkId, Criterion, criterion_group, criterion_main};
use geometry::{Ray, shapes};
use glam::{Mat4, Vec3, vec3};
use lighting::Light;
use raytrace::{
    Object, Search, Settings, Shape, Surface, TracedMesh, World, fast, nearest, nearest_brute, render,
    viewing_ray,
};
use transforms::{Camera, Pipeline, ViewVolume};

/// A teapot of 240 triangles at level 0, about four times as many a level.
fn world(level: u32) -> World {
    let mesh = Arc::new(TracedMesh::new(shapes::teapot(level).expect("a level in range")));
    let object =
        Object::new(Shape::Mesh(mesh), Mat4::IDENTITY, vec![Surface::default()]).expect("a sound object");
    let lights = vec![
        Light::Ambient { color: Rgb::splat(0.2) },
        Light::Directional { to_light: vec3(0.48, 0.64, 0.6), color: Rgb::splat(0.8) },
    ];
    World::new(vec![object], lights)
}

fn pipeline(size: u32) -> Pipeline {
    let camera = Camera::look_at(vec3(2.0, 5.0, 8.0), vec3(0.2, 1.4, 0.0), Vec3::Y).expect("a sound camera");
    let volume = ViewVolume::from_fov_y(0.65, 1.0, -1.0, -50.0).expect("a sound volume");
    Pipeline::new(camera, volume, size, size).expect("a sound pipeline")
}

/// 64 rays at meshes that grow: the loop takes as much longer as there are more triangles, the hierarchy hardly.
fn nearest_hit(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("nearest hit of 64 rays");
    group.sample_size(20).warm_up_time(Duration::from_millis(300)).measurement_time(Duration::from_secs(1));
    let rays = rays(8);
    for level in [0, 1, 2, 3] {
        let (world, triangles) = (world(level), shapes::teapot(level).expect("a level in range").len());
        group.bench_function(BenchmarkId::new("slide's loop", triangles), |bencher| {
            bencher.iter(|| {
                rays.iter().filter_map(|ray| nearest_brute(black_box(&world), ray, 0.0, 99.0)).count()
            });
        });
        group.bench_function(BenchmarkId::new("hierarchy", triangles), |bencher| {
            bencher.iter(|| rays.iter().filter_map(|ray| nearest(black_box(&world), ray, 0.0, 99.0)).count());
        });
    }
    group.finish();
}

/// The same rays one by one, and neighbours together.
fn together(criterion: &mut Criterion) {
    let (world, rays) = (world(3), rays(256));
    let mut met = vec![None; rays.len()];
    let mut group = criterion.benchmark_group("together: 65,536 rays, 16,256 triangles");
    group.sample_size(10).warm_up_time(Duration::from_millis(300)).measurement_time(Duration::from_secs(1));
    group.bench_function("one by one", |bencher| {
        bencher
            .iter(|| rays.iter().filter_map(|ray| fast::nearest(black_box(&world), ray, 0.0, 99.0)).count());
    });
    group.bench_function("eight neighbours", |bencher| {
        bencher.iter(|| fast::nearest_each(black_box(&world), &rays, 0.0, 99.0, &mut met));
    });
    group.finish();
}

/// What comes before the first ray.
fn build(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("build the hierarchy");
    group.sample_size(10).warm_up_time(Duration::from_millis(300)).measurement_time(Duration::from_secs(1));
    for level in [1, 3] {
        let mesh = shapes::teapot(level).expect("a level in range");
        let one_thread = one_thread();
        group.bench_function(format!("{} triangles", mesh.len()), |bencher| {
            one_thread.install(|| bencher.iter(|| TracedMesh::new(black_box(mesh.clone()))));
        });
    }
    group.finish();
}

fn picture(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("picture of the teapot with shadows");
    group.sample_size(10).warm_up_time(Duration::from_millis(300)).measurement_time(Duration::from_secs(1));
    let one_thread = one_thread();
    let small = world(0);
    for (name, search) in [("slide's loop", Search::BruteForce), ("hierarchy", Search::Hierarchy)] {
        let settings = Settings { search, ..Settings::default() };
        let draw = || render(&small, &pipeline(64), &settings, &|_| ());
        group.bench_function(format!("240 triangles, 64 × 64, {name}"), |bencher| {
            one_thread.install(|| bencher.iter(draw));
        });
    }
    let fine = world(3);
    let draw = || render(&fine, &pipeline(512), &Settings::default(), &|_| ());
    group.bench_function("16256 triangles, 512 × 512, hierarchy", |bencher| {
        one_thread.install(|| bencher.iter(draw));
    });
    group.finish();
}

/// The viewing rays of `side` × `side` pixels, in blocks of 4 × 2.
fn rays(side: u32) -> Vec<Ray> {
    let pipeline = pipeline(side);
    let blocks = (0..side).step_by(2).flat_map(|j| (0..side).step_by(4).map(move |i| (i, j)));
    let pixels = blocks.flat_map(|(i, j)| (0..8).map(move |k| (i + k % 4, j + k / 4)));
    pixels.map(|(i, j)| viewing_ray(&pipeline, i as f32, j as f32)).collect()
}

fn one_thread() -> rayon::ThreadPool {
    rayon::ThreadPoolBuilder::new().num_threads(1).build().expect("a thread")
}

criterion_group!(benches, nearest_hit, together, build, picture);
criterion_main!(benches);
