//! Is the halfway vector cheaper than the reflected one, as a slide says? (E5)

use std::hint::black_box;
use std::time::Duration;

use criterion::{Criterion, criterion_group, criterion_main};
use glam::{Vec3, vec3};
use lighting::{
    Illumination, Material, blinn_highlight, blinn_phong, halfway, phong, phong_highlight, reflect,
};

fn directions() -> Vec<(Vec3, Vec3)> {
    let at = |k: u32| {
        let (a, b) = (k as f32 * 0.37, k as f32 * 0.11);
        vec3(a.sin() * b.cos(), a.cos() * b.cos(), 1.1 + b.sin()).normalize()
    };
    (0..1000).map(|k| (at(k), at(7 * k + 3))).collect()
}

fn forms(c: &mut Criterion) {
    let pairs = directions();
    let mut group = c.benchmark_group("1000 highlights");
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

criterion_group!(benches, forms);
criterion_main!(benches);
