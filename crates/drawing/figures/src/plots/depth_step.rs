//! How far apart must two surfaces be before a depth buffer tells which is nearer? (L20, E9)

use sheet::Ink;
use sheet::plot::{Axis, Kind, Plot, Series};
use transforms::ViewVolume;
use zbuffer::DepthFormat;
use zbuffer::depth_format::step_at;

use crate::figure::{Drawing, Drawn, Figure, Text, Words};
use crate::handle::without_handles;
use crate::parameter::{Parameter, Values};

pub(super) static FIGURE: Figure = Figure {
    numbers: &["L20", "E9"],
    name: "depth-step",
    title: Text { en: "Depth step against distance", nl: "Dieptestap tegen afstand" },
    caption: Text {
        en: "Canonical z is not proportional to distance, so the smallest distance that a depth buffer tells apart grows with the square of the distance. 24 bits divide it by 256. An f32 is finest around 0, and canonical z passes 0 at the distance 2nf/(n+f), about twice the near distance: the line of 32 bits dips there, and each tooth is a halving of the steps. Farther away it gains only a factor of 2 over 24 bits.",
        nl: "Canonieke z is niet evenredig met de afstand; daarom groeit de kleinste afstand die een z-buffer onderscheidt met het kwadraat van de afstand. 24 bits delen die door 256. Een f32 is het fijnst rond 0, en canonieke z gaat door 0 op de afstand 2nf/(n+f), ongeveer tweemaal de near-afstand: de lijn van 32 bits duikt daar omlaag, en elke tand is een halvering van de stappen. Verder weg wint die maar een factor 2 op 24 bits.",
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
    handles: without_handles,
};

fn draw(values: &Values) -> Drawn {
    /// Points on each line: enough to see each tooth of the line of 32 bits.
    const POINTS: u16 = 600;
    let (near, far) = (values.number("near"), values.number("far"));
    let volume = ViewVolume::from_fov_y(1.0, 1.5, -near, -far)?;
    let series = |name: &str, ink, format| {
        // From just behind the near plane to just before the far plane, in equal factors.
        let distance = |k: u16| near * (far / near).powf((f32::from(k) + 0.5) / f32::from(POINTS));
        let point = |k| (f64::from(distance(k)), f64::from(step_at(format, &volume, distance(k))));
        Series { name: name.into(), ink, points: (0..POINTS).map(point).collect(), kind: Kind::Measured }
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
    let at_far = |format| step_at(format, &volume, 0.99 * far);
    let steps = [DepthFormat::Bits16, DepthFormat::Bits24, DepthFormat::F32].map(at_far);
    let [coarse, times_24, times_32] = [steps[0], steps[0] / steps[1], steps[0] / steps[2]];
    let alt = Words::new(
        format!(
            "Three rising lines: with 16 bits the step is {coarse:.3} at the far plane, with 24 bits it is {times_24:.0} times smaller, with 32 bits {times_32:.0} times."
        ),
        format!(
            "Drie stijgende lijnen: met 16 bits is de stap {coarse:.3} bij het far-vlak, met 24 bits {times_24:.0} keer kleiner, met 32 bits {times_32:.0} keer."
        ),
    );
    Ok(vec![Drawing::only(alt, |alt| plot.svg(alt))])
}
