//! Which way does light bounce, and which direction lies halfway? (L31, L33)

use glam::Vec3;

/// The reflected direction r = 2(n·l)n − l (L31): `to_light` mirrored about `n`. Length and angle to `n` stay.
///
/// It needs no square root, against what a slide suggests (E5).
///
/// - `n`: unit vector. `to_light`: any vector; a unit vector gives a unit vector.
///
/// ```
/// use glam::{Vec3, vec3};
/// assert_eq!(lighting::reflect(Vec3::Z, vec3(0.6, 0.0, 0.8)), vec3(-0.6, 0.0, 0.8));
/// ```
#[must_use]
pub fn reflect(n: Vec3, to_light: Vec3) -> Vec3 {
    2.0 * n.dot(to_light) * n - to_light
}

/// The halfway vector h = (e + l)/‖e + l‖ (L33), or `None` where it is undefined: e = −l (E3).
///
/// - `to_eye`, `to_light`: unit vectors.
///
/// ```
/// use glam::{Vec3, vec3};
/// assert_eq!(lighting::halfway(vec3(0.6, 0.0, 0.8), vec3(-0.6, 0.0, 0.8)), Some(Vec3::Z));
/// assert_eq!(lighting::halfway(Vec3::X, Vec3::NEG_X), None);
/// ```
#[must_use]
pub fn halfway(to_eye: Vec3, to_light: Vec3) -> Option<Vec3> {
    let sum = to_eye + to_light;
    // Both vectors carry rounding of about one epsilon a component: a shorter sum is noise and points anywhere.
    (sum.length() > 4.0 * f32::EPSILON).then(|| sum.normalize())
}
