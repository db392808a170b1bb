//! Which colour follows from the weights? Flat, Gouraud and Phong shading, eight pixels at a time.

use canvas::Rgb;
use fearless_simd::prelude::*;
use fearless_simd::{Simd, f32x8, mask32x8};
use glam::DVec3;
use lighting::Material;
use lighting::fast::{Points, Vectors, lit};
use zbuffer::fast::{Corners, gather_columns};

use crate::Lighting;
use crate::fast::attributes::Lit;
use crate::fast::known::Known;
use crate::fast::rows::{Coloring, Eight, fill};

impl Coloring<'_> {
    /// One colour a triangle (L37).
    #[inline(always)]
    pub(crate) fn flat<S: Simd>(&self, simd: S, at: &Eight, known: &mut Known) -> Vectors<S> {
        if at.numbers.are_same {
            let [color, ..] = known.corner_colors(at.numbers.all[0], at.object, at.triangle(0), self);
            return Vectors::splat(simd, color);
        }
        let mut columns = [[0.0; 8]; 3];
        for (k, number) in at.numbers.all.iter().enumerate() {
            let [color, ..] = known.corner_colors(*number, at.object, at.triangle(k), self);
            (columns[0][k], columns[1][k], columns[2][k]) = (color.x, color.y, color.z);
        }
        Vectors::load(simd, [&columns[0], &columns[1], &columns[2]])
    }

    /// αc₀ + βc₁ + γc₂ (L38).
    #[inline(always)]
    pub(crate) fn gouraud<S: Simd>(
        &self,
        simd: S,
        at: &Eight,
        known: &mut Known,
        weights: &[f32x8<S>; 3],
        plainly: &mut mask32x8<S>,
    ) -> Vectors<S> {
        if self.attributes.lit[at.index] == Lit::Vertices {
            let (turned, uncertain) = self.turned(simd, at);
            if turned.all_false() {
                let colors = gather(simd, &self.attributes.colors, at.corners);
                *plainly |= uncertain | is_nan(&colors);
                return mix(weights, &colors);
            }
        }
        let mut columns = [[[0.0; 8]; 3]; 3];
        for (k, number) in at.numbers.all.iter().enumerate() {
            let colors = known.corner_colors(*number, at.object, at.triangle(k), self);
            for (columns, color) in columns.iter_mut().zip(colors) {
                (columns[0][k], columns[1][k], columns[2][k]) = (color.x, color.y, color.z);
            }
        }
        let [a, b, c] = &columns;
        let load = |of: &[[f32; 8]; 3]| Vectors::load(simd, [&of[0], &of[1], &of[2]]);
        mix(weights, &[load(a), load(b), load(c)])
    }

    /// The lighting model with the interpolated normal (L40).
    #[inline(always)]
    pub(crate) fn phong<S: Simd>(
        &self,
        simd: S,
        at: &Eight,
        weights: &[f32x8<S>; 3],
        plainly: &mut mask32x8<S>,
    ) -> Vectors<S> {
        let Some(normals) = at.object.mesh.normals() else {
            *plainly = mask32x8::splat(simd, true);
            return Vectors::splat(simd, Rgb::ZERO);
        };
        let places = gather(simd, &self.attributes.positions, at.corners);
        let p_world = mix(weights, &places);
        let mut of_normals = Corners::default();
        let start = self.attributes.first_normal[at.index];
        fill(&mut of_normals, &normals.triangles, at.numbers, at.first, start);
        let n = mix(weights, &gather(simd, &self.attributes.normals, &of_normals));
        let length = n.dot(n).sqrt();
        // As `phong_normal`: what is shorter has no direction. A NaN is no length at all.
        let has_direction = length.simd_gt(f32x8::splat(simd, 4.0 * f32::EPSILON));
        *plainly |= !has_direction;
        let mut scale = f32x8::splat(simd, 1.0) / length;
        if !self.fronts_only {
            let (turned, uncertain) = self.turned_of(simd, at, &places);
            *plainly |= uncertain;
            scale = turned.select(-scale, scale);
        }
        let points = Points::seen_from(simd, self.lighting.eye, p_world, n.scaled(scale));
        self.light(simd, at, &points)
    }

    /// Lights eight points, material by material.
    #[inline(always)]
    fn light<S: Simd>(&self, simd: S, at: &Eight, points: &Points<S>) -> Vectors<S> {
        let first = at.object.material(at.triangle(0));
        let color = self.light_with(simd, &first, points);
        if at.numbers.are_same || !at.object.mesh.has_materials() {
            return color;
        }
        let (mut r, mut g, mut b) = (color.x.to_array(), color.y.to_array(), color.z.to_array());
        for k in 1..8 {
            let own = at.object.material(at.triangle(k));
            if own != first {
                let color = self.light_with(simd, &own, points);
                (r[k], g[k], b[k]) = (color.x[k], color.y[k], color.z[k]);
            }
        }
        Vectors::load(simd, [&r, &g, &b])
    }

    #[inline(always)]
    fn light_with<S: Simd>(&self, simd: S, material: &Material, points: &Points<S>) -> Vectors<S> {
        let Lighting { lights, highlight, .. } = self.lighting;
        lit(simd, material, lights, highlight, points, |_, _, _, before| before)
    }

    /// Which triangles show their backs, and of which that is not certain: see [`Coloring::turned_of`].
    #[inline(always)]
    fn turned<S: Simd>(&self, simd: S, at: &Eight) -> (mask32x8<S>, mask32x8<S>) {
        if self.fronts_only {
            let no = mask32x8::splat(simd, false);
            return (no, no);
        }
        self.turned_of(simd, at, &gather(simd, &self.attributes.positions, at.corners))
    }

    /// Whether the eye lies behind the triangle, by the sign of (b − a) × (c − a) · (eye − a). Seen so nearly edge-on that rounding
    /// could decide, the slide's rule has to.
    #[inline(always)]
    fn turned_of<S: Simd>(
        &self,
        simd: S,
        at: &Eight,
        [a, b, c]: &[Vectors<S>; 3],
    ) -> (mask32x8<S>, mask32x8<S>) {
        /// A cosine that is certainly not 0: the roundings of products and differences in f32 add up to less.
        const LEAST_COSINE: f32 = 1e-4;
        let (u, v) = (b.minus(*a), c.minus(*a));
        let cross = Vectors { x: u.y * v.z - u.z * v.y, y: u.z * v.x - u.x * v.z, z: u.x * v.y - u.y * v.x };
        let to_eye = Vectors::splat(simd, self.lighting.eye).minus(*a);
        let volume = cross.dot(to_eye);
        let scale = (u.dot(u).sqrt() * v.dot(v).sqrt()) * to_eye.dot(to_eye).sqrt();
        let is_certain = volume.abs().simd_gt(scale * f32x8::splat(simd, LEAST_COSINE));
        let zero = f32x8::splat(simd, 0.0);
        let is_behind = volume.simd_lt(zero);
        // A map that mirrors turns the corners round the other way.
        let is_turned = if self.attributes.is_mirrored[at.index] { !is_behind } else { is_behind };
        if is_certain.all_true() {
            return (is_turned, !is_certain);
        }
        let mut turned = is_turned.to_bitmask() as u8;
        let uncertain = self.decide(at, !is_certain.to_bitmask() as u8, &mut turned);
        (mask32x8::from_bitmask(simd, turned.into()), mask32x8::from_bitmask(simd, uncertain.into()))
    }

    /// The same in f64 for the triangles whose bits are set in `uncertain`, of floors that reach far beyond the eye, say; returns those
    /// of which even that is not certain.
    #[inline(never)]
    fn decide(&self, at: &Eight, uncertain: u8, turned: &mut u8) -> u8 {
        /// The slide's rule takes a cosine of two vectors in f32: above this its sign is right.
        const LEAST_COSINE: f64 = 2e-6;
        let mirror = if self.attributes.is_mirrored[at.index] { -1.0 } else { 1.0 };
        let mut left = 0;
        let mut cosine = 0.0;
        for k in 0..8 {
            if k == 0 || !at.corners.are_same {
                let corner = |c: usize| {
                    let [x, y, z, _] = self.attributes.positions[at.corners.each[k][c] as usize];
                    DVec3::new(x.into(), y.into(), z.into())
                };
                let (a, b, c) = (corner(0), corner(1), corner(2));
                let normal = (b - a).cross(c - a).normalize_or_zero();
                cosine = mirror * normal.dot((self.lighting.eye.as_dvec3() - a).normalize_or_zero());
            }
            if uncertain >> k & 1 == 1 {
                *turned = *turned & !(1 << k) | u8::from(cosine < 0.0) << k;
                left |= u8::from(cosine.abs() <= LEAST_COSINE) << k;
            }
        }
        left
    }
}

/// Three corners' vectors of eight triangles.
#[inline(always)]
fn gather<S: Simd>(simd: S, of: &[[f32; 4]], corners: &Corners) -> [Vectors<S>; 3] {
    let [x, y, z, _] = gather_columns(simd, of, corners, 0);
    let a = Vectors { x, y, z };
    let [x, y, z, _] = gather_columns(simd, of, corners, 1);
    let b = Vectors { x, y, z };
    let [x, y, z, _] = gather_columns(simd, of, corners, 2);
    [a, b, Vectors { x, y, z }]
}

/// αa + βb + γc, added in the order of [`geometry::Barycentric::interpolate`].
#[inline(always)]
fn mix<S: Simd>(weights: &[f32x8<S>; 3], [a, b, c]: &[Vectors<S>; 3]) -> Vectors<S> {
    a.scaled(weights[0]).plus(b.scaled(weights[1])).plus(c.scaled(weights[2]))
}

/// Where a colour is missing.
#[inline(always)]
fn is_nan<S: Simd>(colors: &[Vectors<S>; 3]) -> mask32x8<S> {
    let sum = colors[0].x + colors[1].x + colors[2].x;
    sum.simd_ne(sum)
}
