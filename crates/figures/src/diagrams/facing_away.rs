//! What if the light is behind the surface? Then n·l is negative, and no light may be taken away (L27).

use glam::{Vec2, vec2};
use lighting::lambert;
use sheet::crowd::Vector;
use sheet::text::{decimal, degrees};
use sheet::{Ink, Letters, Side};

use super::slice::{N, WORDS, direction, sheet, tip};
use crate::figure::{Drawing, Drawn, Figure, Text, Words};
use crate::handle::without_handles;
use crate::parameter::{Parameter, Values};

pub(super) static FIGURE: Figure = Figure {
    numbers: &["L27"],
    name: "facing-away",
    title: Text { en: "A surface that faces away", nl: "Een oppervlak dat is afgewend" },
    caption: Text {
        en: "Beyond 90° the light is behind the surface and the product n·l is negative. A negative colour would take light away from other lamps, so the model uses max(0, n·l).",
        nl: "Voorbij 90° staat het licht achter het oppervlak en is het inproduct n·l negatief. Een negatieve kleur zou licht van andere lampen wegnemen; daarom gebruikt het model max(0, n·l).",
    },
    parameters: &[Parameter::number(
        "theta",
        Text { en: "angle θ between n and l, degrees", nl: "hoek θ tussen n en l, graden" },
        125.0,
        91.0,
        179.0,
    )],
    size: (640, 480),
    draw,
    handles: without_handles,
};

fn draw(values: &Values) -> Drawn {
    let theta = values.number("theta");
    let l = direction(theta);
    let product = N.dot(l);
    let mut sheet = sheet(-1.12);
    let foot = vec2(0.0, product);
    sheet.line(tip(l), foot, Ink::D.pen().dashed());
    sheet.vectors(Vec2::ZERO, &[Vector::new("n", tip(N), Ink::B), Vector::new("l", tip(l), Ink::A)]);
    let beside = vec2(-sheet.units(9.0), 0.0);
    sheet.line(beside, foot + beside, Ink::D.pen().wide());
    // However short the line is, its name stands below the surface.
    let name = vec2(1.4 * beside.x, (0.5 * product).min(-0.12));
    sheet.label(name, Side::Left, "n·l < 0", Letters::Plain, Ink::D);
    sheet.angle(Vec2::ZERO, 0.3, [tip(N), tip(l)], "θ", Ink::Main);
    sheet.dot(Vec2::ZERO, Ink::Main);
    let (product, share) = (decimal(product, 3), decimal(lambert(N, l), 3));
    sheet.lines(
        WORDS,
        60.0,
        [
            format!("θ = {}", degrees(theta.to_radians())),
            format!("n·l = cos θ = {product}"),
            format!("max(0, n·l) = {share}"),
        ],
    );
    let alt = Words::new(
        format!(
            "The light is {theta:.1}° from the normal, below the surface: n·l is {product}, max(0, n·l) is {share}."
        ),
        format!(
            "Het licht staat {theta:.1}° van de normaal, onder het oppervlak: n·l is {product}, max(0, n·l) is {share}."
        ),
    );
    Ok(vec![Drawing::only(alt, |alt| sheet.svg(alt))])
}
