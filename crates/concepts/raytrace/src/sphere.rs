//! Where does a ray enter and leave a ball?
//!
//! The schoolbook formula (−b ± √(b² − 4ac)) / 2a loses everything to cancellation when the sphere is far away or very
//! large: b² and 4ac are then huge and nearly equal. The form used here is that of Hearn and Baker, as in Haines et al.,
//! *Precision Improvements for Ray/Sphere Intersection* (Ray Tracing Gems, 2019), in f64 throughout.

use geometry::{Ray, Sphere};
use glam::DVec3;

use crate::space::SpaceRay;

/// The smallest t with t0 < t < t1 at which the ray meets the sphere's surface, from outside or inside.
///
/// - `ray`, `sphere`: in one common space; the direction may have any length.
/// - `None` too for a ray that is not finite or has no direction.
///
/// ```
/// use geometry::{Ray, Sphere};
/// use glam::vec3;
/// use raytrace::sphere::intersect;
///
/// let ball = Sphere::new(vec3(0.0, 3.0, -5.0), 2.0);
/// let ray = Ray::new(vec3(0.0, 3.0, 5.0), vec3(0.0, 0.0, -4.0));
/// assert_eq!(intersect(&ray, &ball, 0.0, 9.0), Some(2.0)); // enters at z = −3
/// assert_eq!(intersect(&ray, &ball, 2.0, 9.0), Some(3.0)); // leaves at z = −7: t₀ itself does not count
/// ```
#[must_use]
pub fn intersect(ray: &Ray, sphere: &Sphere, t0: f32, t1: f32) -> Option<f32> {
    let crossings = crossings(&SpaceRay::new(ray)?, sphere)?;
    crossings.into_iter().map(|t| t as f32).find(|t| t0 < *t && *t < t1)
}

/// The two t at which the line crosses the sphere, smaller first; equal if it touches.
pub(crate) fn crossings(ray: &SpaceRay, sphere: &Sphere) -> Option<[f64; 2]> {
    let radius = f64::from(sphere.radius);
    let from_center = ray.origin - sphere.center.as_dvec3();
    let (a, b) = (ray.direction.length_squared(), -from_center.dot(ray.direction));
    // The point of the line nearest the centre: its distance, not b² − ac, says how far the line is from touching.
    let nearest: DVec3 = from_center + b / a * ray.direction;
    let discriminant = radius * radius - nearest.length_squared();
    // Also for a NaN, which comes of sizes beyond all range.
    if !(discriminant >= 0.0 && a > 0.0) {
        return None;
    }
    // The root where nothing cancels; the other one by Vieta: their product is c/a.
    let q = b + (a * discriminant).sqrt().copysign(b);
    let c = from_center.length_squared() - radius * radius;
    let (t, s) = if q == 0.0 { (0.0, 0.0) } else { (c / q, q / a) };
    Some([t.min(s), t.max(s)])
}

/// The point of the sphere nearest to `p`.
pub(crate) fn onto(sphere: &Sphere, p: DVec3) -> DVec3 {
    let center = sphere.center.as_dvec3();
    center + f64::from(sphere.radius) * (p - center).normalize_or(DVec3::Z)
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::{Vec3, vec3};

    #[test]
    fn a_far_small_sphere_and_a_huge_near_one_are_hit_where_they_are() {
        // The schoolbook formula in f32 finds the first at 99 968 or not at all.
        let far = Sphere::new(vec3(0.0, 0.0, -1e5), 0.5);
        let t = intersect(&Ray::new(Vec3::ZERO, Vec3::NEG_Z), &far, 0.0, f32::INFINITY).unwrap();
        assert_eq!(t, 99_999.5);
        let ground = Sphere::new(vec3(0.0, -1e7, 0.0), 1e7);
        let t = intersect(&Ray::new(vec3(0.0, 1.5, 0.0), Vec3::NEG_Y), &ground, 0.0, f32::INFINITY).unwrap();
        assert_eq!(t, 1.5);
    }

    #[test]
    fn from_inside_the_far_side_is_hit_and_from_beyond_nothing() {
        let ball = Sphere::new(vec3(1.0, 2.0, 3.0), 2.0);
        assert_eq!(intersect(&Ray::new(ball.center, Vec3::X), &ball, 0.0, 9.0), Some(2.0));
        assert_eq!(intersect(&Ray::new(vec3(4.0, 2.0, 3.0), Vec3::X), &ball, 0.0, 9.0), None);
        assert_eq!(intersect(&Ray::new(vec3(4.0, 2.0, 3.0), Vec3::ZERO), &ball, 0.0, 9.0), None);
    }

    #[test]
    fn a_tangent_touches_once() {
        let ball = Sphere::new(Vec3::ZERO, 1.0);
        let ray = Ray::new(vec3(-3.0, 1.0, 0.0), Vec3::X);
        assert_eq!(intersect(&ray, &ball, 0.0, 9.0), Some(3.0));
        assert_eq!(intersect(&Ray::new(vec3(-3.0, 1.0 + 1e-6, 0.0), Vec3::X), &ball, 0.0, 9.0), None);
    }
}
