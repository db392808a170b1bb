//! The halfway vector (L33, Fig 10.8).
//!
//! Give the unit vector that lies halfway between the directions to the eye and to the light:
//!
//!     h = (e + l) / |e + l|
//!
//! - `to_eye`, `to_light`: unit vectors, e and l.
//! - Where eye and light lie in exactly opposite directions, e = −l, nothing lies halfway: give `None`.
//!
//! glam: `v.length()`, `v.normalize()`, `v.try_normalize()`.

use glam::Vec3;

pub fn halfway(to_eye: Vec3, to_light: Vec3) -> Option<Vec3> {
    todo!()
}
