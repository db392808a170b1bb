//! Which boxes may eight rays meet? Those that a ray with a little thickness meets.
//!
//! A bundle is an interval of origins and an interval of directions, axis by axis. It meets a box unless *no* ray of it
//! does: the side where a ray enters is met at the earliest by the foremost origin with the fastest direction, the side
//! where it leaves at the latest by the hindmost origin with the slowest. That is the same arithmetic as for one ray,
//! with one number for entering and another for leaving.
//!
//! One ray is a bundle too, as thick as the rounding of its numbers to f32: so the boxes lose nothing (after Ize, *Robust
//! BVH Ray Traversal*, JCGT 2013), and the test needs no further allowance.

use fearless_simd::{f32x8, prelude::*};
use glam::{DVec3, Vec3};

use super::lanes::Lanes;
use crate::space::SpaceRay;

/// Along one axis.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Slab {
    /// The origin and the inverse direction that enter a box first.
    pub(crate) enter: (f32, f32),
    /// Those that leave it last.
    pub(crate) leave: (f32, f32),
    /// Which side is entered: 0 for the lower one, 1 for the upper one.
    pub(crate) side: usize,
}

/// Rays that run much the same way.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Bundle {
    pub(crate) slabs: [Slab; 3],
    /// No hit before this counts.
    pub(crate) t0: f32,
}

/// What rounding the origin to f32 may lose, 2⁻²⁴ of it, four times over: so much that adding it never rounds to nothing.
const ORIGIN_SLACK: f32 = 2.0 * f32::EPSILON;

/// t of a side is computed with five roundings, and the t of a hit is rounded once: together 6 · 2⁻²⁴ of it; this is
/// more than twice that.
const T_SLACK: f32 = 8.0 * f32::EPSILON;

/// Beyond this, and directions below its inverse, f32 would over- or underflow in the boxes.
const TAME: f32 = 1e30;

impl Bundle {
    /// The bundle of one ray, for hits from `t0` on. `None` if numbers are so large or small that f32 would over- or
    /// underflow.
    #[inline(always)]
    pub(crate) fn of_one(ray: &SpaceRay, t0: f32) -> Option<Self> {
        let (origin, direction) = (ray.origin.as_vec3(), ray.direction.as_vec3());
        let inverse = direction.recip();
        let tame = direction.abs().cmpgt(Vec3::splat(TAME.recip())) | direction.cmpeq(Vec3::ZERO);
        // Where the direction in f64 is so small that it is nothing in f32, it is not nothing.
        let vanished = direction.cmpeq(Vec3::ZERO).bitmask() != ray.direction.cmpeq(DVec3::ZERO).bitmask();
        let before = before(t0)?;
        if vanished
            || !(tame.all() && direction.abs().max_element() < TAME && origin.abs().max_element() < TAME)
        {
            return None;
        }
        let mut slabs = [Slab::default(); 3];
        for axis in 0..3 {
            let more = before * direction[axis].abs();
            slabs[axis] = Slab::new([origin[axis]; 2], [inverse[axis]; 2], more);
        }
        Some(Self { slabs, t0 })
    }

    /// The bundle of eight rays. `None` too if they run to different sides, and for `t0` < 0: behind the eye the fastest
    /// ray is the first to leave.
    #[inline(always)]
    pub(crate) fn of_eight<S: Simd>(simd: S, rays: &Lanes<S>, t0: f32) -> Option<Self> {
        if t0.is_nan() || t0 < 0.0 {
            return None;
        }
        let mut slabs = [Slab::default(); 3];
        for (axis, slab) in slabs.iter_mut().enumerate() {
            let (o, d) = (rays.origin[axis], rays.direction[axis]);
            let speed = d.abs();
            let tame = speed.simd_gt(TAME.recip()) | d.simd_eq(f32x8::splat(simd, 0.0));
            let inverse = f32x8::splat(simd, 1.0) / d;
            let (least, most) = (inverse.reduce_min(), inverse.reduce_max());
            if !tame.all_true() || least.is_sign_positive() != most.is_sign_positive() {
                return None;
            }
            *slab = Slab::new([o.reduce_min(), o.reduce_max()], [least, most], 0.0);
        }
        Some(Self { slabs, t0 })
    }
}

/// A t below 0 shrinks where it should grow: as much as this, times the speed, is added to the origin's slack.
#[inline(always)]
fn before(t0: f32) -> Option<f32> {
    let before = if t0 < 0.0 { -4.0 * T_SLACK * t0 } else { 0.0 };
    (before < TAME.sqrt()).then_some(before)
}

impl Slab {
    /// Between two origins and two inverse directions of one sign; `more` is added to the slack.
    #[inline(always)]
    fn new([low, high]: [f32; 2], [least, most]: [f32; 2], more: f32) -> Self {
        // Never 0, so that a ray that runs inside a side of a box meets 0 · ∞ nowhere.
        let more = more + f32::MIN_POSITIVE;
        let low = low - (ORIGIN_SLACK * low.abs() + more);
        let high = high + (ORIGIN_SLACK * high.abs() + more);
        let (shorter, longer) = (1.0 - T_SLACK, 1.0 + T_SLACK);
        if least.is_sign_positive() {
            Self { enter: (high, least * shorter), leave: (low, most * longer), side: 0 }
        } else {
            Self { enter: (low, most * shorter), leave: (high, least * longer), side: 1 }
        }
    }
}
