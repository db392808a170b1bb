//! Triangles for tests, by position and depth alone.

use geometry::Barycentric;
use glam::Vec3;

use crate::screen::{ScreenTriangle, ScreenVertex};

/// The triangle with these x, y and z; 1/w is −1 everywhere.
pub(super) fn triangle(corners: [[f32; 3]; 3]) -> ScreenTriangle {
    let weights = [Barycentric::A, Barycentric::B, Barycentric::C];
    ScreenTriangle {
        vertices: [0, 1, 2].map(|k| ScreenVertex {
            position: Vec3::from(corners[k]).as_dvec3(),
            inv_w: -1.0,
            weights: weights[k],
        }),
    }
}

/// The three long triangles of Fig 8.9: each lies over the next and under the one before (L14).
pub(super) fn three_polygon_cycle() -> [ScreenTriangle; 3] {
    [
        triangle([[4.0, 6.0, -0.5], [58.0, 9.0, 0.5], [4.0, 16.0, -0.5]]),
        triangle([[46.0, 3.0, -0.5], [56.0, 4.0, -0.5], [26.0, 58.0, 0.5]]),
        triangle([[40.0, 52.0, -0.5], [32.0, 60.0, -0.5], [6.0, 2.0, 0.5]]),
    ]
}
