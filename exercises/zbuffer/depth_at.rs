//! The depth of a triangle at a point of the screen (L18, E9).
//!
//! Depths are computed for the corners and interpolated for everything between them:
//!
//!     z = α z_a + β z_b + γ z_c
//!
//! where α, β, γ are the barycentric coordinates of p in the triangle on the screen (L48).
//!
//! - `triangle`: its corners after projection. x and y are in pixels, y upwards; z is the depth, from −1 (farthest) to 1
//!   (nearest). On the screen it has an area; clockwise or anticlockwise.
//! - `p`: a point of the screen, in pixels; inside the triangle or not. Outside, the triangle's plane goes on.
//!
//! glam: `corner.truncate()` leaves z out; `u.perp_dot(v)` is u.x · v.y − u.y · v.x.

use glam::Vec2;
use vocabulary::Triangle;

pub fn depth_at(triangle: Triangle, p: Vec2) -> f32 {
    todo!()
}
