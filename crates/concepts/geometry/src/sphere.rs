//! The exact ball, beside its approximations by triangles in [`crate::shapes`].

use glam::Vec3;

use crate::Aabb;

/// The points at distance `radius` from `center`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sphere {
    /// The middle.
    pub center: Vec3,
    /// The radius, greater than 0.
    pub radius: f32,
}

impl Sphere {
    /// The sphere around `center` with the given radius.
    #[must_use]
    pub fn new(center: Vec3, radius: f32) -> Self {
        Self { center, radius }
    }

    /// The outward unit normal at `p`, a point of the surface: (p − center) / radius.
    #[must_use]
    pub fn normal(&self, p: Vec3) -> Vec3 {
        (p - self.center) / self.radius
    }

    /// The smallest box around the sphere.
    #[must_use]
    pub fn aabb(&self) -> Aabb {
        Aabb { min: self.center - self.radius, max: self.center + self.radius }
    }
}
