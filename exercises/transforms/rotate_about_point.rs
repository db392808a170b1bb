//! Rotate about a point (slide's exercise 6.9, L10).
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
