//! Carry one basis to another (slide's exercise 6.10, L11).
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
