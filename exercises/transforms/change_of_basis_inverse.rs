//! Carry the other basis back (slide's exercise 6.11, L12).
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
