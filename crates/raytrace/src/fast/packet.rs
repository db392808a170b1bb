//! Eight rays at once.

use fearless_simd::Simd;
use geometry::Ray;

use crate::query::Met;
use crate::space::SpaceRay;
use crate::world::World;

/// Rays in a packet.
pub(crate) const LANES: usize = 8;

#[inline(always)]
pub(crate) fn nearest<S: Simd>(simd: S, world: &World, rays: &[Ray], t0: f32, t1: f32, met: &mut [Option<Met>]) {
    for (ray, met) in rays.iter().zip(met) {
        *met = SpaceRay::new(ray).and_then(|ray| super::nearest_of_one(simd, world, &ray, t0, t1));
    }
}

#[inline(always)]
pub(crate) fn any_hit<S: Simd>(simd: S, world: &World, rays: &[Ray], t0: f32, t1: &[f32], met: &mut [bool]) {
    for ((ray, t1), met) in rays.iter().zip(t1).zip(met) {
        *met = SpaceRay::new(ray).is_some_and(|ray| super::any_of_one(simd, world, &ray, t0, *t1));
    }
}
