//! The reflected direction (L31, Fig 10.5).
//!
//! Give r, the direction in which light goes on that comes from `to_light` and meets a mirror:
//!
//!     r = 2 (n·l) n − l
//!
//! - `n`: unit vector, the mirror's normal.
//! - `to_light`: l, from the surface towards the light. It may have any length; r has the same.
//! - r starts at the surface, as l does. It lies on the same side of the surface as l, whichever that is.
//!
//! glam: `a.dot(b)`. Its `reflect` has another convention: there the light travels *towards* the surface.

use glam::Vec3;

pub fn reflection(n: Vec3, to_light: Vec3) -> Vec3 {
    todo!()
}
