//! A ray with a little thickness: what boxes are tested against, for one ray and for eight at once.
//!
//! A bundle is an interval of origins and an interval of directions, axis by axis. It meets a box unless *no* ray of it
//! does: the side where a ray enters is met at the earliest by the foremost origin with the fastest direction, the side
//! where it leaves at the latest by the hindmost origin with the slowest. That is the same arithmetic as for one ray,
//! with one number for entering and another for leaving.
//!
//! One ray is a bundle too, as thick as the rounding of its numbers to f32: so the boxes lose nothing (after Ize, *Robust
//! BVH Ray Traversal*, JCGT 2013), and the test needs no further allowance.

use glam::DVec3;

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

/// t of a side is computed with four roundings, and the t of a hit is rounded once: together 5 · 2⁻²⁴ of it; this is
/// three times that.
const T_SLACK: f32 = 8.0 * f32::EPSILON;

/// Beyond this, and below its inverse, f32 would over- or underflow in the boxes.
const TAME: f64 = 1e30;

impl Bundle {
    /// The bundle of these rays, for hits from `t0` on. `None` if they run to different sides, if there is no ray, or if
    /// numbers are so large or small that f32 would over- or underflow.
    #[inline]
    pub(crate) fn new<'a>(rays: impl IntoIterator<Item = &'a SpaceRay>, t0: f32) -> Option<Self> {
        let mut origins = [DVec3::INFINITY, DVec3::NEG_INFINITY];
        let mut inverses = [DVec3::INFINITY, DVec3::NEG_INFINITY];
        let mut fastest = DVec3::ZERO;
        for ray in rays {
            let inverse = ray.direction.recip();
            origins = [origins[0].min(ray.origin), origins[1].max(ray.origin)];
            inverses = [inverses[0].min(inverse), inverses[1].max(inverse)];
            fastest = fastest.max(ray.direction.abs());
        }
        let before = if t0 < 0.0 { -t0 } else { 0.0 };
        if !(f64::from(before) < TAME) {
            return None;
        }
        let mut slabs = [Slab::default(); 3];
        for (axis, slab) in slabs.iter_mut().enumerate() {
            // A t below 0 grows where it should shrink: as much is added to the origin's slack.
            let more = before * T_SLACK * 2.0 * fastest[axis] as f32;
            *slab = Slab::new(origins.map(|o| o[axis]), inverses.map(|i| i[axis]), more)?;
        }
        Some(Self { slabs, t0 })
    }
}

impl Slab {
    #[inline]
    fn new(origins: [f64; 2], inverses: [f64; 2], more: f32) -> Option<Self> {
        let tame = |o: f64| o == 0.0 || (TAME.recip()..TAME).contains(&o.abs());
        let steep = |i: f64| i.is_infinite() || (TAME.recip()..TAME).contains(&i.abs());
        if !(origins.into_iter().all(tame) && inverses.into_iter().all(steep)) {
            return None;
        }
        let forward = inverses.map(|i| i.is_sign_positive());
        if forward[0] != forward[1] {
            return None;
        }
        let [low, high] = origins.map(|o| o as f32);
        // Never 0, so that a ray that runs inside a side of a box meets 0 · ∞ nowhere.
        let slack = |o: f32| ORIGIN_SLACK * o.abs() + f32::MIN_POSITIVE + more;
        let (low, high) = (low - slack(low), high + slack(high));
        let [least, most] = inverses.map(|i| i as f32);
        let (less, more) = (1.0 - T_SLACK, 1.0 + T_SLACK);
        Some(if forward[0] {
            Self { enter: (high, least * less), leave: (low, most * more), side: 0 }
        } else {
            Self { enter: (low, most * less), leave: (high, least * more), side: 1 }
        })
    }
}
