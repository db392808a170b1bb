//! How wide is a highlight, and how much wider with h·n than with e·r? (E4, L34)

use glam::Vec3;
use lighting::Highlight;
use sheet::Ink;
use sheet::plot::{Axis, Kind, Plot, Series};
use sheet::text::decimal;

use crate::figure::{Drawing, Drawn, Figure, Text, Words};
use crate::handle::without_handles;
use crate::parameter::{Parameter, Values};

pub(super) static FIGURE: Figure = Figure {
    numbers: &["E4", "L34", "L31"],
    name: "highlight-width",
    title: Text { en: "Two highlights: e·r and h·n", nl: "Twee glansplekken: e·r en h·n" },
    caption: Text {
        en: "How far the eye must leave the mirror direction, in the plane of light and normal, until the highlight has half its brightness. With the same p the highlight of h·n is twice as wide; with 4p the two are nearly the same.",
        nl: "Hoe ver het oog van de terugkaatsrichting af moet, in het vlak van licht en normaal, tot de glansplek half zo helder is. Met dezelfde p is de glansplek van h·n tweemaal zo breed; met 4p zijn de twee bijna gelijk.",
    },
    parameters: &[Parameter::number(
        "light",
        Text { en: "angle between n and l, degrees", nl: "hoek tussen n en l, graden" },
        30.0,
        0.0,
        80.0,
    )],
    size: (640, 480),
    draw,
    handles: without_handles,
};

/// The exponents, each twice the one before, from 4 to 1024.
fn exponents() -> impl Iterator<Item = f32> {
    (2..=10).map(|k| 2.0_f32.powi(k))
}

fn draw(values: &Values) -> Drawn {
    let light = values.number("light").to_radians();
    let series = |name: Words, ink, form, factor: f32| {
        let point = |p: f32| (f64::from(p), half_width(form, light, factor * p).to_degrees());
        Series { name, ink, points: exponents().map(point).collect(), kind: Kind::Measured }
    };
    let plot = Plot {
        x: Axis::logarithmic(Words::new("exponent p", "exponent p")),
        y: Axis::logarithmic(Words::new(
            "angle at half brightness, degrees",
            "hoek bij halve helderheid, graden",
        )),
        series: vec![
            series("(h·n)^p".into(), Ink::A, Highlight::Blinn, 1.0),
            series("(e·r)^p".into(), Ink::B, Highlight::Phong, 1.0),
            series("(h·n)^4p".into(), Ink::C, Highlight::Blinn, 4.0),
        ],
    };
    let width = |form, p| decimal(half_width(form, light, p).to_degrees(), 1);
    let [phong, blinn, four] =
        [(Highlight::Phong, 32.0), (Highlight::Blinn, 32.0), (Highlight::Blinn, 128.0)]
            .map(|(form, p)| width(form, p));
    let alt = Words::new(
        format!(
            "Three falling lines. At p = 32 half brightness lies {phong}° off for e·r, {blinn}° for h·n, and {four}° for h·n with 4p."
        ),
        format!(
            "Drie dalende lijnen. Bij p = 32 ligt halve helderheid {phong}° ernaast voor e·r, {blinn}° voor h·n en {four}° voor h·n met 4p."
        ),
    );
    Ok(vec![Drawing::only(alt, |alt| plot.svg(alt))])
}

/// The angle off the mirror direction, towards the normal and beyond, at which the highlight falls to a half. Radians.
fn half_width(form: Highlight, light: f32, p: f32) -> f64 {
    /// Each halves the interval of a quarter turn: 2⁻²⁴ of it is the rounding of an f32.
    const STEPS: usize = 24;
    let direction = |angle: f32| Vec3::new(angle.sin(), angle.cos(), 0.0);
    // The light at the left, so that the mirror direction is `light` at the right.
    let brightness = |off: f32| form.at(Vec3::Y, direction(-light), direction(light - off), p);
    let (mut above, mut below) = (0.0, std::f32::consts::FRAC_PI_2);
    for _ in 0..STEPS {
        let middle = 0.5 * (above + below);
        *(if brightness(middle) > 0.5 { &mut above } else { &mut below }) = middle;
    }
    f64::from(above)
}
