//! Exercise 6.10: carry one basis to another (L11, E15).

use glam::{Mat4, Vec3, Vec4, vec3};
use testkit::by_hand::point3;
use vocabulary::Basis;

use super::drawing;
use super::inputs::{STANDARD, basis};
use crate::exercise::{arguments, signature};
use crate::{Concept, Example, Exercise, Law, Misconception, Title, close};

const STUB: &str = r#"//! Carry one basis to another (slide's exercise 6.10, L11).
//!
//! Give the 4×4 matrix M that turns the axes u, v, w of `from` into the axes u, v, w of `to`:
//!
//!     M · from.u = to.u,   M · from.v = to.v,   M · from.w = to.w
//!
//! - `from`, `to`: unit vectors at right angles, right-handed; all in the same world coordinates.
//! - A direction is a column (x, y, z, 0), a point a column (x, y, z, 1). The origin stays where it is.
//! - No input is degenerate.
//!
//! The slide works with R, the matrix whose rows are the axes of a basis: it carries those axes to x, y and z.
//! Its inverse is its transpose. The slide asks for a 4×4 matrix and answers with a 3×3 one (E15): complete it.
//!
//! glam: `Mat3::from_cols(u, v, w)` takes columns, `transpose()` exchanges them for rows, `Mat4::from_mat3` completes.

use glam::Mat4;
use vocabulary::Basis;

pub fn change_of_basis(from: Basis, to: Basis) -> Mat4 {
    todo!()
}
"#;

signature!((from: Basis, to: Basis) -> Mat4);

/// Entries are sums of three products of numbers up to 1; each axis is off by two roundings, each product and sum by one:
/// 3 · 5 · 2⁻²⁴ < 1e-6 an entry, and three matrices in a row, or an inverse, get ten times as much.
const TOLERANCE: f32 = 1e-5;

pub(super) fn exercise() -> Exercise {
    Exercise {
        name: "change_of_basis",
        concept: Concept::Transforms,
        items: "L11, E15",
        title: Title { english: "Carry one basis to another", dutch: "De ene basis in de andere overvoeren" },
        prerequisites: &[],
        stub: STUB,
        signature: SIGNATURE,
        hints: [
            "Go by way of x, y, z: which matrix carries u, v, w of `from` to x, y, z, and which one carries x, y, z to those \
                of `to`?",
            "R with the rows u, v, w carries u, v, w to x, y, z: each row is a dot product with one axis. Its transpose has \
             the axes as columns and goes the other way.",
            "First R of `from`, then the transpose of R of `to`. What acts first stands rightmost. Then \
             complete the 3×3 matrix with (0, 0, 0, 1).",
        ],
        examples: examples(),
        laws: laws(),
        reference: program!(slide),
        variants: vec![program!(sum_over_the_axes), program!(by_inverting)],
        misconceptions: misconceptions(),
        explanation: "Transpose of R(to) times R(from): take the coordinates along the old axes, spend them along the new \
            ones. Both bases are right-handed here, so M is a rotation; were one of them left-handed, the same formula would \
            give a mirror, with determinant -1 (E15).",
        draw: drawing::carried_axes,
        source: include_str!("change_of_basis.rs"),
    }
}

/// A basis with numbers to calculate with: turned about z by the angle of a 3-4-5 triangle.
const TURNED: Basis = Basis { u: vec3(0.6, 0.8, 0.0), v: vec3(-0.8, 0.6, 0.0), w: Vec3::Z };

/// x, y, z, each moved one place on.
const CYCLED: Basis = Basis { u: Vec3::Y, v: Vec3::Z, w: Vec3::X };

fn examples() -> Vec<Example> {
    let cycle = Mat4::from_cols(Vec4::Y, Vec4::Z, Vec4::X, Vec4::W);
    // x = 0.6 u − 0.8 v becomes 0.6 y − 0.8 z; y = 0.8 u + 0.6 v becomes 0.8 y + 0.6 z.
    let both = Mat4::from_cols(
        Vec4::new(0.0, 0.6, -0.8, 0.0),
        Vec4::new(0.0, 0.8, 0.6, 0.0),
        Vec4::new(1.0, 0.0, 0.0, 0.0),
        Vec4::W,
    );
    vec![
        Example::new("x, y, z to y, z, x", arguments![STANDARD, CYCLED], cycle, TOLERANCE),
        Example::new("a turned basis to y, z, x", arguments![TURNED, CYCLED], both, TOLERANCE),
    ]
}

fn laws() -> Vec<Law> {
    vec![
        Law::of(
            "the_axes_arrive",
            3,
            "The axes of `from` arrive at those of `to`: M·u = u, M·v = v, M·w = w.",
            "An axis arrives elsewhere. Follow from.u by hand: where is it after the first factor, and where after the second?",
        )
        .over((basis(), basis()), |&(from, to), program| {
            let m: Mat4 = program.ask(arguments![from, to])?;
            for (name, axis, wanted) in [("u", from.u, to.u), ("v", from.v, to.v), ("w", from.w, to.w)] {
                close(&format!("M·from.{name}"), m.transform_vector3(axis), wanted, TOLERANCE)?;
            }
            Ok(())
        }),
        Law::of(
            "there_and_back",
            2,
            "There and back again is no change: M(to, from) · M(from, to) = identity.",
            "Going to the other basis and back changes something. Which of the two factors has to undo its own R?",
        )
        .over((basis(), basis()), |&(from, to), program| {
            let there: Mat4 = program.ask(arguments![from, to])?;
            let back: Mat4 = program.ask(arguments![to, from])?;
            close("M(to, from) · M(from, to)", back * there, Mat4::IDENTITY, TOLERANCE)
        }),
        Law::of(
            "by_way_of_a_third",
            2,
            "It does not matter to go by way of a third basis: M(b, c) · M(a, b) = M(a, c).",
            "Two steps end elsewhere than one. In what order do the two factors act, and which basis belongs to which?",
        )
        .over((basis(), basis(), basis()), |&(a, b, c), program| {
            let first: Mat4 = program.ask(arguments![a, b])?;
            let second: Mat4 = program.ask(arguments![b, c])?;
            let straight: Mat4 = program.ask(arguments![a, c])?;
            close("M(b, c) · M(a, b)", second * first, straight, TOLERANCE)
        }),
        Law::of(
            "points_stay_points",
            1,
            "A point stays a point: the fourth coordinate of M · (x, y, z, 1) is 1.",
            "The fourth coordinate is no longer 1: what stands in the last row of the 4×4 matrix?",
        )
        .over((basis(), basis(), point3(6)), |&(from, to, p), program| {
            let m: Mat4 = program.ask(arguments![from, to])?;
            close("the fourth coordinate", (m * p.extend(1.0)).w, 1.0, TOLERANCE)
        }),
    ]
}

fn slide(from: Basis, to: Basis) -> Mat4 {
    let rows = |basis: Basis| glam::Mat3::from_cols(basis.u, basis.v, basis.w).transpose();
    Mat4::from_mat3(rows(to).transpose() * rows(from))
}

fn sum_over_the_axes(from: Basis, to: Basis) -> Mat4 {
    // What becomes of an arrow: its coordinates along the old axes are spent along the new ones.
    let image =
        |p: glam::Vec3| (p.dot(from.u) * to.u + p.dot(from.v) * to.v + p.dot(from.w) * to.w).extend(0.0);
    Mat4::from_cols(image(glam::Vec3::X), image(glam::Vec3::Y), image(glam::Vec3::Z), glam::Vec4::W)
}

fn by_inverting(from: Basis, to: Basis) -> Mat4 {
    let columns = |basis: Basis| {
        Mat4::from_cols(basis.u.extend(0.0), basis.v.extend(0.0), basis.w.extend(0.0), glam::Vec4::W)
    };
    columns(to) * columns(from).inverse()
}

fn misconceptions() -> Vec<Misconception> {
    vec![
        Misconception {
            program: program!(the_way_back),
            looks_like: "the matrix goes from `to` to `from`",
            help: "This is exercise 6.11, the inverse: it carries the axes of `to` to those of `from`.",
        },
        Misconception {
            program: program!(factors_in_reading_order),
            looks_like: "the factors stand in the order in which they happen",
            help: "The rightmost matrix meets the vector first: R of `from` belongs on the right.",
        },
        Misconception {
            program: program!(columns_for_rows),
            looks_like: "R has the axes as columns where the slide has them as rows",
            help: "`Mat3::from_cols(u, v, w)` has the axes as columns: that is the transpose of the slide's R.",
        },
        Misconception {
            program: program!(not_transposed),
            looks_like: "R of `to` is not transposed",
            help: "R of `to` carries its axes to x, y, z. Here the way from x, y, z to those axes is wanted: the transpose.",
        },
        Misconception {
            program: program!(half_way),
            looks_like: "the axes of `from` arrive at x, y, z",
            help: "That is half of the way. From x, y, z it goes on to the axes of `to`.",
        },
        Misconception {
            program: program!(corner_left_zero),
            looks_like: "the 3×3 matrix is completed with zeros only",
            help: "The corner at the lower right is 1, or every point loses its 1 (and with it every later translation).",
        },
    ]
}

fn the_way_back(from: Basis, to: Basis) -> Mat4 {
    let rows = |basis: Basis| glam::Mat3::from_cols(basis.u, basis.v, basis.w).transpose();
    Mat4::from_mat3(rows(from).transpose() * rows(to))
}

fn factors_in_reading_order(from: Basis, to: Basis) -> Mat4 {
    let rows = |basis: Basis| glam::Mat3::from_cols(basis.u, basis.v, basis.w).transpose();
    Mat4::from_mat3(rows(from) * rows(to).transpose())
}

fn columns_for_rows(from: Basis, to: Basis) -> Mat4 {
    let columns = |basis: Basis| glam::Mat3::from_cols(basis.u, basis.v, basis.w);
    Mat4::from_mat3(columns(to).transpose() * columns(from))
}

fn not_transposed(from: Basis, to: Basis) -> Mat4 {
    let rows = |basis: Basis| glam::Mat3::from_cols(basis.u, basis.v, basis.w).transpose();
    Mat4::from_mat3(rows(to) * rows(from))
}

fn half_way(from: Basis, _to: Basis) -> Mat4 {
    Mat4::from_mat3(glam::Mat3::from_cols(from.u, from.v, from.w).transpose())
}

fn corner_left_zero(from: Basis, to: Basis) -> Mat4 {
    let rows = |basis: Basis| glam::Mat3::from_cols(basis.u, basis.v, basis.w).transpose();
    let m = rows(to).transpose() * rows(from);
    Mat4::from_cols(m.x_axis.extend(0.0), m.y_axis.extend(0.0), m.z_axis.extend(0.0), glam::Vec4::ZERO)
}
