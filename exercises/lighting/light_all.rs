//! Phong's lighting model with several lights (L32, L24).
//!
//! Give the colour of a point of a surface in ambient light and the light of all lamps together:
//!
//!     c = c_r · c_a + Σ ( c_r · c_l · max(0, n·l) + c_l · max(0, e·r)^p )        where r = 2 (n·l) n − l
//!
//! - `material`: c_r is `material.diffuse`, p is `material.exponent`, at least 1.
//! - `c_a`: the colour of the ambient light. It shines once, however many lamps there are.
//! - `lights`: for a `Light::Directional`, l is its `to_light`; for a `Light::Point`, l is the unit vector from the point of
//!   the surface to its `position`. c_l is its `colour`: light does not fall off with distance here (E6). No lamp stands
//!   at the point itself. The list may be empty.
//! - `at`: where the point is, its unit normal n, and e, the unit vector to the eye. All is in world space.
//! - A light behind the surface, n·l ≤ 0, adds nothing, no highlight either (E3).
//! - Colours have no upper end: do not clamp the sum (E8).
//!
//! glam: `a.dot(b)`, `v.normalize()`; std: `match`, `f32::powf`, `f32::max`.

use glam::Vec3;
use vocabulary::{Light, Material, SurfacePoint};

pub fn light_all(material: Material, c_a: Vec3, lights: &[Light], at: SurfacePoint) -> Vec3 {
    todo!()
}
