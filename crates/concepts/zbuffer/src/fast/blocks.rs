//! How are larger triangles drawn? By blocks of 4 × 2 pixels, and not at all where something nearer is everywhere.

use fearless_simd::prelude::*;
use fearless_simd::{Simd, f32x8, f64x4, i32x8, mask32x8, mask64x4};

use crate::fast::band::Band;
use crate::fast::bins::BAND_ROWS;
use crate::fast::edges::Edges;
use crate::fast::projected::Number;

/// How many columns a block has; it has two rows.
pub(crate) const BLOCK: u32 = 4;

/// How many columns a tile has; it has the rows of the band.
pub(crate) const TILE: u32 = 64;

impl Band {
    /// Draws a triangle of some pixels, block by block of its box.
    #[inline(always)]
    pub(crate) fn draw_in_blocks<S: Simd>(&mut self, simd: S, number: Number, edges: &Edges) {
        let (columns, [lowest, highest]) = edges.pixels((self.width, self.height));
        let pairs = self.pairs(lowest, highest);
        let block = Block::new(simd, number, edges);
        for pair in pairs {
            self.draw_pair(simd, &block, edges, pair, columns);
        }
    }

    /// Draws a large triangle tile by tile, but for those tiles in which everything is nearer.
    #[inline(always)]
    pub(crate) fn draw_in_tiles<S: Simd>(&mut self, simd: S, number: Number, edges: &Edges) {
        let (columns, [lowest, highest]) = edges.pixels((self.width, self.height));
        let pairs = self.pairs(lowest, highest);
        let block = Block::new(simd, number, edges);
        let mut covered = [[1, 0]; (BAND_ROWS / 2) as usize];
        for pair in pairs.clone() {
            covered[pair as usize] = edges.covered(columns, self.top_of(pair));
        }
        for tile in columns[0] / TILE..=columns[1] / TILE {
            let (left, right) = (tile * TILE, (tile + 1) * TILE - 1);
            if edges.nearest([left, right], [self.top_of(pairs.end - 1) - 1.0, self.top_of(pairs.start)])
                < f64::from(self.farthest[tile as usize])
            {
                continue;
            }
            for pair in pairs.clone() {
                let [first, last] = covered[pair as usize];
                self.draw_pair(simd, &block, edges, pair, [first.max(left), last.min(right)]);
            }
            self.farthest[tile as usize] = self.farthest_in(simd, tile);
        }
    }

    /// The pairs of rows of the band in which rows `lowest` to `highest` lie, j upwards.
    #[inline(always)]
    pub(crate) fn pairs(&self, lowest: u32, highest: u32) -> std::ops::Range<u32> {
        let top = (self.height - 1 - highest).max(self.rows.start) - self.rows.start;
        let bottom = (self.height - 1 - lowest).min(self.rows.end - 1) - self.rows.start;
        top / 2..bottom / 2 + 1
    }

    /// j of the upper row of a pair.
    #[inline(always)]
    pub(crate) fn top_of(&self, pair: u32) -> f64 {
        f64::from(self.height) - 1.0 - f64::from(self.rows.start + 2 * pair)
    }

    /// Two rows of a triangle from a first to a last column.
    #[inline(always)]
    fn draw_pair<S: Simd>(
        &mut self,
        simd: S,
        block: &Block<S>,
        edges: &Edges,
        pair: u32,
        [first, last]: [u32; 2],
    ) {
        if first > last {
            return;
        }
        let mut at = block.at(edges, first, self.top_of(pair));
        let (depths, numbers) = self.blocks_mut(pair, first, ((last - first) / BLOCK + 1) as usize);
        for (depths, numbers) in depths.iter_mut().zip(numbers) {
            block.test(simd, &at, depths, numbers);
            at = block.stepped_right(&at);
        }
    }

    /// Some blocks of a pair of rows from a column on.
    #[inline(always)]
    pub(crate) fn blocks_mut(
        &mut self,
        pair: u32,
        first: u32,
        blocks: usize,
    ) -> (&mut [[f32; 8]], &mut [[i32; 8]]) {
        let start = 2 * (pair as usize * self.stride + first as usize);
        let pixels = start..start + 8 * blocks;
        (self.depths[pixels.clone()].as_chunks_mut().0, self.numbers[pixels].as_chunks_mut().0)
    }

    /// The farthest depth in a tile, as far as it is on the screen; −∞ where there is nothing.
    #[inline(always)]
    fn farthest_in<S: Simd>(&self, simd: S, tile: u32) -> f32 {
        let (left, right) = (tile * TILE, self.width.min((tile + 1) * TILE));
        let mut farthest = f32x8::splat(simd, f32::INFINITY);
        let mut rest = f32::INFINITY;
        let rows = self.rows.len();
        for pair in 0..rows.div_ceil(2) {
            let start = 2 * (pair * self.stride + left as usize);
            let pixels = &self.depths[start..start + 2 * (right - left) as usize];
            if 2 * pair + 1 == rows {
                // The last row of a screen of odd height stands alone.
                rest = pixels.iter().step_by(2).copied().fold(rest, f32::min);
                continue;
            }
            let (blocks, last) = pixels.as_chunks::<8>();
            for block in blocks {
                farthest = farthest.min(f32x8::load_array_ref(simd, block));
            }
            rest = last.iter().copied().fold(rest, f32::min);
        }
        farthest.reduce_min().min(rest)
    }
}

/// What all blocks of one triangle have in common. Of its eight pixels a block has four in each half: two columns, each from the top down.
struct Block<S: Simd> {
    number: i32x8<S>,
    thresholds: [f64x4<S>; 3],
    /// What the edge functions gain from the upper left pixel of a half to its four pixels.
    within: [f64x4<S>; 3],
    /// From a half to the next.
    half_step: [f64x4<S>; 3],
    z: [f64x4<S>; 3],
    inv_doubled_area: f64x4<S>,
    least_z: f32x8<S>,
    greatest_z: f32x8<S>,
}

/// The edge functions in the two halves of a block: whole numbers below 2⁵³, so no sum is rounded.
type AtBlock<S> = [[f64x4<S>; 3]; 2];

impl<S: Simd> Block<S> {
    #[inline(always)]
    fn new(simd: S, number: Number, edges: &Edges) -> Self {
        let splat = |x: f64| f64x4::splat(simd, x);
        let [a, b, c] = edges.depths;
        Self {
            number: i32x8::splat(simd, number as i32),
            thresholds: three!(k => splat(edges.threshold(k))),
            within: three!(k => {
                let (right, down) = (edges.step_right(k), -edges.step_up(k));
                f64x4::load_array(simd, [0.0, down, right, right + down])
            }),
            half_step: three!(k => splat(2.0 * edges.step_right(k))),
            z: [splat(a), splat(b), splat(c)],
            inv_doubled_area: splat(edges.inv_doubled_area),
            // Rounding keeps the order: bounds that are rounded bound what is rounded.
            least_z: f32x8::splat(simd, a.min(b).min(c) as f32),
            greatest_z: f32x8::splat(simd, a.max(b).max(c) as f32),
        }
    }

    /// The block whose upper left pixel is (i, j).
    #[inline(always)]
    fn at(&self, edges: &Edges, i: u32, j: f64) -> AtBlock<S> {
        let at = edges.at(f64::from(i), j);
        let left = three!(k => self.within[k] + at[k]);
        [left, three!(k => left[k] + self.half_step[k])]
    }

    #[inline(always)]
    fn stepped_right(&self, at: &AtBlock<S>) -> AtBlock<S> {
        let left = three!(k => at[1][k] + self.half_step[k]);
        [left, three!(k => left[k] + self.half_step[k])]
    }

    /// Puts the triangle into those pixels of a block where it is inside and nearest.
    #[inline(always)]
    fn test(&self, simd: S, at: &AtBlock<S>, depths: &mut [f32; 8], numbers: &mut [i32; 8]) {
        let covered = self.covers(&at[0]).narrow(self.covers(&at[1]));
        if covered.all_false() {
            return;
        }
        let left = affine_z(at[0], self.z, self.inv_doubled_area);
        let z = left.narrow(affine_z(at[1], self.z, self.inv_doubled_area));
        let z = z.max(self.least_z).min(self.greatest_z);
        keep_nearest(simd, covered, z, self.number, depths, numbers);
    }

    #[inline(always)]
    fn covers(&self, at: &[f64x4<S>; 3]) -> mask64x4<S> {
        at[0].simd_ge(self.thresholds[0])
            & at[1].simd_ge(self.thresholds[1])
            & at[2].simd_ge(self.thresholds[2])
    }
}

/// z in four pixels with the slide's roundings: interpolated in f64 from the edge functions there (E9).
#[inline(always)]
pub(crate) fn affine_z<S: Simd>(at: [f64x4<S>; 3], z: [f64x4<S>; 3], inv_doubled_area: f64x4<S>) -> f64x4<S> {
    (at[0] * z[0] + at[1] * z[1] + at[2] * z[2]) * inv_doubled_area
}

/// The depth test for a block: of equals the lower number stays, in whatever order they come.
#[inline(always)]
pub(crate) fn keep_nearest<S: Simd>(
    simd: S,
    covered: mask32x8<S>,
    z: f32x8<S>,
    number: i32x8<S>,
    depths: &mut [f32; 8],
    numbers: &mut [i32; 8],
) {
    let known = f32x8::load_array_ref(simd, depths);
    let known_numbers = i32x8::load_array_ref(simd, numbers);
    let is_first_of_equals = z.simd_eq(known) & number.simd_lt(known_numbers);
    let wins = covered & (z.simd_gt(known) | is_first_of_equals);
    wins.select(z, known).store_array(depths);
    wins.select(number, known_numbers).store_array(numbers);
}
