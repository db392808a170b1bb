//! A ray in the space of an object.

use geometry::Ray;
use glam::{DAffine3, DVec3};

/// A ray in f64: carrying it into an object's space costs next to no accuracy.
#[derive(Clone, Copy, Debug)]
pub(crate) struct SpaceRay {
    pub(crate) origin: DVec3,
    pub(crate) direction: DVec3,
}

impl SpaceRay {
    /// `None` for a ray that is none: something is not finite, or the direction is zero.
    pub(crate) fn new(ray: &Ray) -> Option<Self> {
        let usable = ray.origin.is_finite() && ray.direction.is_finite() && ray.direction != glam::Vec3::ZERO;
        usable.then(|| Self::of(ray))
    }

    /// The same ray in f64, whatever its numbers.
    #[inline]
    pub(crate) fn of(ray: &Ray) -> Self {
        Self { origin: ray.origin.as_dvec3(), direction: ray.direction.as_dvec3() }
    }

    /// The same ray in another space; t keeps its meaning.
    pub(crate) fn transformed(&self, target_from_source: &DAffine3) -> Self {
        Self {
            origin: target_from_source.transform_point3(self.origin),
            direction: target_from_source.transform_vector3(self.direction),
        }
    }

    pub(crate) fn at(&self, t: f64) -> DVec3 {
        self.origin + t * self.direction
    }
}
