//! How far apart must two surfaces be before a depth buffer tells which is nearer? (L20, E9)

use transforms::ViewVolume;
use zbuffer::DepthFormat;
use zbuffer::depth_format::step_at;

use crate::figure::{Drawing, Drawn, Figure, Text, Words};
use crate::parameter::{Parameter, Values};
use crate::sheet::Ink;
use crate::sheet::plot::{Axis, Plot, Series};

pub(super) static FIGURE: Figure = Figure {
    numbers: &["L20", "E9"],
    name: "depth-step",
    title: Text { en: "Depth step against distance", nl: "Dieptestap tegen afstand" },
    caption: Text {
        en: "Canonical z is not proportional to distance, so the smallest distance that a depth buffer tells apart grows with the square of the distance. Each 8 bits more divide it by 256.",
        nl: "Canonieke z is niet evenredig met de afstand; daarom groeit de kleinste afstand die een z-buffer onderscheidt met het kwadraat van de afstand. Elke 8 bits meer delen die door 256.",
    },
    parameters: &[
        Parameter::number(
            "near",
            Text { en: "distance of the near plane", nl: "afstand van het near-vlak" },
            1.0,
            0.01,
            10.0,
        ),
        Parameter::number(
            "far",
            Text { en: "distance of the far plane", nl: "afstand van het far-vlak" },
            1000.0,
            20.0,
            100_000.0,
        ),
    ],
    size: (640, 480),
    draw,
};

fn draw(values: &Values) -> Drawn {
    /// Points on each line.
    const POINTS: u16 = 60;
    let (near, far) = (values.number("near"), values.number("far"));
    let volume = ViewVolume::from_fov_y(1.0, 1.5, -near, -far)?;
    let series = |name: &str, ink, format| {
        // From just behind the near plane to just before the far plane, in equal factors.
        let distance = |k: u16| near * (far / near).powf((f32::from(k) + 0.5) / f32::from(POINTS));
        let point = |k| (f64::from(distance(k)), f64::from(step_at(format, &volume, distance(k))));
        Series { name: name.into(), ink, points: (0..POINTS).map(point).collect(), is_theory: false }
    };
    let plot = Plot {
        x: Axis::logarithmic(Words::new("distance before the eye", "afstand voor het oog")),
        y: Axis::logarithmic(Words::new(
            "smallest difference in distance that is seen",
            "kleinste afstandsverschil dat gezien wordt",
        )),
        series: vec![
            series("16 bits", Ink::A, DepthFormat::Bits16),
            series("24 bits", Ink::B, DepthFormat::Bits24),
            series("32 bits (f32)", Ink::C, DepthFormat::F32),
        ],
    };
    let at_far = step_at(DepthFormat::Bits16, &volume, 0.99 * far);
    let alt = Words::new(
        format!(
            "Three rising lines: with 16 bits the step is {at_far:.3} at the far plane, with 24 and 32 bits it is hundreds of times smaller."
        ),
        format!(
            "Drie stijgende lijnen: met 16 bits is de stap {at_far:.3} bij het far-vlak, met 24 en 32 bits honderden keren kleiner."
        ),
    );
    Ok(vec![Drawing::diagram("", alt.clone(), plot.svg(&alt))])
}
