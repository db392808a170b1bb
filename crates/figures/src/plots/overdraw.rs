//! How often is a pixel shaded if shading stands inside the z-buffer's loop? (E16, L16, L19)

use canvas::{Image, Rgb};
use geometry::Barycentric;
use glam::{Vec3, vec3};
use zbuffer::draw::z_buffer;
use zbuffer::{DepthBuffer, DepthFormat, ScreenTriangle, ScreenVertex};

use crate::figure::{Drawing, Drawn, Figure, Text, Words};
use crate::parameter::{Parameter, Values};
use crate::sheet::Ink;
use crate::sheet::plot::{Axis, Plot, Series};

pub(super) static FIGURE: Figure = Figure {
    numbers: &["E16", "L16", "L21"],
    name: "overdraw",
    title: Text { en: "Overdraw against number of layers", nl: "Overdraw tegen aantal lagen" },
    caption: Text {
        en: "How many colours the slide's loop computes for a pixel that n layers cover. From front to back one; from back to front n; in random order Hₙ = 1 + 1/2 + … + 1/n on average (dashed), since layer k is shaded only if it is the nearest of the first k.",
        nl: "Hoeveel kleuren de lus van de slide berekent voor een pixel met n lagen. Van voor naar achter één; van achter naar voor n; in willekeurige volgorde gemiddeld Hₙ = 1 + 1/2 + … + 1/n (gestreept), want laag k wordt alleen berekend als hij de dichtstbijzijnde van de eerste k is.",
    },
    parameters: &[Parameter::count(
        "layers",
        Text { en: "most layers", nl: "meeste lagen" },
        24.0,
        2.0,
        64.0,
    )],
    size: (640, 480),
    draw,
};

/// The screen is small: every pixel of it tells the same.
const SIDE: u32 = 4;

/// Random orders for each number of layers: the mean is then known to about a tenth.
const ORDERS: u32 = 400;

fn draw(values: &Values) -> Drawn {
    let most = values.count("layers");
    let counts: Vec<u32> = (1..=most).collect();
    let series = |name: Words, ink, is_theory, mean: &mut dyn FnMut(u32) -> f64| {
        let points = counts.iter().map(|n| (f64::from(*n), mean(*n))).collect();
        Series { name, ink, points, is_theory }
    };
    let mut random = Random(1);
    let plot = Plot {
        x: Axis::linear(Words::new("layers n", "lagen n")),
        y: Axis::linear(Words::new("colours computed per pixel", "berekende kleuren per pixel")),
        series: vec![
            series(Words::new("front to back", "voor naar achter"), Ink::C, false, &mut |n| {
                shaded(&from_front(n))
            }),
            series(Words::new("random", "willekeurig"), Ink::A, false, &mut |n| {
                mean_of_random_orders(n, &mut random)
            }),
            series("Hₙ".into(), Ink::Main, true, &mut |n| (1..=n).map(|k| 1.0 / f64::from(k)).sum()),
            series(Words::new("back to front", "achter naar voor"), Ink::B, false, &mut |n| {
                shaded(&from_front(n).into_iter().rev().collect::<Vec<_>>())
            }),
        ],
    };
    let last = |k: usize| plot.series[k].points.last().map_or(0.0, |point| point.1);
    let alt = Words::new(
        format!(
            "With {most} layers a pixel is shaded {:.0} time from front to back, {:.2} times in random order (theory {:.2}), {:.0} times from back to front.",
            last(0),
            last(1),
            last(2),
            last(3)
        ),
        format!(
            "Met {most} lagen wordt een pixel {:.0} keer berekend van voor naar achter, {:.2} keer in willekeurige volgorde (theorie {:.2}), {:.0} keer van achter naar voor.",
            last(0),
            last(1),
            last(2),
            last(3)
        ),
    );
    Ok(vec![Drawing::diagram("", alt.clone(), plot.svg(&alt))])
}

/// Depths of n layers, the nearest first.
fn from_front(n: u32) -> Vec<f32> {
    (0..n).map(|k| 1.0 - 2.0 * (k as f32 + 0.5) / n as f32).collect()
}

fn mean_of_random_orders(n: u32, random: &mut Random) -> f64 {
    let mut depths = from_front(n);
    let sum: f64 = (0..ORDERS)
        .map(|_| {
            random.shuffle(&mut depths);
            shaded(&depths)
        })
        .sum();
    sum / f64::from(ORDERS)
}

/// Colours per pixel, counted by the z-buffer of the slide.
fn shaded(depths: &[f32]) -> f64 {
    let polygons: Vec<(ScreenTriangle, Rgb)> = depths.iter().map(|z| (cover(*z), Rgb::ONE)).collect();
    let mut image = Image::new(SIDE, SIDE, Rgb::ZERO);
    let mut depth = DepthBuffer::new(SIDE, SIDE, DepthFormat::F32);
    let work = z_buffer(Rgb::ZERO, &polygons, &mut image, &mut depth);
    work.colored as f64 / f64::from(SIDE * SIDE)
}

/// A triangle of one depth that covers the screen.
fn cover(z: f32) -> ScreenTriangle {
    let corners = [vec3(-1.0, -1.0, z), vec3(20.0, -1.0, z), vec3(-1.0, 20.0, z)];
    let vertex = |position: Vec3| ScreenVertex { position, inv_w: -1.0, weights: Barycentric::A };
    ScreenTriangle { vertices: corners.map(vertex) }
}

/// A sequence that looks random and is the same every time (splitmix64), so that the figure is.
struct Random(u64);

impl Random {
    fn below(&mut self, bound: usize) -> usize {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        ((z ^ (z >> 31)) % bound as u64) as usize
    }

    /// Every order is equally likely (Fisher and Yates).
    fn shuffle<T>(&mut self, items: &mut [T]) {
        for last in (1..items.len()).rev() {
            let other = self.below(last + 1);
            items.swap(last, other);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_mean_of_random_orders_is_the_harmonic_number() {
        let harmonic: f64 = (1..=12).map(|k| 1.0 / f64::from(k)).sum();
        // The variance of the count is H_12 − Σ 1/k² = 1.54; the mean of 400 has a deviation of 0.062. Four of them.
        assert!((mean_of_random_orders(12, &mut Random(3)) - harmonic).abs() < 0.25);
        assert_eq!(shaded(&from_front(12)), 1.0);
    }
}
