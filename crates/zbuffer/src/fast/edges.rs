//! On which side of its three edges is a pixel, exactly? The slide's whole numbers, in f64, where they are exact too.

use fearless_simd::prelude::*;
use fearless_simd::{Simd, f64x4};

use crate::fast::bins::doubled_area;
use crate::fast::vertices::Vertex;
use crate::screen::SUBPIXELS;

/// A triangle made ready for its pixels: as the slide's `Setup`, number for number.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Edges {
    /// The vertices, anticlockwise.
    pub(crate) corners: [Vertex; 3],
    /// Whether b and c were exchanged for that.
    pub(crate) is_turned: bool,
    /// Where the edges bc, ca, ab start, and which way they go, in 1/256 pixels.
    from: [[f64; 2]; 3],
    along: [[f64; 2]; 3],
    pub(crate) inv_doubled_area: f64,
}

/// 1/256 pixels from a pixel to the next.
const STEP: f64 = SUBPIXELS as f64;

impl Edges {
    /// The edges of a triangle with an area.
    #[inline(always)]
    pub(crate) fn new([a, b, c]: [&Vertex; 3]) -> Self {
        let area = doubled_area(a, b, c);
        let is_turned = area < 0.0;
        let corners = if is_turned { [*a, *c, *b] } else { [*a, *b, *c] };
        let [a, b, c] = corners.map(|v| [f64::from(v[0]), f64::from(v[1])]);
        let along = |from: [f64; 2], to: [f64; 2]| [to[0] - from[0], to[1] - from[1]];
        Self {
            corners,
            is_turned,
            from: [b, c, a],
            along: [along(b, c), along(c, a), along(a, b)],
            inv_doubled_area: 1.0 / area.abs(),
        }
    }

    /// The three edge functions at the centre of pixel (i, j).
    #[inline(always)]
    pub(crate) fn at(&self, i: f64, j: f64) -> [f64; 3] {
        std::array::from_fn(|k| {
            let ([x, y], [dx, dy]) = (self.from[k], self.along[k]);
            dx * (STEP * j - y) - dy * (STEP * i - x)
        })
    }

    /// What edge function `k` gains from a pixel to the next on the right.
    #[inline(always)]
    pub(crate) fn step_right(&self, k: usize) -> f64 {
        -STEP * self.along[k][1]
    }

    /// What edge function `k` gains from a row to the next one up.
    #[inline(always)]
    pub(crate) fn step_up(&self, k: usize) -> f64 {
        STEP * self.along[k][0]
    }

    /// The least value of edge function `k` that counts as inside, by the top-left rule (E10).
    #[inline(always)]
    pub(crate) fn threshold(&self, k: usize) -> f64 {
        let [dx, dy] = self.along[k];
        let is_owned = dy < 0.0 || dy == 0.0 && dx < 0.0;
        if is_owned { 0.0 } else { 1.0 }
    }

    /// Coordinate `axis` of the three vertices: 2 is z, 3 is 1/w.
    #[inline(always)]
    pub(crate) fn of_corners<S: Simd>(&self, simd: S, axis: usize) -> [f64x4<S>; 3] {
        self.corners.map(|v| f64x4::splat(simd, f64::from(v[axis])))
    }

    /// The columns and rows of the box around the triangle that are on a screen, both ends included; rows j upwards.
    #[inline(always)]
    pub(crate) fn pixels(&self, (width, height): (u32, u32)) -> ([u32; 2], [u32; 2]) {
        let [a, b, c] = self.corners;
        let range = |axis: usize, size: u32| {
            let least = a[axis].min(b[axis]).min(c[axis]);
            let greatest = a[axis].max(b[axis]).max(c[axis]);
            let in_pixels = 1.0 / SUBPIXELS as f32;
            // `as` turns what lies below 0 into 0.
            let first = (least * in_pixels).ceil() as u32;
            let last = (greatest * in_pixels).floor().min(size as f32 - 1.0) as u32;
            [first, last]
        };
        (range(0, width), range(1, height))
    }
}
