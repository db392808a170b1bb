//! How does something in space come onto a sheet? Through the camera of the lecture.

use glam::{Vec2, Vec3};
use transforms::{Camera, DegenerateCamera};

/// A camera that looks at a diagram in space. Parallel projection keeps parallels parallel, which diagrams want; for
/// perspective ask [`transforms::Pipeline`].
#[derive(Clone, Copy, Debug)]
pub struct View {
    camera: Camera,
}

impl View {
    /// From `eye` towards `target`, y up.
    ///
    /// # Errors
    /// If `eye` and `target` are one place, or one stands above the other.
    pub fn new(eye: Vec3, target: Vec3) -> Result<Self, DegenerateCamera> {
        Ok(Self { camera: Camera::look_at(eye, target, Vec3::Y)? })
    }

    /// Where a point lands on the sheet, in units of the world; `target` lands at (0, 0) only if the sheet is laid so.
    pub fn at(&self, p_world: Vec3) -> Vec2 {
        self.camera.camera_from_world().transform_point3(p_world).truncate()
    }
}
