//! Which triangles can have pixels in which rows of the screen? Most small ones have none at all.

use std::ops::Range;

use fearless_simd::prelude::*;
use fearless_simd::{Level, Simd, dispatch, f32x4};
use glam::Vec4;

use crate::fast::projected::{Faces, Number, Part};
use crate::fast::vertices::{ToScreen, Vertex, is_outside};
use crate::screen::{SUBPIXELS, ScreenTriangle};

/// How many rows a thread draws at a time: few, so that their depths stay near the processor, and that they share out evenly.
pub const BAND_ROWS: u32 = 16;

/// Some neighbouring triangles of a part: those that may have pixels, by bands.
#[derive(Debug, Default)]
pub(crate) struct Chunk {
    /// Which part they belong to.
    pub(crate) part: usize,
    kept: Vec<Kept>,
    /// `numbers[starts[b]..starts[b + 1]]` are the triangles in band b.
    starts: Vec<u32>,
    numbers: Vec<Number>,
    /// What clipping left of those that had to be clipped.
    pub(crate) pieces: Vec<Piece>,
}

/// A triangle that may have pixels in some bands, counted from the top.
#[derive(Clone, Copy, Debug)]
struct Kept {
    number: Number,
    first_band: u16,
    last_band: u16,
}

/// A part of a clipped triangle.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Piece {
    pub(crate) number: Number,
    pub(crate) on_screen: ScreenTriangle,
}

/// What chunks of one part have in common.
#[derive(Clone, Copy)]
pub(crate) struct Sorting<'a> {
    pub(crate) index: usize,
    pub(crate) part: &'a Part<'a>,
    /// The part's own vertices.
    pub(crate) vertices: &'a [Vertex],
    pub(crate) to_screen: ToScreen,
    pub(crate) size: (u32, u32),
    pub(crate) faces: Faces,
    /// Whether anticlockwise on the screen is a back: the map mirrors.
    pub(crate) is_mirrored: bool,
    /// The number of the part's first triangle.
    pub(crate) first: Number,
}

impl Chunk {
    /// The triangles in band `b`, in drawing order.
    pub(crate) fn in_band(&self, b: u32) -> &[Number] {
        let (start, end) = (self.starts[b as usize], self.starts[b as usize + 1]);
        &self.numbers[start as usize..end as usize]
    }

    /// Sorts `triangles`, a range of the part's.
    pub(crate) fn fill(&mut self, sorting: &Sorting, triangles: Range<usize>) {
        self.part = sorting.index;
        self.kept.clear();
        self.pieces.clear();
        dispatch!(Level::new(), simd => self.sort_out(simd, sorting, triangles));
        self.by_bands(sorting.size.1.div_ceil(BAND_ROWS));
    }

    #[inline(always)]
    fn sort_out<S: Simd>(&mut self, simd: S, sorting: &Sorting, triangles: Range<usize>) {
        let limits = Limits::new(simd, sorting.size);
        let first = sorting.first + triangles.start as u32;
        for (number, corners) in (first..).zip(&sorting.part.mesh.triangles()[triangles]) {
            let [a, b, c] = corners.map(|index| &sorting.vertices[index as usize]);
            if is_outside(a) || is_outside(b) || is_outside(c) {
                self.clip(sorting, number, corners);
            } else if sorting.shows(doubled_area(a, b, c))
                && let Some((top, bottom)) = limits.rows(simd, a, b, c)
            {
                let band = |row: u32| (row / BAND_ROWS) as u16;
                self.kept.push(Kept { number, first_band: band(top), last_band: band(bottom) });
            }
        }
    }

    /// A triangle that crosses the border of the clipped volume, or lies outside.
    #[cold]
    fn clip(&mut self, sorting: &Sorting, number: Number, corners: &[u32; 3]) {
        let to_screen = &sorting.to_screen;
        let positions = sorting.part.mesh.positions();
        let clip = corners.map(|index| {
            let p_world = to_screen.world_from_object.transform_point3(positions[index as usize]);
            to_screen.clip_from_world * p_world.extend(1.0)
        });
        if is_beside(&clip) {
            return;
        }
        let pieces = crate::project_clip(clip, sorting.size.0, sorting.size.1).triangles();
        let pieces = pieces.filter(|on_screen| sorting.shows(on_screen.doubled_area() as f64));
        self.pieces.extend(pieces.map(|on_screen| Piece { number, on_screen }));
    }

    /// Counts the triangles of each band, then puts each into its place: twice over the list, without a list a band.
    fn by_bands(&mut self, bands: u32) {
        self.starts.clear();
        self.starts.resize(bands as usize + 1, 0);
        for kept in &self.kept {
            for band in kept.first_band..=kept.last_band {
                self.starts[usize::from(band) + 1] += 1;
            }
        }
        for band in 0..bands as usize {
            self.starts[band + 1] += self.starts[band];
        }
        self.numbers.clear();
        self.numbers.resize(self.starts[bands as usize] as usize, 0);
        for kept in &self.kept {
            for band in kept.first_band..=kept.last_band {
                let place = &mut self.starts[usize::from(band)];
                self.numbers[*place as usize] = kept.number;
                *place += 1;
            }
        }
        // Each start has moved to its end, which is the next one's start.
        self.starts.rotate_right(1);
        self.starts[0] = 0;
    }
}

impl Sorting<'_> {
    /// Whether a triangle of this signed area on the screen is drawn.
    #[inline(always)]
    fn shows(&self, doubled_area: f64) -> bool {
        match self.faces {
            Faces::Both => doubled_area != 0.0,
            Faces::Front => (doubled_area > 0.0) != self.is_mirrored && doubled_area != 0.0,
        }
    }
}

/// Twice the signed area in 1/256 pixels: exact, since products of differences stay below 2⁵².
#[inline(always)]
pub(crate) fn doubled_area(a: &Vertex, b: &Vertex, c: &Vertex) -> f64 {
    let [ax, ay, bx, by, cx, cy] = [a[0], a[1], b[0], b[1], c[0], c[1]].map(f64::from);
    (bx - ax) * (cy - ay) - (by - ay) * (cx - ax)
}

/// Whether all corners lie beyond the same side of what is seen, so that nothing can be left.
fn is_beside(clip: &[Vec4; 3]) -> bool {
    let all = |test: fn(&Vec4) -> bool| clip.iter().all(test);
    // Visible points have w < 0 and |x|, |y|, |z| ≤ −w; the pixels reach half a pixel less far than that. Before the near
    // plane is z < w, beyond the far one −z < w.
    all(|p| p.z < p.w)
        || all(|p| -p.z < p.w)
        || all(|p| p.x > -p.w && p.w < 0.0)
        || all(|p| -p.x > -p.w && p.w < 0.0)
        || all(|p| p.y > -p.w && p.w < 0.0)
        || all(|p| -p.y > -p.w && p.w < 0.0)
}

/// The screen as the sorting sees it.
struct Limits<S: Simd> {
    least: f32x4<S>,
    greatest: f32x4<S>,
    highest_row: u32,
}

impl<S: Simd> Limits<S> {
    #[inline(always)]
    fn new(simd: S, (width, height): (u32, u32)) -> Self {
        let greatest = [width as f32 - 1.0, height as f32 - 1.0, f32::INFINITY, f32::INFINITY];
        let least = [0.0, 0.0, f32::NEG_INFINITY, f32::NEG_INFINITY];
        Self {
            least: f32x4::load_array(simd, least),
            greatest: f32x4::load_array(simd, greatest),
            highest_row: height - 1,
        }
    }

    /// The first and the last row, from the top, with pixel centres in the triangle's box; `None` if there is no centre on
    /// the screen.
    #[inline(always)]
    fn rows(&self, simd: S, a: &Vertex, b: &Vertex, c: &Vertex) -> Option<(u32, u32)> {
        let [a, b, c] = [a, b, c].map(|v| f32x4::load_array_ref(simd, v));
        let in_pixels = f32x4::splat(simd, 1.0 / SUBPIXELS as f32);
        let first = (a.min(b).min(c) * in_pixels).ceil().max(self.least);
        let last = (a.max(b).max(c) * in_pixels).floor().min(self.greatest);
        // Lanes 0 and 1 are x and y.
        if first.simd_gt(last).to_bitmask() & 0b11 != 0 {
            return None;
        }
        Some((self.highest_row - last[1] as u32, self.highest_row - first[1] as u32))
    }
}
