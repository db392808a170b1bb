//! The Blinn-Phong lighting model (L34).
//!
//! Give the colour of a point in ambient light and the light of one lamp:
//!
//!     c = c_r · (c_a + c_l · max(0, n·l)) + c_l · (h·n)^p        where h = (e + l) / |e + l|
//!
//! - `material`: c_r is `material.diffuse`, p is `material.exponent`, at least 1.
//! - `c_a`, `c_l`: the colours of the ambient light and of the lamp, linear RGB.
//! - `n`, `to_light`, `to_eye`: unit vectors; the normal, l and e, both starting at the surface.
//! - The slide says that h·n is always positive. It is not (E3): use max(0, h·n), and no highlight at all where the light
//!   stands behind the surface, n·l ≤ 0. Where e = −l there is no h and no highlight.
//! - Colours have no upper end: do not clamp the result.
//!
//! glam: `a.dot(b)`, `v.normalize_or_zero()`; std: `f32::powf`, `f32::max`.

use glam::Vec3;
use vocabulary::Material;

pub fn blinn_phong(material: Material, c_a: Vec3, c_l: Vec3, n: Vec3, to_light: Vec3, to_eye: Vec3) -> Vec3 {
    todo!()
}
