//! What colour has each pixel of a band? Eight pixels of a row at a time, whichever triangles they show.

use canvas::{Rgb, row_from_j};
use fearless_simd::prelude::*;
use fearless_simd::{Level, Simd, dispatch, f32x8, mask32x8};
use lighting::Material;
use lighting::fast::{Points, Vectors, lit};
use zbuffer::fast::{Band, Corners, Number, Numbers, Projected, gather_columns};

use crate::fast::attributes::{Attributes, Lit};
use crate::fast::known::Known;
use crate::{Lighting, Object, Shading, World};

/// All that a row's colours depend on.
pub(crate) struct Coloring<'a> {
    pub(crate) world: &'a World<'a>,
    pub(crate) lighting: Lighting<'a>,
    pub(crate) shading: Shading,
    /// Whether only fronts were drawn.
    pub(crate) fronts_only: bool,
    pub(crate) projected: &'a Projected,
    pub(crate) attributes: &'a Attributes,
    /// How many rows the picture has.
    pub(crate) height: u32,
}

const FLAT: u8 = 0;
const GOURAUD: u8 = 1;
const PHONG: u8 = 2;

/// Eight neighbouring pixels of a row that show one object.
struct Eight<'a> {
    numbers: &'a Numbers,
    object: &'a Object<'a>,
    /// The object's index, and the number of its first triangle.
    index: usize,
    first: Number,
    /// Of the pixels' triangles, counted through the positions of all objects.
    corners: &'a Corners,
    i: u32,
    j: u32,
}

impl Eight<'_> {
    /// The triangle of pixel `k` in its object.
    #[inline(always)]
    fn triangle(&self, k: usize) -> usize {
        (self.numbers.all[k] - self.first) as usize
    }
}

impl Coloring<'_> {
    /// Colours the rows of a band; `pixels` are theirs, from the top down.
    pub(crate) fn color(&self, band: &Band, known: &mut Known, pixels: &mut [Rgb]) {
        // One function for each shading: each is small enough for the processor's registers.
        match self.shading {
            Shading::Flat => {
                dispatch!(Level::new(), simd => self.color_rows::<_, FLAT>(simd, band, known, pixels))
            }
            Shading::Gouraud => {
                dispatch!(Level::new(), simd => self.color_rows::<_, GOURAUD>(simd, band, known, pixels));
            }
            Shading::Phong => {
                dispatch!(Level::new(), simd => self.color_rows::<_, PHONG>(simd, band, known, pixels))
            }
        }
    }

    #[inline(always)]
    fn color_rows<S: Simd, const SHADING: u8>(
        &self,
        simd: S,
        band: &Band,
        known: &mut Known,
        pixels: &mut [Rgb],
    ) {
        let width = pixels.len() / band.rows().len();
        let mut rest = [Rgb::ZERO; 8];
        for (row, pixels) in band.rows().zip(pixels.chunks_exact_mut(width)) {
            let j = row_from_j(row, self.height);
            let mut i = 0;
            let (eights, last) = pixels.as_chunks_mut::<8>();
            for eight in eights {
                self.color_eight::<S, SHADING>(simd, band, known, (row, i, j), eight);
                i += 8;
            }
            if !last.is_empty() {
                self.color_eight::<S, SHADING>(simd, band, known, (row, i, j), &mut rest);
                last.copy_from_slice(&rest[..last.len()]);
            }
        }
    }

    #[inline(always)]
    fn color_eight<S: Simd, const SHADING: u8>(
        &self,
        simd: S,
        band: &Band,
        known: &mut Known,
        (row, i, j): (u32, u32, u32),
        pixels: &mut [Rgb; 8],
    ) {
        let mut numbers = Numbers::default();
        band.eight(simd, row, i, &mut numbers);
        if numbers.is_there == 0 {
            *pixels = [self.world.background; 8];
            return;
        }
        let index = self.projected.part_of(numbers.least);
        let object = &self.world.objects[index];
        let first = self.projected.first_number(index);
        if numbers.greatest - first >= object.mesh.len() as u32 {
            self.color_one_by_one(&numbers, (i, j), known, pixels);
            return;
        }
        let start = self.projected.first_vertex(index) as u32;
        let mut of_positions = Corners::default();
        fill(&mut of_positions, object.mesh.triangles(), &numbers, first, start);
        let at = Eight { numbers: &numbers, object, index, first, corners: &of_positions, i, j };
        let mut weights = self.projected.weights(simd, at.corners, i, j);
        if weights.is_clipped.any_true() {
            let is_clipped = weights.is_clipped.to_bitmask() as u8 & numbers.is_there;
            let mut columns =
                [weights.columns[0].to_array(), weights.columns[1].to_array(), weights.columns[2].to_array()];
            self.weigh_singly(&at, is_clipped, known, &mut columns);
            for (column, own) in weights.columns.iter_mut().zip(&columns) {
                *column = f32x8::load_array_ref(simd, own);
            }
        }
        let mut plainly = mask32x8::splat(simd, false);
        let color = match SHADING {
            FLAT => self.flat(simd, &at, known),
            GOURAUD => self.gouraud(simd, &at, known, &weights.columns, &mut plainly),
            _ => self.phong(simd, &at, &weights.columns, &mut plainly),
        };
        let (r, g, b) = (color.x.to_array(), color.y.to_array(), color.z.to_array());
        if numbers.is_there == u8::MAX {
            for k in 0..8 {
                pixels[k] = Rgb::new(r[k], g[k], b[k]);
            }
        } else {
            for k in 0..8 {
                let is_there = numbers.is_there >> k & 1 == 1;
                pixels[k] = if is_there { Rgb::new(r[k], g[k], b[k]) } else { self.world.background };
            }
        }
        let plainly = plainly.to_bitmask() as u8 & numbers.is_there;
        if plainly != 0 && self.shading != Shading::Flat {
            self.color_plainly(&at, plainly, known, pixels);
        }
    }

    /// The weights of those pixels whose triangle was clipped.
    #[inline(never)]
    fn weigh_singly(&self, at: &Eight, is_clipped: u8, known: &mut Known, columns: &mut [[f32; 8]; 3]) {
        for k in 0..8 {
            if is_clipped >> k & 1 == 1 {
                let pixel = (at.i + k as u32, at.j);
                let own = known.singly.weights(self.projected, at.object.mesh, at.numbers.all[k], pixel);
                (columns[0][k], columns[1][k], columns[2][k]) = (own.alpha, own.beta, own.gamma);
            }
        }
    }

    /// Pixels of several objects.
    #[cold]
    #[inline(never)]
    fn color_one_by_one(
        &self,
        numbers: &Numbers,
        (i, j): (u32, u32),
        known: &mut Known,
        pixels: &mut [Rgb; 8],
    ) {
        for (k, pixel) in pixels.iter_mut().enumerate() {
            let is_there = numbers.is_there >> k & 1 == 1;
            *pixel = if is_there {
                self.plain_color(numbers.all[k], (i + k as u32, j), known)
            } else {
                self.world.background
            };
        }
    }

    /// The few pixels that are special: clipped, edge-on, without normals.
    #[cold]
    #[inline(never)]
    fn color_plainly(&self, at: &Eight, plainly: u8, known: &mut Known, pixels: &mut [Rgb; 8]) {
        for (k, pixel) in pixels.iter_mut().enumerate() {
            if plainly >> k & 1 == 1 {
                *pixel = self.plain_color(at.numbers.all[k], (at.i + k as u32, at.j), known);
            }
        }
    }

    /// The slide's colour of a pixel.
    fn plain_color(&self, number: Number, (i, j): (u32, u32), known: &mut Known) -> Rgb {
        let index = self.projected.part_of(number);
        let object = &self.world.objects[index];
        let triangle = (number - self.projected.first_number(index)) as usize;
        let weights = known.singly.weights(self.projected, object.mesh, number, (i, j));
        known.surface(object, triangle, self).color(weights)
    }

    /// One colour a triangle (L37).
    #[inline(always)]
    fn flat<S: Simd>(&self, simd: S, at: &Eight, known: &mut Known) -> Vectors<S> {
        if at.numbers.are_same {
            let [color, ..] = known.corner_colors(at.numbers.all[0], at.object, at.triangle(0), self);
            return Vectors::splat(simd, color);
        }
        let mut columns = [[0.0; 8]; 3];
        for k in 0..8 {
            let [color, ..] = known.corner_colors(at.numbers.all[k], at.object, at.triangle(k), self);
            (columns[0][k], columns[1][k], columns[2][k]) = (color.x, color.y, color.z);
        }
        Vectors::load(simd, [&columns[0], &columns[1], &columns[2]])
    }

    /// αc₀ + βc₁ + γc₂ (L38).
    #[inline(always)]
    fn gouraud<S: Simd>(
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
                *plainly = *plainly | uncertain | is_nan(&colors);
                return mix(weights, &colors);
            }
        }
        let mut columns = [[[0.0; 8]; 3]; 3];
        for k in 0..8 {
            let colors = known.corner_colors(at.numbers.all[k], at.object, at.triangle(k), self);
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
    fn phong<S: Simd>(
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
        *plainly = *plainly | !has_direction;
        let mut scale = f32x8::splat(simd, 1.0) / length;
        if !self.fronts_only {
            let (turned, uncertain) = self.turned_of(simd, at, &places);
            *plainly = *plainly | uncertain;
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
        (is_turned, !is_certain)
    }
}

/// The corners of the pixels' triangles, with `start` added.
#[inline(always)]
fn fill(corners: &mut Corners, triangles: &[[u32; 3]], numbers: &Numbers, first: Number, start: u32) {
    corners.are_same = numbers.are_same;
    let count = if numbers.are_same { 1 } else { 8 };
    for (corner, number) in corners.each.iter_mut().zip(&numbers.all).take(count) {
        let [a, b, c] = triangles[(number - first) as usize];
        (corner[0], corner[1], corner[2]) = (a + start, b + start, c + start);
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
