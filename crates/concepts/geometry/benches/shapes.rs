//! What do triangles cost, before anything is drawn? Saying where in one a point lies (L48), building a shape, reading a mesh.
//!
//! `cargo bench -p geometry -- barycentric` runs one question alone; the others are `shapes` and `obj`.

use std::fmt::Write;
use std::hint::black_box;
use std::time::Duration;

use criterion::measurement::WallTime;
use criterion::{BenchmarkGroup, Criterion, Throughput, criterion_group, criterion_main};
use geometry::shapes::{icosphere, teapot, uv_sphere};
use geometry::{Barycentric, Mesh, Triangle};
use glam::vec3;

fn group<'c>(criterion: &'c mut Criterion, question: &str) -> BenchmarkGroup<'c, WallTime> {
    let mut group = criterion.benchmark_group(question);
    group.sample_size(20).measurement_time(Duration::from_secs(1)).warm_up_time(Duration::from_millis(300));
    group
}

/// Is it dearer to find a point's weights than to find the point of given weights?
fn barycentric(criterion: &mut Criterion) {
    let triangle = Triangle::new(vec3(0.3, 0.1, 1.0), vec3(4.0, 0.5, 1.5), vec3(0.2, 8.0, 0.7));
    let weights = Barycentric::from_beta_gamma(0.25, 0.6);
    let p = triangle.point(weights);
    let mut group = group(criterion, "barycentric");
    group.bench_function("point of weights", |b| b.iter(|| black_box(&triangle).point(black_box(weights))));
    group.bench_function("weights of a point", |b| b.iter(|| black_box(&triangle).barycentric(black_box(p))));
    group.finish();
}

/// Which ball is built sooner? Time for each triangle, of about as many; and the teapot's patches beside them.
fn shapes(criterion: &mut Criterion) {
    let mut group = group(criterion, "shapes");
    for (name, shape, level) in
        [("uv_sphere", uv_sphere as fn(u32) -> _, 4), ("icosphere", icosphere, 4), ("teapot", teapot, 2)]
    {
        let triangles = shape(level).expect("small level").len();
        group.throughput(Throughput::Elements(triangles as u64));
        group
            .bench_function(format!("{name}, {triangles} triangles"), |b| b.iter(|| shape(black_box(level))));
    }
    group.finish();
}

/// How much longer does it take to read a mesh than to build it? And does a face with many dents cost more than a mesh of
/// as many triangles?
fn obj(criterion: &mut Criterion) {
    let mut group = group(criterion, "obj");
    let pot = teapot(2).expect("small level");
    let comb = comb_text(1000);
    group.bench_function("teapot built, 4032 triangles", |b| b.iter(|| teapot(black_box(2))));
    for (name, text) in
        [("teapot read, 4032 triangles", &obj_text(&pot)), ("comb read, 2000 triangles", &comb)]
    {
        let read =
            || geometry::obj::parse(black_box(text.as_bytes()), "bench.obj", &mut |_| Err(String::new()));
        group.bench_function(name, |b| b.iter(read));
    }
    group.finish();
}

fn obj_text(mesh: &Mesh) -> String {
    let mut text = String::new();
    let normals = mesh.normals().expect("every shape has normals");
    for p in mesh.positions() {
        writeln!(text, "v {} {} {}", p.x, p.y, p.z).expect("a String takes all");
    }
    for n in &normals.values {
        writeln!(text, "vn {} {} {}", n.x, n.y, n.z).expect("a String takes all");
    }
    for (p, n) in mesh.triangles().iter().zip(&normals.triangles) {
        let [a, b, c] = std::array::from_fn(|k| format!("{}//{}", p[k] + 1, n[k] + 1));
        writeln!(text, "f {a} {b} {c}").expect("a String takes all");
    }
    text
}

/// One face, concave between any two teeth.
fn comb_text(teeth: u32) -> String {
    let mut text = format!("v {teeth} -1 0\nv 0 -1 0\n");
    for k in 0..teeth {
        writeln!(text, "v {k} 0 0\nv {k}.5 7 0").expect("a String takes all");
    }
    let corners: Vec<String> = (1..=2 * teeth + 2).map(|k| k.to_string()).collect();
    text + "f " + &corners.join(" ") + "\n"
}

criterion_group!(benches, barycentric, shapes, obj);
criterion_main!(benches);
