//! What do eight rays meet in one mesh? Each step down the tree and each triangle is shared by all of them.

use fearless_simd::{f32x8, prelude::*, u32x8};
use geometry::Ray;
use glam::Vec3;

use super::bundle::Bundle;
use super::crossing::{LEAST_SIZE, SHARE, TAME};
use super::mesh::{Leaves, Place};
use super::packet::LANES;
use super::tree::LEAF;
use crate::object::Object;
use crate::query::Nearest;
use crate::space::SpaceRay;

/// [`super::crossing::Probe`] for each of eight rays.
#[derive(Clone, Copy)]
pub(crate) struct Lanes<S: Simd> {
    pub(crate) origin: [f32x8<S>; 3],
    pub(crate) direction: [f32x8<S>; 3],
    pub(crate) error: f32x8<S>,
    pub(crate) margin: f32x8<S>,
}

impl<S: Simd> Lanes<S> {
    /// The rays as they are. `None` if one is none, or if f32 may overflow.
    #[inline(always)]
    pub(crate) fn new(simd: S, rays: &[Ray; LANES]) -> Option<Self> {
        Self::of(simd, rays, 0.0, |ray| (ray.origin, ray.direction))
    }

    /// The rays in the space of an object; see [`super::crossing::Probe::new`].
    #[inline(always)]
    pub(crate) fn in_space(simd: S, object: &Object, rays: &[Ray; LANES], reach: f32) -> Option<Self> {
        if object.is_in_place() {
            return Self::of(simd, rays, reach, |ray| (ray.origin, ray.direction));
        }
        Self::of(simd, rays, reach, |ray| {
            let ray = object.ray_from_world(&SpaceRay::of(ray));
            (ray.origin.as_vec3(), ray.direction.as_vec3())
        })
    }

    /// The rays, each brought to its place by `moved`.
    #[inline(always)]
    fn of(simd: S, rays: &[Ray; LANES], reach: f32, moved: impl Fn(&Ray) -> (Vec3, Vec3)) -> Option<Self> {
        let (mut origins, mut directions) = ([[0.0; LANES]; 3], [[0.0; LANES]; 3]);
        for (lane, ray) in rays.iter().enumerate() {
            let (origin, direction) = moved(ray);
            for axis in 0..3 {
                origins[axis][lane] = origin[axis];
                directions[axis][lane] = direction[axis];
            }
        }
        Self::tame(simd, &origins, &directions, reach)
    }

    #[inline(always)]
    fn tame(simd: S, origin: &[[f32; LANES]; 3], direction: &[[f32; LANES]; 3], reach: f32) -> Option<Self> {
        let (origin, direction) = (lanes(simd, origin), lanes(simd, direction));
        let sum = |[x, y, z]: [f32x8<S>; 3]| x.abs() + y.abs() + z.abs();
        let (far, speed) = (sum(origin) + reach, sum(direction));
        let tame = far.simd_lt(TAME) & speed.simd_lt(TAME) & speed.simd_gt(TAME.recip());
        if !tame.all_true() {
            return None;
        }
        let error = far * SHARE + LEAST_SIZE;
        Some(Self { origin, direction, error, margin: error * speed })
    }
}

#[inline(always)]
fn lanes<S: Simd>(simd: S, [x, y, z]: &[[f32; LANES]; 3]) -> [f32x8<S>; 3] {
    [f32x8::load_array_ref(simd, x), f32x8::load_array_ref(simd, y), f32x8::load_array_ref(simd, z)]
}

/// No triangle yet.
const NONE: u32 = u32::MAX;

/// The best so far, lane by lane.
#[derive(Clone, Copy)]
struct Best<S: Simd> {
    at_least: f32x8<S>,
    at_most: f32x8<S>,
    /// [`LEAF`] times the leaf, and the place there; or [`NONE`].
    place: u32x8<S>,
}

impl Leaves {
    /// The rays in the mesh's space, and the bundle that boxes see. `None` if they cannot be searched as one.
    #[inline(always)]
    fn as_one<S: Simd>(
        &self,
        simd: S,
        object: &Object,
        rays: &[Ray; LANES],
        t0: f32,
    ) -> Option<(Lanes<S>, Bundle)> {
        let lanes = Lanes::in_space(simd, object, rays, self.reach)?;
        let bundle = Bundle::of_eight(simd, &lanes, t0)?;
        Some((lanes, bundle))
    }

    /// Offers the nearest hit of each ray. `false` if these rays cannot be searched as one: then nothing was.
    #[inline(always)]
    pub(super) fn nearest_of_eight<S: Simd>(
        &self,
        simd: S,
        object: &Object,
        rays: &[Ray; LANES],
        nearest: &mut [Nearest; LANES],
    ) -> bool {
        let (t0, _) = nearest[0].interval();
        let Some((lanes, bundle)) = self.as_one(simd, object, rays, t0) else { return false };
        let t1 = f32x8::load_array(simd, std::array::from_fn(|lane| nearest[lane].interval().1));
        let mut best = Best { at_least: t1, at_most: t1, place: u32x8::splat(simd, NONE) };
        let ray = |lane: usize| object.ray_from_world(&SpaceRay::of(&rays[lane]));
        self.tree.walk(
            simd,
            &bundle,
            t1.reduce_max(),
            #[inline(always)]
            |leaf| {
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
                        best = self.decided(simd, best, (undecided, number), ray, nearest);
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

    /// Lets the exact test decide between the best so far and another triangle, in some of the lanes.
    #[cold]
    #[inline(never)]
    fn decided<S: Simd>(
        &self,
        simd: S,
        best: Best<S>,
        (undecided, other): (u32, u32),
        ray: impl Fn(usize) -> SpaceRay,
        nearest: &mut [Nearest; LANES],
    ) -> Best<S> {
        let (mut at_least, mut at_most) = (best.at_least.to_array(), best.at_most.to_array());
        let mut places = best.place.to_array();
        for lane in (0..LANES).filter(|lane| undecided >> lane & 1 == 1) {
            for number in [places[lane], other] {
                self.offer_exact(&ray(lane), Place::numbered(number), &mut nearest[lane]);
            }
            let (_, t1) = nearest[lane].interval();
            (places[lane], at_least[lane], at_most[lane]) = (NONE, t1, t1);
        }
        Best {
            at_least: f32x8::load_array(simd, at_least),
            at_most: f32x8::load_array(simd, at_most),
            place: u32x8::load_array(simd, places),
        }
    }

    /// Takes those rays from `open` that hit anything. `false` if these rays cannot be searched as one.
    #[inline(always)]
    pub(super) fn any_of_eight<S: Simd>(
        &self,
        simd: S,
        object: &Object,
        rays: &[Ray; LANES],
        (t0, ends): (f32, &[f32; LANES]),
        open: &mut u32,
    ) -> bool {
        let Some((lanes, bundle)) = self.as_one(simd, object, rays, t0) else { return false };
        let t1 = f32x8::load_array_ref(simd, ends);
        let farthest = t1.reduce_max();
        let ray = |lane: usize| object.ray_from_world(&SpaceRay::of(&rays[lane]));
        self.tree.walk(
            simd,
            &bundle,
            farthest,
            #[inline(always)]
            |leaf| {
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
