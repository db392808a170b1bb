//! How does a triangle come onto the screen without a camera? With its corners in pixels, as the slides draw it.

use geometry::Barycentric;
use glam::Vec3;
use zbuffer::{ScreenTriangle, ScreenVertex};

/// The triangle with these corners: x and y in pixels, z canonical.
pub(crate) fn triangle(corners: [[f32; 3]; 3]) -> ScreenTriangle {
    let weights = [Barycentric::A, Barycentric::B, Barycentric::C];
    ScreenTriangle {
        vertices: [0, 1, 2].map(|k| ScreenVertex {
            position: Vec3::from(corners[k]).as_dvec3(),
            inv_w: -1.0,
            weights: weights[k],
        }),
    }
}
