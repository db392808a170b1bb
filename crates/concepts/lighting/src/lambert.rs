//! How much light does a matt surface scatter? As much as falls on it: the cosine (L26).

use glam::Vec3;

/// max(0, n·l): the share of the light that reaches a surface tilted away from it (L26, L27). 0 to 1.
///
/// The same from every direction: the eye does not occur in it. Proportional to the *cosine* of the angle, not to the
/// angle, as one slide says (E6). The light that is absorbed or scattered is the material's affair: matt does not mean
/// absorbing (E18).
///
/// - `n`, `to_light`: unit vectors in one common space.
///
/// ```
/// use glam::{Vec3, vec3};
/// assert_eq!(lighting::lambert(Vec3::Z, vec3(0.6, 0.0, 0.8)), 0.8);
/// assert_eq!(lighting::lambert(Vec3::Z, vec3(0.6, 0.0, -0.8)), 0.0);
/// ```
#[must_use]
pub fn lambert(n: Vec3, to_light: Vec3) -> f32 {
    // Rounding can carry the product of two unit vectors a hair beyond 1.
    n.dot(to_light).clamp(0.0, 1.0)
}
