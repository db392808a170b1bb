//! Where does a point of a triangle's plane lie? Its barycentric coordinates say it (L48, L49, Fig 4.10).

use geometry::{Barycentric, Triangle};
use glam::{Vec2, vec3};
use sheet::text::decimal;
use sheet::{Ink, Letters, Sheet, Side};

use crate::figure::{Drawing, Drawn, Figure, Text, Words};
use crate::handle::{Handled, Handles, with_handles};
use crate::parameter::{Parameter, Values};

/// The part of the plane that is drawn: β and γ between these.
const LEAST: f32 = -0.5;
const GREATEST: f32 = 1.25;

pub(super) static FIGURE: Figure = Figure {
    numbers: &["L48", "L49", "E10"],
    name: "barycentric-plane",
    title: Text { en: "Ray-triangle intersection: the plane", nl: "Ray-driehoek intersectie: het vlak" },
    caption: Text {
        en: "Each point of the plane is p = a + β(b − a) + γ(c − a), or αa + βb + γc with α + β + γ = 1. On lines parallel to a side one of the three stays the same; it is 0 on the side itself. Inside all three are positive.",
        nl: "Elk punt van het vlak is p = a + β(b − a) + γ(c − a), ofwel αa + βb + γc met α + β + γ = 1. Op lijnen evenwijdig aan een zijde blijft één van de drie gelijk; op de zijde zelf is die 0. Binnen zijn alle drie positief.",
    },
    parameters: &[
        Parameter::number(
            "beta",
            Text { en: "β, the weight of b", nl: "β, het gewicht van b" },
            0.35,
            LEAST,
            GREATEST,
        ),
        Parameter::number(
            "gamma",
            Text { en: "γ, the weight of c", nl: "γ, het gewicht van c" },
            0.4,
            LEAST,
            GREATEST,
        ),
    ],
    size: (640, 480),
    draw,
    handles,
};

const TRIANGLE: Triangle =
    Triangle { a: vec3(0.0, 0.0, 0.0), b: vec3(4.0, 0.5, 0.0), c: vec3(0.8, 3.0, 0.0) };

/// The point of the plane with these weights.
fn at(beta: f32, gamma: f32) -> Vec2 {
    TRIANGLE.point(Barycentric::from_beta_gamma(beta, gamma)).truncate()
}

/// The corners of the part that is drawn.
fn seen() -> [Vec2; 4] {
    [at(LEAST, LEAST), at(GREATEST, LEAST), at(GREATEST, GREATEST), at(LEAST, GREATEST)]
}

fn sheet(seen: &[Vec2]) -> Sheet {
    Sheet::around(seen, Vec2::new(760.0, 460.0), 26.0, 250.0)
}

fn draw(values: &Values) -> Drawn {
    let weights = Barycentric::from_beta_gamma(values.number("beta"), values.number("gamma"));
    let seen = seen();
    let mut sheet = sheet(&seen);
    sheet.wash(&seen, Ink::Faint);
    for (k, name) in [(0.0, "0"), (0.5, "½"), (1.0, "1")] {
        parallels(&mut sheet, k, name);
    }
    let corners = TRIANGLE.corners().map(|corner| corner.truncate());
    sheet.wash(&corners, Ink::D);
    sheet.polygon(&corners, Ink::Main.pen());
    let p = at(weights.beta, weights.gamma);
    for corner in corners {
        sheet.dot(corner, Ink::Main);
    }
    sheet.dot(p, Ink::D);
    let around = |p: Vec2, x: f32, y: f32| p + sheet.units(15.0) * Vec2::new(x, y);
    let names = [
        (around(corners[0], -0.9, -0.7), "a", Ink::Main),
        (around(corners[1], 0.9, -0.6), "b", Ink::Main),
        (around(corners[2], -0.9, 0.7), "c", Ink::Main),
        (around(p, 0.9, 0.7), "p", Ink::D),
    ];
    sheet.names(&names);
    words(&mut sheet, weights);
    let alt = alt(weights);
    with_handles(vec![Drawing::only(alt, |alt| sheet.svg(alt))], handles(values))
}

/// The lines α = k, β = k and γ = k, each named at an end.
fn parallels(sheet: &mut Sheet, k: f32, name: &str) {
    let pen = |ink: Ink| if k == 0.0 { ink.pen() } else { ink.pen().dashed().fine() };
    // On α = k is β + γ = 1 − k; the line leaves the drawn part where either is at its end.
    let (first, last) = ((1.0 - k - GREATEST).max(LEAST), (1.0 - k - LEAST).min(GREATEST));
    let alpha = [at(first, 1.0 - k - first), at(last, 1.0 - k - last)];
    let beta = [at(k, LEAST), at(k, GREATEST)];
    // α = 0 leaves the drawn part at its top, the others at its left.
    let alpha_side = if first > LEAST { Side::Above } else { Side::Left };
    let gamma = [at(LEAST, k), at(GREATEST, k)];
    for ([from, to], ink, letter, side, end) in [
        (alpha, Ink::A, "α", alpha_side, 0),
        (beta, Ink::B, "β", Side::Below, 0),
        (gamma, Ink::C, "γ", Side::Right, 1),
    ] {
        sheet.line(from, to, pen(ink));
        let text = format!("{letter} = {name}");
        sheet.label_sized([from, to][end], side, text, Letters::Plain, ink, 15.0);
    }
}

/// The three weights, and which test of the slide they pass.
fn words(sheet: &mut Sheet, weights: Barycentric) {
    let Barycentric { alpha, beta, gamma } = weights;
    let lines = [("α", alpha), ("β", beta), ("γ", gamma)];
    sheet.lines(596.0, 50.0, lines.map(|(name, value)| format!("{name} = {}", decimal(value, 2))));
    let mark = |holds: bool| if holds { "✓" } else { "✗" };
    sheet.lines(
        596.0,
        150.0,
        [
            format!("β > 0  {}", mark(beta > 0.0)),
            format!("γ > 0  {}", mark(gamma > 0.0)),
            format!("β + γ < 1  {}", mark(beta + gamma < 1.0)),
        ],
    );
    sheet.lines(596.0, 250.0, [place(weights)]);
}

fn place(weights: Barycentric) -> Words {
    let least = weights.to_vec3().min_element();
    if weights.is_inside() {
        Words::new("p is inside", "p ligt binnen")
    } else if least >= 0.0 {
        Words::new("p is on the border", "p ligt op de rand")
    } else {
        Words::new("p is outside", "p ligt buiten")
    }
}

fn alt(weights: Barycentric) -> Words {
    let [alpha, beta, gamma] = weights.to_vec3().to_array().map(|value| decimal(value, 2));
    let place = place(weights);
    Words::new(
        format!(
            "A triangle in its plane and a point with α = {alpha}, β = {beta}, γ = {gamma}: {}.",
            place.en
        ),
        format!(
            "Een driehoek in zijn vlak en een punt met α = {alpha}, β = {beta}, γ = {gamma}: {}.",
            place.nl
        ),
    )
}

fn handles(values: &Values) -> Handled {
    let p = at(values.number("beta"), values.number("gamma"));
    let name = Text { en: "the point p", nl: "het punt p" };
    Ok(vec![Handles::on(&sheet(&seen()), [(name, &["beta", "gamma"], p)])])
}
