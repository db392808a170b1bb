//! How long does it take to make a mesh, and to read one?

use std::fmt::Write;
use std::hint::black_box;
use std::time::Duration;

use criterion::{BenchmarkId, Criterion, Throughput, criterion_group, criterion_main};
use geometry::Mesh;
use geometry::shapes::{icosphere, teapot, uv_sphere};

/// Building a shape: four times the work with each level.
fn build(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("build");
    group.sample_size(20).measurement_time(Duration::from_secs(2)).warm_up_time(Duration::from_millis(300));
    for level in [1, 3, 5] {
        for (name, shape) in
            [("uv_sphere", uv_sphere as fn(u32) -> _), ("icosphere", icosphere), ("teapot", teapot)]
        {
            let triangles = shape(level).expect("small level").len();
            group.throughput(Throughput::Elements(triangles as u64));
            group.bench_function(BenchmarkId::new(name, level), |b| {
                b.iter(|| shape(black_box(level)));
            });
        }
    }
}

/// Reading OBJ text: many triangles, and one large concave face.
fn parse_obj(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("parse_obj");
    group.sample_size(20).measurement_time(Duration::from_secs(2)).warm_up_time(Duration::from_millis(300));
    let pot = obj_text(&teapot(3).expect("small level"));
    let comb = comb_text(1000);
    for (name, text) in [("teapot, 16256 triangles", &pot), ("a comb of 1000 teeth in one face", &comb)] {
        group.throughput(Throughput::Bytes(text.len() as u64));
        let read =
            || geometry::obj::parse(black_box(text.as_bytes()), "bench.obj", &mut |_| Err(String::new()));
        group.bench_function(name, |b| b.iter(read));
    }
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

criterion_group!(benches, build, parse_obj);
criterion_main!(benches);
