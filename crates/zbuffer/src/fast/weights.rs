//! Where in its triangle is what a pixel shows? For eight pixels of a row at once, whichever triangles they show.

use fearless_simd::prelude::*;
use fearless_simd::{Simd, f32x8, f64x4, mask32x8};

use crate::fast::bins::Piece;
use crate::fast::eight::{Eight, Indices};
use crate::fast::projected::{Number, Projected};
use crate::screen::SUBPIXELS;
use geometry::Barycentric;

/// α, β and γ of eight pixels, and those of which they are not known.
pub struct Weights<S: Simd> {
    /// α, β, γ, perspective-correct (E9): what [`crate::rasterize`] gives, bit for bit.
    pub columns: [f32x8<S>; 3],
    /// Pixels of triangles that were clipped: for them ask [`Projected::weights_of_clipped`].
    pub is_clipped: mask32x8<S>,
}

impl Projected {
    /// The weights in pixels (i, j), (i + 1, j), … (i + 7, j).
    ///
    /// - `indices`: the corners of the triangle that each pixel shows, counted through the positions of all parts:
    ///   [`Projected::first_vertex`].
    #[inline(always)]
    pub fn weights<S: Simd>(&self, simd: S, indices: &Indices, i: u32, j: u32) -> Weights<S> {
        let eight = Eight::gather(simd, &self.vertices, indices);
        let is_turned = eight.doubled_area().simd_lt(f32x8::splat(simd, 0.0));
        let [a, b, c] = &eight.corners;
        // Anticlockwise, as the slide's rasterizer has them: sums are then rounded alike.
        let (turned_b, turned_c) = (
            [pick(is_turned, c, b, 0), pick(is_turned, c, b, 1)],
            [pick(is_turned, b, c, 0), pick(is_turned, b, c, 1)],
        );
        let inv_w = [a[3], pick(is_turned, c, b, 3), pick(is_turned, b, c, 3)];
        let x = [a[0].widen(), turned_b[0].widen(), turned_c[0].widen()];
        let y = [a[1].widen(), turned_b[1].widen(), turned_c[1].widen()];
        let w = three!(k => inv_w[k].widen());
        let (step, first) = (SUBPIXELS as f64, f64::from(i));
        let columns = f64x4::load_array(simd, [first, first + 1.0, first + 2.0, first + 3.0]) * step;
        let row = f64x4::splat(simd, step * f64::from(j));
        let low = four([three!(k => x[k].0), three!(k => y[k].0), three!(k => w[k].0)], columns, row);
        let high =
            four([three!(k => x[k].1), three!(k => y[k].1), three!(k => w[k].1)], columns + 4.0 * step, row);
        let [alpha, beta, gamma] = three!(k => low[k].narrow(high[k]));
        Weights {
            columns: [alpha, is_turned.select(gamma, beta), is_turned.select(beta, gamma)],
            is_clipped: eight.is_outside(),
        }
    }

    /// The weights in pixel (i, j) of a triangle that was clipped, the slide's way; `None` if it does not cover the pixel.
    #[must_use]
    pub fn weights_of_clipped(&self, number: Number, i: u32, j: u32) -> Option<Barycentric> {
        let mut found = None;
        for Piece { on_screen, .. } in self.pieces_of(number) {
            crate::rasterize_rows(on_screen, self.size.0, j..j + 1, |fragment| {
                if fragment.i == i {
                    found = Some(fragment.weights);
                }
            });
        }
        found
    }
}

/// The coordinate of one corner or of another.
#[inline(always)]
fn pick<S: Simd>(mask: mask32x8<S>, yes: &[f32x8<S>; 4], no: &[f32x8<S>; 4], axis: usize) -> f32x8<S> {
    mask.select(yes[axis], no[axis])
}

/// The weights in four pixels: each edge function times 1/w of the vertex opposite, over their sum. All terms have one sign:
/// nothing cancels.
#[inline(always)]
fn four<S: Simd>([x, y, w]: [[f64x4<S>; 3]; 3], column: f64x4<S>, row: f64x4<S>) -> [f64x4<S>; 3] {
    let edge =
        |from: usize, to: usize| (x[to] - x[from]) * (row - y[from]) - (y[to] - y[from]) * (column - x[from]);
    let shares = [edge(1, 2) * w[0], edge(2, 0) * w[1], edge(0, 1) * w[2]];
    let sum = shares[0] + shares[1] + shares[2];
    [shares[0] / sum, shares[1] / sum, shares[2] / sum]
}
