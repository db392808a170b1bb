//! How is a point turned about another one? To the origin, turned there, and back (L10, exercise 6.9).

use glam::{Mat3, Vec2, vec2};
use sheet::text::{decimal, degrees};
use sheet::{Ink, Letters, Sheet, Side};
use transforms::affine2::{rotate, rotate_about};

use crate::figure::{Drawing, Drawn, Figure, Text, Words};
use crate::handle::{Handled, Handles, with_handles};
use crate::parameter::{Parameter, Values};

pub(super) static FIGURE: Figure = Figure {
    numbers: &["L10"],
    name: "rotation-about-a-point",
    title: Text { en: "Rotation about a point", nl: "Rotatie om een punt" },
    caption: Text {
        en: "M = T(p) · R(θ) · T(−p): the point q is brought along with p to the origin, turned there, and brought back (dashed). The pivot p itself stays where it is.",
        nl: "M = T(p) · R(θ) · T(−p): het punt q gaat met p mee naar de oorsprong, draait daar en gaat terug (gestreept). Het draaipunt p zelf blijft waar het is.",
    },
    parameters: &[
        Parameter::number(
            "theta",
            Text { en: "angle θ, degrees", nl: "hoek θ, graden" },
            70.0,
            -180.0,
            180.0,
        ),
        Parameter::number(
            "p_x",
            Text { en: "x of the pivot p", nl: "x van het draaipunt p" },
            0.8,
            -1.0,
            1.0,
        ),
        Parameter::number(
            "p_y",
            Text { en: "y of the pivot p", nl: "y van het draaipunt p" },
            0.5,
            -1.0,
            1.0,
        ),
        Parameter::number("q_x", Text { en: "x of the point q", nl: "x van het punt q" }, -1.7, -2.0, 2.0),
        Parameter::number("q_y", Text { en: "y of the point q", nl: "y van het punt q" }, 1.6, -2.0, 2.0),
    ],
    size: (640, 480),
    draw,
    handles,
};

/// As far as anything gets from the origin: p is at most √2 from it, q at most 3√2 from p.
const REACH: f32 = 5.7;
/// Where the words begin, in pixels from the left.
const WORDS: f32 = 500.0;

/// What is turned, about what, and by how much.
struct Turn {
    theta: f32,
    p: Vec2,
    q: Vec2,
    /// M.
    matrix: Mat3,
}

impl Turn {
    fn new(values: &Values) -> Self {
        let theta = values.number("theta").to_radians();
        let p = vec2(values.number("p_x"), values.number("p_y"));
        let q = vec2(values.number("q_x"), values.number("q_y"));
        Self { theta, p, q, matrix: rotate_about(theta, p) }
    }

    /// q after the rotation.
    fn turned(&self) -> Vec2 {
        self.matrix.transform_point2(self.q)
    }
}

fn sheet() -> Sheet {
    Sheet::around(&[Vec2::splat(-REACH), Vec2::splat(REACH)], vec2(760.0, 460.0), 12.0, 290.0)
}

fn handles(values: &Values) -> Handled {
    const PIVOT: Text = Text { en: "the pivot", nl: "het draaipunt" };
    const POINT: Text = Text { en: "the point", nl: "het punt" };
    const TURNED: Text = Text { en: "the turned point", nl: "het gedraaide punt" };
    let turn = Turn::new(values);
    let list: [(Text, &[&'static str], Vec2); 3] = [
        (PIVOT, &["p_x", "p_y"], turn.p),
        (POINT, &["q_x", "q_y"], turn.q),
        (TURNED, &["theta"], turn.turned()),
    ];
    Ok(vec![Handles::on(&sheet(), list)])
}

fn draw(values: &Values) -> Drawn {
    let turn = Turn::new(values);
    let Turn { theta, p, q, .. } = turn;
    let turned = turn.turned();
    let mut sheet = sheet();
    axes(&mut sheet);
    // To the origin, turned there, and back.
    let (moved, there) = (q - p, rotate(theta).transform_point2(q - p));
    let faint = || Ink::Faint.pen().dashed().fine();
    for (from, to) in [(q, moved), (there, turned)] {
        sheet.line(from, to, faint());
    }
    sheet.line(Vec2::ZERO, moved, Ink::Faint.pen().fine());
    sheet.line(Vec2::ZERO, there, Ink::Faint.pen().fine());
    for place in [moved, there] {
        sheet.speck(place, Ink::Faint);
    }
    sheet.line(p, q, Ink::B.pen());
    sheet.line(p, turned, Ink::A.pen());
    if q != p {
        arc(&mut sheet, &turn);
    }
    for (place, ink) in [(q, Ink::B), (turned, Ink::A), (p, Ink::D)] {
        sheet.dot(place, ink);
    }
    let near = sheet.units(15.0);
    let beyond = |place: Vec2| place + near * (place - p).normalize_or(Vec2::X);
    let names =
        [(beyond(q), "q", Ink::B), (beyond(turned), "q′", Ink::A), (p - near * middle(&turn), "p", Ink::D)];
    sheet.names(&names);
    numbers(&mut sheet, &turn);
    let alt = alt(&turn);
    with_handles(vec![Drawing::only(alt, |alt| sheet.svg(alt))], handles(values))
}

/// From p between q and where it is turned to.
fn middle(turn: &Turn) -> Vec2 {
    rotate(0.5 * turn.theta).transform_vector2(turn.q - turn.p).normalize_or(Vec2::X)
}

fn axes(sheet: &mut Sheet) {
    for (axis, name, side) in [(Vec2::X, "x", Side::Below), (Vec2::Y, "y", Side::Left)] {
        sheet.arrow(-REACH * axis, 0.98 * REACH * axis, Ink::Faint.pen().fine());
        sheet.label(0.94 * REACH * axis, side, name, Letters::Scalar, Ink::Faint);
    }
}

/// The path of q, in the way that it is turned.
fn arc(sheet: &mut Sheet, turn: &Turn) {
    let from_p = turn.q - turn.p;
    let path: Vec<Vec2> = (0..=48_u8)
        .map(|k| turn.p + rotate(turn.theta * f32::from(k) / 48.0).transform_vector2(from_p))
        .collect();
    sheet.path(&path, Ink::C.pen().dashed().fine());
    let label = turn.p + 0.45 * from_p.length() * middle(turn);
    sheet.label(label, Side::Middle, "θ", Letters::Scalar, Ink::C);
}

/// The matrix, and where it brings q.
fn numbers(sheet: &mut Sheet, turn: &Turn) {
    let entries = |column: glam::Vec3| column.to_array().map(|x| decimal(x, 2));
    let Mat3 { x_axis, y_axis, z_axis } = turn.matrix;
    sheet.label(sheet.place(WORDS - 12.0, 60.0 + 39.0), Side::Left, "M =", Letters::Plain, Ink::Main);
    sheet.matrix(WORDS, 60.0, 54.0, &[x_axis, y_axis, z_axis].map(entries));
    let pair = |place: Vec2| format!("({}, {})", decimal(place.x, 2), decimal(place.y, 2));
    sheet.lines(
        WORDS - 40.0,
        190.0,
        [
            format!("θ = {}", degrees(turn.theta)),
            format!("p = {}", pair(turn.p)),
            format!("q = {}", pair(turn.q)),
            format!("q′ = M·q = {}", pair(turn.turned())),
            format!("M·p = {}", pair(turn.matrix.transform_point2(turn.p))),
        ],
    );
}

fn alt(turn: &Turn) -> Words {
    let pair = |place: Vec2| format!("({}, {})", decimal(place.x, 2), decimal(place.y, 2));
    let (angle, p, q, turned) = (degrees(turn.theta), pair(turn.p), pair(turn.q), pair(turn.turned()));
    Words::new(
        format!("The point q = {q} is turned about the pivot p = {p} by {angle}, to {turned}."),
        format!("Het punt q = {q} is om het draaipunt p = {p} gedraaid over {angle}, naar {turned}."),
    )
}
