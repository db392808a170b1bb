//! Gouraud shading (L38).
//!
//! Give the colour of one pixel of a triangle. Step 2: the colour of each corner, with that corner's own normal, by the
//! lighting model (here ambient and diffuse light, L28). Step 3: interpolate these three colours.
//!
//!     c_k = c_r · (c_a + c_l · max(0, n_k·l))        c = α c_0 + β c_1 + γ c_2
//!
//! - `c_r`: what share of light the surface scatters. `c_a`, `c_l`: the colours of ambient light and lamp, linear RGB.
//! - `to_light`: l, unit vector, the same for the whole triangle.
//! - `normals`: n_0, n_1, n_2, the unit normals at the corners a, b, c.
//! - `at`: where in the triangle the pixel lies; α + β + γ = 1, none negative.
//!
//! glam: `a.dot(b)`; std: `f32::max`, `normals.map(|n| …)`.

use glam::Vec3;
use vocabulary::Barycentric;

pub fn gouraud(c_r: Vec3, c_a: Vec3, c_l: Vec3, to_light: Vec3, normals: [Vec3; 3], at: Barycentric) -> Vec3 {
    todo!()
}
