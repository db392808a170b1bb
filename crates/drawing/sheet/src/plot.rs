//! How do measured numbers look? As lines over two axes, each named at its end.

use glam::{Vec2, vec2};

use crate::text::decimal;
use crate::{Ink, LETTER, Letters, Sheet, Side, Words};

/// One axis of a plot.
#[derive(Clone, Debug)]
pub struct Axis {
    /// What is measured, with its unit.
    pub label: Words,
    /// Whether equal steps are equal factors.
    pub logarithmic: bool,
    /// The lower end that must be seen; the data widen it.
    pub least: Option<f64>,
    /// The upper end that must be seen; the data widen it.
    pub greatest: Option<f64>,
}

impl Axis {
    /// Equal steps are equal differences, from 0.
    pub fn linear(label: impl Into<Words>) -> Self {
        Self { label: label.into(), logarithmic: false, least: Some(0.0), greatest: None }
    }

    /// Equal steps are equal factors.
    pub fn logarithmic(label: impl Into<Words>) -> Self {
        Self { label: label.into(), logarithmic: true, least: None, greatest: None }
    }
}

/// Points that belong together.
#[derive(Clone, Debug)]
pub struct Series {
    /// What it is called.
    pub name: Words,
    /// Its colour.
    pub ink: Ink,
    /// Its points, (x, y), in the order in which the line runs.
    pub points: Vec<(f64, f64)>,
    /// How it is drawn.
    pub kind: Kind,
}

/// How a series is drawn.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// A measurement: a line, with dots where it was taken unless they are many.
    Measured,
    /// A law: a dashed line.
    Theory,
    /// Single places: dots alone.
    Places,
}

/// A plot in the making.
#[derive(Clone, Debug)]
pub struct Plot {
    /// To the right.
    pub x: Axis,
    /// Upwards.
    pub y: Axis,
    /// What is plotted.
    pub series: Vec<Series>,
}

const WIDTH: f32 = 780.0;
const HEIGHT: f32 = 460.0;
/// Room around the axes, in pixels: for numbers at the left, names of the series at the right.
const LEFT: f32 = 84.0;
const RIGHT: f32 = 190.0;
const TOP: f32 = 44.0;
const BOTTOM: f32 = 62.0;
/// The height of the numbers at the axes.
const SMALL: f32 = 15.0;
/// On fewer decades than this 2 and 5 are marked as well.
const FEW_DECADES: f64 = 2.5;
/// More dots than this are a smear.
const MOST_DOTS: usize = 24;

impl Plot {
    /// Width and height of every plot, in pixels.
    pub const SIZE: Vec2 = vec2(WIDTH, HEIGHT);

    /// Where a point (x, y) lies: the shares of the plot's width and of its height from the top left corner.
    ///
    /// # Panics
    /// As [`Plot::svg`].
    pub fn share(&self, (p_x, p_y): (f64, f64)) -> Vec2 {
        let (x, y) = self.scales();
        Self::sheet().share(vec2(x.at(p_x), y.at(p_y)))
    }

    /// Plane coordinates are pixels.
    fn sheet() -> Sheet {
        Sheet::new(Vec2::ZERO, Self::SIZE, WIDTH)
    }

    fn scales(&self) -> (Scale, Scale) {
        let points = || self.series.iter().flat_map(|series| &series.points);
        let x = Scale::of(&self.x, points().map(|p| p.0), LEFT, WIDTH - RIGHT);
        let y = Scale::of(&self.y, points().map(|p| p.1), BOTTOM, HEIGHT - TOP);
        (x, y)
    }

    /// The text of an SVG file. `alt` is what it says to somebody who cannot see it.
    ///
    /// # Panics
    /// If there is no point to plot: a plot of nothing is a mistake of the figure.
    pub fn svg(&self, alt: &Words) -> String {
        let (x, y) = self.scales();
        let mut sheet = Self::sheet();
        self.draw_axes(&mut sheet, &x, &y);
        for series in &self.series {
            let points: Vec<Vec2> = series.points.iter().map(|p| vec2(x.at(p.0), y.at(p.1))).collect();
            let pen = series.ink.pen();
            match series.kind {
                Kind::Measured => sheet.path(&points, pen),
                Kind::Theory => sheet.path(&points, pen.dashed()),
                Kind::Places => {}
            }
            if series.kind == Kind::Places || (series.kind == Kind::Measured && points.len() <= MOST_DOTS) {
                for p in &points {
                    sheet.dot(*p, series.ink);
                }
            }
        }
        self.name_series(&mut sheet, &x, &y);
        sheet.svg(alt)
    }

    fn draw_axes(&self, sheet: &mut Sheet, x: &Scale, y: &Scale) {
        for (value, text) in x.ticks() {
            let at = x.at(value);
            sheet.line(vec2(at, BOTTOM), vec2(at, HEIGHT - TOP), Ink::Faint.pen().fine());
            sheet.label_sized(vec2(at, BOTTOM), Side::Below, text, Letters::Plain, Ink::Main, SMALL);
        }
        for (value, text) in y.ticks() {
            let at = y.at(value);
            sheet.line(vec2(LEFT, at), vec2(WIDTH - RIGHT, at), Ink::Faint.pen().fine());
            sheet.label_sized(vec2(LEFT, at), Side::Left, text, Letters::Plain, Ink::Main, SMALL);
        }
        let pen = Ink::Main.pen();
        sheet.path(&[vec2(LEFT, HEIGHT - TOP), vec2(LEFT, BOTTOM), vec2(WIDTH - RIGHT, BOTTOM)], pen);
        let middle = 0.5 * (LEFT + WIDTH - RIGHT);
        sheet.label_sized(
            vec2(middle, 8.0),
            Side::Above,
            self.x.label.clone(),
            Letters::Plain,
            Ink::Main,
            SMALL + 1.0,
        );
        let top = vec2(14.0, HEIGHT - TOP + 12.0);
        sheet.label_sized(
            top,
            Side::AboveRight,
            self.y.label.clone(),
            Letters::Plain,
            Ink::Main,
            SMALL + 1.0,
        );
    }

    /// Each name at the end of its line, pushed apart where they would overlap.
    fn name_series(&self, sheet: &mut Sheet, x: &Scale, y: &Scale) {
        let last = |s: &Series| s.points.last().map(|p| vec2(x.at(p.0), y.at(p.1)));
        let mut ends: Vec<(&Series, Vec2)> = self.series.iter().filter_map(|s| Some((s, last(s)?))).collect();
        ends.sort_by(|a, b| a.1.y.total_cmp(&b.1.y));
        let mut lowest = f32::NEG_INFINITY;
        for (series, end) in ends {
            let height = end.y.max(lowest);
            lowest = height + 1.25 * LETTER;
            let place = vec2(WIDTH - RIGHT, height);
            sheet.label_sized(place, Side::Right, series.name.clone(), Letters::Plain, series.ink, SMALL);
        }
    }
}

/// From values to places on the sheet.
struct Scale {
    logarithmic: bool,
    least: f64,
    greatest: f64,
    from: f32,
    to: f32,
}

impl Scale {
    fn of(axis: &Axis, values: impl Iterator<Item = f64>, from: f32, to: f32) -> Self {
        let usable = values.filter(|v| v.is_finite() && (!axis.logarithmic || *v > 0.0));
        let ends = usable.chain(axis.least).chain(axis.greatest);
        let (least, greatest) =
            ends.fold((f64::INFINITY, f64::NEG_INFINITY), |(a, b), v| (a.min(v), b.max(v)));
        assert!(least <= greatest, "a plot needs a point");
        let mut scale = Self { logarithmic: axis.logarithmic, least, greatest, from, to };
        if axis.logarithmic {
            scale.least = least / 1.15;
            scale.greatest = greatest * 1.15;
        } else if greatest > least {
            scale.greatest = greatest + 0.04 * (greatest - least);
        } else {
            scale.greatest = least + 1.0;
        }
        scale
    }

    fn at(&self, value: f64) -> f32 {
        let share = if self.logarithmic {
            (value.max(self.least) / self.least).ln() / (self.greatest / self.least).ln()
        } else {
            (value - self.least) / (self.greatest - self.least)
        };
        self.from + share as f32 * (self.to - self.from)
    }

    /// Round values between the ends, with their texts.
    fn ticks(&self) -> Vec<(f64, String)> {
        if self.logarithmic { self.decades() } else { self.steps() }
    }

    fn steps(&self) -> Vec<(f64, String)> {
        let rough = (self.greatest - self.least) / 5.0;
        let power = 10_f64.powf(rough.log10().floor());
        let step =
            [1.0, 2.0, 5.0, 10.0].map(|m| m * power).into_iter().find(|step| *step >= rough).unwrap_or(rough);
        let (first, last) = ((self.least / step).ceil() as i64, (self.greatest / step).floor() as i64);
        (first..=last).map(|k| k as f64 * step).map(|v| (v, plain(v, step))).collect()
    }

    fn decades(&self) -> Vec<(f64, String)> {
        let (first, last) = (self.least.log10().floor() as i32, self.greatest.log10().ceil() as i32);
        let few = (self.greatest / self.least).log10() < FEW_DECADES;
        let multiples: &[f64] = if few { &[1.0, 2.0, 5.0] } else { &[1.0] };
        let skip = ((last - first) / 7).max(0) + 1;
        let all = (first..=last).filter(|e| e.rem_euclid(skip) == 0);
        let all = all.flat_map(|e| multiples.iter().map(move |m| (m * 10_f64.powi(e), *m, e)));
        let inside = all.filter(|(v, ..)| (self.least..=self.greatest).contains(v));
        inside.map(|(v, m, e)| (v, power_of_ten(v, m, e))).collect()
    }
}

fn plain(value: f64, step: f64) -> String {
    decimal(value, (-step.log10().floor()).max(0.0) as usize)
}

/// 0.01 to 10,000 are written out; others as powers.
fn power_of_ten(value: f64, multiple: f64, exponent: i32) -> String {
    if (-2..=4).contains(&exponent) {
        return plain(value, 10_f64.powi(exponent));
    }
    let digits = ['⁰', '¹', '²', '³', '⁴', '⁵', '⁶', '⁷', '⁸', '⁹'];
    let sign = if exponent < 0 { "⁻" } else { "" };
    let raised: String =
        exponent.abs().to_string().bytes().map(|digit| digits[usize::from(digit - b'0')]).collect();
    let multiple = if multiple == 1.0 { String::new() } else { format!("{multiple}·") };
    format!("{multiple}10{sign}{raised}")
}

#[cfg(test)]
mod tests {
    use super::*;

    fn scale(logarithmic: bool, values: &[f64]) -> Scale {
        let axis = Axis { logarithmic, ..Axis::logarithmic("x") };
        Scale::of(&axis, values.iter().copied(), 0.0, 100.0)
    }

    #[test]
    fn ticks_are_round_and_inside() {
        let texts = |scale: &Scale| scale.ticks().into_iter().map(|tick| tick.1).collect::<Vec<_>>();
        assert_eq!(texts(&scale(false, &[0.0, 9.0])), ["0", "2", "4", "6", "8"]);
        assert_eq!(texts(&scale(true, &[1.0, 100.0])), ["1", "2", "5", "10", "20", "50", "100"]);
        assert_eq!(texts(&scale(true, &[1e-6, 1e-2])), ["10⁻⁶", "10⁻⁵", "10⁻⁴", "10⁻³", "0.01"]);
    }

    #[test]
    fn equal_factors_are_equal_steps() {
        let scale = scale(true, &[1.0, 1000.0]);
        let steps = [1.0, 10.0, 100.0].map(|v| scale.at(10.0 * v) - scale.at(v));
        assert!((steps[0] - steps[1]).abs() < 1e-4 && (steps[1] - steps[2]).abs() < 1e-4);
    }
}
