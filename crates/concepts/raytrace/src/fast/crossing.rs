//! When may a quick test in f32 be believed? When it knows how wrong it can be.
//!
//! The test is that of Möller and Trumbore: three determinants u, v, w, one for each edge, which have one sign where the
//! ray passes inside. In f32 they are wrong by up to a *margin* that is derived below. So there are three answers:
//!
//! - two of them differ in sign by more than the margin: surely no hit;
//! - all are of one sign by more than the margin: surely a hit, and t is known to within an *error*;
//! - else rounding decides, and only the exact test may ([`crate::triangle::watertight`]).
//!
//! # The margin
//!
//! With η = 2⁻²⁴, R ≥ |o| + |corner|, and edges no longer than L: a corner relative to the origin is wrong by at most 2ηR
//! (the origin is rounded from f64, then the difference), an edge and the direction by η of themselves. A determinant of
//! three vectors has six products, which are together at most √2 |a||b||c|, and each term is rounded by 5η more. So
//! |δu|, |δv| ≤ (2 + 1 + 1 + 5)√2 η·R·|d|·L < 13η·R|d|L, the whole determinant is wrong by (3 + 5)√2 η·L²|d| < 23η·R|d|L
//! as L ≤ 2R, and w, the difference of the three, by less than 13 + 13 + 23 + 7 = 56η·R|d|L. The margin is 64η·R|d|L.
//!
//! t = n/det: |δn| < 13η·RL², and since |t||d| ≤ R, the error of the determinant moves t by 12η·RL²/|det|; the quotient and
//! the rounding of the exact t add 4η·R/|d| ≤ 4η·RL²/|det|. A sure hit has |det| ≥ 3 margins, so that all this is off by
//! an eighth at most: less than 33η·RL²/|det|, and twice that is taken.
//!
//! What the exact test itself rounds, in f64, is smaller by 2²⁹ and disappears in what was rounded up.

use fearless_simd::prelude::*;

use crate::space::SpaceRay;

/// What the tests of one ray on one mesh have in common.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Probe {
    pub(crate) origin: [f32; 3],
    pub(crate) direction: [f32; 3],
    /// 64η·R: times L²/|det| the error of t.
    pub(crate) error: f32,
    /// 64η·R|d|: times L the margin.
    pub(crate) margin: f32,
}

/// 64η.
pub(super) const SHARE: f32 = 32.0 * f32::EPSILON;

/// Numbers between this and its inverse (directions), or at most as large (places), can be multiplied three at a time
/// without leaving the range of f32.
pub(super) const TAME: f32 = (1_u64 << 40) as f32;

/// Added to sizes, so that margins are larger than what is lost below the range of f32 (2⁻¹⁰⁶ of what is tame).
pub(crate) const LEAST_SIZE: f32 = 1.0 / (1_u32 << 30) as f32;

impl Probe {
    /// `reach`: the greatest distance of a corner from the origin of the mesh's space. `None` if f32 may overflow.
    #[inline(always)]
    pub(crate) fn new(ray: &SpaceRay, reach: f32) -> Option<Self> {
        let (origin, direction) = (ray.origin.as_vec3(), ray.direction.as_vec3());
        // Sums of coordinates are greater than lengths, and quicker.
        let (far, speed) = (origin.abs().element_sum() + reach, direction.abs().element_sum());
        if !(far < TAME && TAME.recip() < speed && speed < TAME) {
            return None;
        }
        let error = SHARE * far + LEAST_SIZE;
        let (origin, direction) = (origin.to_array(), direction.to_array());
        Some(Self { origin, direction, error, margin: error * speed })
    }
}

/// The determinants of as many tests as there are lanes.
pub(crate) struct Crossing<F> {
    /// The least and the greatest of u, v and w.
    least: F,
    greatest: F,
    /// t is `along` / `whole`.
    along: F,
    whole: F,
}

impl<F> Crossing<F> {
    /// The ray o + t·d against the triangle a, b, c, lane by lane.
    #[inline(always)]
    pub(crate) fn new<S: Simd>(o: [F; 3], d: [F; 3], [a, b, c]: [[F; 3]; 3]) -> Self
    where
        F: SimdFloat<S, Element = f32>,
    {
        let (to_b, to_c, from_a) = (minus(b, a), minus(c, a), minus(o, a));
        let across = cross(d, to_c);
        let turned = cross(from_a, to_b);
        let whole = dot(to_b, across);
        let (u, v) = (dot(from_a, across), dot(d, turned));
        let w = whole - u - v;
        Self { least: u.min(v).min(w), greatest: u.max(v).max(w), along: dot(to_c, turned), whole }
    }

    /// The lanes in which the ray may hit: all but the sure misses. A NaN misses.
    #[inline(always)]
    pub(crate) fn possible<S: Simd>(&self, margin: F) -> u32
    where
        F: SimdFloat<S, Element = f32>,
    {
        (self.least.simd_ge(-margin) | self.greatest.simd_le(margin)).to_bitmask() as u32
    }

    /// The lanes in which the ray surely hits.
    #[inline(always)]
    pub(crate) fn sure<S: Simd>(&self, margin: F) -> F::Mask
    where
        F: SimdFloat<S, Element = f32>,
    {
        self.least.simd_gt(margin) | self.greatest.simd_lt(-margin)
    }

    /// Where t lies at least and at most; `error` is that of the ray times L².
    #[inline(always)]
    pub(crate) fn t<S: Simd>(&self, simd: S, error: F) -> (F, F)
    where
        F: SimdFloat<S, Element = f32>,
    {
        let inverse = F::splat(simd, 1.0) / self.whole;
        let (t, error) = (self.along * inverse, error * inverse.abs());
        (t - error, t + error)
    }
}

#[inline(always)]
fn minus<S: Simd, F: SimdFloat<S, Element = f32>>(p: [F; 3], q: [F; 3]) -> [F; 3] {
    [p[0] - q[0], p[1] - q[1], p[2] - q[2]]
}

#[inline(always)]
fn cross<S: Simd, F: SimdFloat<S, Element = f32>>(p: [F; 3], q: [F; 3]) -> [F; 3] {
    [p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2], p[0] * q[1] - p[1] * q[0]]
}

#[inline(always)]
fn dot<S: Simd, F: SimdFloat<S, Element = f32>>(p: [F; 3], q: [F; 3]) -> F {
    p[0] * q[0] + p[1] * q[1] + p[2] * q[2]
}
