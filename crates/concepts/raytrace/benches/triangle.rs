//! What does a ray–triangle test cost? The three solutions of the system (L51), `raytri` and the watertight test, on the
//! same thousand rays and triangles, of which about half meet. Read the ratios within the one group.
//!
//! `cargo bench -p raytrace -- triangle`

use std::hint::black_box;
use std::time::Duration;

use criterion::{Criterion, Throughput, criterion_group, criterion_main};
use geometry::{Ray, Triangle};
use proptest::strategy::{Strategy, ValueTree};
use proptest::test_runner::TestRunner;
use raytrace::triangle::{
    Solution, System, TriangleHit, cramer, elimination, inverse, raytri, system, watertight,
};
use testkit::strategy;

const PAIRS: usize = 1000;

type Solver = fn(&System) -> Option<Solution>;
type Test = fn(&Ray, &Triangle, f32, f32) -> Option<TriangleHit>;

fn pairs() -> Vec<(Ray, Triangle)> {
    let mut runner = TestRunner::deterministic();
    let pair = strategy::triangle(5.0).prop_flat_map(|triangle| {
        let ray = proptest::prop_oneof![strategy::ray_at(triangle, 10.0), strategy::ray(10.0)];
        (ray, proptest::strategy::Just(triangle))
    });
    (0..PAIRS).map(|_| pair.new_tree(&mut runner).expect("a pair").current()).collect()
}

fn triangle(criterion: &mut Criterion) {
    let pairs = pairs();
    let mut group = criterion.benchmark_group("triangle, 1000 rays");
    group.sample_size(20).warm_up_time(Duration::from_millis(300)).measurement_time(Duration::from_secs(1));
    group.throughput(Throughput::Elements(PAIRS as u64));
    let solvers: [(&str, Solver); 3] =
        [("cramer", cramer), ("inverse", inverse), ("elimination", elimination)];
    for (name, solve) in solvers {
        group.bench_function(name, |bencher| {
            bencher.iter(|| {
                for (ray, triangle) in &pairs {
                    black_box(solve(&system(ray, triangle)));
                }
            });
        });
    }
    let tests: [(&str, Test); 2] = [("raytri", raytri), ("watertight", watertight)];
    for (name, test) in tests {
        group.bench_function(name, |bencher| {
            bencher.iter(|| {
                for (ray, triangle) in &pairs {
                    black_box(test(ray, triangle, 0.0, f32::INFINITY));
                }
            });
        });
    }
    group.finish();
}

criterion_group!(benches, triangle);
criterion_main!(benches);
