//! Barycentric coordinates on the screen (L48).
//!
//! Give the weights α, β, γ of the corners a, b, c that make the point p:
//!
//!     p = a + β (b − a) + γ (c − a),   α = 1 − β − γ
//!
//! - `triangle`: its corners on the screen, in pixels, y upwards; clockwise or anticlockwise.
//! - `p`: any point of the screen. Outside the triangle some weights are negative; that is right.
//! - `None` if the triangle has no area: its corners lie on one line, or in one point. All coordinates are
//!   multiples of ¼, so that products and differences of coordinates are exact.
//!
//! glam: `u.perp_dot(v)` is u.x · v.y − u.y · v.x: twice the signed area of the triangle that u and v span.

use glam::Vec2;
use vocabulary::{Barycentric, Triangle2};

pub fn barycentric(triangle: Triangle2, p: Vec2) -> Option<Barycentric> {
    todo!()
}
