//! How much light falls on a tilted surface? As much as the cosine of its angle to the light (L26, E6).

use glam::{Vec2, vec2};
use lighting::lambert;
use sheet::crowd::Vector;
use sheet::text::{decimal, degrees};
use sheet::{Ink, Letters, Side};

use super::slice::{N, THE_LIGHT, WORDS, direction, sheet, tip};
use crate::figure::{Drawing, Drawn, Figure, Text, Words};
use crate::handle::{Handled, Handles, with_handles};
use crate::parameter::{Parameter, Values};

pub(super) static FIGURE: Figure = Figure {
    numbers: &["L26", "E6"],
    name: "lambert",
    title: Text { en: "Diffuse reflection: Lambert's law", nl: "Diffuse reflectie: de wet van Lambert" },
    caption: Text {
        en: "The product n·l of two unit vectors is the length of l's shadow on n: the cosine of the angle θ, and not the angle itself. Light from straight above gives 1, light along the surface 0.",
        nl: "Het inproduct n·l van twee eenheidsvectoren is de lengte van de schaduw van l op n: de cosinus van de hoek θ, en niet de hoek zelf. Licht van recht boven geeft 1, licht langs het oppervlak 0.",
    },
    parameters: &[Parameter::number(
        "theta",
        Text { en: "angle θ between n and l, degrees", nl: "hoek θ tussen n en l, graden" },
        40.0,
        0.0,
        90.0,
    )],
    size: (640, 480),
    draw,
    handles,
};

/// The least y that is drawn: a little below the surface.
const LOWEST: f32 = -0.12;

fn draw(values: &Values) -> Drawn {
    let theta = values.number("theta");
    let l = direction(theta);
    let share = lambert(N, l);
    let mut sheet = sheet(LOWEST);
    let foot = vec2(0.0, share);
    sheet.line(tip(l), foot, Ink::C.pen().dashed());
    sheet.vectors(Vec2::ZERO, &[Vector::new("n", tip(N), Ink::B), Vector::new("l", tip(l), Ink::A)]);
    // A little beside n, so that both are seen.
    let beside = vec2(-sheet.units(9.0), 0.0);
    sheet.line(beside, foot + beside, Ink::C.pen().wide());
    sheet.label(0.5 * foot + beside, Side::Left, "n·l", Letters::Plain, Ink::C);
    sheet.angle(Vec2::ZERO, 0.3, [tip(N), tip(l)], "θ", Ink::Main);
    sheet.dot(Vec2::ZERO, Ink::Main);
    sheet.lines(
        WORDS,
        60.0,
        [
            format!("θ = {}", degrees(theta.to_radians())),
            format!("n·l = cos θ = {}", decimal(N.dot(l), 3)),
            format!("c = {} · c_r c_l", decimal(share, 3)),
        ],
    );
    let share = decimal(share, 3);
    let alt = Words::new(
        format!(
            "The unit vector l stands {theta:.1}° from the normal n; its projection on n has length {share}."
        ),
        format!(
            "De eenheidsvector l staat {theta:.1}° van de normaal n; zijn projectie op n heeft lengte {share}."
        ),
    );
    with_handles(vec![Drawing::only(alt, |alt| sheet.svg(alt))], handles(values))
}

fn handles(values: &Values) -> Handled {
    let l = direction(values.number("theta"));
    Ok(vec![Handles::on(&sheet(LOWEST), [(THE_LIGHT, &["theta"], tip(l))])])
}
