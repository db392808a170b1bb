//! Which of two triangles does a ray hit that is aimed exactly at their common edge? Exactly one.
//!
//! The idea is that of Woop, Benthin and Wald, *Watertight Ray/Triangle Intersection* (JCGT 2013): shear space so that
//! the ray becomes the z-axis. Each corner gets a place in the xy-plane that depends on the ray and the corner alone, not
//! on the triangle, and the question becomes flat: does the triangle hold the origin? For each edge, on which side of it
//! does the origin lie?
//!
//! Two things go beyond the paper. The side is found *exactly*, not merely with the same rounding on both sides of an
//! edge. And an origin on an edge, or on a corner, is moved aside by (ε, ε²) with an infinitely small ε > 0: a tie-break
//! in the manner of the rasterizer's top-left rule (Edelsbrunner and Mücke, *Simulation of Simplicity*, 1990). Together
//! they make the answers those of a flat, exact problem without special cases, in which a closed surface covers every
//! point an even number of times. So no ray slips through an edge or a corner, none hits both sides, and every line
//! crosses a closed mesh an even number of times (E10).

use geometry::{Barycentric, Ray, Triangle};
use glam::{DVec2, DVec3, Vec3};

use super::TriangleHit;
use crate::space::SpaceRay;

/// Where the ray hits the triangle with t0 < t < t1, from either side; of the triangles that share an edge or a corner
/// and cover the ray, exactly one is hit, however the ray is aimed.
///
/// - `ray`, `triangle`: in one common space.
/// - `None` for a triangle that the ray sees edge-on or that has no area, and for a ray that is not finite or has no
///   direction.
///
/// ```
/// use geometry::{Ray, Triangle};
/// use glam::vec3;
/// use raytrace::triangle::watertight;
///
/// let triangle = Triangle::new(vec3(0.0, 0.0, 1.0), vec3(4.0, 0.0, 1.0), vec3(0.0, 8.0, 1.0));
/// let ray = Ray::new(vec3(1.0, 2.0, 7.0), vec3(0.0, 0.0, -2.0));
/// let hit = watertight(&ray, &triangle, 0.0, f32::INFINITY).unwrap();
/// assert_eq!((hit.t, hit.weights.beta, hit.weights.gamma), (3.0, 0.25, 0.25));
/// ```
#[must_use]
pub fn watertight(ray: &Ray, triangle: &Triangle, t0: f32, t1: f32) -> Option<TriangleHit> {
    let hit = ShearedRay::new(&SpaceRay::new(ray)?).hit(&triangle.corners())?;
    (t0 < hit.t && hit.t < t1).then_some(hit)
}

/// A ray with what all triangles of one mesh need of it: the axes and the shear that make it the z-axis.
#[derive(Clone, Copy, Debug)]
pub(crate) struct ShearedRay {
    origin: [f64; 3],
    direction: [f64; 3],
    /// The ray's greatest axis, which becomes z, and the two after it.
    axes: [usize; 3],
    /// What x and y lose for each unit of z.
    shear: DVec2,
}

impl ShearedRay {
    pub(crate) fn new(ray: &SpaceRay) -> Self {
        let direction = ray.direction.to_array();
        let z = ray.direction.abs().max_position();
        let (x, y) = ((z + 1) % 3, (z + 2) % 3);
        let shear = DVec2::new(direction[x], direction[y]) / direction[z];
        Self { origin: ray.origin.to_array(), direction, axes: [x, y, z], shear }
    }

    /// The hit on the whole line, −∞ < t < ∞.
    pub(crate) fn hit(&self, corners: &[Vec3; 3]) -> Option<TriangleHit> {
        let [a, b, c] = [self.sheared(corners[0]), self.sheared(corners[1]), self.sheared(corners[2])];
        // Twice the signed areas of the triangles that the origin makes with the edges: the weights, not yet divided.
        let areas = [side(b.0, c.0), side(c.0, a.0), side(a.0, b.0)];
        if areas.iter().any(|area| *area < 0.0) && areas.iter().any(|area| *area > 0.0) {
            return None;
        }
        if areas.contains(&0.0) && !holds_shifted_origin([a.0, b.0, c.0], areas) {
            return None;
        }
        // All of one sign and not all 0: nothing cancels.
        let whole = areas[0] + areas[1] + areas[2];
        let [alpha, beta, gamma] = [areas[0] / whole, areas[1] / whole, areas[2] / whole];
        let t =
            self.within_box(corners, (alpha * a.1 + beta * b.1 + gamma * c.1) / self.direction[self.axes[2]]);
        Some(TriangleHit { t: t as f32, weights: Barycentric::from_beta_gamma(beta as f32, gamma as f32) })
    }

    /// The corner relative to the ray's origin: its place in the plane across the ray, and its z along the ray.
    fn sheared(&self, corner: Vec3) -> (DVec2, f64) {
        let corner = corner.to_array();
        let relative = |axis: usize| f64::from(corner[axis]) - self.origin[axis];
        let [x, y, z] = [relative(self.axes[0]), relative(self.axes[1]), relative(self.axes[2])];
        (DVec2::new(x - self.shear.x * z, y - self.shear.y * z), z)
    }

    /// `t`, moved into the part of the ray that lies in the box around the triangle.
    ///
    /// It lies there already, but for a triangle seen so nearly edge-on that its area is all rounding. A hierarchy of
    /// boxes relies on it.
    fn within_box(&self, corners: &[Vec3; 3], t: f64) -> f64 {
        let min = corners[0].min(corners[1]).min(corners[2]).to_array();
        let max = corners[0].max(corners[1]).max(corners[2]).to_array();
        let mut t = t;
        for axis in 0..3 {
            let (o, d) = (self.origin[axis], self.direction[axis]);
            if d != 0.0 {
                let (enter, leave) = ((f64::from(min[axis]) - o) / d, (f64::from(max[axis]) - o) / d);
                t = t.clamp(enter.min(leave), enter.max(leave));
            }
        }
        t
    }
}

/// p × q: twice the signed area of the triangle (0, p, q), with the sign of the exact result.
fn side(p: DVec2, q: DVec2) -> f64 {
    let (left, right) = (p.x * q.y, p.y * q.x);
    // Rounding keeps order: where the rounded products differ, the exact ones differ the same way.
    if left != right {
        return left - right;
    }
    if left == 0.0 {
        return 0.0;
    }
    // They round alike; what they lost in rounding, which a fused multiply-add returns exactly, decides.
    p.x.mul_add(q.y, -left) - p.y.mul_add(q.x, -right)
}

/// Whether the triangle holds the origin moved aside by (ε, ε²).
fn holds_shifted_origin([a, b, c]: [DVec2; 3], areas: [f64; 3]) -> bool {
    let edges = [(b, c), (c, a), (a, b)];
    let signs: [i8; 3] = std::array::from_fn(|k| {
        let (p, q) = edges[k];
        // (p − s) × (q − s) with s = (ε, ε²) is p × q − ε (q.y − p.y) + ε² (q.x − p.x): the first term not 0 decides.
        [areas[k], p.y - q.y, q.x - p.x].iter().map(|term| sign(*term)).find(|sign| *sign != 0).unwrap_or(0)
    });
    signs[0] != 0 && signs[0] == signs[1] && signs[1] == signs[2]
}

fn sign(x: f64) -> i8 {
    i8::from(x > 0.0) - i8::from(x < 0.0)
}

/// The point of the plane of a triangle with the given β and γ, in f64: it lies in the plane as exactly as f64 allows.
pub(crate) fn point_in_plane(corners: &[Vec3; 3], weights: Barycentric) -> DVec3 {
    let [a, b, c] = corners.map(|corner| corner.as_dvec3());
    a + f64::from(weights.beta) * (b - a) + f64::from(weights.gamma) * (c - a)
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::vec3;

    #[test]
    fn the_side_is_right_where_both_products_round_alike() {
        // (1 + 2⁻³⁰)(1 − 2⁻³⁰) = 1 − 2⁻⁶⁰ rounds to 1.
        let tiny = f64::EPSILON.sqrt() / 64.0;
        let (p, q) = (DVec2::new(1.0 + tiny, 1.0), DVec2::new(1.0, 1.0 - tiny));
        assert_eq!(p.x * q.y - p.y * q.x, 0.0);
        assert_eq!(side(p, q), -tiny * tiny);
        assert_eq!(side(q, p), tiny * tiny);
    }

    #[test]
    fn a_ray_at_the_hub_of_a_fan_hits_one_blade() {
        for blades in 3..40 {
            let rim = |k: i32| {
                let turn = k.rem_euclid(blades) as f32 / blades as f32 * std::f32::consts::TAU;
                vec3(turn.cos(), turn.sin(), 0.25 * (3.0 * turn).sin())
            };
            let hub = vec3(0.1, -0.05, 0.3);
            let ray = Ray::through(vec3(0.7, 0.4, 5.0), hub);
            let hits = (0..blades)
                .filter(|&k| watertight(&ray, &Triangle::new(hub, rim(k), rim(k + 1)), 0.0, 9.0).is_some());
            assert_eq!(hits.count(), 1, "{blades} blades");
        }
    }

    #[test]
    fn rays_that_are_no_rays_hit_nothing() {
        let triangle = Triangle::new(Vec3::ZERO, Vec3::X, Vec3::Y);
        for ray in [
            Ray::new(Vec3::ONE, Vec3::ZERO),
            Ray::new(Vec3::splat(f32::NAN), Vec3::NEG_Z),
            Ray::new(vec3(0.2, 0.2, 1.0), vec3(0.0, f32::INFINITY, -1.0)),
        ] {
            assert_eq!(watertight(&ray, &triangle, f32::NEG_INFINITY, f32::INFINITY), None);
        }
    }
}
