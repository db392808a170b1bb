//! What does a triangle cost, before its pixels and for each of them? And a whole frame of them?
//!
//! `cargo bench -p zbuffer -- triangle` runs one question alone; the others are `project`, `layers` and `frame`, and
//! `painter` (L13, L16).

use std::hint::black_box;
use std::time::Duration;

use canvas::{Image, Rgb};
use criterion::{BenchmarkId, Criterion, Throughput, criterion_group, criterion_main};
use geometry::shapes::torus;
use geometry::{Barycentric, Triangle};
use glam::{Mat4, Vec3, vec3};
use transforms::{Camera, Pipeline, ViewVolume};
use zbuffer::draw::{draw, draw_fast};
use zbuffer::fast::{Band, Faces, MeshInstance, Projected};
use zbuffer::{
    DepthBuffer, DepthFormat, Fragment, ScreenTriangle, ScreenVertex, project, rasterize, rasterize_rows,
};

const SIDE: u32 = 1024;

fn triangle(corners: [Vec3; 3]) -> ScreenTriangle {
    let weights = [Barycentric::A, Barycentric::B, Barycentric::C];
    let vertex = |k: usize| ScreenVertex {
        position: corners[k].as_dvec3(),
        inv_w: -0.1 - 0.2 * k as f32,
        weights: weights[k],
    };
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
    *total += f.z as f32 + f.weights.beta;
}

fn fill(c: &mut Criterion) {
    let mut group = c.benchmark_group("triangle");
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
    let mut group = c.benchmark_group("layers, 8 large ones");
    for format in [DepthFormat::F32, DepthFormat::Bits16] {
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
    let z = 0.5 * vertex.position.z - 0.05 * f64::from(layer);
    ScreenVertex { position: vertex.position.with_z(z), ..vertex }
}

/// Which triangle is the nearest in each pixel? The slide's loop, by rows, and by bands with blocks of pixels; on one thread.
fn frame(c: &mut Criterion) {
    let mesh = torus(1.6, 0.7, 5).expect("a level in range");
    let camera = Camera::look_at(vec3(1.0, 3.0, 4.0), Vec3::ZERO, Vec3::Y).expect("a fixed camera");
    let volume = ViewVolume::from_fov_y(0.9, 1.0, -1.0, -20.0).expect("a valid volume");
    let pipeline = Pipeline::new(camera, volume, SIDE, SIDE).expect("a valid pipeline");
    let clip_from_world = pipeline.clip_from_world();
    let mut depth = DepthBuffer::new(SIDE, SIDE, DepthFormat::F32);
    let mut numbers = vec![usize::MAX; (SIDE * SIDE) as usize];
    let mut group = c.benchmark_group(format!("frame, {} triangles, {SIDE} × {SIDE}", mesh.len()));
    group.sample_size(10).measurement_time(Duration::from_secs(1));
    for (name, by_rows) in [("slide", false), ("rows", true)] {
        group.bench_function(name, |b| {
            b.iter(|| {
                depth.clear();
                for k in 0..mesh.len() {
                    let mut test = |f: Fragment| {
                        if depth.test_and_set(f.i, f.j, f.z) {
                            numbers[(f.j * SIDE + f.i) as usize] = k;
                        }
                    };
                    for triangle in project(&clip_from_world, SIDE, SIDE, &mesh.triangle(k)).triangles() {
                        if by_rows {
                            rasterize_rows(&triangle, SIDE, 0..SIDE, &mut test);
                        } else {
                            rasterize(&triangle, SIDE, SIDE, &mut test);
                        }
                    }
                }
            });
        });
    }
    let parts = [MeshInstance { mesh: &mesh, world_from_object: Mat4::IDENTITY }];
    let (mut projected, mut band) = (Projected::default(), Band::default());
    let one_thread = rayon::ThreadPoolBuilder::new().num_threads(1).build().expect("a thread");
    for (name, faces) in [("fast", Faces::Both), ("fast, fronts only", Faces::Front)] {
        let mut draw = || {
            projected.project(black_box(&parts), &pipeline, faces);
            (0..projected.bands()).for_each(|b| band.draw(b, &projected, &parts));
        };
        group.bench_function(name, |b| one_thread.install(|| b.iter(&mut draw)));
    }
    group.finish();
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
    targets = fill, clip, z_buffer, frame
}
criterion_main!(benches);
