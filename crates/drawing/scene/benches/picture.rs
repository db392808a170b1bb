//! How long does a whole picture take? And when does object order lose to image order (L21)?
//!
//! `cargo bench -p scene -- order` runs one question alone; the other is `renderers`.

use std::hint::black_box;
use std::time::Duration;

use criterion::{BenchmarkId, Criterion, criterion_group, criterion_main};
use scene::{Loaded, Named, Prepared, Renderer, Scene, Settings, Shape, builtin, prepare, render};

fn settings(renderer: Renderer, size: (u32, u32)) -> Settings {
    Settings { renderer, size, samples: 1, ..Settings::default() }
}

fn draw(prepared: &Prepared, settings: &Settings) -> f32 {
    let rendered = render(prepared, settings, &|_| ()).expect("a built-in scene");
    rendered.image.get(settings.size.0 / 2, settings.size.1 / 2).x
}

/// The teapot by all three renderers.
fn renderers(c: &mut Criterion) {
    let prepared = prepare(&builtin::all()[0].load().expect("built in")).expect("built in");
    let mut group = c.benchmark_group("renderers, teapot 320 × 240");
    for (name, renderer) in Renderer::ALL {
        let settings = settings(*renderer, (320, 240));
        draw(&prepared, &settings); // The hierarchy is built once, and not in this measurement.
        group.bench_function(*name, |b| b.iter(|| black_box(draw(&prepared, &settings))));
    }
    group.finish();
}

/// A ball of 20 · 4^level triangles: a rasterizer looks at each of them, a ray at a few boxes. In a small picture, where there
/// are more triangles than pixels before there are too many to wait for.
fn ball(level: u32) -> Loaded {
    let mut loaded = builtin::find("two-spheres").expect("built in").load().expect("built in");
    let scene: &mut Scene = &mut loaded.scene;
    scene.objects.truncate(1);
    scene.objects[0].shape = Shape::Icosphere { radius: 1.8, level };
    loaded
}

fn crossover(c: &mut Criterion) {
    let mut group = c.benchmark_group("order of objects or of the image, 20 × 15");
    for level in [1, 3, 5, 7] {
        let prepared = prepare(&ball(level)).expect("built in");
        for renderer in [Renderer::ZBuffer, Renderer::Raytrace] {
            let settings = settings(renderer, (20, 15));
            draw(&prepared, &settings);
            let id = BenchmarkId::new(renderer.name(), prepared.triangle_count());
            group.bench_function(id, |b| b.iter(|| black_box(draw(&prepared, &settings))));
        }
    }
    group.finish();
}

criterion_group! {
    name = benches;
    config = Criterion::default()
        .sample_size(10)
        .warm_up_time(Duration::from_millis(300))
        .measurement_time(Duration::from_secs(1));
    targets = renderers, crossover
}
criterion_main!(benches);
