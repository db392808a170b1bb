//! Eight triangles side by side: their corners as columns, so that one instruction works on all of them.

use fearless_simd::prelude::*;
use fearless_simd::{Simd, f32x4, f32x8, mask32x8};

use glam::Vec3;

use crate::fast::vertices::Vertex;
use crate::screen::SUBPIXELS;

/// The corners of eight triangles.
pub(crate) struct Eight<S: Simd> {
    /// Of corners a, b, c: x and y in 1/256 pixels, z, 1/w.
    pub(crate) corners: [[f32x8<S>; 4]; 3],
}

/// The indices of the corners of eight triangles.
#[derive(Clone, Copy, Debug, Default)]
pub struct Corners {
    /// Of each triangle; of the first alone if they are the same.
    pub each: [[u32; 3]; 8],
    /// Whether all eight are the same triangle.
    pub are_same: bool,
}

impl<S: Simd> Eight<S> {
    /// The corners with these indices.
    #[inline(always)]
    pub(crate) fn gather(simd: S, vertices: &[Vertex], corners: &Corners) -> Self {
        Self { corners: three!(k => gather_columns(simd, vertices, corners, k)) }
    }

    /// The least and the greatest coordinate along an axis.
    #[inline(always)]
    pub(crate) fn extent(&self, axis: usize) -> [f32x8<S>; 2] {
        let [a, b, c] = three!(k => self.corners[k][axis]);
        [a.min(b).min(c), a.max(b).max(c)]
    }

    /// Twice the signed areas. Exact as far as the sign goes where the triangle is [`is_small`]: the products are.
    #[inline(always)]
    pub(crate) fn doubled_area(&self) -> f32x8<S> {
        let [a, b, c] = &self.corners;
        (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])
    }

    /// Those with a corner that has to be clipped.
    #[inline(always)]
    pub(crate) fn is_outside(&self) -> mask32x8<S> {
        let [a, b, c] = &self.corners;
        // NaN wins every sum.
        let sum = a[0] + b[0] + c[0];
        sum.simd_ne(sum)
    }
}

/// The greatest width and height of a small triangle in 1/256 pixels: 8 pixels. In a box of that size the products of two differences of
/// coordinates are whole numbers up to 2²², and the edge functions stay below 2²⁴, up to which f32 holds all whole numbers.
pub(crate) const SMALL: f32 = 2048.0;

/// Which triangles are small, by the extents of their x and y.
#[inline(always)]
pub(crate) fn is_small<S: Simd>(simd: S, x: [f32x8<S>; 2], y: [f32x8<S>; 2]) -> mask32x8<S> {
    let limit = f32x8::splat(simd, SMALL);
    (x[1] - x[0]).simd_le(limit) & (y[1] - y[0]).simd_le(limit)
}

/// The first and the last pixel centre in each extent; there is none if the first lies behind the last.
#[inline(always)]
pub(crate) fn centers<S: Simd>(simd: S, extent: [f32x8<S>; 2], size: u32) -> [f32x8<S>; 2] {
    let in_pixels = f32x8::splat(simd, 1.0 / SUBPIXELS as f32);
    let first = (extent[0] * in_pixels).ceil().max(f32x8::splat(simd, 0.0));
    [first, (extent[1] * in_pixels).floor().min(f32x8::splat(simd, size as f32 - 1.0))]
}

/// The four numbers that stand at corner `k` of each of eight triangles, as four columns.
///
/// # Panics
/// If an index lies beyond the end of `of_vertices`, or if `k` is 3 or more.
#[inline(always)]
pub fn gather_columns<S: Simd>(
    simd: S,
    of_vertices: &[[f32; 4]],
    corners: &Corners,
    k: usize,
) -> [f32x8<S>; 4] {
    let indices = &corners.each;
    if corners.are_same {
        let [x, y, z, w] = of_vertices[indices[0][k] as usize];
        let splat = |x: f32| f32x8::splat(simd, x);
        return [splat(x), splat(y), splat(z), splat(w)];
    }
    let vertex = |n: usize| f32x4::load_array_ref(simd, &of_vertices[indices[n][k] as usize]);
    let low = turned(vertex(0), vertex(1), vertex(2), vertex(3));
    let high = turned(vertex(4), vertex(5), vertex(6), vertex(7));
    [low[0].combine(high[0]), low[1].combine(high[1]), low[2].combine(high[2]), low[3].combine(high[3])]
}

/// Up to eight vectors as columns of x, y and z; what is missing is 0.
///
/// # Panics
/// If there are more than eight.
#[inline(always)]
pub fn load_columns<S: Simd>(simd: S, rows: &[Vec3]) -> [f32x8<S>; 3] {
    let mut columns = [[0.0; 8]; 3];
    for (k, v) in rows.iter().enumerate() {
        (columns[0][k], columns[1][k], columns[2][k]) = (v.x, v.y, v.z);
    }
    three!(k => f32x8::load_array_ref(simd, &columns[k]))
}

/// Puts four columns into up to eight rows of four numbers: what [`gather_columns`] reads.
///
/// # Panics
/// If there are more than eight rows.
#[inline(always)]
pub fn store_columns<S: Simd>(columns: [f32x8<S>; 4], rows: &mut [[f32; 4]]) {
    if let Ok(eight) = <&mut [[f32; 4]; 8]>::try_from(&mut *rows) {
        store_eight(columns, eight);
    } else {
        let mut eight = [[0.0; 4]; 8];
        store_eight(columns, &mut eight);
        rows.copy_from_slice(&eight[..rows.len()]);
    }
}

#[inline(always)]
fn store_eight<S: Simd>([x, y, z, w]: [f32x8<S>; 4], rows: &mut [[f32; 4]; 8]) {
    let (x, y, z, w) = (x.split(), y.split(), z.split(), w.split());
    let (low, high) = rows.as_flattened_mut().split_at_mut(16);
    f32x4::store_four_interleaved([x.0, y.0, z.0, w.0], low);
    f32x4::store_four_interleaved([x.1, y.1, z.1, w.1], high);
}

/// Four rows as four columns.
#[inline(always)]
fn turned<S: Simd>(a: f32x4<S>, b: f32x4<S>, c: f32x4<S>, d: f32x4<S>) -> [f32x4<S>; 4] {
    let (ac_low, ac_high) = (a.zip_low(c), a.zip_high(c));
    let (bd_low, bd_high) = (b.zip_low(d), b.zip_high(d));
    [ac_low.zip_low(bd_low), ac_low.zip_high(bd_low), ac_high.zip_low(bd_high), ac_high.zip_high(bd_high)]
}
