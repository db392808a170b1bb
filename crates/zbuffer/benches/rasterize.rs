//! What does a triangle cost, before its pixels and for each of them?

use std::hint::black_box;
use std::time::Duration;

use canvas::{Image, Rgb};
use criterion::{BenchmarkId, Criterion, Throughput, criterion_group, criterion_main};
use geometry::{Barycentric, Triangle};
use glam::{Vec3, vec3};
use transforms::{Camera, Pipeline, ViewVolume};
use zbuffer::draw::{draw, draw_fast};
use zbuffer::{
    DepthBuffer, DepthFormat, Fragment, ScreenTriangle, ScreenVertex, project, rasterize, rasterize_rows,
};

const SIDE: u32 = 1024;

fn triangle(corners: [Vec3; 3]) -> ScreenTriangle {
    let weights = [Barycentric::A, Barycentric::B, Barycentric::C];
    let vertex =
        |k: usize| ScreenVertex { position: corners[k], inv_w: -0.1 - 0.2 * k as f32, weights: weights[k] };
    ScreenTriangle { vertices: [0, 1, 2].map(vertex) }
}

/// Four shapes: of a fine mesh, of a coarse one, of a wall, and a sliver across the screen whose bounding box is almost empty.
fn shapes() -> [(&'static str, ScreenTriangle); 4] {
    [
        ("small", triangle([vec3(10.3, 20.1, 0.2), vec3(14.9, 21.7, 0.3), vec3(12.2, 25.4, 0.1)])),
        ("medium", triangle([vec3(100.3, 20.1, 0.2), vec3(164.9, 41.7, 0.3), vec3(112.2, 95.4, 0.1)])),
        ("large", triangle([vec3(-100.0, 3.0, 0.2), vec3(1300.0, 150.0, 0.9), vec3(300.0, 1400.0, -0.5)])),
        ("sliver", triangle([vec3(3.0, 3.0, 0.2), vec3(1020.0, 990.0, 0.3), vec3(1020.0, 993.0, 0.1)])),
    ]
}

fn sum(total: &mut f32, f: Fragment) {
    *total += f.z + f.weights.beta;
}

fn fill(c: &mut Criterion) {
    let mut group = c.benchmark_group("set-up and fill");
    for (name, triangle) in shapes() {
        let mut pixels = 0;
        rasterize(&triangle, SIDE, SIDE, |_| pixels += 1);
        group.throughput(Throughput::Elements(pixels));
        group.bench_function(BenchmarkId::new("slide", name), |b| {
            b.iter(|| {
                let mut total = 0.0;
                rasterize(black_box(&triangle), SIDE, SIDE, |f| sum(&mut total, f));
                total
            });
        });
        group.bench_function(BenchmarkId::new("rows", name), |b| {
            b.iter(|| {
                let mut total = 0.0;
                rasterize_rows(black_box(&triangle), SIDE, 0..SIDE, |f| sum(&mut total, f));
                total
            });
        });
    }
    group.finish();
}

fn clip(c: &mut Criterion) {
    let camera = Camera::look_at(Vec3::ZERO, vec3(0.0, 0.0, -1.0), Vec3::Y).expect("a fixed camera");
    let volume = ViewVolume { left: -1.0, right: 1.0, bottom: -1.0, top: 1.0, near: -1.0, far: -50.0 };
    let clip_from_world =
        Pipeline::new(camera, volume, SIDE, SIDE).expect("a valid volume").clip_from_world();
    let mut group = c.benchmark_group("project");
    let inside = Triangle::new(vec3(-1.0, -2.0, -5.0), vec3(3.0, -1.0, -8.0), vec3(0.5, 3.0, -6.0));
    let through_the_eye = Triangle::new(vec3(-1.0, -2.0, 5.0), vec3(3.0, -1.0, -8.0), vec3(0.5, 3.0, -60.0));
    for (name, triangle) in [("inside", inside), ("cut at near and far", through_the_eye)] {
        group.bench_function(name, |b| {
            b.iter(|| project(&clip_from_world, SIDE, SIDE, black_box(&triangle)));
        });
    }
    group.finish();
}

fn z_buffer(c: &mut Criterion) {
    let (_, front) = shapes()[2];
    // Front to back colours each pixel once, back to front eight times: the two extremes.
    let layers: Vec<_> =
        (0..8).map(|k| ScreenTriangle { vertices: front.vertices.map(|v| moved_away(v, k)) }).collect();
    let mut group = c.benchmark_group("z-buffer, 8 large layers");
    for format in [DepthFormat::F32, DepthFormat::Bits24, DepthFormat::Bits16] {
        let mut image = Image::new(SIDE, SIDE, Rgb::ZERO);
        let mut depth = DepthBuffer::new(SIDE, SIDE, format);
        let color = |f: &Fragment| f.weights.to_vec3();
        let mut run = |name: &str, order: &mut dyn Iterator<Item = &ScreenTriangle>, fast: bool| {
            let order: Vec<_> = order.collect();
            group.bench_function(BenchmarkId::new(name, format!("{format:?}")), |b| {
                b.iter(|| {
                    depth.clear();
                    for triangle in &order {
                        if fast {
                            draw_fast(triangle, color, &mut image, &mut depth);
                        } else {
                            draw(triangle, color, &mut image, &mut depth);
                        }
                    }
                });
            });
        };
        run("slide, front to back", &mut layers.iter(), false);
        run("rows, front to back", &mut layers.iter(), true);
        run("rows, back to front", &mut layers.iter().rev(), true);
    }
    group.finish();
}

fn moved_away(vertex: ScreenVertex, layer: u16) -> ScreenVertex {
    let z = 0.5 * vertex.position.z - 0.05 * f32::from(layer);
    ScreenVertex { position: vertex.position.with_z(z), ..vertex }
}

fn quick() -> Criterion {
    Criterion::default()
        .sample_size(20)
        .warm_up_time(Duration::from_millis(200))
        .measurement_time(Duration::from_millis(600))
}

criterion_group! {
    name = benches;
    config = quick();
    targets = fill, clip, z_buffer
}
criterion_main!(benches);
