//! From where, and whereto, does the eye look? (L1, L6)

use glam::{Mat3, Mat4, Vec3};

use crate::{Basis, DegenerateBasis};

/// An eye with a frame: it looks along −w, u points right and v up.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Camera {
    eye: Vec3,
    basis: Basis,
}

/// Why eye, target and up make no camera.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
pub enum DegenerateCamera {
    /// The eye is not a point.
    #[error("the eye is at {0}: not a finite point")]
    EyeNotFinite(Vec3),
    /// The target is not a point.
    #[error("the target is at {0}: not a finite point")]
    TargetNotFinite(Vec3),
    /// The eye is so far out that its camera coordinates overflow.
    #[error("the eye is at {0}: too far from the origin for 32-bit numbers")]
    TooFar(Vec3),
    /// Gaze and up span no frame.
    #[error(transparent)]
    Basis(#[from] DegenerateBasis),
}

impl Camera {
    /// The camera at `eye` that looks at `target`, with `up` pointing upwards on the screen (L6). All in world space.
    ///
    /// # Errors
    /// [`DegenerateCamera`] if the target is the eye, if up is zero or lies along the gaze, or if a number is not finite.
    ///
    /// ```
    /// use glam::{Vec3, vec3};
    /// use transforms::Camera;
    ///
    /// let camera = Camera::look_at(vec3(1.0, 2.0, 8.0), vec3(1.0, 2.0, 3.0), Vec3::Y)?;
    /// // Five units ahead of the eye is z = −5 in camera space.
    /// assert_eq!(camera.camera_from_world().transform_point3(vec3(1.0, 2.0, 3.0)), vec3(0.0, 0.0, -5.0));
    /// # Ok::<(), transforms::DegenerateCamera>(())
    /// ```
    pub fn look_at(eye: Vec3, target: Vec3, up: Vec3) -> Result<Self, DegenerateCamera> {
        if !eye.is_finite() {
            return Err(DegenerateCamera::EyeNotFinite(eye));
        }
        if !target.is_finite() {
            return Err(DegenerateCamera::TargetNotFinite(target));
        }
        let camera = Self { eye, basis: Basis::from_gaze_and_up(target - eye, up)? };
        if camera.camera_from_world().is_finite() { Ok(camera) } else { Err(DegenerateCamera::TooFar(eye)) }
    }

    /// e: where the camera is, in world space.
    #[must_use]
    pub fn eye(&self) -> Vec3 {
        self.eye
    }

    /// u, v, w: the camera's frame, in world space.
    #[must_use]
    pub fn basis(&self) -> Basis {
        self.basis
    }

    /// R · T: the rows u, v, w times the translation by −e (L1). Rigid: it keeps lengths and handedness.
    #[must_use]
    pub fn camera_from_world(&self) -> Mat4 {
        self.rotation() * self.translation()
    }

    /// The inverse of [`Camera::camera_from_world`]: T(e) · Rᵀ, with columns u, v, w, e.
    #[must_use]
    pub fn world_from_camera(&self) -> Mat4 {
        let Basis { u, v, w } = self.basis;
        Mat4::from_cols(u.extend(0.0), v.extend(0.0), w.extend(0.0), self.eye.extend(1.0))
    }

    /// T: moves the eye to the origin; the first factor of L1 to act.
    #[must_use]
    pub fn translation(&self) -> Mat4 {
        Mat4::from_translation(-self.eye)
    }

    /// R: the rows u, v, w; the second factor of L1 to act.
    #[must_use]
    pub fn rotation(&self) -> Mat4 {
        Mat4::from_mat3(Mat3::from_cols(self.basis.u, self.basis.v, self.basis.w).transpose())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::vec3;

    #[test]
    fn an_eye_that_overflows_is_an_error_and_not_an_infinite_matrix() {
        let eye = Vec3::splat(3e38);
        assert_eq!(Camera::look_at(eye, vec3(0.0, 1e38, 2e38), Vec3::Y), Err(DegenerateCamera::TooFar(eye)));
    }

    #[test]
    fn an_eye_at_its_own_target_or_nowhere_is_an_error() {
        let p = vec3(1.0, 2.0, 3.0);
        assert_eq!(Camera::look_at(p, p, Vec3::Y), Err(DegenerateBasis::ZeroGaze.into()));
        let nowhere = vec3(1.0, f32::NAN, 3.0);
        assert!(matches!(Camera::look_at(nowhere, p, Vec3::Y), Err(DegenerateCamera::EyeNotFinite(_))));
        assert!(matches!(Camera::look_at(p, nowhere, Vec3::Y), Err(DegenerateCamera::TargetNotFinite(_))));
    }
}
