//! What colour has each pixel of a band? Eight pixels of a row at a time, whichever triangles they show.

use canvas::{Rgb, row_from_j};
use fearless_simd::prelude::*;
use fearless_simd::{Level, Simd, dispatch, f32x8, mask32x8};
use geometry::Barycentric;
use lighting::Material;
use lighting::fast::{Points, Vectors, lit};
use zbuffer::fast::{Band, Indices, NONE, Number, Projected, gather_columns};

use crate::fast::attributes::{Attributes, Lit};
use crate::fast::known::Known;
use crate::{Lighting, Shading, World};

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

/// Eight neighbouring pixels of a row.
struct Eight {
    /// What they show; pixels of the background show what some other one of the eight does, and are not coloured.
    numbers: [Number; 8],
    is_there: u64,
    /// Their objects and their triangles there.
    objects: [usize; 8],
    triangles: [usize; 8],
    /// Of the corners, counted through the positions of all objects.
    corners: Indices,
    i: u32,
    j: u32,
}

impl Coloring<'_> {
    /// Colours the rows of a band; `pixels` are theirs, from the top down.
    pub(crate) fn color(&self, band: &Band, known: &mut Known, pixels: &mut [Rgb]) {
        dispatch!(Level::new(), simd => self.color_rows(simd, band, known, pixels));
    }

    #[inline(always)]
    fn color_rows<S: Simd>(&self, simd: S, band: &Band, known: &mut Known, pixels: &mut [Rgb]) {
        let width = pixels.len() / band.rows().len();
        for (row, pixels) in band.rows().zip(pixels.chunks_exact_mut(width)) {
            let j = row_from_j(row, self.height);
            for (start, eight) in (0..).step_by(8).zip(pixels.chunks_mut(8)) {
                let numbers = band.eight_numbers(row, start, eight.len());
                match self.eight(numbers, start, j) {
                    Some(at) => self.color_eight(simd, &at, known, eight),
                    None => eight.fill(self.world.background),
                }
            }
        }
    }

    /// Looks up what eight pixels show; `None` if that is the background only.
    #[inline(always)]
    fn eight(&self, mut numbers: [Number; 8], i: u32, j: u32) -> Option<Eight> {
        let mut is_there = 0;
        let mut some = NONE;
        for (k, number) in numbers.iter().enumerate() {
            if *number != NONE {
                is_there |= 1 << k;
                some = *number;
            }
        }
        if is_there == 0 {
            return None;
        }
        let (mut objects, mut triangles, mut corners) = ([0; 8], [0; 8], [[0; 3]; 8]);
        let mut object = usize::MAX;
        let (mut first, mut end, mut first_vertex) = (0, 0, 0);
        for k in 0..8 {
            if numbers[k] == NONE {
                numbers[k] = some;
            }
            // Neighbours mostly show the same object.
            if object == usize::MAX || numbers[k] < first || end <= numbers[k] {
                object = self.projected.part_of(numbers[k]);
                first = self.projected.first_number(object);
                end = first + self.world.objects[object].mesh.len() as u32;
                first_vertex = self.projected.first_vertex(object) as u32;
            }
            objects[k] = object;
            triangles[k] = (numbers[k] - first) as usize;
            let [a, b, c] = self.world.objects[object].mesh.triangles()[triangles[k]];
            corners[k] = [a + first_vertex, b + first_vertex, c + first_vertex];
        }
        Some(Eight { numbers, is_there, objects, triangles, corners, i, j })
    }

    #[inline(always)]
    fn color_eight<S: Simd>(&self, simd: S, at: &Eight, known: &mut Known, pixels: &mut [Rgb]) {
        let weights = self.projected.weights(simd, &at.corners, at.i, at.j);
        let mut plainly = weights.is_clipped;
        let color = match self.shading {
            Shading::Flat => self.flat(simd, at, known),
            Shading::Gouraud => self.gouraud(simd, at, known, &weights.columns, &mut plainly),
            Shading::Phong => self.phong(simd, at, &weights.columns, &mut plainly),
        };
        for (k, pixel) in pixels.iter_mut().enumerate() {
            *pixel = if at.is_there >> k & 1 == 1 { color.get(k) } else { self.world.background };
        }
        let mut plainly = plainly.to_bitmask() & at.is_there;
        if self.shading == Shading::Flat {
            plainly = 0;
        }
        while plainly != 0 {
            let k = plainly.trailing_zeros() as usize;
            plainly &= plainly - 1;
            let weights = weights.columns.map(|column| column[k]);
            pixels[k] = self.plain_color(at, k, weights, known);
        }
    }

    /// The slide's colour of pixel k, for the few that are special: clipped, edge-on, without normals.
    #[cold]
    fn plain_color(&self, at: &Eight, k: usize, [alpha, beta, gamma]: [f32; 3], known: &mut Known) -> Rgb {
        let weights = Barycentric { alpha, beta, gamma };
        let weights = if alpha.is_nan() {
            let found = self.projected.weights_of_clipped(at.numbers[k], at.i + k as u32, at.j);
            found.unwrap_or(Barycentric::from_beta_gamma(1.0 / 3.0, 1.0 / 3.0))
        } else {
            weights
        };
        let object = &self.world.objects[at.objects[k]];
        known.surface(at.numbers[k], object, at.triangles[k], self).color(weights)
    }

    /// One colour a triangle (L37).
    #[inline(always)]
    fn flat<S: Simd>(&self, simd: S, at: &Eight, known: &mut Known) -> Vectors<S> {
        let mut columns = [[0.0; 8]; 3];
        for k in 0..8 {
            let object = &self.world.objects[at.objects[k]];
            let [color, ..] = known.corner_colors(at.numbers[k], object, at.triangles[k], self);
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
        let from_vertices = self.lit_at_vertices(at);
        if from_vertices {
            let (turned, uncertain) = self.turned(simd, at);
            if turned.all_false() {
                let colors = gather(simd, &self.attributes.colors, &at.corners);
                *plainly = *plainly | uncertain | is_nan(&colors);
                return mix(weights, &colors);
            }
        }
        let mut columns = [[[0.0; 8]; 3]; 3];
        for k in 0..8 {
            let object = &self.world.objects[at.objects[k]];
            let colors = known.corner_colors(at.numbers[k], object, at.triangles[k], self);
            for (columns, color) in columns.iter_mut().zip(colors) {
                (columns[0][k], columns[1][k], columns[2][k]) = (color.x, color.y, color.z);
            }
        }
        let load = |c: usize| Vectors::load(simd, [&columns[c][0], &columns[c][1], &columns[c][2]]);
        mix(weights, &[load(0), load(1), load(2)])
    }

    fn lit_at_vertices(&self, at: &Eight) -> bool {
        at.objects.iter().all(|object| self.attributes.lit[*object] == Lit::Vertices)
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
        let Some(normals) = self.normal_indices(at) else {
            *plainly = mask32x8::splat(simd, true);
            return Vectors::splat(simd, Rgb::ZERO);
        };
        let corners = gather(simd, &self.attributes.positions, &at.corners);
        let p_world = mix(weights, &corners);
        let n = mix(weights, &gather(simd, &self.attributes.normals, &normals));
        let length = n.dot(n).sqrt();
        // As `phong_normal`: what is shorter has no direction. A NaN is no length at all.
        let has_direction = length.simd_gt(f32x8::splat(simd, 4.0 * f32::EPSILON));
        *plainly = *plainly | !has_direction;
        let mut scale = f32x8::splat(simd, 1.0) / length;
        if !self.fronts_only {
            let (turned, uncertain) = self.turned_of(simd, at, &corners);
            *plainly = *plainly | uncertain;
            scale = turned.select(-scale, scale);
        }
        let points = Points::seen_from(simd, self.lighting.eye, p_world, n.scaled(scale));
        self.light(simd, at, &points)
    }

    /// Lights eight points, material by material.
    #[inline(always)]
    fn light<S: Simd>(&self, simd: S, at: &Eight, points: &Points<S>) -> Vectors<S> {
        let material = |k: usize| self.world.objects[at.objects[k]].material(at.triangles[k]);
        let first = material(0);
        let color = self.light_with(simd, &first, points);
        if (1..8).all(|k| self.same_material(at, k)) {
            return color;
        }
        let mut columns = [color.x.to_array(), color.y.to_array(), color.z.to_array()];
        for k in 1..8 {
            let own = material(k);
            if own != first {
                let color = self.light_with(simd, &own, points);
                (columns[0][k], columns[1][k], columns[2][k]) = (color.x[k], color.y[k], color.z[k]);
            }
        }
        Vectors::load(simd, [&columns[0], &columns[1], &columns[2]])
    }

    fn same_material(&self, at: &Eight, k: usize) -> bool {
        at.numbers[k] == at.numbers[0]
            || at.objects[k] == at.objects[0] && {
                let mesh = self.world.objects[at.objects[k]].mesh;
                mesh.material(at.triangles[k]) == mesh.material(at.triangles[0])
            }
    }

    #[inline(always)]
    fn light_with<S: Simd>(&self, simd: S, material: &Material, points: &Points<S>) -> Vectors<S> {
        let Lighting { lights, highlight, .. } = self.lighting;
        lit(simd, material, lights, highlight, points, |_, _, _, before| before)
    }

    /// The corners' normals, counted through those of all objects; `None` if some object has none.
    #[inline(always)]
    fn normal_indices(&self, at: &Eight) -> Option<Indices> {
        let mut indices = [[0; 3]; 8];
        for k in 0..8 {
            let normals = self.world.objects[at.objects[k]].mesh.normals()?;
            let first = self.attributes.first_normal[at.objects[k]];
            let [a, b, c] = normals.triangles[at.triangles[k]];
            indices[k] = [a + first, b + first, c + first];
        }
        Some(indices)
    }

    /// Which triangles show their backs, and of which that is not certain: see [`Coloring::turned_of`].
    #[inline(always)]
    fn turned<S: Simd>(&self, simd: S, at: &Eight) -> (mask32x8<S>, mask32x8<S>) {
        if self.fronts_only {
            let no = mask32x8::splat(simd, false);
            return (no, no);
        }
        self.turned_of(simd, at, &gather(simd, &self.attributes.positions, &at.corners))
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
        let limit = scale * f32x8::splat(simd, LEAST_COSINE);
        let mut side = f32x8::splat(simd, 0.0);
        for k in 0..8 {
            let is_mirrored = self.world.objects[at.objects[k]].world_from_object.determinant() < 0.0;
            side[k] = if is_mirrored { -1.0 } else { 1.0 };
        }
        let turned = (volume * side).simd_lt(f32x8::splat(simd, 0.0));
        (turned, !volume.abs().simd_gt(limit))
    }
}

/// Three corners' vectors of eight triangles.
#[inline(always)]
fn gather<S: Simd>(simd: S, of: &[[f32; 4]], indices: &Indices) -> [Vectors<S>; 3] {
    let [x, y, z, _] = gather_columns(simd, of, indices, 0);
    let a = Vectors { x, y, z };
    let [x, y, z, _] = gather_columns(simd, of, indices, 1);
    let b = Vectors { x, y, z };
    let [x, y, z, _] = gather_columns(simd, of, indices, 2);
    [a, b, Vectors { x, y, z }]
}

/// αa + βb + γc, added in the order of [`Barycentric::interpolate`].
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
