//! What colour have eight points, all light taken together? The model of [`crate::lit`], column by column.

use fearless_simd::prelude::*;
use fearless_simd::{Simd, f32x8, mask32x8};

use crate::fast::{Vectors, power};
use crate::{Highlight, Light, Material, light};

/// Eight points of surfaces of one material, as a lighting model sees them (L22).
#[derive(Clone, Copy, Debug)]
pub struct Points<S: Simd> {
    /// Where they are, world space.
    pub p_world: Vectors<S>,
    /// n: the unit normals on the side of the eye, world space.
    pub n: Vectors<S>,
    /// e: the unit directions towards the eye, world space.
    pub to_eye: Vectors<S>,
}

impl<S: Simd> Points<S> {
    /// The points seen by an eye at `eye` (world space).
    ///
    /// A point at the eye itself, where the direction to it is undefined, is taken to be looked at along its normal.
    #[inline(always)]
    pub fn seen_from(simd: S, eye: glam::Vec3, p_world: Vectors<S>, n: Vectors<S>) -> Self {
        let way = Vectors::splat(simd, eye).minus(p_world);
        let length = way.dot(way).sqrt();
        let is_apart = length.simd_gt(f32x8::splat(simd, 0.0));
        let unit = way.scaled(f32x8::splat(simd, 1.0) / length);
        let to_eye = Vectors {
            x: is_apart.select(unit.x, n.x),
            y: is_apart.select(unit.y, n.y),
            z: is_apart.select(unit.z, n.z),
        };
        Self { p_world, n, to_eye }
    }
}

/// All lights together: c_r c_a + Σ (c_r c_l max(0, n·l) + c_l highlight^p), over the lights that reach the point, as
/// [`crate::lit`].
///
/// - `reaches`: asked once for each light with a direction, with the light's number in `lights`, the eight directions to it, its distances
///   (infinite for a directional light) and the points on whose side it is; answers which of them it reaches. A ray tracer
///   sends shadow rays (L56), a rasterizer returns what it got.
/// - Result: linear RGB, not clamped.
#[inline(always)]
pub fn lit<S: Simd>(
    simd: S,
    material: &Material,
    lights: &[Light],
    highlight: Highlight,
    at: &Points<S>,
    mut reaches: impl FnMut(usize, Vectors<S>, f32x8<S>, mask32x8<S>) -> mask32x8<S>,
) -> Vectors<S> {
    let diffuse = Vectors::splat(simd, material.diffuse);
    let specular = Vectors::splat(simd, material.specular);
    let exponent = f32x8::splat(simd, material.exponent);
    let (zero, one) = (f32x8::splat(simd, 0.0), f32x8::splat(simd, 1.0));
    let mut sum = Vectors::splat(simd, material.diffuse * light::ambient(lights));
    for (k, light) in lights.iter().enumerate() {
        let Some((to_light, distance, color)) = illumination(simd, light, at.p_world) else { continue };
        let cosine = at.n.dot(to_light);
        // A NaN is not before anything: asked before `min`, which may answer with either number.
        let is_before = cosine.simd_gt(zero);
        let cosine = is_before.select(cosine, zero).min(one);
        if is_before.all_false() {
            continue;
        }
        let arrives = reaches(k, to_light, distance, is_before) & is_before;
        if arrives.all_false() {
            continue;
        }
        let gleam = power(simd, highlight_cosine(simd, highlight, at, to_light), exponent);
        let reflected =
            diffuse.scaled(cosine).plus(specular.scaled(gleam)).times(Vectors::splat(simd, color));
        sum = Vectors {
            x: arrives.select(sum.x + reflected.x, sum.x),
            y: arrives.select(sum.y + reflected.y, sum.y),
            z: arrives.select(sum.z + reflected.z, sum.z),
        };
    }
    sum
}

/// 2⁶², beyond which a light is far.
const FAR: f32 = (1_u64 << 62) as f32;

/// l and the distance to the light for eight points; `None` for ambient light. At the light itself l is NaN, which lights nothing.
#[inline(always)]
fn illumination<S: Simd>(
    simd: S,
    light: &Light,
    p_world: Vectors<S>,
) -> Option<(Vectors<S>, f32x8<S>, crate::Rgb)> {
    match *light {
        Light::Ambient { .. } => None,
        Light::Directional { to_light, color } => {
            Some((Vectors::splat(simd, to_light), f32x8::splat(simd, f32::INFINITY), color))
        }
        Light::Point { position, color } => {
            // Squares of lengths above 2⁶⁴ would leave the range of f32. A power of two changes no digit.
            let scale = if position.abs().max_element() > FAR { 1.0 / FAR } else { 1.0 };
            let way = Vectors::splat(simd, position).minus(p_world).scaled(f32x8::splat(simd, scale));
            let length = way.dot(way).sqrt();
            let to_light = way.scaled(f32x8::splat(simd, 1.0) / length);
            Some((to_light, length * f32x8::splat(simd, 1.0 / scale), color))
        }
    }
}

/// e·r (L31) or h·n (L34), without r or h: e·r = 2(n·l)(n·e) − l·e, and h·n = (e·n + l·n)/‖e + l‖.
#[inline(always)]
fn highlight_cosine<S: Simd>(
    simd: S,
    highlight: Highlight,
    at: &Points<S>,
    to_light: Vectors<S>,
) -> f32x8<S> {
    match highlight {
        Highlight::Phong => {
            let twice = at.n.dot(to_light) * f32x8::splat(simd, 2.0);
            let r = at.n.scaled(twice).minus(to_light);
            at.to_eye.dot(r)
        }
        Highlight::Blinn => {
            let sum = at.to_eye.plus(to_light);
            let length = sum.dot(sum).sqrt();
            // As `halfway`: a shorter sum is rounding and points anywhere.
            let has_direction = length.simd_gt(f32x8::splat(simd, 4.0 * f32::EPSILON));
            has_direction.select(sum.dot(at.n) / length, f32x8::splat(simd, 0.0))
        }
    }
}
