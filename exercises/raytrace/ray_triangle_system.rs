//! The system that says where a ray meets a triangle's plane (L50).
//!
//! Where the ray meets the plane, both sides name the same point:
//!
//!     e + t d = a + β(b − a) + γ(c − a)
//!
//! Bring what is unknown to one side and give the system A·(β, γ, t) = b as the pair (A, b):
//!
//! - `ray`: origin e and direction d, of any length. `triangle`: corners a, b, c. All in one space.
//! - The unknowns stand in the order β, γ, t.
//! - Do not solve it. Rows in another order, or with another sign on both sides, are right as well: its solution counts.
//! - No input is degenerate; a ray parallel to the plane has its system too, which has no (or not one) solution.
//!
//! glam: `Mat3::from_cols(first, second, third)` takes columns, not rows.

use glam::{Mat3, Vec3};
use vocabulary::{Ray, Triangle};

pub fn ray_triangle_system(ray: Ray, triangle: Triangle) -> (Mat3, Vec3) {
    todo!()
}
