//! Triangles given directly in pixels, as the slides draw them, without a camera.

use geometry::Barycentric;
use glam::Vec3;
use zbuffer::{ScreenTriangle, ScreenVertex};

/// Returns the screen triangle with these corners: x and y in pixels, z canonical.
#[must_use]
pub fn triangle(corners: [[f32; 3]; 3]) -> ScreenTriangle {
    let weights = [Barycentric::A, Barycentric::B, Barycentric::C];
    ScreenTriangle {
        vertices: [0, 1, 2].map(|k| ScreenVertex {
            position: Vec3::from(corners[k]).as_dvec3(),
            inv_w: -1.0,
            weights: weights[k],
        }),
    }
}
