//! What do α, β and γ say about a point of a triangle's plane? (L48, L49, Fig 4.10)

use geometry::{Barycentric, Triangle};
use glam::{Vec2, vec2, vec3};

use crate::figure::{Drawing, Drawn, Figure, Text, Words};
use crate::parameter::{Parameter, Values};
use crate::sheet::text::decimal;
use crate::sheet::{Ink, Letters, Sheet, Side};

pub(super) static FIGURE: Figure = Figure {
    numbers: &["L48", "L49"],
    name: "barycentric",
    title: Text { en: "A plane and barycentric coordinates", nl: "Een vlak en barycentrische coördinaten" },
    caption: Text {
        en: "p = a + β(b − a) + γ(c − a). β is 0 on the line through a and c and grows in equal steps towards b; γ does so from the line through a and b towards c; α = 1 − β − γ. Inside all three are positive, and a sign tells on which side of an edge a point lies.",
        nl: "p = a + β(b − a) + γ(c − a). β is 0 op de lijn door a en c en groeit in gelijke stappen naar b toe; γ zo ook van de lijn door a en b naar c; α = 1 − β − γ. Binnen zijn alle drie positief, en een teken vertelt aan welke kant van een zijde een punt ligt.",
    },
    parameters: &[
        Parameter::number("beta", Text { en: "β of the point p", nl: "β van het punt p" }, 0.5, -0.5, 1.5),
        Parameter::number("gamma", Text { en: "γ of the point p", nl: "γ van het punt p" }, 0.3, -0.5, 1.5),
    ],
    size: (640, 480),
    draw,
};

/// A triangle without any symmetry, on the sheet.
const CORNERS: Triangle = Triangle { a: vec3(0.0, 0.0, 0.0), b: vec3(4.0, 0.6, 0.0), c: vec3(1.1, 2.6, 0.0) };

fn draw(values: &Values) -> Drawn {
    let weights = Barycentric::from_beta_gamma(values.number("beta"), values.number("gamma"));
    let point = |beta: f32, gamma: f32| CORNERS.point(Barycentric::from_beta_gamma(beta, gamma)).truncate();
    let ends = [(-0.6, -0.6), (-0.6, 1.6), (1.6, -0.6), (1.6, 1.6)].map(|(b, c)| point(b, c));
    let mut sheet = Sheet::around(&ends, vec2(820.0, 500.0), 44.0, 150.0);
    lines(&mut sheet, &point);
    let corners = CORNERS.corners().map(|corner| corner.truncate());
    sheet.wash(&corners, Ink::B);
    sheet.polygon(&corners, Ink::B.pen().wide());
    for (name, corner, side) in [
        ("a", corners[0], Side::BelowLeft),
        ("b", corners[1], Side::BelowRight),
        ("c", corners[2], Side::Above),
    ] {
        sheet.dot(corner, Ink::B);
        sheet.label(corner, side, name, Letters::Vector, Ink::B);
    }
    // The way from a to p: first along b − a, then along c − a.
    let (a, turn, p) = (corners[0], point(weights.beta, 0.0), CORNERS.point(weights).truncate());
    sheet.arrow(a, turn, Ink::A.pen());
    sheet.arrow(turn, p, Ink::A.pen());
    sheet.dot(p, Ink::A);
    sheet.label(p, Side::AboveRight, "p", Letters::Vector, Ink::A);
    let inside =
        if weights.is_inside() { Words::new("inside", "binnen") } else { Words::new("outside", "buiten") };
    let [alpha, beta, gamma] = [weights.alpha, weights.beta, weights.gamma].map(|weight| decimal(weight, 2));
    sheet.lines(645.0, 60.0, [format!("α = {alpha}"), format!("β = {beta}"), format!("γ = {gamma}")]);
    sheet.lines(645.0, 150.0, [inside.clone()]);
    let alt = Words::new(
        format!(
            "A triangle a, b, c with lines of equal β and γ; p with α = {alpha}, β = {beta}, γ = {gamma} lies {}.",
            inside.en
        ),
        format!(
            "Een driehoek a, b, c met lijnen van gelijke β en γ; p met α = {alpha}, β = {beta}, γ = {gamma} ligt {}.",
            inside.nl
        ),
    );
    Ok(vec![Drawing::diagram("", alt.clone(), sheet.svg(&alt))])
}

/// Lines of equal β, of equal γ, and that of α = 0.
fn lines(sheet: &mut Sheet, point: &dyn Fn(f32, f32) -> Vec2) {
    for k in [-1_i8, 0, 1, 2, 3] {
        let share = 0.5 * f32::from(k);
        let pen = |is_zero: bool, ink: Ink| if is_zero { ink.pen() } else { ink.pen().fine().dashed() };
        sheet.line(point(share, -0.6), point(share, 1.6), pen(k == 0, Ink::C));
        sheet.line(point(-0.6, share), point(1.6, share), pen(k == 0, Ink::D));
        let name = decimal(share, 1);
        sheet.label_sized(
            point(share, -0.6),
            Side::Below,
            format!("β = {name}"),
            Letters::Plain,
            Ink::C,
            13.0,
        );
        sheet.label_sized(
            point(-0.6, share),
            Side::AboveRight,
            format!("γ = {name}"),
            Letters::Plain,
            Ink::D,
            13.0,
        );
    }
    sheet.line(point(1.6, -0.6), point(-0.6, 1.6), Ink::Main.pen().fine());
    sheet.label_sized(point(1.45, -0.45), Side::Right, "α = 0", Letters::Plain, Ink::Main, 13.0);
}
