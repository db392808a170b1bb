//! What colour has each pixel of a band? Eight pixels of a row at a time, whichever triangles they show.

use canvas::{Rgb, row_from_j};
use fearless_simd::prelude::*;
use fearless_simd::{Level, Simd, dispatch, f32x8, mask32x8};
use zbuffer::fast::{Band, Corners, Number, Numbers, Projected, Weights};

use crate::fast::attributes::Attributes;
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
pub(crate) struct Eight<'a> {
    pub(crate) numbers: &'a Numbers,
    pub(crate) object: &'a Object<'a>,
    /// The object's index, and the number of its first triangle.
    pub(crate) index: usize,
    pub(crate) first: Number,
    /// Of the pixels' triangles, counted through the positions of all objects.
    pub(crate) corners: &'a Corners,
    pub(crate) i: u32,
    pub(crate) j: u32,
}

impl Eight<'_> {
    /// The triangle of pixel `k` in its object.
    #[inline(always)]
    pub(crate) fn triangle(&self, k: usize) -> usize {
        (self.numbers.all[k] - self.first) as usize
    }
}

impl Coloring<'_> {
    /// Colours the rows of a band; `pixels` are theirs, from the top down.
    pub(crate) fn color(&self, band: &Band, known: &mut Known, pixels: &mut [Rgb]) {
        // One function for each shading: each is small enough for the processor's registers.
        match self.shading {
            Shading::Flat => {
                dispatch!(Level::new(), simd => self.color_rows::<_, FLAT>(simd, band, known, pixels));
            }
            Shading::Gouraud => {
                dispatch!(Level::new(), simd => self.color_rows::<_, GOURAUD>(simd, band, known, pixels));
            }
            Shading::Phong => {
                dispatch!(Level::new(), simd => self.color_rows::<_, PHONG>(simd, band, known, pixels));
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
        let mut of_positions = Corners::default();
        if SHADING != FLAT {
            let start = self.projected.first_vertex(index) as u32;
            fill(&mut of_positions, object.mesh.triangles(), &numbers, first, start);
        }
        let at = Eight { numbers: &numbers, object, index, first, corners: &of_positions, i, j };
        let mut plainly = mask32x8::splat(simd, false);
        let color = match SHADING {
            FLAT => self.flat(simd, &at, known),
            GOURAUD => {
                let weights = self.weights(simd, &at, known);
                self.gouraud(simd, &at, known, &weights, &mut plainly)
            }
            _ => {
                let weights = self.weights(simd, &at, known);
                self.phong(simd, &at, &weights, &mut plainly)
            }
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
        if plainly != 0 {
            self.color_plainly(&at, plainly, known, pixels);
        }
    }

    /// The weights of the pixels in their triangles.
    #[inline(always)]
    fn weights<S: Simd>(&self, simd: S, at: &Eight, known: &mut Known) -> [f32x8<S>; 3] {
        let Weights { columns, is_clipped } = self.projected.weights(simd, at.corners, at.i, at.j);
        let is_clipped = is_clipped.to_bitmask() as u8 & at.numbers.is_there;
        if is_clipped == 0 {
            return columns;
        }
        let [alpha, beta, gamma] = columns;
        let mut own = [alpha.to_array(), beta.to_array(), gamma.to_array()];
        self.weigh_singly(at, is_clipped, known, &mut own);
        let [alpha, beta, gamma] = &own;
        [
            f32x8::load_array_ref(simd, alpha),
            f32x8::load_array_ref(simd, beta),
            f32x8::load_array_ref(simd, gamma),
        ]
    }

    /// The weights of those pixels whose triangle was clipped.
    #[inline(never)]
    fn weigh_singly(&self, at: &Eight, is_clipped: u8, known: &mut Known, columns: &mut [[f32; 8]; 3]) {
        let [alpha, beta, gamma] = columns;
        let columns = alpha.iter_mut().zip(beta).zip(gamma).zip(&at.numbers.all).enumerate();
        for (k, (((alpha, beta), gamma), number)) in columns.filter(|(k, _)| is_clipped >> k & 1 == 1) {
            let pixel = (at.i + k as u32, at.j);
            let own = known.singly.weights(self.projected, at.object.mesh, *number, pixel);
            (*alpha, *beta, *gamma) = (own.alpha, own.beta, own.gamma);
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
        known.color(number, object, triangle, weights, self)
    }
}

/// The corners of the pixels' triangles, with `start` added.
#[inline(always)]
pub(crate) fn fill(
    corners: &mut Corners,
    triangles: &[[u32; 3]],
    numbers: &Numbers,
    first: Number,
    start: u32,
) {
    corners.are_same = numbers.are_same;
    let count = if numbers.are_same { 1 } else { 8 };
    for (corner, number) in corners.each.iter_mut().zip(&numbers.all).take(count) {
        let [a, b, c] = triangles[(number - first) as usize];
        (corner[0], corner[1], corner[2]) = (a + start, b + start, c + start);
    }
}
