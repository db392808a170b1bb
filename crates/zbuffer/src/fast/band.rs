//! What do some rows of the screen show? The nearest triangle in each pixel, and its depth.

use std::ops::Range;

use fearless_simd::prelude::*;
use fearless_simd::{Level, Simd, dispatch, f32x4, f32x8, f64x4, i32x4, i32x8, mask64x4};

use crate::fast::bins::{BAND_ROWS, Piece};
use crate::fast::edges::Edges;
use crate::fast::projected::{NONE, Number, Part, Projected};

/// Depths and triangles of a band of rows. One for each thread is enough; it is used again for band after band.
#[derive(Clone, Debug, Default)]
pub struct Band {
    /// The screen's rows in it, counted from the top.
    rows: Range<u32>,
    width: usize,
    height: u32,
    /// Pixels from a row to the next: a few more than the width, since blocks may stand over.
    stride: usize,
    depths: Vec<f32>,
    numbers: Vec<i32>,
}

/// How many columns a block has; it has two rows.
const BLOCK: usize = 4;

impl Band {
    /// Draws band `b`: for each pixel the nearest triangle, and of equally near ones the first (L16).
    ///
    /// The same triangles and the same depths, bit for bit, as [`crate::rasterize`] and [`crate::DepthBuffer`] find.
    ///
    /// - `parts`: those of [`Projected::project`].
    ///
    /// # Panics
    /// If there is no such band, or if `parts` are others.
    pub fn draw(&mut self, b: u32, projected: &Projected, parts: &[Part]) {
        self.clear(b, projected.size);
        dispatch!(Level::new(), simd => self.draw_chunks(simd, b, projected, parts));
        for chunk in projected.chunks() {
            chunk.pieces.iter().for_each(|piece| self.draw_piece(piece));
        }
    }

    /// The rows of the screen in the band, from the top.
    #[must_use]
    pub fn rows(&self) -> Range<u32> {
        self.rows.clone()
    }

    /// What a row shows, by columns: triangles' numbers, or [`NONE`]. Rows from the top.
    ///
    /// # Panics
    /// If the row lies outside the band.
    #[must_use]
    pub fn numbers(&self, row: u32) -> &[i32] {
        let start = self.start(row);
        &self.numbers[start..start + self.width]
    }

    /// Its depths: canonical z, −∞ where there is nothing.
    ///
    /// # Panics
    /// If the row lies outside the band.
    #[must_use]
    pub fn depths(&self, row: u32) -> &[f32] {
        let start = self.start(row);
        &self.depths[start..start + self.width]
    }

    fn start(&self, row: u32) -> usize {
        assert!(self.rows.contains(&row), "row {row} is not one of {:?}", self.rows);
        (row - self.rows.start) as usize * self.stride
    }

    fn clear(&mut self, b: u32, (width, height): (u32, u32)) {
        self.rows = b * BAND_ROWS..height.min((b + 1) * BAND_ROWS);
        (self.width, self.height) = (width as usize, height);
        self.stride = self.width + BLOCK;
        // One row more, over which a block may stand.
        let pixels = self.stride * (self.rows.len() + 1);
        self.depths.clear();
        self.depths.resize(pixels, f32::NEG_INFINITY);
        self.numbers.clear();
        self.numbers.resize(pixels, NONE as i32);
    }

    #[inline(always)]
    fn draw_chunks<S: Simd>(&mut self, simd: S, b: u32, projected: &Projected, parts: &[Part]) {
        for chunk in projected.chunks() {
            let first = projected.first_number(chunk.part);
            let mesh = parts[chunk.part].mesh;
            for &number in chunk.in_band(b) {
                let corners = projected.corners(chunk.part, mesh, (number - first) as usize);
                self.draw_triangle(simd, number, &Edges::new(corners));
            }
        }
    }

    /// Blocks of 4 × 2 pixels, from the top down.
    #[inline(always)]
    fn draw_triangle<S: Simd>(&mut self, simd: S, number: Number, edges: &Edges) {
        let ([left, right], [lowest, highest]) = edges.pixels((self.width as u32, self.height));
        // From j upwards to rows downwards.
        let top = (self.height - 1 - highest).max(self.rows.start);
        let bottom = (self.height - 1 - lowest).min(self.rows.end - 1);
        let block = Block::new(simd, number, edges);
        let mut row = top;
        while row <= bottom {
            let j = f64::from(self.height - 1 - row);
            let (mut i, mut last) = (left, right);
            if right - left >= 4 * BLOCK as u32 {
                (i, last) = covered(edges, [left, right], j);
            }
            let mut at = block.at(edges, i, j);
            while i <= last {
                let upper = (row - self.rows.start) as usize * self.stride + i as usize;
                self.test(simd, &block, &at, upper);
                at = block.stepped_right(at);
                i += BLOCK as u32;
            }
            row += 2;
        }
    }

    /// Puts the triangle into those pixels of a block where it is inside and nearest.
    #[inline(always)]
    fn test<S: Simd>(&mut self, simd: S, block: &Block<S>, at: &[[f64x4<S>; 3]; 2], upper: usize) {
        let covered = block.covers(at[0]).narrow(block.covers(at[1]));
        if covered.all_false() {
            return;
        }
        let z = block.depths(at);
        let lower = upper + self.stride;
        let known = two_rows(simd, &self.depths, upper, lower);
        let numbers = i32x4::from_slice(simd, &self.numbers[upper..upper + BLOCK])
            .combine(i32x4::from_slice(simd, &self.numbers[lower..lower + BLOCK]));
        let first_of_equals = z.simd_eq(known) & block.number.simd_lt(numbers);
        let wins = covered & (z.simd_gt(known) | first_of_equals);
        let (z_upper, z_lower) = wins.select(z, known).split();
        z_upper.store_slice(&mut self.depths[upper..upper + BLOCK]);
        z_lower.store_slice(&mut self.depths[lower..lower + BLOCK]);
        let (n_upper, n_lower) = wins.select(block.number, numbers).split();
        n_upper.store_slice(&mut self.numbers[upper..upper + BLOCK]);
        n_lower.store_slice(&mut self.numbers[lower..lower + BLOCK]);
    }

    /// What clipping left of a triangle goes the slide's way.
    fn draw_piece(&mut self, piece: &Piece) {
        let j = self.height - self.rows.end..self.height - self.rows.start;
        let (width, height) = (self.width as u32, self.height);
        let (start, stride, number) = (self.rows.start, self.stride, piece.number as i32);
        let (depths, numbers) = (&mut self.depths, &mut self.numbers);
        crate::rasterize_rows(&piece.on_screen, width, j, |fragment| {
            let row = height - 1 - fragment.j - start;
            let pixel = row as usize * stride + fragment.i as usize;
            if fragment.z > depths[pixel] || fragment.z == depths[pixel] && number < numbers[pixel] {
                depths[pixel] = fragment.z;
                numbers[pixel] = number;
            }
        });
    }
}

/// Four columns of two rows.
#[inline(always)]
fn two_rows<S: Simd>(simd: S, of: &[f32], upper: usize, lower: usize) -> f32x8<S> {
    f32x4::from_slice(simd, &of[upper..upper + BLOCK])
        .combine(f32x4::from_slice(simd, &of[lower..lower + BLOCK]))
}

/// Columns of row j, and of the row below it, that may be covered: at least all that are.
#[inline(always)]
fn covered(edges: &Edges, [left, right]: [u32; 2], j: f64) -> (u32, u32) {
    let at = edges.at(f64::from(left), j);
    let (mut first, mut last) = (0.0_f64, f64::from(right - left));
    for k in 0..3 {
        let step = edges.step_right(k);
        // The greater value of the two rows: inside there, where either is.
        let greatest = at[k].max(at[k] - edges.step_up(k));
        if step > 0.0 {
            first = first.max(-greatest / step);
        } else if step < 0.0 {
            last = last.min(greatest / -step);
        } else if greatest < 0.0 {
            return (1, 0);
        }
    }
    // Rounding is far below a pixel.
    let (first, last) = ((first - 1.0).max(0.0), (last + 1.0).min(f64::from(right - left)));
    if first <= last { (left + first as u32, left + last as u32) } else { (1, 0) }
}

/// What all blocks of one triangle have in common.
struct Block<S: Simd> {
    number: i32x8<S>,
    thresholds: [f64x4<S>; 3],
    /// What the edge functions gain from the first to each of the four columns.
    across: [f64x4<S>; 3],
    /// And from a block to the next.
    step: [f64x4<S>; 3],
    z: [f64x4<S>; 3],
    inv_doubled_area: f64x4<S>,
    least_z: f32x8<S>,
    greatest_z: f32x8<S>,
}

impl<S: Simd> Block<S> {
    #[inline(always)]
    fn new(simd: S, number: Number, edges: &Edges) -> Self {
        let columns = f64x4::load_array(simd, [0.0, 1.0, 2.0, 3.0]);
        let splat = |x: f64| f64x4::splat(simd, x);
        let [a, b, c] = edges.corners.map(|v| v[2]);
        Self {
            number: i32x8::splat(simd, number as i32),
            thresholds: std::array::from_fn(|k| splat(edges.threshold(k))),
            across: std::array::from_fn(|k| columns * splat(edges.step_right(k))),
            step: std::array::from_fn(|k| splat(BLOCK as f64 * edges.step_right(k))),
            z: edges.of_corners(simd, 2),
            inv_doubled_area: splat(edges.inv_doubled_area),
            least_z: f32x8::splat(simd, a.min(b).min(c)),
            greatest_z: f32x8::splat(simd, a.max(b).max(c)),
        }
    }

    /// The edge functions in a block whose upper left pixel is (i, j): whole numbers below 2⁵³, so no sum is rounded.
    #[inline(always)]
    fn at(&self, edges: &Edges, i: u32, j: f64) -> [[f64x4<S>; 3]; 2] {
        let at = edges.at(f64::from(i), j);
        let upper: [f64x4<S>; 3] = std::array::from_fn(|k| self.across[k] + at[k]);
        [upper, std::array::from_fn(|k| upper[k] - edges.step_up(k))]
    }

    #[inline(always)]
    fn stepped_right(&self, at: [[f64x4<S>; 3]; 2]) -> [[f64x4<S>; 3]; 2] {
        at.map(|row| std::array::from_fn(|k| row[k] + self.step[k]))
    }

    #[inline(always)]
    fn covers(&self, at: [f64x4<S>; 3]) -> mask64x4<S> {
        at[0].simd_ge(self.thresholds[0])
            & at[1].simd_ge(self.thresholds[1])
            & at[2].simd_ge(self.thresholds[2])
    }

    /// z in both rows, with the slide's roundings: interpolated in f64, rounded to f32, kept within the vertices' (E9).
    #[inline(always)]
    fn depths(&self, at: &[[f64x4<S>; 3]; 2]) -> f32x8<S> {
        let [upper, lower] =
            at.map(|e| (e[0] * self.z[0] + e[1] * self.z[1] + e[2] * self.z[2]) * self.inv_doubled_area);
        upper.narrow(lower).max(self.least_z).min(self.greatest_z)
    }
}
