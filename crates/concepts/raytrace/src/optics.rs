//! What do a mirror and a pane of glass do with a ray? Reflection, Snell's law and Fresnel's equations (L58).

use glam::Vec3;

/// The mirrored direction d − 2(d·n)n of an incoming ray.
///
/// [`lighting::reflect`] mirrors a direction that points *away* from the surface; a ray points towards it.
///
/// - `d`: any length, which stays. `n`: unit normal, either side.
///
/// ```
/// use glam::{Vec3, vec3};
/// assert_eq!(raytrace::optics::mirrored(vec3(3.0, 1.0, -4.0), Vec3::Z), vec3(3.0, 1.0, 4.0));
/// ```
#[must_use]
pub fn mirrored(d: Vec3, n: Vec3) -> Vec3 {
    d - 2.0 * d.dot(n) * n
}

/// Snell's law: the direction in which a ray goes on beyond the surface, n₁ sin θ₁ = n₂ sin θ₂. `None` for total
/// internal reflection: no such θ₂ exists.
///
/// - `d`: unit direction of the incoming ray. `n`: unit normal on the side it comes from, d·n ≤ 0.
/// - `ratio`: n₁/n₂, refractive index before the surface over that behind it, greater than 0.
/// - Result: unit vector.
///
/// ```
/// use glam::{Vec3, vec3};
/// use raytrace::optics::refracted;
///
/// // From air into something with index 4/3, at sin θ₁ = 0.8: sin θ₂ = 0.6.
/// let t = refracted(vec3(0.8, 0.0, -0.6), Vec3::Z, 0.75).unwrap();
/// assert!(t.abs_diff_eq(vec3(0.6, 0.0, -0.8), 1e-6));
/// assert_eq!(refracted(vec3(0.8, 0.0, -0.6), Vec3::Z, 4.0 / 3.0), None); // the other way: total reflection
/// ```
#[must_use]
pub fn refracted(d: Vec3, n: Vec3, ratio: f32) -> Option<Vec3> {
    let cos_before = -d.dot(n);
    // The part of d along the surface has length sin θ₁, and n₁/n₂ times that beyond it.
    let along = ratio * (d + cos_before * n);
    let cos_squared = 1.0 - along.length_squared();
    (cos_squared >= 0.0).then(|| (along - cos_squared.sqrt() * n).normalize())
}

/// Fresnel's equations: the share of unpolarized light that a surface between two clear media reflects, 0 to 1; the rest
/// passes.
///
/// The mean of the shares for the two polarizations, ((cos θ₁ − m cos θ₂)/(cos θ₁ + m cos θ₂))² and
/// ((m cos θ₁ − cos θ₂)/(m cos θ₁ + cos θ₂))² with m = n₂/n₁. It is 1 for total internal reflection.
///
/// - `cos_before`: cos θ₁, of the angle between ray and normal; 0 to 1.
/// - `ratio`: n₁/n₂, as for [`refracted`].
///
/// ```
/// use raytrace::optics::fresnel;
/// assert!((fresnel(1.0, 1.0 / 1.5) - 0.04).abs() < 1e-6); // glass, looked at straight: 4 % is reflected
/// assert_eq!(fresnel(0.0, 1.0 / 1.5), 1.0); // at grazing angles it is a mirror
/// ```
#[must_use]
pub fn fresnel(cos_before: f32, ratio: f32) -> f32 {
    let cos_before = cos_before.clamp(0.0, 1.0);
    let cos_squared = 1.0 - ratio * ratio * (1.0 - cos_before * cos_before);
    if cos_squared <= 0.0 {
        return 1.0;
    }
    let (m, cos_behind) = (ratio.recip(), cos_squared.sqrt());
    let across = (cos_before - m * cos_behind) / (cos_before + m * cos_behind);
    let along = (m * cos_before - cos_behind) / (m * cos_before + cos_behind);
    0.5 * (across * across + along * along)
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::vec3;

    #[test]
    fn beyond_the_critical_angle_nothing_passes() {
        // From glass of index 1.5 into air: sin θ = 1/1.5 at 41.8°.
        for (degrees, passes) in [(41.7_f32, true), (41.9, false), (80.0, false)] {
            let (sin, cos) = degrees.to_radians().sin_cos();
            assert_eq!(refracted(vec3(sin, 0.0, -cos), Vec3::Z, 1.5).is_some(), passes, "{degrees}");
            assert_eq!(fresnel(cos, 1.5) < 1.0, passes, "{degrees}");
        }
    }

    #[test]
    fn at_brewsters_angle_the_reflected_light_is_half_of_the_other_polarization() {
        // tan θ = n₂/n₁: one polarization is not reflected at all. Known value for index 1.5: 7.4 %.
        let cos = 1.5_f32.atan().cos();
        assert!((fresnel(cos, 1.0 / 1.5) - 0.0740).abs() < 1e-4);
    }

    #[test]
    fn equal_media_change_nothing() {
        let d = vec3(0.48, 0.6, -0.64);
        assert!(refracted(d, Vec3::Z, 1.0).unwrap().abs_diff_eq(d, 1e-6));
        assert!(fresnel(0.64, 1.0) < 1e-12);
    }
}
