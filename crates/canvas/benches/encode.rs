//! How long does a picture take to become a file, and back?

use std::hint::black_box;
use std::time::Duration;

use canvas::{Format, Image, Rgb, codec, difference, srgb};
use criterion::{Criterion, criterion_group, criterion_main};

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

fn files(c: &mut Criterion) {
    let image = picture(1024);
    let mut group = c.benchmark_group("1024x1024");
    group.sample_size(20).warm_up_time(Duration::from_millis(500)).measurement_time(Duration::from_secs(2));
    for format in [Format::Png8, Format::Png16, Format::Exr] {
        let file = codec::encode(&image, format).unwrap();
        group.bench_function(format!("encode {format:?}"), |b| {
            b.iter(|| codec::encode(black_box(&image), format));
        });
        group.bench_function(format!("decode {format:?}"), |b| {
            b.iter(|| codec::decode(black_box(&file)));
        });
    }
    let curve = srgb::EightBitSteps::new();
    let channels = || image.pixels().iter().flat_map(|pixel| pixel.to_array());
    group.bench_function("8-bit steps computed", |b| {
        b.iter(|| channels().map(|light| u32::from(srgb::to_u8(black_box(light)))).sum::<u32>());
    });
    group.bench_function("8-bit steps looked up", |b| {
        b.iter(|| channels().map(|light| u32::from(curve.nearest(black_box(light)))).sum::<u32>());
    });
    let dimmed = Image::from_fn(1024, 1024, |i, j| 0.9 * image.get(i, j));
    group.bench_function("difference", |b| {
        b.iter(|| difference(black_box(&image), &dimmed, 0.1));
    });
    group.finish();
}

criterion_group!(benches, files);
criterion_main!(benches);
