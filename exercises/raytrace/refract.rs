//! A ray on its way into glass, water or air (L58).
//!
//! Where light passes from one clear medium into another it is bent, by Snell's law:
//!
//!     n₁ sin θ₁ = n₂ sin θ₂
//!
//! θ₁ is the angle between the ray and the surface's normal before the surface, θ₂ the one behind it. Give the direction in which the
//! ray goes on, of length 1; `None` if no θ₂ exists: then all light is reflected, none passes.
//!
//! - `direction`: unit vector along the incoming ray, towards the surface. `normal`: unit vector on the side that the ray
//!   comes from, so that direction · normal < 0.
//! - `ratio`: n₁/n₂, greater than 0.
//! - The new direction lies in the plane of direction and normal. Rays at the very limit of total reflection do not occur.

use glam::Vec3;

pub fn refract(direction: Vec3, normal: Vec3, ratio: f32) -> Option<Vec3> {
    todo!()
}
