//! The normal of a triangle (L37, step 1 of flat shading).
//!
//! Give the unit vector at right angles to the triangle, on its front: the side from which its corners a, b, c run
//! anticlockwise.
//!
//!     n = (b − a) × (c − a) / |(b − a) × (c − a)|
//!
//! - `triangle`: its corners are points of space, in any one coordinate system; n is a direction of the same system.
//! - A triangle without area, its corners on one line or in one point, has no normal: give `None`.
//!
//! glam: `u.cross(v)`, `v.normalize()`, `v.try_normalize()`.

use glam::Vec3;
use vocabulary::Triangle;

pub fn face_normal(triangle: Triangle) -> Option<Vec3> {
    todo!()
}
