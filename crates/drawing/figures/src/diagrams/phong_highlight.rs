//! When does the eye see a highlight? When it stands near the mirror direction of the light (L31).

use glam::{Vec2, Vec3};
use lighting::{phong_highlight, reflect};
use sheet::label_layout::Vector;
use sheet::text::{decimal, degrees};
use sheet::{Ink, Sheet};

use super::slice::{self, LOWEST, N, THE_EYE, THE_LIGHT, WORDS, direction, paper, sheet, tip};
use crate::figure::{Drawing, Drawn, Figure, Text, Words};
use crate::handle::{Handled, Handles, with_handles};
use crate::parameter::{Parameter, Values};

pub(super) static FIGURE: Figure = Figure {
    numbers: &["L31", "L30"],
    name: "phong-geometry",
    title: Text { en: "Specular reflection: the Phong model", nl: "Spiegelreflectie: het Phong-model" },
    caption: Text {
        en: "The light l is reflected to r, as far from the normal on the other side. The lobe shows the brightness of the highlight for every place of the eye e: it is greatest along r, and the greater p, the narrower.",
        nl: "Het licht l kaatst terug naar r, even ver van de normaal aan de andere kant. De lob toont de helderheid van de glansplek voor elke plaats van het oog e: het grootst langs r, en hoe groter p, hoe smaller.",
    },
    parameters: &[
        slice::light(50.0),
        slice::eye(30.0),
        Parameter::number("p", Text { en: "Phong exponent p", nl: "Phong-exponent p" }, 8.0, 1.0, 256.0),
    ],
    size: (640, 480),
    draw,
    handles,
};

fn draw(values: &Values) -> Drawn {
    let [light, eye, p] = ["light", "eye", "p"].map(|name| values.number(name));
    let (l, e) = (direction(-light), direction(eye));
    let r = reflect(N, l);
    let sigma = e.angle_between(r);
    let highlight = phong_highlight(N, l, e, p);
    let mut sheet = sheet(LOWEST);
    lobe(&mut sheet, light, p);
    sheet.vectors(
        Vec2::ZERO,
        &[
            Vector::new("n", tip(N), Ink::B),
            Vector::new("l", tip(l), Ink::A),
            Vector::new("r", tip(r), Ink::A).dashed(),
            Vector::new("e", tip(e), Ink::C),
        ],
    );
    sheet.angle(Vec2::ZERO, 0.24, [tip(l), tip(N)], "θ", Ink::Main);
    sheet.angle(Vec2::ZERO, 0.24, [tip(N), tip(r)], "θ", Ink::Main);
    sheet.angle(Vec2::ZERO, 0.66, [tip(e), tip(r)], "σ", Ink::D);
    sheet.dot(tip(highlight * e), Ink::D);
    sheet.dot(Vec2::ZERO, Ink::Main);
    words(&mut sheet, [l, e], p);
    let (sigma, value) = (sigma.to_degrees(), decimal(highlight, 3));
    let alt = Words::new(
        format!(
            "The eye is {sigma:.1}° away from the mirror direction of the light; with exponent {p} the highlight has brightness {value}."
        ),
        format!(
            "Het oog staat {sigma:.1}° van de terugkaatsrichting van het licht; met exponent {p} heeft de glansplek helderheid {value}."
        ),
    );
    with_handles(vec![Drawing::only(alt, |alt| sheet.svg(alt))], handles(values))
}

/// The angles, and what the highlight makes of them.
fn words(sheet: &mut Sheet, [l, e]: [Vec3; 2], p: f32) {
    let r = reflect(N, l);
    let (product, value) = (decimal(e.dot(r), 3), decimal(phong_highlight(N, l, e, p), 3));
    sheet.lines(
        WORDS,
        60.0,
        [
            format!("θ = {}", degrees(l.angle_between(N))),
            format!("σ = {}", degrees(e.angle_between(r))),
            format!("e·r = cos σ = {product}"),
            format!("p = {p}"),
            format!("max(0, e·r)^p = {value}"),
        ],
    );
}

/// The brightness in each direction, as a length in that direction.
fn lobe(sheet: &mut Sheet, light: f32, p: f32) {
    let l = direction(-light);
    let brightness = |half_degree: i16| {
        let e = direction(0.5 * f32::from(half_degree));
        tip(phong_highlight(N, l, e, p) * e)
    };
    let outline: Vec<Vec2> = (-180..=180).map(brightness).collect();
    sheet.wash(&outline, Ink::D);
    sheet.polygon(&outline, Ink::D.pen().fine());
}

fn handles(values: &Values) -> Handled {
    let [light, eye, p] = ["light", "eye", "p"].map(|name| values.number(name));
    let (l, e) = (direction(-light), direction(eye));
    let brightness = Text { en: "the brightness of the highlight", nl: "de helderheid van de glansplek" };
    let list: [(Text, &[&str], Vec2); 3] = [
        (THE_LIGHT, &["light"], tip(l)),
        (THE_EYE, &["eye"], tip(e)),
        (brightness, &["p"], tip(phong_highlight(N, l, e, p) * e)),
    ];
    Ok(vec![Handles::on(&paper(LOWEST), list)])
}
