//! Exercise 6.11: carry the other basis back (L12).

use glam::{Mat4, Vec3, Vec4, vec3};
use testkit::by_hand::point3;
use vocabulary::Basis;

use super::drawing;
use super::inputs::{STANDARD, basis};
use crate::exercise::{arguments, signature};
use crate::{Concept, Example, Exercise, Law, Misconception, Title, close};

const STUB: &str = r#"//! Carry the other basis back (slide's exercise 6.11, L12).
//!
//! M, the matrix of exercise 6.10, carries the axes of `from` to those of `to`: M = R(to)ᵀ · R(from), where R has the axes of
//! a basis as its rows. Give the 4×4 matrix that undoes it:
//!
//!     M⁻¹ · to.u = from.u,   M⁻¹ · to.v = from.v,   M⁻¹ · to.w = from.w
//!
//! - `from`, `to`: unit vectors at right angles, right-handed; all in the same world coordinates.
//! - A direction is a column (x, y, z, 0), a point a column (x, y, z, 1). The origin stays where it is.
//! - No input is degenerate.
//!
//! Work it out on paper first: what is the inverse of a product, and what is the inverse of R?
//!
//! glam: `Mat3::from_cols(u, v, w)` takes columns, `transpose()` exchanges them for rows, `Mat4::from_mat3` completes.

use glam::Mat4;
use vocabulary::Basis;

pub fn change_of_basis_inverse(from: Basis, to: Basis) -> Mat4 {
    todo!()
}
"#;

signature!((from: Basis, to: Basis) -> Mat4);

/// Entries are sums of three products of numbers up to 1, off by less than 1e-6; two matrices in a row, or an inverse, get ten
/// times as much. Relative for a product of vectors as long as 10·10.
const TOLERANCE: f32 = 1e-5;

pub(super) fn exercise() -> Exercise {
    Exercise {
        name: "change_of_basis_inverse",
        concept: Concept::Transforms,
        items: "L12",
        title: Title { english: "Carry the other basis back", dutch: "De andere basis terugvoeren" },
        prerequisites: &["change_of_basis"],
        stub: STUB,
        signature: SIGNATURE,
        hints: [
            "Socks and shoes: what was put on last comes off first. What does that say about the inverse of a product A·B?",
            "(A·B)⁻¹ = B⁻¹·A⁻¹. The rows of R are unit vectors at right angles: multiply R by its transpose and see what \
                comes out.",
            "The inverse of R is its transpose, and the transpose of a transpose is R: M⁻¹ = R(from)ᵀ · R(to).",
        ],
        examples: examples(),
        laws: laws(),
        reference: program!(slide),
        variants: vec![program!(entry_by_entry), program!(sum_over_the_axes), program!(by_inverting)],
        misconceptions: misconceptions(),
        explanation: "R(from)ᵀ · R(to) is also the transpose of M, and also M with `from` and `to` exchanged: three ways to \
            the same matrix, none of which needs a division. For a matrix whose columns are unit vectors at right angles, \
            the inverse is always this cheap.",
        draw: drawing::carried_back_axes,
        source: include_str!("change_of_basis_inverse.rs"),
    }
}

/// A basis with numbers to calculate with: turned about x by the angle of a 3-4-5 triangle.
const TURNED: Basis = Basis { u: Vec3::X, v: vec3(0.0, 0.6, 0.8), w: vec3(0.0, -0.8, 0.6) };

/// x, y, z, each moved one place on.
const CYCLED: Basis = Basis { u: Vec3::Y, v: Vec3::Z, w: Vec3::X };

fn examples() -> Vec<Example> {
    let cycle = Mat4::from_cols(Vec4::Z, Vec4::X, Vec4::Y, Vec4::W);
    // x is w of `to` and goes to w = (0, −0.8, 0.6), y is u and goes to x, z is v and goes to (0, 0.6, 0.8).
    let both = Mat4::from_cols(
        Vec4::new(0.0, -0.8, 0.6, 0.0),
        Vec4::new(1.0, 0.0, 0.0, 0.0),
        Vec4::new(0.0, 0.6, 0.8, 0.0),
        Vec4::W,
    );
    vec![
        Example::new("y, z, x back to x, y, z", arguments![STANDARD, CYCLED], cycle, TOLERANCE),
        Example::new("y, z, x back to a turned basis", arguments![TURNED, CYCLED], both, TOLERANCE),
    ]
}

fn laws() -> Vec<Law> {
    vec![
        Law::of(
            "the_axes_return",
            3,
            "The axes of `to` return to those of `from`.",
            "An axis of `to` ends elsewhere. Follow to.u by hand: where is it after the first factor, and where after the \
                second?",
        )
        .over((basis(), basis()), |&(from, to), program| {
            let m: Mat4 = program.ask(arguments![from, to])?;
            for (name, axis, wanted) in [("u", to.u, from.u), ("v", to.v, from.v), ("w", to.w, from.w)] {
                close(&format!("M⁻¹·to.{name}"), m.transform_vector3(axis), wanted, TOLERANCE)?;
            }
            Ok(())
        }),
        Law::of(
            "it_undoes_the_exchanged",
            2,
            "With `from` and `to` exchanged it is undone: M⁻¹(from, to) · M⁻¹(to, from) = identity.",
            "There and back changes something. Which of the two R has to be undone here, and which one not?",
        )
        .over((basis(), basis()), |&(from, to), program| {
            let there: Mat4 = program.ask(arguments![from, to])?;
            let back: Mat4 = program.ask(arguments![to, from])?;
            close("M⁻¹(from, to) · M⁻¹(to, from)", there * back, Mat4::IDENTITY, TOLERANCE)
        }),
        Law::of(
            "right_hands_stay_right",
            2,
            "A right hand stays a right hand: M⁻¹(p × q) = M⁻¹p × M⁻¹q.",
            "A right hand has become a left one, or a length has changed. A rotation does neither; what else did the inverse \
                do?",
        )
        .over((basis(), basis(), point3(3), point3(3)), |&(from, to, p, q), program| {
            let m: Mat4 = program.ask(arguments![from, to])?;
            let crossed = m.transform_vector3(p).cross(m.transform_vector3(q));
            // Sums of two products of numbers up to 3·√3, each off by three roundings of that size.
            close("M⁻¹p × M⁻¹q", crossed, m.transform_vector3(p.cross(q)), 3.0 * TOLERANCE)
        }),
        Law::of(
            "points_stay_points",
            1,
            "A point stays a point: the fourth coordinate of M⁻¹ · (x, y, z, 1) is 1.",
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
    Mat4::from_mat3(rows(from).transpose() * rows(to))
}

fn entry_by_entry(from: Basis, to: Basis) -> Mat4 {
    // Every entry of M is a sum over the three axes; its transpose exchanges row and column.
    let mut m = Mat4::ZERO;
    for (old, new) in [(from.u, to.u), (from.v, to.v), (from.w, to.w)] {
        for row in 0..3 {
            for column in 0..3 {
                m.col_mut(column)[row] += old[row] * new[column];
            }
        }
    }
    m.w_axis.w = 1.0;
    m
}

fn sum_over_the_axes(from: Basis, to: Basis) -> Mat4 {
    let image =
        |p: glam::Vec3| (p.dot(to.u) * from.u + p.dot(to.v) * from.v + p.dot(to.w) * from.w).extend(0.0);
    Mat4::from_cols(image(glam::Vec3::X), image(glam::Vec3::Y), image(glam::Vec3::Z), glam::Vec4::W)
}

fn by_inverting(from: Basis, to: Basis) -> Mat4 {
    let rows = |basis: Basis| glam::Mat3::from_cols(basis.u, basis.v, basis.w).transpose();
    Mat4::from_mat3(rows(to).transpose() * rows(from)).inverse()
}

fn misconceptions() -> Vec<Misconception> {
    vec![
        Misconception {
            program: program!(forward),
            looks_like: "the matrix still goes from `from` to `to`",
            help: "This is M itself, the answer of exercise 6.10. Here the way back is wanted.",
        },
        Misconception {
            program: program!(order_kept),
            looks_like: "each factor is inverted, but the order is kept",
            help: "(A·B)⁻¹ = B⁻¹·A⁻¹: what was done last is undone first, so the factors change places.",
        },
        Misconception {
            program: program!(columns_for_rows),
            looks_like: "R has the axes as columns where the slide has them as rows",
            help: "`Mat3::from_cols(u, v, w)` has the axes as columns: that is the transpose of the slide's R.",
        },
        Misconception {
            program: program!(nothing_transposed),
            looks_like: "the factors changed places, but R of `from` is not transposed",
            help: "The inverse of R(from) is its transpose: it carries x, y, z to the axes of `from`.",
        },
        Misconception {
            program: program!(negated),
            looks_like: "the inverse is taken with a minus sign",
            help: "A minus undoes an addition. What undoes a rotation is the opposite rotation, which is the transpose.",
        },
        Misconception {
            program: program!(corner_left_zero),
            looks_like: "the 3×3 matrix is completed with zeros only",
            help: "The corner at the lower right is 1, or every point loses its 1 (and with it every later translation).",
        },
    ]
}

fn forward(from: Basis, to: Basis) -> Mat4 {
    let rows = |basis: Basis| glam::Mat3::from_cols(basis.u, basis.v, basis.w).transpose();
    Mat4::from_mat3(rows(to).transpose() * rows(from))
}

fn order_kept(from: Basis, to: Basis) -> Mat4 {
    let rows = |basis: Basis| glam::Mat3::from_cols(basis.u, basis.v, basis.w).transpose();
    Mat4::from_mat3(rows(to) * rows(from).transpose())
}

fn columns_for_rows(from: Basis, to: Basis) -> Mat4 {
    let columns = |basis: Basis| glam::Mat3::from_cols(basis.u, basis.v, basis.w);
    Mat4::from_mat3(columns(from).transpose() * columns(to))
}

fn nothing_transposed(from: Basis, to: Basis) -> Mat4 {
    let rows = |basis: Basis| glam::Mat3::from_cols(basis.u, basis.v, basis.w).transpose();
    Mat4::from_mat3(rows(from) * rows(to))
}

fn negated(from: Basis, to: Basis) -> Mat4 {
    let rows = |basis: Basis| glam::Mat3::from_cols(basis.u, basis.v, basis.w).transpose();
    Mat4::from_mat3(-(rows(to).transpose() * rows(from)))
}

fn corner_left_zero(from: Basis, to: Basis) -> Mat4 {
    let rows = |basis: Basis| glam::Mat3::from_cols(basis.u, basis.v, basis.w).transpose();
    let m = rows(from).transpose() * rows(to);
    Mat4::from_cols(m.x_axis.extend(0.0), m.y_axis.extend(0.0), m.z_axis.extend(0.0), glam::Vec4::ZERO)
}
