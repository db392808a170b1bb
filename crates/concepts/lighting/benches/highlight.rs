//! Is the halfway vector cheaper than the reflected one, as a slide says? (E5) And what is gained by lighting eight points at
//! once?
//!
//! `cargo bench -p lighting -- highlight` runs one question alone; the other is `eight`.

use std::hint::black_box;
use std::time::Duration;

use criterion::{Criterion, criterion_group, criterion_main};
use fearless_simd::{Level, Simd, SimdBase, dispatch, f32x8};
use glam::{Vec3, vec3};
use lighting::fast::{self, LANES, Points, Vectors};
use lighting::{
    Highlight, Illumination, Light, Material, SurfacePoint, blinn_highlight, blinn_phong, halfway, lit,
    phong, phong_highlight, reflect,
};

fn directions() -> Vec<(Vec3, Vec3)> {
    let at = |k: u32| {
        let (a, b) = (k as f32 * 0.37, k as f32 * 0.11);
        vec3(a.sin() * b.cos(), a.cos() * b.cos(), 1.1 + b.sin()).normalize()
    };
    (0..POINTS as u32).map(|k| (at(k), at(7 * k + 3))).collect()
}

fn forms(c: &mut Criterion) {
    let pairs = directions();
    let mut group = c.benchmark_group("highlight, 1000 of them");
    group.sample_size(20).measurement_time(Duration::from_secs(1)).warm_up_time(Duration::from_millis(300));
    let mut bench = |name: &str, f: &dyn Fn(Vec3, Vec3) -> f32| {
        group.bench_function(name, |b| {
            b.iter(|| pairs.iter().map(|(l, e)| f(black_box(*l), black_box(*e))).sum::<f32>());
        });
    };
    let n = Vec3::Z;
    bench("r alone: 2(n·l)n − l", &|l, _| reflect(n, l).x);
    bench("h alone: (e + l)/‖e + l‖", &|l, e| halfway(e, l).map_or(0.0, |h| h.x));
    bench("(e·r)^p", &|l, e| phong_highlight(n, l, e, 32.0));
    bench("(h·n)^4p", &|l, e| blinn_highlight(n, l, e, 128.0));
    let light = |to_light| Illumination { to_light, distance: 1.0, color: Vec3::ONE };
    let material = Material::new(vec3(0.7, 0.4, 0.1), 32.0);
    bench("Phong model", &|l, e| phong(&material, n, e, &light(l)).x);
    bench("Blinn–Phong model", &|l, e| blinn_phong(&material, n, e, &light(l)).x);
    group.finish();
}

const POINTS: usize = 1000;

/// The whole model under an ambient and a point light, point by point and eight at a time.
fn eight_at_once(c: &mut Criterion) {
    let material = Material::new(vec3(0.7, 0.4, 0.1), 32.0);
    let lights = [
        Light::Ambient { color: Vec3::splat(0.1) },
        Light::Point { position: vec3(2.0, 4.0, 3.0), color: Vec3::ONE },
    ];
    let eye = vec3(0.5, 0.2, 5.0);
    let (normals, points): (Vec<Vec3>, Vec<Vec3>) = directions().into_iter().unzip();
    let mut group = c.benchmark_group("eight");
    group.sample_size(20).measurement_time(Duration::from_secs(1)).warm_up_time(Duration::from_millis(300));
    group.bench_function("1000 points, one at a time", |b| {
        b.iter(|| {
            let color = |(p_world, n): (&Vec3, &Vec3)| {
                let at = SurfacePoint { p_world: *p_world, n: *n, to_eye: (eye - *p_world).normalize() };
                lit(&material, &lights, Highlight::Blinn, &at, |_| true).x
            };
            black_box(&points).iter().zip(&normals).map(color).sum::<f32>()
        });
    });
    let columns = |list: &[Vec3]| [0, 1, 2].map(|axis| list.iter().map(|v| v[axis]).collect::<Vec<f32>>());
    let (points, normals) = (columns(&points), columns(&normals));
    let level = Level::new();
    group.bench_function("1000 points, eight at a time", |b| {
        b.iter(
            || dispatch!(level, simd => reds(simd, black_box(&points), &normals, (&material, &lights, eye))),
        );
    });
    group.finish();
}

/// The sums of the red channels of all points, column by column of eight.
#[inline(always)]
fn reds<S: Simd>(
    simd: S,
    points: &[Vec<f32>; 3],
    normals: &[Vec<f32>; 3],
    (material, lights, eye): (&Material, &[Light], Vec3),
) -> [f32; LANES] {
    let mut sum = f32x8::splat(simd, 0.0);
    for first in (0..POINTS).step_by(LANES) {
        let [x, y, z] = points;
        let p_world = Vectors::load(simd, [&x[first..], &y[first..], &z[first..]]);
        let [x, y, z] = normals;
        let n = Vectors::load(simd, [&x[first..], &y[first..], &z[first..]]);
        let at = Points::seen_from(simd, eye, p_world, n);
        sum += fast::lit(simd, material, lights, Highlight::Blinn, &at, |_, _, _, facing| facing).x;
    }
    sum.into()
}

criterion_group!(benches, forms, eight_at_once);
criterion_main!(benches);
