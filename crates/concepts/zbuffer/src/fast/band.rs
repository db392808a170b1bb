//! What do some rows of the screen show? The nearest triangle in each pixel, and its depth.

use std::ops::Range;

use fearless_simd::prelude::*;
use fearless_simd::{Level, Simd, dispatch, i32x8, mask32x8, u32x8};

use crate::fast::bins::{BAND_ROWS, Piece};
use crate::fast::blocks::TILE;
use crate::fast::edges::Edges;
use crate::fast::eight::Corners;
use crate::fast::projected::{MeshInstance, NONE, Number, Projected};

/// Depths and triangles of a band of rows. One for each thread is enough; it is used again for band after band.
///
/// Two rows lie interleaved: a block of pixels two rows high, as [`crate::fast`] draws them, is one piece of memory.
#[derive(Clone, Debug, Default)]
pub struct Band {
    /// The screen's rows in it, counted from the top.
    pub(crate) rows: Range<u32>,
    pub(crate) width: u32,
    /// That of the screen.
    pub(crate) height: u32,
    /// Columns, with a few behind the last, since blocks may stand over.
    pub(crate) stride: usize,
    pub(crate) depths: Vec<f32>,
    pub(crate) numbers: Vec<i32>,
    /// The large triangles of the band by their nearest depths.
    large: Vec<(f64, Number, usize)>,
    /// The farthest depth in each tile.
    pub(crate) farthest: Vec<f32>,
}

/// What eight neighbouring pixels show.
#[derive(Clone, Copy, Debug, Default)]
pub struct Numbers {
    /// Their triangles. A pixel of the background has the number of one of the others.
    pub all: [Number; 8],
    /// Bit k is set where pixel k shows a triangle.
    pub is_there: u8,
    /// Whether all that show a triangle show the same.
    pub are_same: bool,
    /// The least number.
    pub least: Number,
    /// The greatest number.
    pub greatest: Number,
}

/// How many columns may stand over.
const OVERHANG: usize = 4;

impl Band {
    /// Draws band `b`: for each pixel the nearest triangle, and of equally near ones the first (L16).
    ///
    /// The same triangles and the same depths, bit for bit, as [`crate::rasterize()`] and [`crate::DepthBuffer`] find.
    ///
    /// - `parts`: those of [`Projected::project`].
    ///
    /// # Panics
    /// If there is no such band, or if `parts` are others.
    pub fn draw(&mut self, b: u32, projected: &Projected, parts: &[MeshInstance]) {
        self.clear(b, projected.size);
        dispatch!(Level::new(), simd => self.draw_large(simd, b, projected, parts));
        dispatch!(Level::new(), simd => self.draw_small(simd, b, projected, parts));
        for chunk in projected.chunks_in(b) {
            chunk.pieces.iter().for_each(|piece| self.draw_piece(piece));
        }
    }

    /// The rows of the screen in the band, from the top.
    #[must_use]
    pub fn rows(&self) -> Range<u32> {
        self.rows.clone()
    }

    /// What a row shows, column by column: the number of a triangle, or [`NONE`], and the depth, canonical z or −∞. Rows from
    /// the top.
    ///
    /// # Panics
    /// If the row lies outside the band.
    pub fn row(&self, row: u32) -> impl Iterator<Item = (Number, f32)> {
        assert!(self.rows.contains(&row), "row {row} is not one of {:?}", self.rows);
        let start = self.pixel(0, row);
        let pixels = self.numbers[start..].iter().zip(&self.depths[start..]);
        pixels.step_by(2).take(self.width as usize).map(|(number, z)| (*number as Number, *z))
    }

    /// Puts into `eight` what eight pixels of a row show, from column `first` on. Beyond the last column it is nothing.
    ///
    /// # Panics
    /// If the first pixel does not lie in the band.
    #[inline(always)]
    pub fn eight<S: Simd>(&self, simd: S, row: u32, first: u32, eight: &mut Numbers) {
        let start = self.pixel(first, row);
        let all = match self.numbers[start..].first_chunk::<16>() {
            Some(sixteen) => {
                let (low, high) = sixteen.split_at(8);
                i32x8::from_slice(simd, low).unzip_low(i32x8::from_slice(simd, high))
            }
            None => {
                // The band ends before.
                let mut all = [NONE as i32; 8];
                for (to, from) in all.iter_mut().zip(self.numbers[start..].iter().step_by(2)) {
                    *to = *from;
                }
                i32x8::load_array(simd, all)
            }
        };
        let columns = (1_u64 << (self.width - first).min(8)) - 1;
        let is_there = all.simd_ne(NONE as i32).to_bitmask() & columns;
        let some = all[is_there.trailing_zeros().min(7) as usize];
        let is_same = all.simd_eq(some).to_bitmask() & is_there == is_there;
        let is_there_mask = mask32x8::from_bitmask(simd, is_there);
        let all = is_there_mask.select(all, i32x8::splat(simd, some));
        let numbers: u32x8<S> = all.bitcast();
        numbers.store_array(&mut eight.all);
        eight.is_there = is_there as u8;
        eight.are_same = is_same;
        eight.least = all.reduce_min() as Number;
        eight.greatest = all.reduce_max() as Number;
    }

    /// The place of a pixel in memory.
    #[inline(always)]
    pub(crate) fn pixel(&self, i: u32, row: u32) -> usize {
        let row = row - self.rows.start;
        2 * ((row / 2) as usize * self.stride + i as usize) + (row % 2) as usize
    }

    fn clear(&mut self, b: u32, (width, height): (u32, u32)) {
        self.rows = b * BAND_ROWS..height.min((b + 1) * BAND_ROWS);
        (self.width, self.height) = (width, height);
        self.stride = width as usize + OVERHANG;
        let pixels = 2 * self.stride * self.rows.len().div_ceil(2);
        self.depths.clear();
        self.depths.resize(pixels, f32::NEG_INFINITY);
        self.numbers.clear();
        self.numbers.resize(pixels, NONE as i32);
        self.farthest.clear();
        self.farthest.resize(self.width.div_ceil(TILE) as usize, f32::NEG_INFINITY);
    }

    /// Large triangles, the nearest first: most of what lies behind them is then never asked pixel by pixel.
    #[inline(always)]
    fn draw_large<S: Simd>(&mut self, simd: S, b: u32, projected: &Projected, parts: &[MeshInstance]) {
        let mut large = std::mem::take(&mut self.large);
        large.clear();
        for chunk in projected.chunks_in(b) {
            let first = projected.first_number(chunk.part);
            for &number in chunk.large(b) {
                let corners =
                    projected.corners(chunk.part, parts[chunk.part].mesh, (number - first) as usize);
                let edges = Edges::new(corners);
                if edges.is_wider_than(TILE) {
                    large.push((edges.nearest_corner(), number, chunk.part));
                } else {
                    self.draw_in_blocks(simd, number, &edges);
                }
            }
        }
        large.sort_unstable_by(|a, b| b.0.total_cmp(&a.0).then(a.1.cmp(&b.1)));
        for &(_, number, part) in &large {
            let k = (number - projected.first_number(part)) as usize;
            let edges = Edges::new(projected.corners(part, parts[part].mesh, k));
            self.draw_in_tiles(simd, number, &edges);
        }
        self.large = large;
    }

    #[inline(always)]
    fn draw_small<S: Simd>(&mut self, simd: S, b: u32, projected: &Projected, parts: &[MeshInstance]) {
        for chunk in projected.chunks_in(b) {
            let first = projected.first_number(chunk.part);
            let triangles = parts[chunk.part].mesh.triangles();
            let (vertices, rests) = (projected.vertices_of(chunk.part), projected.rests_of(chunk.part));
            for eight in chunk.small(b).chunks(8) {
                // The last stands in for those that are missing: drawn twice, it changes nothing.
                let mut numbers = [eight[eight.len() - 1]; 8];
                numbers[..eight.len()].copy_from_slice(eight);
                let mut corners = Corners::default();
                for (corners, number) in corners.each.iter_mut().zip(&numbers) {
                    *corners = triangles[(number - first) as usize];
                }
                self.draw_eight(simd, &numbers, (vertices, rests), &corners);
            }
        }
    }

    /// What clipping left of a triangle goes the slide's way.
    fn draw_piece(&mut self, piece: &Piece) {
        let j = self.height - self.rows.end..self.height - self.rows.start;
        let (width, height, number) = (self.width, self.height, piece.number as i32);
        crate::rasterize_rows(&piece.on_screen, width, j, |fragment| {
            let pixel = self.pixel(fragment.i, height - 1 - fragment.j);
            self.test_one(pixel, number, fragment.z as f32);
        });
    }

    /// The depth test for one pixel; of equals the lower number stays, in whatever order they come.
    #[inline(always)]
    pub(crate) fn test_one(&mut self, pixel: usize, number: i32, z: f32) {
        let known = &mut self.depths[pixel];
        if z > *known || z == *known && number < self.numbers[pixel] {
            *known = z;
            self.numbers[pixel] = number;
        }
    }
}
