//! How does a pyramid become a cube? The perspective matrix makes it a box (L2), the orthographic one a cube (L3).
//!
//! Visible points have clip w = z_camera < 0 here, since n and f are negative; the slides do not say so (E2). Whoever clips
//! by −w ≤ x ≤ w with w > 0 must negate the whole vector first: [`crate::opengl`] does.

use glam::{Mat4, vec4};

use crate::ViewVolume;

/// P (L2): bends the viewing pyramid into the box over its window, after division by w.
///
/// ```text
///   n 0  0    0
///   0 n  0    0
///   0 0 n+f −fn
///   0 0  1    0
/// ```
///
/// Points of the planes z = n and z = f keep their z; between them the order of depths stays; lines stay lines.
///
/// - `near`, `far`: n and f, negative, camera space.
///
/// # Panics
/// Unless `near` and `far` are finite, negative and different, and their product is in the range of f32.
///
/// ```
/// use glam::{vec2, vec3};
/// use transforms::projection::perspective;
///
/// let p = perspective(-2.0, -50.0);
/// // Twice as far as the window: half the size on it.
/// assert_eq!(p.project_point3(vec3(3.0, 1.0, -4.0)).truncate(), vec2(1.5, 0.5));
/// ```
#[must_use]
pub fn perspective(near: f32, far: f32) -> Mat4 {
    let before_the_eye = near < 0.0 && far < 0.0 && near.is_finite() && far.is_finite();
    assert!(
        before_the_eye && near != far,
        "near = {near} and far = {far} must be two different negative numbers"
    );
    let p = perspective_unchecked(near, far);
    assert!(p.is_finite(), "near = {near} and far = {far} are too large: their product overflows");
    p
}

pub(crate) fn perspective_unchecked(near: f32, far: f32) -> Mat4 {
    let (n, f) = (near, far);
    Mat4::from_cols(
        vec4(n, 0.0, 0.0, 0.0),
        vec4(0.0, n, 0.0, 0.0),
        vec4(0.0, 0.0, n + f, 1.0),
        vec4(0.0, 0.0, -f * n, 0.0),
    )
}

/// S · C (L3): carries the box [l, r] × [b, t] × [f, n] to the cube [−1, 1]³; near becomes z = +1, far z = −1.
///
/// The slide prints `r-1` where r − l is meant (E1).
///
/// # Panics
/// If the volume is degenerate ([`ViewVolume::validate`]).
///
/// ```
/// use glam::{Vec3, vec3};
/// use transforms::{ViewVolume, projection::orthographic};
///
/// let volume = ViewVolume { left: -1.0, right: 3.0, bottom: -2.0, top: 2.0, near: -1.0, far: -5.0 };
/// assert_eq!(orthographic(&volume).transform_point3(vec3(3.0, 2.0, -1.0)), Vec3::ONE);
/// assert_eq!(orthographic(&volume).transform_point3(vec3(-1.0, -2.0, -5.0)), Vec3::NEG_ONE);
/// ```
#[must_use]
pub fn orthographic(volume: &ViewVolume) -> Mat4 {
    assert_valid(volume);
    scale(volume) * center(volume)
}

/// S · C · P: from camera space to clip space, and after division by w to the canonical cube (L5).
///
/// # Panics
/// If the volume is degenerate ([`ViewVolume::validate`]).
#[must_use]
pub fn canonical_from_camera(volume: &ViewVolume) -> Mat4 {
    orthographic(volume) * perspective(volume.near, volume.far)
}

/// S (L3): scale by 2/(r − l), 2/(t − b), 2/(n − f). One factor of [`orthographic`], for those who want to see it; it does
/// not check the volume ([`ViewVolume::validate`]).
#[must_use]
pub fn scale(volume: &ViewVolume) -> Mat4 {
    let ViewVolume { left, right, bottom, top, near, far } = *volume;
    Mat4::from_scale(glam::vec3(2.0 / (right - left), 2.0 / (top - bottom), 2.0 / (near - far)))
}

/// C (L3): move the middle of the box to the origin. One factor of [`orthographic`], for those who want to see it; it does
/// not check the volume ([`ViewVolume::validate`]).
#[must_use]
pub fn center(volume: &ViewVolume) -> Mat4 {
    let ViewVolume { left, right, bottom, top, near, far } = *volume;
    Mat4::from_translation(-0.5 * glam::vec3(left + right, bottom + top, near + far))
}

fn assert_valid(volume: &ViewVolume) {
    if let Err(degenerate) = volume.validate() {
        panic!("{degenerate}");
    }
}
