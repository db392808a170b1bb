//! How near can a ray tracer come to what the machine can do, and still find the very hits of the slide's loop?
//!
//! The slide's loop ([`crate::nearest_brute`]) tests every triangle, in f64, exactly. What is here finds the same hit, bit
//! by bit, and looks at a few boxes and triangles only. Step by step; each gain was measured in one run on one thread with a
//! bumpy ball of 69,312 triangles, and in brackets with one of 1,002,252. What the first step is compared with is a hierarchy
//! with two children a node and the exact test for each triangle of a leaf; it is no longer here; `cargo run
//! --release -p lightlab-peers` compares with obvhs, which has one.
//!
//! 1. **Eight boxes at once** (`tree.rs`). A node has eight children, their boxes stored by coordinate. One subtraction
//!    then serves eight boxes, and the way down is a third as long: a viewing ray opens 6 nodes (8) and 1.4 leaves.
//! 2. **Four triangles at once, without doubt** (`leaf.rs`, `crossing.rs`). A quick test in f32 knows how wrong it may
//!    be. It tells sure hits from sure misses, and bounds t; the exact test is left with the winner and with the few cases
//!    that rounding decides. So nothing is lost, ties are decided as ever, and no ray slips between two triangles.
//!    Both steps together: viewing rays 2.5 times as fast (2.5), random rays 2.9 times (2.9), shadow rays 2.6 times
//!    (2.7). Random rays open 32 nodes (40) and 7.6 leaves each, and spend most of their time waiting for memory.
//! 3. **Eight rays as one** (`bundle.rs`, `packet.rs`, `lanes.rs`). Rays of neighbouring pixels meet the same boxes. An
//!    interval around eight rays is tested like one ray, with one number for entering and one for leaving; in a leaf, each
//!    triangle is tested against all eight. Viewing rays 2.1 times as fast (1.7), shadow rays 2.2 times (0.7 with 512 × 512
//!    pixels, 1.4 with 1024 × 1024: where triangles are smaller than pixels, neighbouring shadow rays leave from different ones).
//! 4. **Tiles** (`tiles.rs`). A picture is drawn eight by eight pixels at a time, so that viewing rays and shadow rays
//!    come in such groups of eight. A picture with shadows: 4.3 times as fast as with the first step.
//!
//! Building (`build.rs`, `bins.rs`) tries up to fifteen places along each axis at each split and shares the parts among threads, with the same
//! tree for any number of them.
//!
//! The instructions are chosen when the program runs, by what the processor has ([`fearless_simd`]); none of them rounds
//! otherwise than its scalar twin, so that every machine finds the same.
//!
//! Read `tree.rs` first, then `crossing.rs`.

mod bins;
mod build;
mod bundle;
mod crossing;
mod lanes;
mod leaf;
pub(crate) mod mesh;
mod packet;
mod tiles;
pub(crate) mod tree;
mod walk;

use fearless_simd::{Simd, dispatch};
use geometry::Ray;

use crate::object::{Object, Shape};
use crate::query::{HitRecord, Nearest};
use crate::space::SpaceRay;
use crate::world::World;
use bundle::Bundle;
use packet::LANES;
pub(crate) use tiles::render;

/// What [`crate::nearest_brute`] finds, without the point and the normal: [`World::hit`] adds them.
///
/// ```
/// use geometry::{Ray, Sphere};
/// use glam::{Mat4, Vec3, vec3};
/// use raytrace::{Object, Shape, Surface, World, fast, nearest};
///
/// let ball = Shape::Sphere(Sphere::new(vec3(1.0, 2.0, -5.0), 3.0));
/// let world = World::new(vec![Object::new(ball, Mat4::IDENTITY, vec![Surface::default()])?], Vec::new());
/// let ray = Ray::new(vec3(1.0, 2.0, 7.0), vec3(0.0, 0.0, -2.0));
/// let met = fast::nearest(&world, &ray, 0.0, 9.0).unwrap();
/// assert_eq!((met.object, met.t), (0, 4.5));
/// assert_eq!(Some(world.hit(&ray, &met)), nearest(&world, &ray, 0.0, 9.0));
/// # Ok::<(), raytrace::ObjectError>(())
/// ```
#[must_use]
pub fn nearest(world: &World, ray: &Ray, t0: f32, t1: f32) -> Option<HitRecord> {
    let ray = SpaceRay::new(ray)?;
    dispatch!(world.level(), simd => nearest_of_one(simd, world, &ray, t0, t1))
}

/// [`nearest`] for each of many rays. Neighbours in the list should be neighbours in space: eight that run much the same
/// way are searched as one (of pixels, blocks of four by two are best).
///
/// - `met`: the answers, in the order of the rays.
///
/// # Panics
/// Unless there are as many places for answers as rays.
pub fn nearest_each(world: &World, rays: &[Ray], t0: f32, t1: f32, met: &mut [Option<HitRecord>]) {
    assert_eq!(rays.len(), met.len(), "an answer for each ray");
    dispatch!(world.level(), simd => {
        for (rays, met) in rays.chunks(LANES).zip(met.chunks_mut(LANES)) {
            packet::nearest(simd, world, rays, (t0, t1), met);
        }
    });
}

/// Whether anything is met with t0 < t < t1: [`crate::any_hit_brute`]'s answer.
#[must_use]
pub fn any_hit(world: &World, ray: &Ray, t0: f32, t1: f32) -> bool {
    let Some(ray) = SpaceRay::new(ray) else { return false };
    dispatch!(world.level(), simd => any_of_one(simd, world, &ray, t0, t1))
}

/// [`any_hit`] for each of many rays, each with its own t1; see [`nearest_each`] for their order.
///
/// - `t1`: where each search ends. `met`: the answers. Both in the order of the rays.
///
/// # Panics
/// Unless there are as many ends and places for answers as rays.
pub fn any_hit_each(world: &World, rays: &[Ray], t0: f32, t1: &[f32], met: &mut [bool]) {
    assert!(rays.len() == met.len() && rays.len() == t1.len(), "an end and an answer for each ray");
    dispatch!(world.level(), simd => {
        for ((rays, t1), met) in rays.chunks(LANES).zip(t1.chunks(LANES)).zip(met.chunks_mut(LANES)) {
            packet::any_hit(simd, world, rays, (t0, t1), met);
        }
    });
}

#[inline(always)]
fn nearest_of_one<S: Simd>(simd: S, world: &World, ray: &SpaceRay, t0: f32, t1: f32) -> Option<HitRecord> {
    let mut nearest = Nearest::new(t0, t1);
    if world.tree().is_one_leaf() {
        for k in 0..world.objects().len() {
            nearest_in_object(simd, world, k as u32, ray, &mut nearest);
        }
        return nearest.met();
    }
    let Some(bundle) = Bundle::of_one(ray, t0) else {
        nearest.in_all_objects(world, ray);
        return nearest.met();
    };
    for k in world.unbounded() {
        nearest_in_object(simd, world, *k, ray, &mut nearest);
    }
    world.tree().walk(
        simd,
        &bundle,
        nearest.interval().1,
        #[inline(always)]
        |leaf| {
            for k in world.tree().things(leaf) {
                nearest_in_object(simd, world, k, ray, &mut nearest);
            }
            nearest.interval().1
        },
    );
    nearest.met()
}

#[inline(always)]
fn nearest_in_object<S: Simd>(simd: S, world: &World, k: u32, ray: &SpaceRay, nearest: &mut Nearest) {
    nearest.in_object(
        world,
        k as usize,
        ray,
        #[inline(always)]
        |traced, ray, nearest| {
            if !traced.leaves().nearest(simd, ray, nearest) {
                traced.nearest_brute(ray, nearest);
            }
        },
    );
}

#[inline(always)]
fn any_of_one<S: Simd>(simd: S, world: &World, ray: &SpaceRay, t0: f32, t1: f32) -> bool {
    if world.tree().is_one_leaf() {
        for object in world.objects() {
            if any_in_object(simd, object, ray, t0, t1) {
                return true;
            }
        }
        return false;
    }
    let Some(bundle) = Bundle::of_one(ray, t0) else {
        let mut nearest = Nearest::new(t0, t1);
        nearest.in_all_objects(world, ray);
        return nearest.met().is_some();
    };
    let mut found = any_of_objects(simd, world, world.unbounded().iter().copied(), ray, (t0, t1));
    if !found {
        world.tree().walk(
            simd,
            &bundle,
            t1,
            #[inline(always)]
            |leaf| {
                found = any_of_objects(simd, world, world.tree().things(leaf), ray, (t0, t1));
                if found { f32::NEG_INFINITY } else { t1 }
            },
        );
    }
    found
}

#[inline(always)]
fn any_of_objects<S: Simd>(
    simd: S,
    world: &World,
    numbers: impl Iterator<Item = u32>,
    ray: &SpaceRay,
    (t0, t1): (f32, f32),
) -> bool {
    for k in numbers {
        if any_in_object(simd, &world.objects()[k as usize], ray, t0, t1) {
            return true;
        }
    }
    false
}

#[inline(always)]
fn any_in_object<S: Simd>(simd: S, object: &Object, ray: &SpaceRay, t0: f32, t1: f32) -> bool {
    let ray = object.ray_from_world(ray);
    match object.shape() {
        Shape::Mesh(traced) => {
            let met = traced.leaves().any(simd, &ray, t0, t1);
            met.unwrap_or_else(|| traced.any_brute(&ray, t0, t1))
        }
        shape => shape.crossings(&ray).into_iter().any(|t| t0 < t && t < t1),
    }
}
