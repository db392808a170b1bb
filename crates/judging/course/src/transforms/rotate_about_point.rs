//! Exercise 6.9: rotate about a point that is not the origin (L10).

use std::f32::consts::{FRAC_PI_2, PI};

use glam::{Mat3, Vec2, mat3, vec2, vec3};
use testkit::by_hand::{angle, point2};

use super::drawing;
use crate::exercise::{arguments, signature};
use crate::{Concept, Example, Exercise, Law, Misconception, Title, close};

const STUB: &str = r#"//! Rotate about a point (slide's exercise 6.9, L10).
//!
//! Give the 3×3 matrix M that turns the plane by the angle theta about the point p:
//!
//!     M = T(p) · R(theta) · T(−p)
//!
//! - `theta`: radians; a positive angle turns anticlockwise, from the x-axis to the y-axis.
//! - `p`: the centre, in the coordinates of the points that M will turn.
//! - Points are columns (x, y, 1), so that M · (x, y, 1) is the turned point. No input is degenerate.
//!
//! glam: `Mat3::from_translation`, `Mat3::from_angle`, or `mat3(column, column, column)`: three columns, not rows.

use glam::{Mat3, Vec2};

pub fn rotate_about_point(theta: f32, p: Vec2) -> Mat3 {
    todo!()
}
"#;

signature!((theta: f32, p: Vec2) -> Mat3);

/// Coordinates are at most 6, a distance from the centre at most 12·√2 < 17. Each entry of M and each coordinate of a turned
/// point is a sum of at most four products below 17 of numbers that are off by one rounding: 4 · 17 · 2⁻²³ ≈ 8e-6. The slide's
/// solution is off by at most 2e-6 against f64; other orders of the same products get four times as much room.
const TOLERANCE: f32 = 3e-5;

pub(super) fn exercise() -> Exercise {
    Exercise {
        name: "rotate_about_point",
        concept: Concept::Transforms,
        items: "L10",
        title: Title { english: "Rotate about a point", dutch: "Rotatie om een punt" },
        prerequisites: &[],
        stub: STUB,
        signature: SIGNATURE,
        hints: [
            "R(theta) turns about the origin. What could you do to p first, so that the origin is where you need it?",
            "Move p to the origin, turn, move back. The matrix that acts first stands rightmost, next to the point.",
            "Multiplied out, the last column of M is p − R·p: (x − x cos θ + y sin θ, y − x sin θ − y cos θ, 1).",
        ],
        examples: examples(),
        laws: laws(),
        reference: program!(slide),
        variants: vec![program!(multiplied_out), program!(conjugated_as_complex_numbers)],
        misconceptions: misconceptions(),
        explanation: "T(p)·R·T(−p) says `do it elsewhere`: go there, do it, come back. The same sandwich scales about a point, mirrors in a \
            line, and turns a camera about what it looks at. Its linear part is R itself; only the last column knows p.",
        draw: drawing::rotation,
        source: include_str!("rotate_about_point.rs"),
    }
}

fn examples() -> Vec<Example> {
    // A quarter turn about (1, 0) carries the origin to (1, −1).
    let quarter = mat3(vec3(0.0, 1.0, 0.0), vec3(-1.0, 0.0, 0.0), vec3(1.0, -1.0, 1.0));
    let half = mat3(vec3(-1.0, 0.0, 0.0), vec3(0.0, -1.0, 0.0), vec3(4.0, 6.0, 1.0));
    vec![
        Example::new(
            "a quarter turn about (1, 0)",
            arguments![FRAC_PI_2, vec2(1.0, 0.0)],
            quarter,
            TOLERANCE,
        ),
        Example::new("half a turn about (2, 3)", arguments![PI, vec2(2.0, 3.0)], half, TOLERANCE),
    ]
}

fn laws() -> Vec<Law> {
    vec![
        Law::of(
            "the_centre_stays",
            3,
            "The centre stays where it is: M·p = p.",
            "The centre moved: was p brought to the origin before the turn, and back after it?",
        )
        .over((angle(), point2(6)), |&(theta, p), program| {
            let m: Mat3 = program.ask(arguments![theta, p])?;
            close("M·p", m * p.extend(1.0), p.extend(1.0), TOLERANCE)
        }),
        Law::of(
            "distances_stay",
            2,
            "Distances stay: |M·q − M·p| = |q − p|.",
            "Lengths changed: a rotation only turns. Do the columns hold (cos, sin) and (−sin, cos)?",
        )
        .over((angle(), point2(6), point2(6)), |&(theta, p, q), program| {
            let m: Mat3 = program.ask(arguments![theta, p])?;
            let turned = m.transform_point2(q) - m.transform_point2(p);
            close("|M·q − M·p|", turned.length(), q.distance(p), TOLERANCE)
        }),
        Law::of(
            "theta_is_the_angle",
            3,
            "An arrow from p to q turns by theta, anticlockwise.",
            "The arrow turned by another angle: radians or degrees, and which sign has the sine?",
        )
        .over((angle(), point2(6), point2(6)), |&(theta, p, q), program| {
            let m: Mat3 = program.ask(arguments![theta, p])?;
            let turned = m.transform_point2(q) - m.transform_point2(p);
            close("M·q − M·p", turned, Vec2::from_angle(theta).rotate(q - p), TOLERANCE)
        }),
        Law::of(
            "points_stay_points",
            1,
            "The last row is (0, 0, 1): a point stays a point.",
            "The last row is not (0, 0, 1): glam's `mat3` takes columns. Is the matrix transposed?",
        )
        .over((angle(), point2(6)), |&(theta, p), program| {
            let m: Mat3 = program.ask(arguments![theta, p])?;
            close("the last row", m.row(2), vec3(0.0, 0.0, 1.0), TOLERANCE)
        }),
    ]
}

fn slide(theta: f32, p: Vec2) -> Mat3 {
    Mat3::from_translation(p) * Mat3::from_angle(theta) * Mat3::from_translation(-p)
}

fn multiplied_out(theta: f32, p: Vec2) -> Mat3 {
    let (sin, cos) = theta.sin_cos();
    let last = glam::vec3(p.x - p.x * cos + p.y * sin, p.y - p.x * sin - p.y * cos, 1.0);
    glam::mat3(glam::vec3(cos, sin, 0.0), glam::vec3(-sin, cos, 0.0), last)
}

fn conjugated_as_complex_numbers(theta: f32, p: Vec2) -> Mat3 {
    let turn = Vec2::from_angle(theta);
    let image = |q: Vec2| p + turn.rotate(q - p);
    let origin = image(Vec2::ZERO);
    Mat3::from_cols(
        (image(Vec2::X) - origin).extend(0.0),
        (image(Vec2::Y) - origin).extend(0.0),
        origin.extend(1.0),
    )
}

fn misconceptions() -> Vec<Misconception> {
    vec![
        Misconception {
            program: program!(not_moved_back),
            looks_like: "p is brought to the origin, but not back",
            help: "After the turn everything still stands shifted by −p: one more translation belongs on the left.",
        },
        Misconception {
            program: program!(factors_in_reading_order),
            looks_like: "the factors stand in the order in which they happen",
            help: "The rightmost matrix meets the point first: what happens first is written last.",
        },
        Misconception {
            program: program!(in_degrees),
            looks_like: "theta is taken for degrees",
            help: "theta is in radians already, as sin and cos want it.",
        },
        Misconception {
            program: program!(clockwise),
            looks_like: "the turn is clockwise",
            help: "The columns of R are (cos, sin) and (−sin, cos): the minus stands above the diagonal.",
        },
        Misconception {
            program: program!(without_the_minus),
            looks_like: "both sines are positive",
            help: "The second column of R is the image of the y-axis, (−sin, cos): it turns to the left. With two plus signs the plane is squeezed.",
        },
        Misconception {
            program: program!(transposed),
            looks_like: "rows and columns are exchanged",
            help: "`mat3` takes columns: rows read from the slide, one after the other, come out transposed.",
        },
        Misconception {
            program: program!(about_the_origin),
            looks_like: "the turn is about the origin, wherever p is",
            help: "R alone keeps only the origin in its place.",
        },
    ]
}

fn not_moved_back(theta: f32, p: Vec2) -> Mat3 {
    Mat3::from_angle(theta) * Mat3::from_translation(-p)
}

fn factors_in_reading_order(theta: f32, p: Vec2) -> Mat3 {
    Mat3::from_translation(-p) * Mat3::from_angle(theta) * Mat3::from_translation(p)
}

fn in_degrees(theta: f32, p: Vec2) -> Mat3 {
    Mat3::from_translation(p) * Mat3::from_angle(theta.to_radians()) * Mat3::from_translation(-p)
}

fn clockwise(theta: f32, p: Vec2) -> Mat3 {
    Mat3::from_translation(p) * Mat3::from_angle(-theta) * Mat3::from_translation(-p)
}

fn without_the_minus(theta: f32, p: Vec2) -> Mat3 {
    let (sin, cos) = theta.sin_cos();
    let squeezed = glam::mat3(glam::Vec3::new(cos, sin, 0.0), glam::Vec3::new(sin, cos, 0.0), glam::Vec3::Z);
    Mat3::from_translation(p) * squeezed * Mat3::from_translation(-p)
}

fn transposed(theta: f32, p: Vec2) -> Mat3 {
    (Mat3::from_translation(p) * Mat3::from_angle(theta) * Mat3::from_translation(-p)).transpose()
}

fn about_the_origin(theta: f32, _p: Vec2) -> Mat3 {
    Mat3::from_angle(theta)
}
