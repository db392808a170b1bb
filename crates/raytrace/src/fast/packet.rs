//! Eight rays that run much the same way, searched as one.
//!
//! The boxes see one [`Bundle`]; eight rays share each step down the tree. In a leaf each triangle is tested against all
//! eight at once. Which hit is best is known lane by lane, by the same sure bounds as for one ray; only the winners, and
//! those between which rounding decides, see the exact test.

use fearless_simd::{f32x8, prelude::*, u32x8};
use geometry::Ray;

use super::bundle::Bundle;
use super::crossing::Lanes;
use super::mesh::{Leaves, Place};
use super::tree::LEAF;
use crate::object::{Object, Shape};
use crate::query::{Met, Nearest};
use crate::space::SpaceRay;
use crate::world::World;

/// Rays in a packet.
pub(crate) const LANES: usize = 8;

/// No triangle yet.
const NONE: u32 = u32::MAX;

/// The nearest hits of up to eight rays.
#[inline(always)]
pub(crate) fn nearest<S: Simd>(
    simd: S,
    world: &World,
    rays: &[Ray],
    (t0, t1): (f32, f32),
    met: &mut [Option<Met>],
) {
    if let Some(eight) = rays.as_array::<LANES>()
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
    let coherent = is_coherent(rays);
    if world.tree().is_one_leaf() {
        for k in 0..world.objects().len() {
            nearest_in_object(simd, world, k, (rays, coherent), &mut nearest);
        }
    } else if coherent {
        let bundle = Bundle::of_eight(simd, &Lanes::new(simd, rays)?, t0)?;
        nearest_in_boxes(simd, world, &bundle, rays, &mut nearest);
    } else {
        return None;
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
        nearest_in_object(simd, world, *k as usize, (rays, true), nearest);
    }
    let t1 = farthest(nearest);
    world.tree().walk(
        simd,
        bundle,
        t1,
        #[inline(always)]
        |_, leaf| {
            for &k in world.tree().leaves()[leaf].iter().filter(|k| **k != u32::MAX) {
                nearest_in_object(simd, world, k as usize, (rays, true), nearest);
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
    (rays, coherent): (&[Ray; LANES], bool),
    nearest: &mut [Nearest; LANES],
) {
    let object = &world.objects()[k];
    simd.vectorize(
        #[inline(always)]
        || {
            if let Shape::Mesh(traced) = object.shape() {
                nearest.iter_mut().for_each(|nearest| nearest.enter(k));
                if coherent && traced.leaves().nearest_of_eight(simd, object, rays, nearest) {
                    return;
                }
                let mut in_space = [SpaceRay::default(); LANES];
                for lane in 0..LANES {
                    in_space[lane] = object.ray_from_world(&SpaceRay::of(&rays[lane]));
                }
                if traced.leaves().nearest_of_each(simd, &in_space, nearest) {
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
    let all = rays.as_array::<LANES>().zip(t1.as_array::<LANES>());
    let Some((eight, ends)) = all.filter(|(rays, _)| is_coherent(rays)) else {
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
            |_, leaf| {
                for &k in world.tree().leaves()[leaf].iter().filter(|k| **k != u32::MAX) {
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
            if let Shape::Mesh(traced) = object.shape() {
                if traced.leaves().any_of_eight(simd, object, rays, (t0, t1), open) {
                    return;
                }
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

/// Whether the rays run so much the same way that they meet the same boxes: a guess from the first, a middle and the last
/// one. A wrong guess costs time only.
fn is_coherent(rays: &[Ray; LANES]) -> bool {
    let [first, middle, last] = [0, 4, 7].map(|k| rays[k].direction);
    let spread = (last - first).abs().max((middle - first).abs()).element_sum();
    spread <= MOST_SPREAD * first.abs().element_sum()
}

/// Directions in a packet differ by no more than this share of their length.
const MOST_SPREAD: f32 = 0.125;

/// The best so far, lane by lane.
#[derive(Clone, Copy)]
struct Best<S: Simd> {
    at_least: f32x8<S>,
    at_most: f32x8<S>,
    /// [`LEAF`] times the leaf, and the place there; or [`NONE`].
    place: u32x8<S>,
}

impl Leaves {
    /// Offers the nearest hit of each ray. `false` if these rays cannot be searched as one: then nothing was.
    #[inline(always)]
    fn nearest_of_eight<S: Simd>(
        &self,
        simd: S,
        object: &Object,
        rays: &[Ray; LANES],
        nearest: &mut [Nearest; LANES],
    ) -> bool {
        let Some(lanes) = Lanes::in_space(simd, object, rays, self.reach) else { return false };
        let (t0, _) = nearest[0].interval();
        let Some(bundle) = Bundle::of_eight(simd, &lanes, t0) else { return false };
        let t1 = f32x8::load_array(simd, std::array::from_fn(|lane| nearest[lane].interval().1));
        let mut best = Best { at_least: t1, at_most: t1, place: u32x8::splat(simd, NONE) };
        let ray = |lane: usize| object.ray_from_world(&SpaceRay::of(&rays[lane]));
        self.tree.walk(
            simd,
            &bundle,
            t1.reduce_max(),
            #[inline(always)]
            |_, leaf| {
                let triangles = &self.leaves[leaf];
                let size = triangles.size();
                let (margin, error) = (lanes.margin * size, lanes.error * (size * size));
                for place in 0..triangles.len() {
                    let crossing = triangles.crossing(simd, place, lanes.origin, lanes.direction);
                    let possible = crossing.possible(margin);
                    if possible == 0 {
                        continue;
                    }
                    let (at_least, at_most) = crossing.t(simd, error);
                    let sure = crossing.sure(margin);
                    let closer = sure & at_most.simd_lt(best.at_least) & at_least.simd_gt(t0);
                    let out = sure & (at_least.simd_gt(best.at_most) | at_most.simd_le(t0));
                    let number = (LEAF * leaf + place) as u32;
                    best.at_least = closer.select(at_least, best.at_least);
                    best.at_most = closer.select(at_most, best.at_most);
                    best.place = closer.select(u32x8::splat(simd, number), best.place);
                    let undecided = possible & !((closer | out).to_bitmask() as u32);
                    if undecided != 0 {
                        let mut places = best.place.to_array();
                        let mut t = best.at_most.to_array();
                        let mut at_least = best.at_least.to_array();
                        for lane in (0..LANES).filter(|lane| undecided >> lane & 1 == 1) {
                            self.decide_lane(&ray(lane), &mut places[lane], number, &mut nearest[lane]);
                            t[lane] = nearest[lane].interval().1;
                            at_least[lane] = t[lane];
                        }
                        best.at_least = f32x8::load_array(simd, at_least);
                        best.at_most = f32x8::load_array(simd, t);
                        best.place = u32x8::load_array(simd, places);
                    }
                }
                best.at_most.reduce_max()
            },
        );
        let places = best.place.to_array();
        for lane in (0..LANES).filter(|lane| places[*lane] != NONE) {
            self.offer_exact(&ray(lane), Place::numbered(places[lane]), &mut nearest[lane]);
        }
        true
    }

    /// Lets the exact test decide between the best so far and another.
    #[cold]
    #[inline(never)]
    fn decide_lane(&self, ray: &SpaceRay, best: &mut u32, other: u32, nearest: &mut Nearest) {
        self.offer_exact(ray, Place::numbered(*best), nearest);
        self.offer_exact(ray, Place::numbered(other), nearest);
        *best = NONE;
    }

    /// Takes those rays from `open` that hit anything. `false` if these rays cannot be searched as one.
    #[inline(always)]
    fn any_of_eight<S: Simd>(
        &self,
        simd: S,
        object: &Object,
        rays: &[Ray; LANES],
        (t0, ends): (f32, &[f32; LANES]),
        open: &mut u32,
    ) -> bool {
        let Some(lanes) = Lanes::in_space(simd, object, rays, self.reach) else { return false };
        let Some(bundle) = Bundle::of_eight(simd, &lanes, t0) else { return false };
        let t1 = f32x8::load_array_ref(simd, ends);
        let farthest = t1.reduce_max();
        let ray = |lane: usize| object.ray_from_world(&SpaceRay::of(&rays[lane]));
        self.tree.walk(
            simd,
            &bundle,
            farthest,
            #[inline(always)]
            |_, leaf| {
                let triangles = &self.leaves[leaf];
                let size = triangles.size();
                let (margin, error) = (lanes.margin * size, lanes.error * (size * size));
                for place in 0..triangles.len() {
                    let crossing = triangles.crossing(simd, place, lanes.origin, lanes.direction);
                    let possible = crossing.possible(margin) & *open;
                    if possible == 0 {
                        continue;
                    }
                    let (at_least, at_most) = crossing.t(simd, error);
                    let sure = crossing.sure(margin);
                    let found = sure & at_least.simd_gt(t0) & at_most.simd_lt(t1);
                    let out = sure & (at_least.simd_ge(t1) | at_most.simd_le(t0));
                    *open &= !(found.to_bitmask() as u32);
                    let mut undecided = possible & !((found | out).to_bitmask() as u32);
                    while undecided != 0 {
                        let lane = undecided.trailing_zeros() as usize & 7;
                        undecided &= undecided - 1;
                        if self.is_exactly_hit(&ray(lane), Place { leaf, place }, t0, ends[lane]) {
                            *open &= !(1 << lane);
                        }
                    }
                }
                if *open == 0 { f32::NEG_INFINITY } else { farthest }
            },
        );
        true
    }
}

impl Place {
    fn numbered(number: u32) -> Option<Self> {
        let number = (number != NONE).then_some(number as usize)?;
        Some(Self { leaf: number / LEAF, place: number % LEAF })
    }
}
