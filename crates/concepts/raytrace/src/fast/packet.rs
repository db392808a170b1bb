//! What can eight rays share that run much the same way? Every step down the tree.
//!
//! The boxes see one [`Bundle`]; eight rays share each step down the tree. In a leaf each triangle is tested against all
//! eight at once. Which hit is best is known lane by lane, by the same sure bounds as for one ray; only the winners, and
//! those between which rounding decides, see the exact test.

use fearless_simd::Simd;
use geometry::Ray;
use glam::Vec3;

use super::bundle::Bundle;
use super::lanes::Lanes;
use crate::object::{Object, Shape};
use crate::query::{HitRecord, Nearest};
use crate::space::SpaceRay;
use crate::world::World;

/// Rays in a packet.
pub(crate) const LANES: usize = 8;

/// The nearest hits of up to eight rays.
#[inline(always)]
pub(crate) fn nearest<S: Simd>(
    simd: S,
    world: &World,
    rays: &[Ray],
    (t0, t1): (f32, f32),
    met: &mut [Option<HitRecord>],
) {
    if let Ok(eight) = <&[Ray; LANES]>::try_from(rays)
        && let Some(found) = nearest_of_eight(simd, world, eight, (t0, t1))
    {
        met.iter_mut().zip(found).for_each(|(met, nearest)| *met = nearest.met());
        return;
    }
    for (ray, met) in rays.iter().zip(met) {
        *met = SpaceRay::new(ray).and_then(|ray| super::nearest_of_one(simd, world, &ray, t0, t1));
    }
}

/// `None` if these rays had better be searched one by one: then nothing was.
#[inline(always)]
fn nearest_of_eight<S: Simd>(
    simd: S,
    world: &World,
    rays: &[Ray; LANES],
    (t0, t1): (f32, f32),
) -> Option<[Nearest; LANES]> {
    let mut nearest: [Nearest; LANES] = std::array::from_fn(|_| Nearest::new(t0, t1));
    if !is_coherent(world, rays) {
        return None;
    }
    if world.tree().is_one_leaf() {
        for k in 0..world.objects().len() {
            nearest_in_object(simd, world, k, rays, &mut nearest);
        }
    } else {
        let bundle = Bundle::of_eight(simd, &Lanes::new(simd, rays)?, t0)?;
        nearest_in_boxes(simd, world, &bundle, rays, &mut nearest);
    }
    Some(nearest)
}

#[inline(always)]
fn nearest_in_boxes<S: Simd>(
    simd: S,
    world: &World,
    bundle: &Bundle,
    rays: &[Ray; LANES],
    nearest: &mut [Nearest; LANES],
) {
    for k in world.unbounded() {
        nearest_in_object(simd, world, *k as usize, rays, nearest);
    }
    let t1 = farthest(nearest);
    world.tree().walk(
        simd,
        bundle,
        t1,
        #[inline(always)]
        |leaf| {
            for k in world.tree().things(leaf) {
                nearest_in_object(simd, world, k as usize, rays, nearest);
            }
            farthest(nearest)
        },
    );
}

fn farthest(nearest: &[Nearest; LANES]) -> f32 {
    nearest.iter().map(|nearest| nearest.interval().1).fold(f32::NEG_INFINITY, f32::max)
}

#[inline(never)]
fn nearest_in_object<S: Simd>(
    simd: S,
    world: &World,
    k: usize,
    rays: &[Ray; LANES],
    nearest: &mut [Nearest; LANES],
) {
    let object = &world.objects()[k];
    simd.vectorize(
        #[inline(always)]
        || {
            if let Shape::Mesh(traced) = object.shape() {
                nearest.iter_mut().for_each(|nearest| nearest.enter(k));
                if traced.leaves().nearest_of_eight(simd, object, rays, nearest) {
                    return;
                }
            }
            for (ray, nearest) in rays.iter().zip(nearest) {
                if let Some(ray) = SpaceRay::new(ray) {
                    super::nearest_in_object(simd, world, k as u32, &ray, nearest);
                }
            }
        },
    );
}

/// Whether each of up to eight rays meets anything.
#[inline(always)]
pub(crate) fn any_hit<S: Simd>(
    simd: S,
    world: &World,
    rays: &[Ray],
    (t0, t1): (f32, &[f32]),
    met: &mut [bool],
) {
    let all = <&[Ray; LANES]>::try_from(rays).ok().zip(<&[f32; LANES]>::try_from(t1).ok());
    let Some((eight, ends)) = all.filter(|(rays, _)| is_coherent(world, rays)) else {
        return any_hit_one_by_one(simd, world, rays, (t0, t1), met);
    };
    // One bit for each ray that has met nothing yet.
    let mut open = u32::from(u8::MAX);
    if world.tree().is_one_leaf() {
        for object in world.objects() {
            any_in_object(simd, object, eight, (t0, ends), &mut open);
        }
    } else {
        let whole = Lanes::new(simd, eight).and_then(
            #[inline(always)]
            |lanes| Bundle::of_eight(simd, &lanes, t0),
        );
        let Some(bundle) = whole else {
            return any_hit_one_by_one(simd, world, rays, (t0, t1), met);
        };
        for k in world.unbounded() {
            any_in_object(simd, &world.objects()[*k as usize], eight, (t0, ends), &mut open);
        }
        let t1 = ends.iter().copied().fold(f32::NEG_INFINITY, f32::max);
        world.tree().walk(
            simd,
            &bundle,
            t1,
            #[inline(always)]
            |leaf| {
                for k in world.tree().things(leaf) {
                    any_in_object(simd, &world.objects()[k as usize], eight, (t0, ends), &mut open);
                }
                if open == 0 { f32::NEG_INFINITY } else { t1 }
            },
        );
    }
    for (lane, met) in met.iter_mut().enumerate() {
        *met = open >> lane & 1 == 0;
    }
}

#[inline(always)]
fn any_hit_one_by_one<S: Simd>(
    simd: S,
    world: &World,
    rays: &[Ray],
    (t0, t1): (f32, &[f32]),
    met: &mut [bool],
) {
    for ((ray, t1), met) in rays.iter().zip(t1).zip(met) {
        *met = SpaceRay::new(ray).is_some_and(|ray| super::any_of_one(simd, world, &ray, t0, *t1));
    }
}

#[inline(never)]
fn any_in_object<S: Simd>(
    simd: S,
    object: &Object,
    rays: &[Ray; LANES],
    (t0, t1): (f32, &[f32; LANES]),
    open: &mut u32,
) {
    simd.vectorize(
        #[inline(always)]
        || {
            if let Shape::Mesh(traced) = object.shape()
                && traced.leaves().any_of_eight(simd, object, rays, (t0, t1), open)
            {
                return;
            }
            for lane in 0..LANES {
                let ray = SpaceRay::new(&rays[lane]).filter(|_| *open >> lane & 1 == 1);
                if ray.is_some_and(|ray| super::any_in_object(simd, object, &ray, t0, t1[lane])) {
                    *open &= !(1 << lane);
                }
            }
        },
    );
}

/// Whether the rays run so much the same way, and from so much the same place, that they meet the same boxes: a guess from the first, a
/// middle and the last one. A wrong guess costs time only.
fn is_coherent(world: &World, rays: &[Ray; LANES]) -> bool {
    let [first, middle, last] = [&rays[0], &rays[4], &rays[7]];
    let spread = |of: fn(&Ray) -> Vec3| {
        let (first, middle, last) = (of(first), of(middle), of(last));
        (last - first).abs().max((middle - first).abs()).element_sum()
    };
    spread(|ray| ray.direction) <= MOST_SPREAD * first.direction.abs().element_sum()
        && spread(|ray| ray.origin) <= MOST_APART * world.size()
}

/// Directions in a packet differ by no more than this share of their length.
const MOST_SPREAD: f32 = 0.125;

/// Origins in a packet lie no farther apart than this share of the world's size: shadow rays from pixels beside each other may leave from
/// different objects, far from each other, and a bundle around both would meet all that lies between.
const MOST_APART: f32 = 1.0 / 64.0;
