//! Which points lie before the eye? Those on a ray (L46).

use glam::{Affine3A, Vec3};

/// The half-line p(t) = e + t·d (L46).
///
/// `direction` need not have unit length: a viewing ray runs from the eye to a point on the view plane, so that
/// t = 0 is the eye and t = 1 the view plane. Points with t < 0 lie behind the eye (L47).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ray {
    /// e: where the ray starts.
    pub origin: Vec3,
    /// d: where it goes; any length but zero.
    pub direction: Vec3,
}

impl Ray {
    /// The ray from `origin` along `direction`.
    #[must_use]
    pub fn new(origin: Vec3, direction: Vec3) -> Self {
        Self { origin, direction }
    }

    /// The ray from `from` to `through`, so that `at(0.0)` is `from` and `at(1.0)` is `through` (L46).
    #[must_use]
    pub fn through(from: Vec3, through: Vec3) -> Self {
        Self::new(from, through - from)
    }

    /// The point p(t) = e + t·d (L46).
    ///
    /// ```
    /// use geometry::Ray;
    /// use glam::vec3;
    ///
    /// let ray = Ray::through(vec3(1.0, 2.0, 3.0), vec3(3.0, 5.0, 9.0));
    /// assert_eq!(ray.at(2.0), vec3(5.0, 8.0, 15.0));
    /// ```
    #[must_use]
    pub fn at(&self, t: f32) -> Vec3 {
        self.origin + t * self.direction
    }

    /// The same ray in another space: its point at t is the image of this ray's point at t, so t keeps its meaning.
    #[must_use]
    pub fn transformed(&self, target_from_source: &Affine3A) -> Self {
        Self::new(
            target_from_source.transform_point3(self.origin),
            target_from_source.transform_vector3(self.direction),
        )
    }
}
