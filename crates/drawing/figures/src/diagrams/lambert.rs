//! How much light falls on a tilted surface? As much as the cosine of its angle to the light (L26, E6).

use canvas::Rgb;
use glam::{Vec2, vec2};
use lighting::lambert;
use sheet::label_layout::Vector;
use sheet::text::{decimal, degrees};
use sheet::{Ink, Letters, Side};

use super::slice::{LOWEST, N, THE_LIGHT, WORDS, direction, paper, sheet, tip};
use crate::ball;
use crate::figure::{Drawing, Drawn, Figure, Text, Words};
use crate::handle::{Handled, Handles, with_handles};
use crate::parameter::{Parameter, Values};

pub(super) static FIGURE: Figure = Figure {
    numbers: &["L26", "E6"],
    name: "lambert",
    title: Text { en: "Diffuse reflection: Lambert's law", nl: "Diffuse reflectie: de wet van Lambert" },
    caption: Text {
        en: "The product n·l of two unit vectors is the length of l's shadow on n: the cosine of the angle θ, and not the angle itself. Light from straight above gives 1, light along the surface 0. The ball stands under the same light and has every normal; its top has the n of the diagram.",
        nl: "Het inproduct n·l van twee eenheidsvectoren is de lengte van de schaduw van l op n: de cosinus van de hoek θ, en niet de hoek zelf. Licht van recht boven geeft 1, licht langs het oppervlak 0. De bol staat onder hetzelfde licht en heeft alle normalen; zijn top heeft de n van de tekening.",
    },
    parameters: &[Parameter::number(
        "theta",
        Text { en: "angle θ between n and l, degrees", nl: "hoek θ tussen n en l, graden" },
        40.0,
        0.0,
        90.0,
    )],
    size: (300, 300),
    draw,
    handles,
};

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
    let diagram = Drawing::diagram("vectors", alt.clone(), sheet.svg(&alt));
    let [ball] = ball::pictures(values.size(), |n, _| [Rgb::splat(lambert(n, l))])?;
    let alt = Text {
        en: "A white matt ball under this light: brightest where it faces the light, black from 90° on.",
        nl: "Een witte matte bol onder dit licht: het helderst waar hij naar het licht wijst, zwart vanaf 90°.",
    };
    with_handles(vec![diagram, Drawing::picture("ball", alt, ball)], handles(values))
}

fn handles(values: &Values) -> Handled {
    let l = direction(values.number("theta"));
    let ball = ball::handles(values.size()).and(THE_LIGHT, &["theta"], ball::place(values.size(), l)?);
    Ok(vec![Handles::on(&paper(LOWEST), [(THE_LIGHT, &["theta"], tip(l))]), ball])
}
