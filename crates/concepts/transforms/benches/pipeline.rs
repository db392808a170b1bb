//! What is saved by multiplying the matrices once instead of every point by all of them? (L5)
//!
//! `cargo bench -p transforms -- chain`

use std::hint::black_box;
use std::time::Duration;

use criterion::{Criterion, criterion_group, criterion_main};
use glam::{Vec3, vec3};
use transforms::{Camera, Pipeline, ViewVolume};

fn chain(c: &mut Criterion) {
    let camera = Camera::look_at(vec3(3.0, 2.0, 5.0), vec3(0.5, 0.0, -1.0), Vec3::Y).expect("a camera");
    let volume = ViewVolume { left: -1.0, right: 1.5, bottom: -0.75, top: 1.0, near: -2.0, far: -20.0 };
    let pipeline = Pipeline::new(camera, volume, 640, 480).expect("a pipeline");
    let points: Vec<Vec3> =
        (0..1000).map(|k| vec3((k % 10) as f32, (k / 10 % 10) as f32, -(k / 100) as f32)).collect();

    let mut group = c.benchmark_group("chain, 1000 points");
    group.sample_size(20).measurement_time(Duration::from_secs(1)).warm_up_time(Duration::from_millis(500));
    let factors = pipeline.factors().map(|factor| factor.matrix);
    group.bench_function("six factors one by one", |b| {
        b.iter(|| {
            for p in &points {
                let q = factors.iter().fold(black_box(*p).extend(1.0), |v, m| *m * v);
                black_box(q.truncate() / q.w);
            }
        });
    });
    group.bench_function("trace: every stage kept", |b| {
        b.iter(|| {
            for p in &points {
                black_box(pipeline.trace(black_box(*p)));
            }
        });
    });
    let screen_from_world = pipeline.screen_from_world();
    group.bench_function("one matrix", |b| {
        b.iter(|| {
            for p in &points {
                black_box(screen_from_world.project_point3(black_box(*p)));
            }
        });
    });
    group.finish();
}

criterion_group!(benches, chain);
criterion_main!(benches);
