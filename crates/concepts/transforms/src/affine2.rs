//! How do points of the plane move? By 3×3 matrices on (x, y, 1).
//!
//! Read [`rotate_about`] for the exercise (L10), then [`crate::basis`].

use glam::{Mat3, Vec2, vec3};

/// Moves every point by `by`.
///
/// ```
/// use glam::vec2;
/// use transforms::affine2::translate;
///
/// assert_eq!(translate(vec2(3.0, -1.0)).transform_point2(vec2(2.0, 5.0)), vec2(5.0, 4.0));
/// ```
#[must_use]
pub fn translate(by: Vec2) -> Mat3 {
    Mat3::from_cols(vec3(1.0, 0.0, 0.0), vec3(0.0, 1.0, 0.0), vec3(by.x, by.y, 1.0))
}

/// Scales x by `by.x` and y by `by.y`; the origin stays.
#[must_use]
pub fn scale(by: Vec2) -> Mat3 {
    Mat3::from_cols(vec3(by.x, 0.0, 0.0), vec3(0.0, by.y, 0.0), vec3(0.0, 0.0, 1.0))
}

/// Rotates about the origin by `theta` radians; positive turns x towards y, anticlockwise where y points up.
///
/// ```
/// use glam::vec2;
/// use std::f32::consts::FRAC_PI_2;
/// use transforms::affine2::rotate;
///
/// let turned = rotate(FRAC_PI_2).transform_point2(vec2(2.0, 1.0));
/// assert!(turned.abs_diff_eq(vec2(-1.0, 2.0), 1e-6));
/// ```
#[must_use]
pub fn rotate(theta: f32) -> Mat3 {
    let (sin, cos) = theta.sin_cos();
    Mat3::from_cols(vec3(cos, sin, 0.0), vec3(-sin, cos, 0.0), vec3(0.0, 0.0, 1.0))
}

/// Rotates about the point `p` by `theta` radians: T(p) · R(θ) · T(−p), multiplied out (L10, exercise 6.9).
///
/// ```text
///   cos θ   −sin θ   x_p − x_p cos θ + y_p sin θ
///   sin θ    cos θ   y_p − x_p sin θ − y_p cos θ
///     0        0                  1
/// ```
///
/// ```
/// use glam::vec2;
/// use std::f32::consts::FRAC_PI_2;
/// use transforms::affine2::rotate_about;
///
/// let about = rotate_about(FRAC_PI_2, vec2(3.0, 1.0));
/// assert!(about.transform_point2(vec2(5.0, 1.0)).abs_diff_eq(vec2(3.0, 3.0), 1e-6));
/// ```
#[must_use]
pub fn rotate_about(theta: f32, p: Vec2) -> Mat3 {
    let (sin, cos) = theta.sin_cos();
    Mat3::from_cols(
        vec3(cos, sin, 0.0),
        vec3(-sin, cos, 0.0),
        vec3(p.x - p.x * cos + p.y * sin, p.y - p.x * sin - p.y * cos, 1.0),
    )
}
