//! Which order draws three triangles that overlap in a ring? None. (L14)

use scene::Renderer;

use super::studio::{built_in, painted_over, settings, shot};
use crate::figure::{Drawing, Drawn, Figure, Text, Words};
use crate::handle::without_handles;
use crate::parameter::Values;

pub(super) static FIGURE: Figure = Figure {
    numbers: &["L14", "L13"],
    name: "cycle",
    title: Text { en: "Occlusion cycles", nl: "Occlusiecycli" },
    caption: Text {
        en: "Each triangle lies partly before the next. Whichever is drawn last covers one that should cover it: three orders, three wrong pictures. Only after one triangle has been cut in two (Newell) is there an order from back to front, and the last picture.",
        nl: "Elke driehoek ligt deels vóór de volgende. Welke ook als laatste getekend wordt, hij bedekt er een die hem had moeten bedekken: drie volgordes, drie foute plaatjes. Pas als een driehoek in tweeën is gesneden (Newell) bestaat er een volgorde van achter naar voren, en het laatste plaatje.",
    },
    parameters: &[],
    size: (320, 320),
    draw,
    handles: without_handles,
};

fn draw(values: &Values) -> Drawn {
    let loaded = built_in("cycle")?;
    let colors = [("red", "rood"), ("green", "groen"), ("blue", "blauw")];
    let mut drawings = Vec::new();
    for first in 0..3 {
        let order = [first, (first + 1) % 3, (first + 2) % 3];
        let image = painted_over(&loaded, &order, values.size())?;
        let [en, nl] = [order.map(|k| colors[k].0), order.map(|k| colors[k].1)].map(|names| names.join(", "));
        let alt = Words::new(
            format!(
                "Three long triangles in a ring, drawn in the order {en}: the last one covers both others."
            ),
            format!(
                "Drie lange driehoeken in een ring, getekend in de volgorde {nl}: de laatste bedekt beide andere."
            ),
        );
        drawings.push(Drawing::picture(order.map(|k| colors[k].0).join("-"), alt, image));
    }
    let right = shot(&loaded, &settings(&loaded, Renderer::Painter, values.size()))?;
    let alt = Text {
        en: "The same triangles drawn by the painter's algorithm with one of them cut: each covers the next.",
        nl: "Dezelfde driehoeken, getekend door het painter's algoritme met één driehoek doorgesneden: elke bedekt de volgende.",
    };
    drawings.push(Drawing::picture("cut", alt, right));
    Ok(drawings)
}
