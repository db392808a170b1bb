//! From the world to the camera (the pipeline's first two matrices, L1).
//!
//! Give the 4×4 matrix M that turns world coordinates into camera coordinates, M = R · T(−e):
//!
//!     x_u y_u z_u 0     1 0 0 −x_e
//!     x_v y_v z_v 0  ·  0 1 0 −y_e
//!     x_w y_w z_w 0     0 0 1 −z_e
//!      0   0   0  1     0 0 0   1
//!
//! - `eye`: e, where the camera is, in world coordinates.
//! - `frame`: its axes u (right), v (up), w (backwards) in world coordinates: unit vectors at right angles, right-handed.
//! - A point is a column (x, y, z, 1). In camera coordinates the eye is the origin and (a, b, c) means a·u + b·v + c·w from it.
//! - No input is degenerate.
//!
//! glam: `Mat4::from_cols` takes columns, `transpose()` exchanges them for rows, `Mat4::from_translation`, `extend`.

use glam::{Mat4, Vec3};
use vocabulary::Basis;

pub fn camera_from_world(eye: Vec3, frame: Basis) -> Mat4 {
    todo!()
}
