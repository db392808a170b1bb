//! How often is a pixel coloured before it has its final colour? (E16, L19)

use canvas::{Image, Rgb};
use sheet::Ink;
use sheet::plot::{Axis, Kind, Plot, Series};
use sheet::text::decimal;
use zbuffer::draw::{Work, z_buffer};
use zbuffer::{DepthBuffer, DepthFormat, ScreenTriangle};

use crate::figure::{Drawing, Drawn, Figure, Text, Words};
use crate::handle::without_handles;
use crate::on_screen;
use crate::parameter::{Parameter, Values};

pub(super) static FIGURE: Figure = Figure {
    numbers: &["E16", "L19"],
    name: "overdraw",
    title: Text { en: "Shading inside the z-buffer loop", nl: "Shading binnen de z-bufferlus" },
    caption: Text {
        en: "Layers over the whole screen, drawn in random order by the slide's loop. The k-th is the nearest so far with probability 1/k, so each pixel is coloured H_n = 1 + 1/2 + … + 1/n times on average: more than once, but far fewer than n times.",
        nl: "Lagen over het hele scherm, in willekeurige volgorde getekend door de lus van de slide. De k-de is met kans 1/k de dichtstbijzijnde tot dan toe; elke pixel wordt dus gemiddeld H_n = 1 + 1/2 + … + 1/n keer gekleurd: vaker dan eens, maar veel minder dan n keer.",
    },
    parameters: &[
        Parameter::count(
            "orders",
            Text { en: "random orders for each point", nl: "willekeurige volgordes per punt" },
            300.0,
            1.0,
            1000.0,
        ),
        Parameter::count(
            "seed",
            Text { en: "seed of the random numbers", nl: "zaad van de toevalsgetallen" },
            1.0,
            0.0,
            1000.0,
        ),
    ],
    size: (640, 480),
    draw,
    handles: without_handles,
};

/// All pixels see the same layers, so few are enough.
const SIDE: u32 = 2;
const MOST_LAYERS: u32 = 64;

fn draw(values: &Values) -> Drawn {
    let orders = values.count("orders");
    let mut random = Random(u64::from(values.count("seed")));
    let counts = [1, 2, 3, 4, 6, 8, 12, 16, 24, 32, 48, MOST_LAYERS];
    let measured: Vec<(f64, f64)> =
        counts.iter().map(|n| (f64::from(*n), mean_colored(*n, orders, &mut random))).collect();
    let harmonic = |n: u32| (1..=n).map(|k| 1.0 / f64::from(k)).sum::<f64>();
    let theory = (1..=MOST_LAYERS).map(|n| (f64::from(n), harmonic(n))).collect();
    let last = measured[measured.len() - 1].1;
    let plot = Plot {
        x: Axis::linear(Words::new("layers n", "lagen n")),
        y: Axis::linear(Words::new("colours computed for each pixel", "berekende kleuren per pixel")),
        series: vec![
            Series {
                name: Words::new("measured", "gemeten"),
                ink: Ink::A,
                points: measured,
                kind: Kind::Measured,
            },
            Series { name: "H_n".into(), ink: Ink::Main, points: theory, kind: Kind::Theory },
        ],
    };
    let (last, theory) = (decimal(last, 2), decimal(harmonic(MOST_LAYERS), 2));
    let alt = Words::new(
        format!(
            "With {MOST_LAYERS} layers each pixel is coloured {last} times on average; theory says {theory}."
        ),
        format!(
            "Met {MOST_LAYERS} lagen wordt elke pixel gemiddeld {last} keer gekleurd; de theorie zegt {theory}."
        ),
    );
    Ok(vec![Drawing::only(alt, |alt| plot.svg(alt))])
}

/// How many colours the loop computes for a pixel, over so many random orders of n layers.
fn mean_colored(n: u32, orders: u32, random: &mut Random) -> f64 {
    let mut layers: Vec<f32> = (0..n).map(|k| 1.0 - 2.0 * (k as f32 + 0.5) / n as f32).collect();
    let mut image = Image::new(SIDE, SIDE, Rgb::ZERO);
    let mut depth = DepthBuffer::new(SIDE, SIDE, DepthFormat::F32);
    let mut work = Work::default();
    for _ in 0..orders {
        random.shuffle(&mut layers);
        let polygons: Vec<_> = layers.iter().map(|z| (layer(*z), Rgb::ONE)).collect();
        work = work + z_buffer(Rgb::ZERO, &polygons, &mut image, &mut depth);
    }
    work.colored as f64 / (f64::from(orders) * f64::from(SIDE * SIDE))
}

/// A triangle of one depth that covers the screen.
fn layer(z: f32) -> ScreenTriangle {
    let reach = 3.0 * SIDE as f32;
    on_screen::triangle([[-1.0, -1.0, z], [reach, -1.0, z], [-1.0, reach, z]])
}

/// A linear congruential generator, Knuth's MMIX constants: good enough to shuffle some layers, and the same plot for the
/// same seed on every machine.
struct Random(u64);

impl Random {
    /// A number from 0 to `below` − 1. The high bits: the low ones repeat early.
    fn below(&mut self, below: usize) -> usize {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        ((self.0 >> 33) as usize) % below
    }

    /// Fisher and Yates: every order is equally likely.
    fn shuffle(&mut self, list: &mut [f32]) {
        for k in (1..list.len()).rev() {
            list.swap(k, self.below(k + 1));
        }
    }
}
