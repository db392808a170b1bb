//! What is a curved patch? Sixteen control points and the surface that follows them.

use glam::DVec3;

/// A bicubic Bézier patch S(u, v) = Σᵢⱼ Bᵢ(u) Bⱼ(v) Pᵢⱼ with 0 ≤ u, v ≤ 1, Bᵢ the cubic Bernstein polynomials.
///
/// In f64, so that the points and normals of a patch carry no more error than their last rounding to f32.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BezierPatch {
    /// The control points Pᵢⱼ as `control[i][j]`: i goes with u, j with v.
    pub control: [[DVec3; 4]; 4],
}

/// A normal shorter than this against the square of the patch's size is rounding: f64 leaves about 1e-15.
const VANISHING: f64 = 1e-12;

impl BezierPatch {
    /// The point S(u, v).
    ///
    /// Neighbours that share the control points of a border get bitwise the same points there, run along from either
    /// end, if t and 1 − t are exact (as k/2ⁿ is): see [`bernstein`].
    ///
    /// ```
    /// use geometry::shapes::bezier::BezierPatch;
    /// use glam::dvec3;
    ///
    /// // Control points over a regular grid: z = x·y, which a bicubic patch follows exactly.
    /// let at = |k: usize| k as f64 / 3.0;
    /// let control = std::array::from_fn(|i| std::array::from_fn(|j| dvec3(at(i), at(j), at(i) * at(j))));
    /// let saddle = BezierPatch { control };
    /// assert!((saddle.point(0.25, 0.5) - dvec3(0.25, 0.5, 0.125)).length() < 1e-15);
    /// ```
    #[must_use]
    pub fn point(&self, u: f64, v: f64) -> DVec3 {
        self.blend(bernstein(u), bernstein(v))
    }

    /// A unit normal along ∂S/∂u × ∂S/∂v. `None` if the patch has no surface around (u, v).
    ///
    /// Where the product vanishes, as at a pole where a whole border is one point, the normal is its limit from inside
    /// the patch.
    #[must_use]
    pub fn normal(&self, u: f64, v: f64) -> Option<DVec3> {
        let ([b_u, d_u, dd_u], [b_v, d_v, dd_v]) = (derivatives(u), derivatives(v));
        let (s_u, s_v) = (self.blend(d_u, b_v), self.blend(b_u, d_v));
        let across = s_u.cross(s_v);
        let vanishing = VANISHING * self.size_squared();
        if across.length() > vanishing {
            return Some(across.normalize());
        }
        // The first term of its Taylor series towards the middle of the patch.
        let (s_uu, s_uv, s_vv) = (self.blend(dd_u, b_v), self.blend(d_u, d_v), self.blend(b_u, dd_v));
        let across_u = s_uu.cross(s_v) + s_u.cross(s_uv);
        let across_v = s_uv.cross(s_v) + s_u.cross(s_vv);
        let limit = (0.5 - u) * across_u + (0.5 - v) * across_v;
        (limit.length() > vanishing).then(|| limit.normalize())
    }

    /// Σᵢⱼ aᵢ bⱼ Pᵢⱼ, added up from both ends, so that reversed rows give the same bits.
    fn blend(&self, a: [f64; 4], b: [f64; 4]) -> DVec3 {
        let sum = |w: [f64; 4], p: [DVec3; 4]| (w[0] * p[0] + w[3] * p[3]) + (w[1] * p[1] + w[2] * p[2]);
        sum(a, self.control.map(|row| sum(b, row)))
    }

    fn size_squared(&self) -> f64 {
        let points = || self.control.iter().flatten();
        let (min, max) =
            points().fold((self.control[0][0], self.control[0][0]), |(lo, hi), p| (lo.min(*p), hi.max(*p)));
        (max - min).length_squared()
    }
}

/// The cubic Bernstein polynomials (1−t)³, 3t(1−t)², 3t²(1−t), t³ at t.
///
/// Written so that 1 − t gives the same four numbers in reverse, bit by bit.
#[must_use]
pub fn bernstein(t: f64) -> [f64; 4] {
    let s = 1.0 - t;
    [s * s * s, 3.0 * (s * s) * t, 3.0 * (t * t) * s, t * t * t]
}

/// The cubic Bernstein polynomials with their first and second derivatives.
fn derivatives(t: f64) -> [[f64; 4]; 3] {
    let s = 1.0 - t;
    let first = [-3.0 * s * s, 3.0 * s * (s - 2.0 * t), 3.0 * t * (2.0 * s - t), 3.0 * t * t];
    let second = [6.0 * s, 6.0 * (t - 2.0 * s), 6.0 * (s - 2.0 * t), 6.0 * t];
    [bernstein(t), first, second]
}

#[cfg(test)]
mod tests {
    use glam::dvec3;

    use super::*;

    /// A dome over the unit square whose whole border u = 0 is one point, with the axis −z.
    fn pole_patch() -> BezierPatch {
        let row =
            |r: f64, z: f64| [dvec3(r, 0.0, z), dvec3(r, 0.5 * r, z), dvec3(0.5 * r, r, z), dvec3(0.0, r, z)];
        BezierPatch { control: [row(0.0, 2.0), row(0.7, 2.0), row(1.3, 1.5), row(1.5, 0.0)] }
    }

    #[test]
    fn derivatives_are_those_of_differences() {
        // Central differences of a cubic are off by f'''/6 · h² ≤ 6 h²; with h = 1e-3 that is 6e-6.
        let (t, h) = (0.3, 1e-3);
        let [_, first, second] = derivatives(t);
        for k in 0..4 {
            let (lo, mid, hi) = (bernstein(t - h)[k], bernstein(t)[k], bernstein(t + h)[k]);
            assert!(((hi - lo) / (2.0 * h) - first[k]).abs() < 6.1e-6);
            assert!(((hi - 2.0 * mid + lo) / (h * h) - second[k]).abs() < 1e-8);
        }
    }

    #[test]
    fn normal_at_a_pole_is_the_limit_and_not_zero() {
        let patch = pole_patch();
        for v in [0.0, 0.25, 0.5, 1.0] {
            assert_eq!(patch.normal(0.0, v), Some(DVec3::Z));
            let near = patch.normal(1e-6, v).unwrap();
            assert!((near - DVec3::Z).length() < 1e-5);
        }
    }

    #[test]
    fn patch_without_a_surface_has_no_normal() {
        let point = BezierPatch { control: [[dvec3(1.0, 2.0, 3.0); 4]; 4] };
        assert_eq!(point.normal(0.5, 0.25), None);
    }

    #[test]
    fn border_read_backwards_gives_the_same_bits() {
        let patch = pole_patch();
        let mut reversed = patch.control;
        reversed.iter_mut().for_each(|row| row.reverse());
        let reversed = BezierPatch { control: reversed };
        for k in 0..64_u64 {
            // So many digits that the cubes are rounded, and yet 1 − t is exact.
            let t = (k * 0x3_1415_9265_3589 % (1 << 50)) as f64 / 2.0_f64.powi(50);
            assert_eq!(patch.point(1.0, t), reversed.point(1.0, 1.0 - t));
        }
    }
}
