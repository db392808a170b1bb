//! Does a triangle cover a sample? The top-left rule (E10).
//!
//! The slides ask for β > 0, γ > 0, β + γ < 1 once (L49), and with ≥ in `raytri` (L53). With > nobody draws a sample on a
//! side that two triangles share; with ≥ both do. A rasterizer gives it to exactly one of them:
//!
//! - A sample inside belongs to the triangle, one outside does not.
//! - A sample on a side belongs to the triangle if that is a left side or a top side.
//! - A left side is any that is not level and has the triangle on its right; a top side is level and has the triangle below it.
//! - A sample in a corner belongs to the triangle if both sides that meet there are left or top sides.
//! - A triangle without area covers nothing.
//!
//! Here y runs upwards: in an anticlockwise triangle a left side runs down, and a top side runs from right to left.
//!
//! - `triangle`: its corners on the screen, in pixels; clockwise or anticlockwise.
//! - `p`: the sample.
//! - All coordinates are multiples of 1/32 and at most 16, so that sums, differences and products of them are exact and "on the
//!   side" is exactly 0. A quotient is rounded: do not divide.
//!
//! glam: `u.perp_dot(v)` is u.x · v.y − u.y · v.x: positive if v points to the left of u.

use glam::Vec2;
use vocabulary::Triangle2;

pub fn covers(triangle: Triangle2, p: Vec2) -> bool {
    todo!()
}
