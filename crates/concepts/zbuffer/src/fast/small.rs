//! How are small triangles drawn? Made ready eight at a time; the tiny ones are drawn so too, pixel by pixel of their boxes, the others one
//! by one in blocks.

use fearless_simd::prelude::*;
use fearless_simd::{Simd, f32x8, f64x4, i32x8, mask32x8};

use crate::fast::band::Band;
use crate::fast::blocks::{BLOCK, affine_z, keep_nearest};
use crate::fast::eight::{Corners, Eight, centers, gather_columns};
use crate::fast::plane::{Wide, followed};
use crate::fast::projected::Number;
use crate::fast::vertices::{Rest, Vertex};
use crate::screen::SUBPIXELS;

/// A triangle is tiny if its box has at most this many pixel centres in a row or a column.
const TINY: f32 = 3.0;

impl Band {
    /// Draws eight small triangles: the tiny ones at once, the others one by one.
    #[inline(always)]
    pub(crate) fn draw_eight<S: Simd>(
        &mut self,
        simd: S,
        numbers: &[Number; 8],
        (vertices, rests): (&[Vertex], &[Rest]),
        corners: &Corners,
    ) {
        let eight = Eight::gather(simd, vertices, corners);
        let columns = centers(simd, eight.extent(0), self.width);
        let rows = self.rows_within(simd, centers(simd, eight.extent(1), self.height));
        let limit = f32x8::splat(simd, TINY);
        let rests = three!(k => gather_columns(simd, rests, corners, k));
        let setup = EightEdges::new(simd, &eight, &rests, columns[0], rows);
        let is_tiny = (columns[1] - columns[0]).simd_lt(limit) & (rows[1] - rows[0]).simd_lt(limit);
        if is_tiny.any_true() {
            self.draw_tiny(numbers, &setup, is_tiny);
        }
        let mut others = !is_tiny.to_bitmask() & 0xff;
        if others == 0 {
            return;
        }
        let last_column = columns[1].to_array();
        let stored = setup.stored();
        while others != 0 {
            let k = others.trailing_zeros() as usize;
            others &= others - 1;
            self.draw_one(simd, numbers[k], &stored, k, last_column[k] as u32);
        }
    }

    /// Draws triangle `k` of eight by blocks of 4 × 2 pixels.
    #[inline(always)]
    fn draw_one<S: Simd>(&mut self, simd: S, number: Number, stored: &Stored, k: usize, last_column: u32) {
        let first_column = stored.first_column[k] as u32;
        let (lowest, highest) = (stored.first_row[k] as u32, stored.last_row[k] as u32);
        let pairs = self.pairs(lowest, highest);
        let block = SmallBlock::new(simd, number, stored, k);
        // How many rows the top of the first pair lies above the lowest row.
        let above = self.top_of(pairs.start) as f32 - stored.first_row[k];
        let mut in_pair = block.at_top(above);
        let blocks = ((last_column - first_column) / BLOCK + 1) as usize;
        for pair in pairs {
            let (depths, numbers) = self.blocks_mut(pair, first_column, blocks);
            let mut at = in_pair;
            for (depths, numbers) in depths.iter_mut().zip(numbers) {
                block.test(simd, &at, depths, numbers);
                at = three!(e => at[e] + block.step[e]);
            }
            in_pair = three!(e => in_pair[e] - block.two_up[e]);
        }
    }

    /// The first and the last of these rows j that are in the band.
    #[inline(always)]
    fn rows_within<S: Simd>(&self, simd: S, [first, last]: [f32x8<S>; 2]) -> [f32x8<S>; 2] {
        let lowest = f32x8::splat(simd, (self.height - self.rows.end) as f32);
        let highest = f32x8::splat(simd, (self.height - 1 - self.rows.start) as f32);
        [first.max(lowest), last.min(highest)]
    }

    /// Asks, pixel after pixel of their boxes, which of the eight cover it.
    #[inline(always)]
    fn draw_tiny<S: Simd>(&mut self, numbers: &[Number; 8], tiny: &EightEdges<S>, is_tiny: mask32x8<S>) {
        let (first_column, first_row) = (tiny.first_column.to_array(), tiny.first_row.to_array());
        let area = tiny.doubled_area.widen();
        // The slide's reciprocal, in f64.
        let one = f64x4::splat(area.0.token(), 1.0);
        let inv = (one / area.0, one / area.1);
        let mut in_row = tiny.at_first;
        for dj in 0..TINY as u32 {
            let row_exists = (tiny.first_row + dj as f32).simd_le(tiny.last_row) & is_tiny;
            if row_exists.all_false() {
                return;
            }
            let mut at = in_row;
            for di in 0..TINY as u32 {
                let mut covered = (tiny.covers(&at) & row_exists).to_bitmask();
                if covered != 0 {
                    let z = tiny.depths(&at, &inv).to_array();
                    while covered != 0 {
                        let k = covered.trailing_zeros() as usize;
                        covered &= covered - 1;
                        let row = self.height - 1 - (first_row[k] as u32 + dj);
                        let pixel = self.pixel(first_column[k] as u32 + di, row);
                        self.test_one(pixel, numbers[k] as i32, z[k]);
                    }
                }
                at = three!(k => at[k] + tiny.step_right[k]);
            }
            in_row = three!(k => in_row[k] + tiny.step_up[k]);
        }
    }
}

/// Eight triangles made ready for their pixels. Up to [`crate::fast::eight::SMALL`] in size, all edge functions in their boxes are whole
/// numbers below 2²⁴, exact in f32.
struct EightEdges<S: Simd> {
    first_column: f32x8<S>,
    first_row: f32x8<S>,
    last_row: f32x8<S>,
    /// The edge functions in the first column of the first row.
    at_first: [f32x8<S>; 3],
    step_right: [f32x8<S>; 3],
    step_up: [f32x8<S>; 3],
    thresholds: [f32x8<S>; 3],
    /// The depths of the planes in the snapped corners, and the least and the greatest of each three, rounded.
    z: [Wide<S>; 3],
    least_z: f32x8<S>,
    greatest_z: f32x8<S>,
    doubled_area: f32x8<S>,
}

impl<S: Simd> EightEdges<S> {
    #[inline(always)]
    fn new(
        simd: S,
        eight: &Eight<S>,
        rests: &[[f32x8<S>; 4]; 3],
        first_column: f32x8<S>,
        [first_row, last_row]: [f32x8<S>; 2],
    ) -> Self {
        let (zero, one) = (f32x8::splat(simd, 0.0), f32x8::splat(simd, 1.0));
        let area = eight.doubled_area();
        let is_turned = area.simd_lt(zero);
        // Anticlockwise, as the slide's rasterizer has them.
        let turned = |[a, b, c]: &[[f32x8<S>; 4]; 3], axis: usize| {
            [a[axis], is_turned.select(c[axis], b[axis]), is_turned.select(b[axis], c[axis])]
        };
        let (x, y, z) = (turned(&eight.corners, 0), turned(&eight.corners, 1), turned(&eight.corners, 2));
        let rests = [turned(rests, 0), turned(rests, 1), turned(rests, 2)];
        let z = followed(simd, [x, y, z], rests);
        let narrow = three!(k => z[k].0.narrow(z[k].1));
        let step = f32x8::splat(simd, SUBPIXELS as f32);
        let (px, py) = (first_column * step, first_row * step);
        // The edges bc, ca, ab: where they start, and which way they go.
        let (from_x, from_y) = ([x[1], x[2], x[0]], [y[1], y[2], y[0]]);
        let along_x = [x[2] - x[1], x[0] - x[2], x[1] - x[0]];
        let along_y = [y[2] - y[1], y[0] - y[2], y[1] - y[0]];
        Self {
            first_column,
            first_row,
            last_row,
            at_first: three!(k => along_x[k] * (py - from_y[k]) - along_y[k] * (px - from_x[k])),
            step_right: three!(k => zero - along_y[k] * step),
            step_up: three!(k => along_x[k] * step),
            thresholds: three!(k => {
                let is_left = along_y[k].simd_lt(zero);
                let is_top = along_y[k].simd_eq(zero) & along_x[k].simd_lt(zero);
                (is_left | is_top).select(zero, one)
            }),
            z,
            // Rounding keeps the order: the least of the rounded is the least, rounded.
            least_z: narrow[0].min(narrow[1]).min(narrow[2]),
            greatest_z: narrow[0].max(narrow[1]).max(narrow[2]),
            doubled_area: area.abs(),
        }
    }

    #[inline(always)]
    fn covers(&self, at: &[f32x8<S>; 3]) -> mask32x8<S> {
        at[0].simd_ge(self.thresholds[0])
            & at[1].simd_ge(self.thresholds[1])
            & at[2].simd_ge(self.thresholds[2])
    }

    /// z with the slide's roundings: interpolated in f64, rounded to f32, kept within the corners' (E9).
    #[inline(always)]
    fn depths(&self, at: &[f32x8<S>; 3], inv: &(f64x4<S>, f64x4<S>)) -> f32x8<S> {
        let at = three!(k => at[k].widen());
        let low = affine_z(three!(k => at[k].0), three!(k => self.z[k].0), inv.0);
        let high = affine_z(three!(k => at[k].1), three!(k => self.z[k].1), inv.1);
        low.narrow(high).max(self.least_z).min(self.greatest_z)
    }
}

/// The same in memory, where one triangle of the eight is picked.
struct Stored {
    first_column: [f32; 8],
    first_row: [f32; 8],
    last_row: [f32; 8],
    at_first: [[f32; 8]; 3],
    step_right: [[f32; 8]; 3],
    step_up: [[f32; 8]; 3],
    thresholds: [[f32; 8]; 3],
    /// Of the first four triangles and of the others.
    z: [[[f64; 4]; 2]; 3],
    least_z: [f32; 8],
    greatest_z: [f32; 8],
    doubled_area: [f32; 8],
}

impl<S: Simd> EightEdges<S> {
    #[inline(always)]
    fn stored(&self) -> Stored {
        Stored {
            first_column: self.first_column.to_array(),
            first_row: self.first_row.to_array(),
            last_row: self.last_row.to_array(),
            at_first: three!(k => self.at_first[k].to_array()),
            step_right: three!(k => self.step_right[k].to_array()),
            step_up: three!(k => self.step_up[k].to_array()),
            thresholds: three!(k => self.thresholds[k].to_array()),
            z: three!(k => [self.z[k].0.to_array(), self.z[k].1.to_array()]),
            least_z: self.least_z.to_array(),
            greatest_z: self.greatest_z.to_array(),
            doubled_area: self.doubled_area.to_array(),
        }
    }
}

/// One small triangle, spread out over the eight pixels of a block: four columns, each of two rows from the top down.
struct SmallBlock<S: Simd> {
    number: i32x8<S>,
    /// In the upper left pixel's column of the lowest row, what the edge functions are in the eight pixels.
    at_lowest: [f32x8<S>; 3],
    step_up: [f32x8<S>; 3],
    two_up: [f32x8<S>; 3],
    /// From a block to the next on the right.
    step: [f32x8<S>; 3],
    thresholds: [f32x8<S>; 3],
    z: [f64x4<S>; 3],
    inv_doubled_area: f64x4<S>,
    least_z: f32x8<S>,
    greatest_z: f32x8<S>,
}

impl<S: Simd> SmallBlock<S> {
    #[inline(always)]
    fn new(simd: S, number: Number, stored: &Stored, k: usize) -> Self {
        let columns = f32x8::load_array(simd, [0.0, 0.0, 1.0, 1.0, 2.0, 2.0, 3.0, 3.0]);
        let down = f32x8::load_array(simd, [0.0, 1.0, 0.0, 1.0, 0.0, 1.0, 0.0, 1.0]);
        let splat = |x: f32| f32x8::splat(simd, x);
        Self {
            number: i32x8::splat(simd, number as i32),
            at_lowest: three!(e => {
                let across = columns * splat(stored.step_right[e][k]) - down * splat(stored.step_up[e][k]);
                across + splat(stored.at_first[e][k])
            }),
            step_up: three!(e => splat(stored.step_up[e][k])),
            two_up: three!(e => splat(2.0 * stored.step_up[e][k])),
            step: three!(e => splat(4.0 * stored.step_right[e][k])),
            thresholds: three!(e => splat(stored.thresholds[e][k])),
            z: three!(e => f64x4::splat(simd, stored.z[e][k / 4][k % 4])),
            inv_doubled_area: f64x4::splat(simd, 1.0 / f64::from(stored.doubled_area[k])),
            least_z: splat(stored.least_z[k]),
            greatest_z: splat(stored.greatest_z[k]),
        }
    }

    /// The block at the left of a pair of rows whose upper one lies `above` rows above the lowest.
    #[inline(always)]
    fn at_top(&self, above: f32) -> [f32x8<S>; 3] {
        three!(e => self.at_lowest[e] + self.step_up[e] * above)
    }

    /// Puts the triangle into those pixels of a block where it is inside and nearest.
    #[inline(always)]
    fn test(&self, simd: S, at: &[f32x8<S>; 3], depths: &mut [f32; 8], numbers: &mut [i32; 8]) {
        let covered = at[0].simd_ge(self.thresholds[0])
            & at[1].simd_ge(self.thresholds[1])
            & at[2].simd_ge(self.thresholds[2]);
        if covered.all_false() {
            return;
        }
        let at = three!(e => at[e].widen());
        let low = affine_z(three!(e => at[e].0), self.z, self.inv_doubled_area);
        let high = affine_z(three!(e => at[e].1), self.z, self.inv_doubled_area);
        let z = low.narrow(high).max(self.least_z).min(self.greatest_z);
        keep_nearest(simd, covered, z, self.number, depths, numbers);
    }
}
