//! Ambient light and diffuse reflection (L28).
//!
//! A surface that faces away from the lamp is black, which looks too hard. Ambient light comes from everywhere at once:
//!
//!     c = c_r · (c_a + c_l · max(0, n·l))
//!
//! - `c_r`: what share of light the surface scatters, each between 0 and 1.
//! - `c_a`, `c_l`: the colours of the ambient light and of the lamp, linear RGB; they may be brighter than 1.
//! - `n`, `to_light`: unit vectors; the normal, and l, from the surface towards the light.
//! - Colours have no upper end: do not clamp the result.
//!
//! glam: `a.dot(b)`, `f32::max`; `a * b` of two vectors multiplies channel by channel.

use glam::Vec3;

pub fn ambient_and_diffuse(c_r: Vec3, c_a: Vec3, c_l: Vec3, n: Vec3, to_light: Vec3) -> Vec3 {
    todo!()
}
