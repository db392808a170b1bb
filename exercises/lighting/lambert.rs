//! Diffuse or Lambertian reflection (L26, L27).
//!
//! Give the colour of a matt surface in the light of one lamp:
//!
//!     c = c_r · c_l · max(0, n·l)
//!
//! - `c_r`: what share of light the surface scatters, for red, green and blue; each between 0 and 1.
//! - `c_l`: the colour of the light, linear RGB; it may be brighter than 1.
//! - `n`, `to_light`: unit vectors; the normal, and l, from the surface towards the light.
//! - A surface that faces away from the light, n·l ≤ 0, is black. Colours have no upper end: do not clamp the result.
//!
//! glam: `a.dot(b)`, `f32::max`; `a * b` of two vectors multiplies channel by channel.

use glam::Vec3;

pub fn lambert(c_r: Vec3, c_l: Vec3, n: Vec3, to_light: Vec3) -> Vec3 {
    todo!()
}
