//! Does the ray hit the triangle, and where? Two unknowns say where in the triangle, one where on the ray (L48–L54).
//!
//! - [`mod@system`]: the 3×3 system in (β, γ, t), and its solution by Cramer's rule, by the inverse and by elimination.
//! - [`raytri`]: the slide's test, with early exits.
//! - [`mod@watertight`]: the test that pictures are made with: no ray slips between two triangles.

pub mod system;
pub mod watertight;

use geometry::{Barycentric, Ray, Triangle};

pub use system::{RowOperation, Solution, System};
pub use system::{cramer, elimination, elimination_watched, inverse, system};
pub use watertight::watertight;

/// Where a ray hits a triangle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TriangleHit {
    /// The place on the ray, e + t·d.
    pub t: f32,
    /// The place in the triangle, αa + βb + γc.
    pub weights: Barycentric,
}

/// The slide's ray–triangle test with its early exits: t, then γ, then β (L53).
///
/// As on the slide, the ends of [t0, t1] and the border of the triangle count as hit: of two triangles that share an
/// edge, a ray at that edge hits both, while the strict test of L49 hits neither (E10), and with rounding either may
/// happen beside the edge. [`watertight()`] has neither fault.
///
/// The slide forgets the ray that is parallel to the triangle's plane, divides by zero and says "hit"; and it keeps t, β
/// and γ to itself (E11). Here the answer is `None` and `Some`.
///
/// - `ray`, `triangle`: in one common space.
/// - `None` too where f32 overflows or the triangle has no area.
///
/// ```
/// use geometry::{Ray, Triangle};
/// use glam::vec3;
/// use raytrace::triangle::raytri;
///
/// let triangle = Triangle::new(vec3(0.0, 0.0, 1.0), vec3(4.0, 0.0, 1.0), vec3(0.0, 8.0, 1.0));
/// let ray = Ray::new(vec3(1.0, 2.0, 7.0), vec3(0.0, 0.0, -2.0));
/// let hit = raytri(&ray, &triangle, 0.0, f32::INFINITY).unwrap();
/// assert_eq!((hit.t, hit.weights.beta, hit.weights.gamma), (3.0, 0.25, 0.25));
/// assert!(raytri(&ray, &triangle, 0.0, 2.0).is_none()); // beyond t1
/// ```
#[must_use]
pub fn raytri(ray: &Ray, triangle: &Triangle, t0: f32, t1: f32) -> Option<TriangleHit> {
    raytri_or_exit(ray, triangle, t0, t1).ok()
}

/// At which of its exits [`raytri`] leaves (L53).
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Exit {
    /// The ray is parallel to the triangle's plane, or the triangle has no area (E11).
    Parallel,
    /// t is not in [t0, t1].
    T,
    /// γ is not in [0, 1].
    Gamma,
    /// β is not in [0, 1 − γ].
    Beta,
}

/// [`raytri`], which says where it left.
///
/// # Errors
/// The [`Exit`] that it took, if the ray misses.
pub fn raytri_or_exit(ray: &Ray, triangle: &Triangle, t0: f32, t1: f32) -> Result<TriangleHit, Exit> {
    // The columns and the right-hand side of the system (L50); each unknown is a quotient of determinants (Cramer).
    let (to_b, to_c, d) = (triangle.a - triangle.b, triangle.a - triangle.c, ray.direction);
    let to_e = triangle.a - ray.origin;
    let determinant = to_b.dot(to_c.cross(d));
    if system::is_parallel(determinant, [to_b, to_c, d]) {
        return Err(Exit::Parallel);
    }
    // "Not inside" instead of the slide's "outside": a NaN is not inside.
    let t = to_b.dot(to_c.cross(to_e)) / determinant;
    if !(t0 <= t && t <= t1) {
        return Err(Exit::T);
    }
    let gamma = to_b.dot(to_e.cross(d)) / determinant;
    if !(0.0..=1.0).contains(&gamma) {
        return Err(Exit::Gamma);
    }
    let beta = to_e.dot(to_c.cross(d)) / determinant;
    if !(0.0 <= beta && beta <= 1.0 - gamma) {
        return Err(Exit::Beta);
    }
    Ok(TriangleHit { t, weights: Barycentric::from_beta_gamma(beta, gamma) })
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::{Vec3, vec3};

    /// L53 word for word: no test for parallel, and each exit asks for "outside".
    fn slide_raytri(ray: &Ray, triangle: &Triangle, t0: f32, t1: f32) -> bool {
        let (to_b, to_c, d) = (triangle.a - triangle.b, triangle.a - triangle.c, ray.direction);
        let to_e = triangle.a - ray.origin;
        let determinant = to_b.dot(to_c.cross(d));
        let t = to_b.dot(to_c.cross(to_e)) / determinant;
        if t < t0 || t > t1 {
            return false;
        }
        let gamma = to_b.dot(to_e.cross(d)) / determinant;
        if !(0.0..=1.0).contains(&gamma) && !gamma.is_nan() {
            return false;
        }
        let beta = to_e.dot(to_c.cross(d)) / determinant;
        if beta < 0.0 || beta > 1.0 - gamma {
            return false;
        }
        true
    }

    #[test]
    fn the_exercise_of_the_lecture_comes_out() {
        // L54: α = β = γ = 1/3, t = 2/3, at (1/3, 1/3, 1/3). A few roundings of numbers of size 1.
        let ray = Ray::new(Vec3::ONE, Vec3::NEG_ONE);
        let triangle = Triangle::new(Vec3::X, Vec3::Y, Vec3::Z);
        for hit in [raytri(&ray, &triangle, 0.0, 1.0), watertight(&ray, &triangle, 0.0, 1.0)] {
            let hit = hit.unwrap();
            assert!(hit.weights.to_vec3().abs_diff_eq(Vec3::splat(1.0 / 3.0), 4.0 * f32::EPSILON));
            assert!((hit.t - 2.0 / 3.0).abs() < 4.0 * f32::EPSILON);
            assert!(ray.at(hit.t).abs_diff_eq(Vec3::splat(1.0 / 3.0), 8.0 * f32::EPSILON));
        }
    }

    #[test]
    fn each_exit_is_taken_for_its_reason() {
        let triangle = Triangle::new(vec3(0.0, 0.0, 1.0), vec3(4.0, 0.0, 1.0), vec3(0.0, 8.0, 1.0));
        let down = |x, y| Ray::new(vec3(x, y, 7.0), vec3(0.0, 0.0, -2.0));
        let exit = |ray: Ray| raytri_or_exit(&ray, &triangle, 0.0, 9.0).err();
        assert_eq!(exit(Ray::new(vec3(1.0, 2.0, 7.0), vec3(1.0, 2.0, 0.0))), Some(Exit::Parallel));
        assert_eq!(exit(Ray::new(vec3(1.0, 2.0, 7.0), vec3(0.0, 0.0, 2.0))), Some(Exit::T));
        // Outside by both: γ is asked first.
        assert_eq!(exit(down(-1.0, -1.0)), Some(Exit::Gamma));
        assert_eq!(exit(down(3.0, 6.0)), Some(Exit::Beta));
        assert_eq!(exit(down(1.0, 2.0)), None);
    }

    #[test]
    fn the_slide_hits_with_a_ray_in_the_plane_and_ours_does_not() {
        // E11: 0/0 is NaN, and no comparison with NaN says "outside".
        let triangle = Triangle::new(vec3(0.0, 0.0, 2.0), vec3(3.0, 0.0, 2.0), vec3(0.0, 5.0, 2.0));
        let beside = Ray::new(vec3(-9.0, 40.0, 2.0), vec3(1.0, 2.0, 0.0));
        assert!(slide_raytri(&beside, &triangle, 0.0, f32::INFINITY));
        assert_eq!(raytri(&beside, &triangle, 0.0, f32::INFINITY), None);
        assert_eq!(watertight(&beside, &triangle, 0.0, f32::INFINITY), None);
    }

    #[test]
    fn strict_misses_a_shared_edge_inclusive_hits_twice_watertight_hits_once() {
        // E10: two halves of a rectangle, and a ray at the middle of their diagonal; all numbers are exact.
        let [a, b, c, d] = [[0.0, 0.0], [4.0, 0.0], [4.0, 2.0], [0.0, 2.0]].map(|[x, y]| vec3(x, y, 1.0));
        let halves = [Triangle::new(a, b, c), Triangle::new(a, c, d)];
        let ray = Ray::new(vec3(2.0, 1.0, 4.0), vec3(0.0, 0.0, -1.0));
        let count = |hit: &dyn Fn(&Triangle) -> bool| halves.iter().filter(|triangle| hit(triangle)).count();
        let strict = |triangle: &Triangle| cramer(&system(&ray, triangle)).unwrap().weights().is_inside();
        assert_eq!(count(&strict), 0);
        assert_eq!(count(&|triangle| raytri(&ray, triangle, 0.0, 9.0).is_some()), 2);
        assert_eq!(count(&|triangle| watertight(&ray, triangle, 0.0, 9.0).is_some()), 1);
    }
}
