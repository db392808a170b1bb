//! Is a point in shadow? (L56)
//!
//! Send a shadow ray from the point p to the lamp at l:
//!
//!     q(t) = p + t (l − p)        q(0) is the point, q(1) the lamp
//!
//! Give `true` if it crosses the surface of a sphere at some t with 0.001 < t < 1, `false` otherwise.
//!
//! - `point`: usually on the surface of one of the spheres, up to rounding; the list holds that sphere too.
//! - `light`: where the lamp is, outside all spheres. `spheres`: any number, also none. All in world space.
//! - Crossings close to t = 0.001 or t = 1, and rays that only touch, do not occur.

use glam::Vec3;
use vocabulary::Sphere;

pub fn in_shadow(point: Vec3, light: Vec3, spheres: &[Sphere]) -> bool {
    todo!()
}
