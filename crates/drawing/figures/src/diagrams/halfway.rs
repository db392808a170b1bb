//! What is cheaper to compare than e and r? The normal and the vector halfway between eye and light (L33, E4).

use glam::{Vec2, Vec3};
use lighting::{blinn_highlight, halfway, phong_highlight, reflect};
use sheet::label_layout::Vector;
use sheet::text::{decimal, degrees};
use sheet::{Ink, Sheet};

use super::slice::{self, LOWEST, N, THE_EYE, THE_LIGHT, WORDS, direction, paper, sheet, tip};
use crate::figure::{Drawing, Drawn, Figure, Text, Words};
use crate::handle::{Handled, Handles, with_handles};
use crate::parameter::{Parameter, Values};

pub(super) static FIGURE: Figure = Figure {
    numbers: &["L33", "L34", "E4"],
    name: "halfway-vector",
    title: Text { en: "Halfway vector h between l and e", nl: "Halfway vector h tussen l en e" },
    caption: Text {
        en: "h is the unit vector through the middle of l and e. Where it is near the normal n, the eye is near the mirror direction r. In one plane the angle σ between e and r is twice the angle ω between h and n, so the two highlights differ: h·n needs about 4p.",
        nl: "h is de eenheidsvector door het midden van l en e. Waar die dicht bij de normaal n ligt, staat het oog dicht bij de terugkaatsrichting r. In één vlak is de hoek σ tussen e en r tweemaal de hoek ω tussen h en n; de twee glansplekken verschillen dus: h·n heeft ongeveer 4p nodig.",
    },
    parameters: &[
        slice::light(60.0),
        slice::eye(20.0),
        Parameter::number("p", Text { en: "exponent p", nl: "exponent p" }, 8.0, 1.0, 256.0),
    ],
    size: (640, 480),
    draw,
    handles,
};

fn draw(values: &Values) -> Drawn {
    let [light, eye, p] = ["light", "eye", "p"].map(|name| values.number(name));
    let (l, e) = (direction(-light), direction(eye));
    let h = halfway(e, l).ok_or("eye and light are opposite: nothing lies halfway")?;
    let r = reflect(N, l);
    let (omega, sigma) = (h.angle_between(N), e.angle_between(r));
    let mut sheet = sheet(LOWEST);
    // e + l goes through the middle of the two tips; h has its direction.
    sheet.line(tip(l), tip(e), Ink::Faint.pen().dashed());
    sheet.vectors(
        Vec2::ZERO,
        &[
            Vector::new("n", tip(N), Ink::B),
            Vector::new("l", tip(l), Ink::A),
            Vector::new("e", tip(e), Ink::C),
            Vector::new("h", tip(h), Ink::D),
            Vector::new("r", tip(r), Ink::Main).dashed(),
        ],
    );
    sheet.dot(tip(0.5 * (e + l)), Ink::Faint);
    sheet.angle(Vec2::ZERO, 0.5, [tip(h), tip(N)], "ω", Ink::D);
    sheet.angle(Vec2::ZERO, 0.72, [tip(e), tip(r)], "σ", Ink::Main);
    sheet.dot(Vec2::ZERO, Ink::Main);
    words(&mut sheet, [l, e, h], p);
    let (omega, sigma) = (omega.to_degrees(), sigma.to_degrees());
    let alt = Words::new(
        format!(
            "The halfway vector h is {omega:.1}° from the normal, the eye {sigma:.1}° from the mirror direction."
        ),
        format!(
            "De halfway vector h staat {omega:.1}° van de normaal, het oog {sigma:.1}° van de terugkaatsrichting."
        ),
    );
    with_handles(vec![Drawing::only(alt, |alt| sheet.svg(alt))], handles(values))
}

/// The two angles, and what the two forms of the highlight make of them.
fn words(sheet: &mut Sheet, [l, e, h]: [Vec3; 3], p: f32) {
    let r = reflect(N, l);
    sheet.lines(
        WORDS,
        50.0,
        [
            format!("ω = {}", degrees(h.angle_between(N))),
            format!("σ = {}", degrees(e.angle_between(r))),
            format!("h·n = cos ω = {}", decimal(h.dot(N), 3)),
            format!("e·r = cos σ = {}", decimal(e.dot(r), 3)),
            format!("p = {p}"),
            format!("(e·r)^p = {}", decimal(phong_highlight(N, l, e, p), 3)),
            format!("(h·n)^p = {}", decimal(blinn_highlight(N, l, e, p), 3)),
            format!("(h·n)^4p = {}", decimal(blinn_highlight(N, l, e, 4.0 * p), 3)),
        ],
    );
}

fn handles(values: &Values) -> Handled {
    let [light, eye] = ["light", "eye"].map(|name| values.number(name));
    let (l, e) = (direction(-light), direction(eye));
    let list: [(Text, &[&str], Vec2); 2] = [(THE_LIGHT, &["light"], tip(l)), (THE_EYE, &["eye"], tip(e))];
    Ok(vec![Handles::on(&paper(LOWEST), list)])
}
