//! Phong shading (L40).
//!
//! Give the colour of one pixel of a triangle. Step 2: interpolate the corners' normals. Step 3: the colour of the pixel by
//! the lighting model, with that normal (here diffuse light and highlight of one lamp, L32 without ambient light).
//!
//!     n = α n_0 + β n_1 + γ n_2, brought back to unit length
//!     c = c_r · c_l · max(0, n·l) + c_l · max(0, e·r)^p        where r = 2 (n·l) n − l
//!
//! - `material`: c_r is `material.diffuse`, p is `material.exponent`, at least 1.
//! - `c_l`: the lamp's colour, linear RGB. `to_light`, `to_eye`: l and e, unit vectors, the same for the whole triangle.
//! - `normals`: n_0, n_1, n_2, the unit normals at the corners a, b, c. They never cancel out.
//! - `at`: where in the triangle the pixel lies; α + β + γ = 1, none negative.
//! - The slide forgets: the mean of unit vectors is shorter than 1 (E7). And n·l ≤ 0 means no light and no highlight (E3).
//!
//! glam: `a.dot(b)`, `v.normalize()`; std: `f32::powf`, `f32::max`.

use glam::Vec3;
use vocabulary::{Barycentric, Material};

pub fn phong_shading(
    material: Material,
    c_l: Vec3,
    to_light: Vec3,
    to_eye: Vec3,
    normals: [Vec3; 3],
    at: Barycentric,
) -> Vec3 {
    todo!()
}
