//! What does each step of the fast search save? A million triangles and 69,312: building; viewing rays, shadow rays and rays
//! from anywhere to anywhere, one by one and many at once; and whole pictures by the fast search and by the slide's loop. One
//! thread; read the ratios within a group. The package in `tests/peers` compares with other Rust libraries.

mod scene;

use std::hint::black_box;
use std::sync::Arc;
use std::time::Duration;

use canvas::Rgb;
use criterion::measurement::WallTime;
use criterion::{BenchmarkGroup, Criterion, Throughput, criterion_group, criterion_main};
use geometry::{Mesh, Ray};
use glam::Mat4;
use lighting::Light;
use raytrace::{Object, Search, Settings, Shape, Surface, TracedMesh, World, fast, render};

/// The meshes' names, squares along an edge of the cube, and how many rays are sent.
const MESHES: [(&str, u32); 2] = [("69k", 76), ("1M", 289)];
const SIDE: u32 = 512;

fn world(mesh: Mesh) -> World {
    let shape = Shape::Mesh(Arc::new(TracedMesh::new(mesh)));
    let object = Object::new(shape, Mat4::IDENTITY, vec![Surface::default()]).expect("the identity");
    let lights = vec![
        Light::Ambient { color: Rgb::splat(0.1) },
        Light::Point { position: scene::LIGHT, color: Rgb::ONE },
    ];
    World::new(vec![object], lights)
}

fn group<'c>(criterion: &'c mut Criterion, name: &str) -> BenchmarkGroup<'c, WallTime> {
    let mut group = criterion.benchmark_group(name);
    group.sample_size(10).warm_up_time(Duration::from_millis(200)).measurement_time(Duration::from_secs(1));
    group
}

fn rays(criterion: &mut Criterion) {
    for (name, n) in MESHES {
        let mesh = scene::bumpy(n);
        let world = world(mesh);
        let primary = scene::primary(SIDE);
        let random = scene::random(primary.len() / 4);
        let mut met = vec![None; primary.len()];
        for (kind, rays) in [("viewing", &primary), ("random", &random)] {
            let mut group = group(criterion, &format!("{kind} rays, {name}"));
            group.throughput(Throughput::Elements(rays.len() as u64));
            let met = &mut met[..rays.len()];
            group.bench_function("many at once", |bencher| {
                bencher.iter(|| fast::nearest_each(&world, rays, 0.0, f32::MAX, met));
            });
            group.bench_function("one by one", |bencher| {
                bencher
                    .iter(|| rays.iter().filter_map(|ray| fast::nearest(&world, ray, 0.0, f32::MAX)).count());
            });
        }
        fast::nearest_each(&world, &primary, 0.0, f32::MAX, &mut met);
        // Slightly in front of the surface, so that a shadow ray does not start behind it.
        let start = |(ray, met): (&Ray, &Option<raytrace::HitRecord>)| met.map(|met| ray.at(met.t * 0.999));
        let starts = primary.iter().zip(&met).filter_map(start);
        let shadow: Vec<Ray> = starts.map(|p| Ray::through(p, scene::LIGHT)).collect();
        let (ends, mut stopped) = (vec![1.0; shadow.len()], vec![false; shadow.len()]);
        let mut group = group(criterion, &format!("shadow rays, {name}"));
        group.throughput(Throughput::Elements(shadow.len() as u64));
        group.bench_function("many at once", |bencher| {
            bencher.iter(|| fast::any_hit_each(&world, &shadow, 0.0, &ends, &mut stopped));
        });
        group.bench_function("one by one", |bencher| {
            bencher.iter(|| shadow.iter().filter(|ray| fast::any_hit(&world, ray, 0.0, 1.0)).count());
        });
    }
}

fn building(criterion: &mut Criterion) {
    let mesh = scene::bumpy(289);
    let mut group = group(criterion, "building, 1M");
    for threads in [1, 2] {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().expect("threads");
        group.bench_function(format!("ours, threads: {threads}"), |bencher| {
            bencher.iter(|| pool.install(|| TracedMesh::new(black_box(mesh.clone()))));
        });
    }
}

fn pictures(criterion: &mut Criterion) {
    let one_thread = rayon::ThreadPoolBuilder::new().num_threads(1).build().expect("a thread");
    let mut group = group(criterion, "pictures with shadows");
    let (coarse, fine) = (world(scene::bumpy(6)), world(scene::bumpy(76)));
    for search in [Search::BruteForce, Search::Hierarchy] {
        let settings = Settings { search, ..Settings::default() };
        group.bench_function(format!("432 triangles, 128 × 96, {search:?}"), |bencher| {
            bencher
                .iter(|| one_thread.install(|| render(&coarse, &scene::view(128, 96), &settings, &|_| ())));
        });
    }
    group.bench_function("69k, 1024 × 768, Hierarchy", |bencher| {
        bencher.iter(|| {
            one_thread.install(|| render(&fine, &scene::view(1024, 768), &Settings::default(), &|_| ()))
        });
    });
}

criterion_group!(benches, rays, building, pictures);
criterion_main!(benches);
