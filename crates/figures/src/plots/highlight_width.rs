//! How wide is a highlight of exponent p, in either form? (E4, L31, L34)

use glam::{Vec3, vec3};
use lighting::{blinn_highlight, phong_highlight};

use crate::figure::{Drawing, Drawn, Figure, Text, Words};
use crate::parameter::{Parameter, Values};
use crate::sheet::Ink;
use crate::sheet::plot::{Axis, Plot, Series};

pub(super) static FIGURE: Figure = Figure {
    numbers: &["E4", "L31", "L34"],
    name: "highlight-width",
    title: Text { en: "Highlight width against exponent", nl: "Breedte van de highlight tegen de exponent" },
    caption: Text {
        en: "How far the eye must turn from the brightest direction until the highlight has half its brightness, the light standing straight above. With the same p, h·n (blue) is twice as wide as e·r (orange), because ω is half of σ. With 4p (green) the two agree. So ⇒ on the slide joins two different highlights.",
        nl: "Hoe ver het oog van de helderste richting weg moet draaien tot de highlight half zo helder is, met het licht recht boven. Bij gelijke p is h·n (blauw) twee keer zo breed als e·r (oranje), omdat ω de helft van σ is. Met 4p (groen) zijn ze gelijk. De ⇒ op de slide verbindt dus twee verschillende highlights.",
    },
    parameters: &[Parameter::number(
        "factor",
        Text { en: "by how much h·n's exponent is larger", nl: "hoeveel groter de exponent van h·n is" },
        4.0,
        1.0,
        8.0,
    )],
    size: (640, 480),
    draw,
};

fn draw(values: &Values) -> Drawn {
    let factor = values.number("factor");
    type Form = fn(Vec3, Vec3, Vec3, f32) -> f32;
    let series = |name: Words, ink, form: Form, factor: f32| {
        let widths = (2..=11).map(|k| 2_f32.powi(k));
        let points =
            widths.map(|p| (f64::from(p), f64::from(half_width(|n, l, e| form(n, l, e, factor * p)))));
        Series { name, ink, points: points.collect(), is_theory: false }
    };
    let plot = Plot {
        x: Axis::logarithmic("p"),
        y: Axis::logarithmic(Words::new("half width in degrees", "halve breedte in graden")),
        series: vec![
            series("(e·r)^p".into(), Ink::A, phong_highlight, 1.0),
            series("(h·n)^p".into(), Ink::B, blinn_highlight, 1.0),
            series(format!("(h·n)^({factor}p)").into(), Ink::C, blinn_highlight, factor),
        ],
    };
    let at = |k: usize| plot.series[k].points[3].1;
    let alt = Words::new(
        format!(
            "Three falling lines. At p = 32 the half width is {:.1}° for e·r, {:.1}° for h·n, {:.1}° for h·n with {factor}p.",
            at(0),
            at(1),
            at(2)
        ),
        format!(
            "Drie dalende lijnen. Bij p = 32 is de halve breedte {:.1}° voor e·r, {:.1}° voor h·n, {:.1}° voor h·n met {factor}p.",
            at(0),
            at(1),
            at(2)
        ),
    );
    Ok(vec![Drawing::diagram("", alt.clone(), plot.svg(&alt))])
}

/// The angle in degrees, from the light's direction, at which a highlight has fallen to half; found by bisection between
/// the brightest direction and the horizon.
fn half_width(highlight: impl Fn(Vec3, Vec3, Vec3) -> f32) -> f32 {
    let at = |angle: f32| highlight(Vec3::Z, Vec3::Z, vec3(angle.sin(), 0.0, angle.cos()));
    let half = 0.5 * at(0.0);
    let (mut inside, mut outside) = (0.0, std::f32::consts::FRAC_PI_2);
    // Each step gives a bit; f32 has 24.
    for _ in 0..24 {
        let middle = 0.5 * (inside + outside);
        if at(middle) > half { inside = middle } else { outside = middle }
    }
    inside.to_degrees()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_half_width_is_where_the_power_of_the_cosine_is_half() {
        // cos^32 σ = ½ at σ = acos(2^(−1/32)) = 11.89°; cos^32(σ/2) at twice that.
        let phong = half_width(|n, l, e| phong_highlight(n, l, e, 32.0));
        let blinn = half_width(|n, l, e| blinn_highlight(n, l, e, 32.0));
        // Half of the 24 bits are lost where the cosine is flat.
        assert!((phong - 11.89).abs() < 0.02 && (blinn - 23.78).abs() < 0.04, "{phong}, {blinn}");
    }
}
