//! What does the hierarchy save? The nearest hit by the slide's loop and through boxes as the mesh grows; the time to build
//! the boxes; and whole pictures both ways.

use std::hint::black_box;
use std::sync::Arc;
use std::time::Duration;

use canvas::Rgb;
use criterion::{BenchmarkId, Criterion, criterion_group, criterion_main};
use geometry::{Ray, shapes};
use glam::{Mat4, Vec3, vec3};
use lighting::Light;
use raytrace::{
    Object, Search, Settings, Shape, Surface, TracedMesh, World, nearest, nearest_brute, render, viewing_ray,
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

fn one_ray(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("nearest hit of 64 rays");
    group.sample_size(20).warm_up_time(Duration::from_millis(300)).measurement_time(Duration::from_secs(1));
    let pipeline = pipeline(8);
    let rays: Vec<Ray> = (0..64).map(|k| viewing_ray(&pipeline, (k % 8) as f32, (k / 8) as f32)).collect();
    for level in [0, 1, 2, 3] {
        let world = world(level);
        let triangles = shapes::teapot(level).expect("a level in range").len();
        group.bench_function(BenchmarkId::new("brute force", triangles), |bencher| {
            bencher.iter(|| {
                rays.iter().filter_map(|ray| nearest_brute(black_box(&world), ray, 0.0, 99.0)).count()
            });
        });
        group.bench_function(BenchmarkId::new("hierarchy", triangles), |bencher| {
            bencher.iter(|| rays.iter().filter_map(|ray| nearest(black_box(&world), ray, 0.0, 99.0)).count());
        });
        let mesh = shapes::teapot(level).expect("a level in range");
        group.bench_function(BenchmarkId::new("building the hierarchy", triangles), |bencher| {
            bencher.iter(|| TracedMesh::new(black_box(mesh.clone())));
        });
    }
    group.finish();
}

fn whole_picture(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("teapot with shadows");
    group.sample_size(10).warm_up_time(Duration::from_millis(300)).measurement_time(Duration::from_secs(2));
    let small = world(0);
    for search in [Search::BruteForce, Search::Hierarchy] {
        let settings = Settings { search, ..Settings::default() };
        group.bench_function(format!("240 triangles, 64 × 64, {search:?}"), |bencher| {
            bencher.iter(|| render(&small, &pipeline(64), &settings, &|_| ()));
        });
    }
    let fine = world(3);
    group.bench_function("16256 triangles, 1024 × 1024, Hierarchy", |bencher| {
        bencher.iter(|| render(&fine, &pipeline(1024), &Settings::default(), &|_| ()));
    });
    group.finish();
}

criterion_group!(benches, one_ray, whole_picture);
criterion_main!(benches);
