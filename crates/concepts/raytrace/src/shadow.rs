//! Does the light reach the point? A ray from the point to the light tells (L56).
//!
//! Three things keep such a ray from being stopped by the very surface that it starts from (E12):
//!
//! - It starts a little off the surface, by [`Hit::clearance`]: as much as rounding can have moved the point, not more.
//! - It ends at the light: what lies behind a lamp casts no shadow before it.
//! - On a mesh with smooth normals it starts where the *smooth* surface would be. A coarse mesh turns faces away from
//!   the light that the smooth surface, whose normals are used for lighting, still shows to it; shadow rays from the flat
//!   faces would draw the triangles as a dark pattern. See [`onto_smooth_surface`].

use canvas::Rgb;
use geometry::{Barycentric, Ray};
use glam::Vec3;
use lighting::Illumination;

use crate::query::{Hit, Search, any_hit, any_hit_brute, nearest, nearest_brute};
use crate::surface::Optics;
use crate::world::{Interpolation, World};

/// The shadow ray p + t·l from what `ray` hit to a light (L56): from a start off the surface, with t from 0 to the
/// light's distance, which is infinite for a directional light.
#[must_use]
pub fn shadow_ray(world: &World, ray: &Ray, hit: &Hit, light: &Illumination) -> Ray {
    Ray::new(shadow_start(world, ray, hit), light.to_light)
}

/// Where the shadow rays from a hit start, whichever the light: off the surface, and the smooth one where there is one.
pub(crate) fn shadow_start(world: &World, ray: &Ray, hit: &Hit) -> Vec3 {
    let mut start = hit.point;
    if world.interpolation != Interpolation::Flat {
        let object = &world.objects()[hit.object];
        if let (Some(corners), Some(normals)) =
            (object.corners(hit.triangle), object.corner_normals(hit.triangle))
        {
            let side = if hit.is_front(ray) { 1.0 } else { -1.0 };
            start = onto_smooth_surface(start, corners, normals.map(|n| side * n), hit.weights);
        }
    }
    start + hit.clearance * hit.normal_towards(ray)
}

/// Whether nothing opaque or clear is between the hit and the light: the slide's shadow test (L56, L57).
#[must_use]
pub fn is_lit(world: &World, ray: &Ray, hit: &Hit, light: &Illumination) -> bool {
    !any_hit(world, &shadow_ray(world, ray, hit, light), 0.0, light.distance)
}

/// The share of the light that reaches the hit, linear RGB: 0 behind an opaque surface or a mirror, and behind glass the
/// product of the transmittances of all its surfaces on the way. A half-transparent surface lets 1 − opacity through.
///
/// The way is straight: light that glass bends and gathers (a caustic) is beyond this model, as is what glass reflects.
#[must_use]
pub fn light_share(world: &World, ray: &Ray, hit: &Hit, light: &Illumination, search: Search) -> Rgb {
    let shadow_ray = shadow_ray(world, ray, hit, light);
    if !world.has_glass() {
        let stopped = match search {
            Search::Hierarchy => any_hit(world, &shadow_ray, 0.0, light.distance),
            Search::BruteForce => any_hit_brute(world, &shadow_ray, 0.0, light.distance),
        };
        return if stopped { Rgb::ZERO } else { Rgb::ONE };
    }
    let (mut share, mut t0) = (Rgb::ONE, 0.0);
    while let Some(between) = match search {
        Search::Hierarchy => nearest(world, &shadow_ray, t0, light.distance),
        Search::BruteForce => nearest_brute(world, &shadow_ray, t0, light.distance),
    } {
        share *= match world.surface(&between).optics {
            Optics::Glass { transmittance, .. } => transmittance,
            Optics::Dissolved { opacity } => Rgb::splat(1.0 - opacity),
            Optics::Opaque | Optics::Mirror { .. } => return Rgb::ZERO,
        };
        t0 = between.t;
    }
    share
}

/// `p` lifted from a flat triangle to about where the smooth surface would be that its corner normals stand for.
///
/// Each corner's tangent plane lies outside a surface that bulges there; `p` is lifted onto each of the three planes (if
/// below it) and the results are mixed by the barycentric weights. Hanika, *Hacking the Shadow Terminator* (Ray Tracing
/// Gems II, 2021). Where the surface is hollow, `p` lies above the planes and stays.
///
/// - `corners`, `normals`: of the triangle, unit normals on the side of the ray. All in world space.
#[must_use]
pub fn onto_smooth_surface(p: Vec3, corners: [Vec3; 3], normals: [Vec3; 3], weights: Barycentric) -> Vec3 {
    let lift = |k: usize| normals[k] * (normals[k].dot(corners[k] - p)).max(0.0);
    p + weights.interpolate(lift(0), lift(1), lift(2))
}
