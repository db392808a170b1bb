//! Painter's order against filling a depth buffer, as the number of triangles grows (L13, L16, L19).
//!
//! The triangles become smaller as they become more, so that they cover the same screen four times: filling it costs the
//! same, ordering grows.
//!
//! `cargo bench -p zbuffer -- painter`

use std::hint::black_box;
use std::time::Duration;

use criterion::{BenchmarkId, Criterion, criterion_group, criterion_main};
use geometry::{Barycentric, shapes};
use glam::{Mat3, Vec3, vec3};
use zbuffer::{ScreenTriangle, ScreenVertex, painter, rasterize_rows};

const WIDTH: u32 = 640;
const HEIGHT: u32 = 480;

fn on_screen(corners: [Vec3; 3]) -> ScreenTriangle {
    let weights = [Barycentric::A, Barycentric::B, Barycentric::C];
    let vertex =
        |k: usize| ScreenVertex { position: corners[k].as_dvec3(), inv_w: -1.0, weights: weights[k] };
    ScreenTriangle { vertices: [vertex(0), vertex(1), vertex(2)] }
}

/// Numbers from 0 to 1 that fill the interval evenly: the multiples of an irrational number.
fn spread(k: usize, irrational: f64) -> f32 {
    (k as f64 * irrational).fract() as f32
}

/// `count` triangles, scattered over screen and depth, each flat enough that there is an order.
fn scattered(count: usize) -> Vec<ScreenTriangle> {
    // Half of size² is a triangle's area.
    let size = (8.0 * (WIDTH * HEIGHT) as f32 / count as f32).sqrt();
    let triangle = |k: usize| {
        let x = WIDTH as f32 * spread(k, 0.618_033_988_7);
        let y = HEIGHT as f32 * spread(k, 0.754_877_666_2);
        let z = 1.8 * spread(k, 0.569_840_290_9) - 0.9;
        let reach = 0.1 / count as f32;
        on_screen([
            vec3(x, y, z),
            vec3(x + size, y + 0.2 * size, z + reach),
            vec3(x - 0.1 * size, y + size, z),
        ])
    };
    (0..count).map(triangle).collect()
}

/// A mesh as it comes out of a file, 25,600 triangles: two tori and a ball, one behind the other, back sides included.
fn mesh() -> Vec<ScreenTriangle> {
    let turn = Mat3::from_rotation_x(0.9) * Mat3::from_rotation_y(0.4);
    let parts = [
        (shapes::torus(1.0, 0.45, 4), vec3(319.5, 239.5, 0.0), 150.0),
        (shapes::torus(1.0, 0.3, 3), vec3(409.5, 300.5, 0.8), 90.0),
        (shapes::icosphere(4), vec3(250.5, 200.5, -0.8), 120.0),
    ];
    let mut triangles = Vec::new();
    for (shape, place, size) in parts {
        let shape = shape.expect("a small level");
        let corner = |p: Vec3| place + size * vec3(1.0, 1.0, 0.002) * (turn * p);
        triangles.extend((0..shape.len()).map(|k| on_screen(shape.triangle(k).corners().map(corner))));
    }
    triangles
}

fn fill(triangles: &[ScreenTriangle], depth: &mut [f32]) {
    depth.fill(f32::NEG_INFINITY);
    for triangle in triangles {
        rasterize_rows(triangle, WIDTH, 0..HEIGHT, |fragment| {
            let pixel = &mut depth[(fragment.j * WIDTH + fragment.i) as usize];
            *pixel = pixel.max(fragment.z as f32);
        });
    }
}

fn painter_against_depth_buffer(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("painter against depth buffer");
    group.sample_size(20).measurement_time(Duration::from_secs(1)).warm_up_time(Duration::from_millis(300));
    let mut depth = vec![0.0; (WIDTH * HEIGHT) as usize];
    let scattered = [100, 1_000, 10_000].map(|count| (format!("{count} scattered"), scattered(count)));
    let mesh = mesh();
    let mesh = (format!("{} of a mesh", mesh.len()), mesh);
    for (name, triangles) in scattered.into_iter().chain([mesh]) {
        assert!(painter::order(&triangles).is_ok(), "{name}: a search that ends at a cycle measures nothing");
        group.bench_with_input(BenchmarkId::new("order", &name), &triangles, |bencher, triangles| {
            bencher.iter(|| painter::order(black_box(triangles)));
        });
        group.bench_with_input(BenchmarkId::new("depth buffer", &name), &triangles, |bencher, triangles| {
            bencher.iter(|| fill(black_box(triangles), &mut depth));
        });
    }
    group.finish();
}

criterion_group!(benches, painter_against_depth_buffer);
criterion_main!(benches);
