//! Where a ray hits a triangle (L51 to L54).
//!
//! Solve the system of `ray_triangle_system` for β, γ and t, by Cramer's rule, the inverse or elimination:
//!
//!     β(a − b) + γ(a − c) + t d = a − e
//!
//! Give t, β and γ if t > 0 and the point is in the triangle: β ≥ 0, γ ≥ 0, β + γ ≤ 1. Otherwise `None`.
//!
//! - `ray`: origin e and direction d, of any length. `triangle`: corners a, b, c, with an area. All in one space.
//! - The triangle is hit from both sides.
//! - A ray that is parallel to the triangle's plane hits nothing, even if it runs in that plane: `None`. The determinant is 0
//!   there, or almost: at most 0.00001 with rounding. For the other rays here it is at least 0.05 in size.
//! - On the triangle's border and at t = 0 either answer is right.
//!
//! glam: `cross`, `dot`, `Mat3::from_cols`, `Mat3::determinant`, `Mat3::inverse`.

use vocabulary::{Ray, Triangle, TriangleHit};

pub fn ray_triangle(ray: Ray, triangle: Triangle) -> Option<TriangleHit> {
    todo!()
}
