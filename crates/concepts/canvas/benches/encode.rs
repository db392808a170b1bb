//! What do files cost, and what does their curve?
//!
//! `cargo bench -p canvas -- steps` runs one question alone; the others are `files` and `difference`.

use std::hint::black_box;
use std::time::Duration;

use canvas::{Format, Image, Rgb, codec, difference, srgb};
use criterion::measurement::WallTime;
use criterion::{BenchmarkGroup, Criterion, criterion_group, criterion_main};

const SIDE: u32 = 512;

fn group<'c>(criterion: &'c mut Criterion, question: &str) -> BenchmarkGroup<'c, WallTime> {
    let mut group = criterion.benchmark_group(format!("{question}, {SIDE} × {SIDE}"));
    group.sample_size(10).warm_up_time(Duration::from_millis(300)).measurement_time(Duration::from_secs(1));
    group
}

/// A picture as renderers make them: smooth parts, an edge, some noise.
fn picture(side: u32) -> Image {
    Image::from_fn(side, side, |i, j| {
        let (x, y) = (i as f32 / side as f32, j as f32 / side as f32);
        let grain = (i.wrapping_mul(2_654_435_761) ^ j.wrapping_mul(2_246_822_519)) >> 24;
        if (x - 0.4).hypot(y - 0.6) < 0.3 {
            Rgb::new(x, y * y, 0.3)
        } else {
            Rgb::splat(0.2 + grain as f32 * 1e-4)
        }
    })
}

/// Which format is written and read soonest?
fn files(c: &mut Criterion) {
    let image = picture(SIDE);
    let mut group = group(c, "files");
    for format in [Format::Png8, Format::Png16, Format::Exr] {
        let file = codec::encode(&image, format).unwrap();
        group.bench_function(format!("encode {format:?}"), |b| {
            b.iter(|| codec::encode(black_box(&image), format));
        });
        group.bench_function(format!("decode {format:?}"), |b| {
            b.iter(|| codec::decode(black_box(&file)));
        });
    }
    group.finish();
}

/// A power for each channel, or a table of where the 256 steps begin? (E8: this is where colours are clamped.)
fn steps(c: &mut Criterion) {
    let image = picture(SIDE);
    let curve = srgb::EightBitSteps::new();
    let channels = || image.pixels().iter().flat_map(|pixel| pixel.to_array());
    let mut group = group(c, "steps");
    group.bench_function("computed", |b| {
        b.iter(|| channels().map(|light| u32::from(srgb::to_u8(black_box(light)))).sum::<u32>());
    });
    group.bench_function("looked up", |b| {
        b.iter(|| channels().map(|light| u32::from(curve.nearest(black_box(light)))).sum::<u32>());
    });
    group.finish();
}

/// What does it take to say whether two pictures show the same?
fn compare(c: &mut Criterion) {
    let image = picture(SIDE);
    let dimmed = Image::from_fn(SIDE, SIDE, |i, j| 0.9 * image.get(i, j));
    let mut group = group(c, "difference");
    group.bench_function("of two pictures", |b| b.iter(|| difference(black_box(&image), &dimmed, 0.1)));
    group.finish();
}

criterion_group!(benches, files, steps, compare);
criterion_main!(benches);
