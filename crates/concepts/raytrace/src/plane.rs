//! Where does a ray cross an unbounded plane?

use geometry::{Plane, Ray};
use glam::DVec3;

use crate::space::SpaceRay;

/// The t with t0 < t < t1 at which the ray crosses the plane, from either side: t = (offset − n·e) / (n·d).
///
/// - `ray`, `plane`: in one common space; the direction may have any length.
/// - `None` for a ray parallel to the plane, also if it lies in it, and for a ray that is not finite.
///
/// ```
/// use geometry::{Plane, Ray};
/// use glam::vec3;
/// use raytrace::plane::intersect;
///
/// let floor = Plane::new(vec3(7.0, 1.0, 4.0), vec3(0.0, 1.0, 0.0));
/// let ray = Ray::new(vec3(0.0, 5.0, 0.0), vec3(3.0, -2.0, 1.0));
/// assert_eq!(intersect(&ray, &floor, 0.0, 9.0), Some(2.0));
/// ```
#[must_use]
pub fn intersect(ray: &Ray, plane: &Plane, t0: f32, t1: f32) -> Option<f32> {
    let t = crossing(&SpaceRay::new(ray)?, plane)? as f32;
    (t0 < t && t < t1).then_some(t)
}

/// The t at which the line crosses the plane.
pub(crate) fn crossing(ray: &SpaceRay, plane: &Plane) -> Option<f64> {
    let n = plane.normal.as_dvec3();
    let t = (f64::from(plane.offset) - n.dot(ray.origin)) / n.dot(ray.direction);
    // Parallel rays divide by 0.
    t.is_finite().then_some(t)
}

/// The point of the plane nearest to `p`.
pub(crate) fn onto(plane: &Plane, p: DVec3) -> DVec3 {
    let n = plane.normal.as_dvec3();
    p - (n.dot(p) - f64::from(plane.offset)) / n.length_squared() * n
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::{Vec3, vec3};

    #[test]
    fn parallel_rays_meet_nothing_even_inside_the_plane() {
        let wall = Plane::new(vec3(2.0, 0.0, 0.0), Vec3::X);
        for x in [0.0, 2.0] {
            let ray = Ray::new(vec3(x, 1.0, 1.0), vec3(0.0, 3.0, 1.0));
            assert_eq!(intersect(&ray, &wall, f32::NEG_INFINITY, f32::INFINITY), None);
        }
    }
}
