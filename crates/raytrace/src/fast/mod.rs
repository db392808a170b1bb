//! How near can a ray tracer come to what the machine can do, and still find the very hits of the slide's loop?
//!
//! (to be written)

mod build;
mod bundle;
mod crossing;
mod leaf;
pub(crate) mod mesh;
mod packet;
mod tiles;
pub(crate) mod tree;

use fearless_simd::{Simd, dispatch};
use geometry::Ray;

use crate::object::{Object, Shape};
use crate::query::{Met, Nearest};
use crate::space::SpaceRay;
use crate::world::World;
use bundle::Bundle;
use packet::LANES;
pub(crate) use tiles::render;

/// What [`crate::nearest_brute`] finds, without the point and the normal: [`World::hit`] adds them.
#[must_use]
pub fn nearest(world: &World, ray: &Ray, t0: f32, t1: f32) -> Option<Met> {
    let ray = SpaceRay::new(ray)?;
    dispatch!(world.level(), simd => nearest_of_one(simd, world, &ray, t0, t1))
}

/// [`nearest`] for each of many rays. Neighbours in the list should be neighbours in space: eight that run much the same
/// way are searched as one.
///
/// # Panics
/// Unless there are as many places for answers as rays.
pub fn nearest_each(world: &World, rays: &[Ray], t0: f32, t1: f32, met: &mut [Option<Met>]) {
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
fn nearest_of_one<S: Simd>(simd: S, world: &World, ray: &SpaceRay, t0: f32, t1: f32) -> Option<Met> {
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
        |_, leaf| {
            for &k in world.tree().leaves()[leaf].iter().filter(|k| **k != u32::MAX) {
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
    let mut found = any_of_objects(simd, world, world.unbounded(), ray, (t0, t1));
    if !found {
        world.tree().walk(
            simd,
            &bundle,
            t1,
            #[inline(always)]
            |_, leaf| {
                found = any_of_objects(simd, world, &world.tree().leaves()[leaf], ray, (t0, t1));
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
    numbers: &[u32],
    ray: &SpaceRay,
    (t0, t1): (f32, f32),
) -> bool {
    for &k in numbers.iter().filter(|k| **k != u32::MAX) {
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
