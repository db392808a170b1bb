//! What are transforms tried on? Bases, viewing volumes and screens that a person can draw on squared paper.

use glam::Vec3;
use proptest::prelude::*;
use testkit::by_hand::{axes, between, coordinate};
use vocabulary::{Basis, ViewVolume};

/// A right-handed basis: unit vectors at right angles along whole-number directions, off by a few roundings.
pub(super) fn basis() -> impl Strategy<Value = Basis> + Clone {
    axes().prop_map(|[u, v, w]| Basis { u, v, w })
}

/// x, y and z.
pub(super) const STANDARD: Basis = Basis { u: Vec3::X, v: Vec3::Y, w: Vec3::Z };

/// Near and far, n and f: n in [−3, −¼], f between 1 and 12 beyond it; multiples of ¼.
pub(super) fn near_and_far() -> impl Strategy<Value = (f32, f32)> + Clone {
    // −1 first, so that shrinking ends there.
    let near = prop_oneof![between(1, 3), Just(0.75), Just(0.5), Just(0.25)];
    (near, between(1, 12)).prop_map(|(near, depth)| (-near, -near - depth))
}

/// A viewing volume whose window is between 2 and 6 wide and high and rarely lies in the middle: l and b in [−4, 4].
pub(super) fn volume() -> impl Strategy<Value = ViewVolume> + Clone {
    (coordinate(4), between(2, 6), coordinate(4), between(2, 6), near_and_far()).prop_map(
        |(left, width, bottom, height, (near, far))| ViewVolume {
            left,
            right: left + width,
            bottom,
            top: bottom + height,
            near,
            far,
        },
    )
}

/// A screen's width and height in pixels, at most 16 × 12. One in four may be as small as one pixel; shrinks to 4 × 3, where
/// there is something to see.
pub(super) fn screen() -> impl Strategy<Value = (u32, u32)> + Clone {
    prop_oneof![3 => (4..=16_u32, 3..=12_u32), 1 => (1..=16_u32, 1..=12_u32)]
}

/// A screen and one of its pixels.
pub(super) fn screen_and_pixel() -> impl Strategy<Value = ((u32, u32), (u32, u32))> + Clone {
    screen().prop_flat_map(|(width, height)| (Just((width, height)), (0..width, 0..height)))
}

/// Two different shares, multiples of ⅛, the smaller one first.
pub(super) fn two_shares() -> impl Strategy<Value = (f32, f32)> + Clone {
    (0..8, 1..=8).prop_map(|(at, step): (i32, i32)| (at as f32 / 8.0, (at + step).min(8) as f32 / 8.0))
}
