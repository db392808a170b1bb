//! Phong's highlight (L31, Figs 10.5 and 10.6).
//!
//! Give the colour of the highlight alone, without ambient light and diffuse reflection:
//!
//!     c = c_l · max(0, e·r)^p        where r = 2 (n·l) n − l
//!
//! - `c_l`: the light's colour, linear RGB; the highlight takes it whatever the surface's colour is (L29).
//! - `p`: the exponent, at least 1; not always a whole number.
//! - `n`, `to_light`, `to_eye`: unit vectors; the normal, l and e, both starting at the surface.
//! - The slide forgets: where the light stands behind the surface, n·l ≤ 0, there is no highlight at all (E3).
//!
//! glam: `a.dot(b)`; std: `f32::powf`, `f32::max`.

use glam::Vec3;

pub fn phong_highlight(c_l: Vec3, p: f32, n: Vec3, to_light: Vec3, to_eye: Vec3) -> Vec3 {
    todo!()
}
