//! Which triangles can have pixels in which rows of the screen? Most small ones have none at all.

use std::ops::Range;

use fearless_simd::prelude::*;
use fearless_simd::{Level, Simd, dispatch, f32x8};
use glam::DVec4;

use crate::fast::eight::{Corners, Eight, centers, is_small};
use crate::fast::projected::{Faces, MeshInstance, Number};
use crate::fast::vertices::{ToScreen, Vertex};
use crate::screen::ScreenTriangle;

/// How many rows a thread draws at a time: few, so that their depths stay near the processor, and that they share out evenly.
pub const BAND_ROWS: u32 = 16;

/// Some neighbouring triangles of a part: those that may have pixels, by bands.
#[derive(Debug, Default)]
pub(crate) struct Chunk {
    /// Which part they belong to.
    pub(crate) part: usize,
    /// The first band that any of them reaches, and how many from there on; a picture of many small objects has many chunks, each in few.
    first_band: u32,
    band_count: u32,
    kept: Vec<Kept>,
    /// `numbers[starts[k]..starts[k + 1]]` are the triangles in bin k: 2b for the small ones of band first_band + b, 2b + 1 for the others.
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
    is_large: bool,
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
    pub(crate) part: &'a MeshInstance<'a>,
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
    /// The bands that any triangle of the chunk reaches.
    pub(crate) fn bands(&self) -> Range<u32> {
        self.first_band..self.first_band + self.band_count
    }

    /// The small triangles in band `b`.
    pub(crate) fn small(&self, b: u32) -> &[Number] {
        self.bin(2 * b as usize)
    }

    /// The others.
    pub(crate) fn large(&self, b: u32) -> &[Number] {
        self.bin(2 * b as usize + 1)
    }

    fn bin(&self, k: usize) -> &[Number] {
        let k = k - 2 * self.first_band as usize;
        &self.numbers[self.starts[k] as usize..self.starts[k + 1] as usize]
    }

    /// Sorts `triangles`, a range of the part's.
    pub(crate) fn fill(&mut self, sorting: &Sorting, triangles: Range<usize>) {
        self.part = sorting.index;
        self.kept.clear();
        self.pieces.clear();
        dispatch!(Level::new(), simd => self.sort_out(simd, sorting, triangles));
        self.find_bands(sorting.size.1);
        self.fill_bins();
    }

    #[inline(always)]
    fn sort_out<S: Simd>(&mut self, simd: S, sorting: &Sorting, triangles: Range<usize>) {
        let first = sorting.first + triangles.start as u32;
        let triangles = &sorting.part.mesh.triangles()[triangles];
        for (start, eight) in (first..).step_by(8).zip(triangles.chunks(8)) {
            // The last triangle stands in for those that are missing, and is dropped again below.
            let mut corners = Corners { each: [eight[eight.len() - 1]; 8], are_same: false };
            corners.each[..eight.len()].copy_from_slice(eight);
            let present = (1_u64 << eight.len()) - 1;
            self.sort_eight(simd, sorting, start, &corners, present);
        }
    }

    /// Sorts triangles `start`, `start + 1`, …, as far as the bits of `present` say.
    #[inline(always)]
    fn sort_eight<S: Simd>(
        &mut self,
        simd: S,
        sorting: &Sorting,
        start: Number,
        corners: &Corners,
        present: u64,
    ) {
        let eight = Eight::gather(simd, sorting.vertices, corners);
        let (x, y) = (eight.extent(0), eight.extent(1));
        let columns = centers(simd, x, sorting.size.0);
        let rows = centers(simd, y, sorting.size.1);
        let has_center = columns[0].simd_le(columns[1]) & rows[0].simd_le(rows[1]);
        let (area, zero) = (eight.doubled_area(), f32x8::splat(simd, 0.0));
        let shows = match (sorting.faces, sorting.is_mirrored) {
            (Faces::Both, _) => area.simd_ne(zero),
            (Faces::Front, false) => area.simd_gt(zero),
            (Faces::Front, true) => area.simd_lt(zero),
        };
        let is_small = is_small(simd, x, y);
        let outside = eight.is_outside().to_bitmask() & present;
        let certain = (has_center & is_small & shows).to_bitmask() & present & !outside;
        let large = (has_center & !is_small).to_bitmask() & present & !outside;
        let (top, bottom) = (rows[1].to_array(), rows[0].to_array());
        let mut left = certain | large | outside;
        while left != 0 {
            let k = left.trailing_zeros() as usize;
            left &= left - 1;
            let number = start + k as u32;
            if outside >> k & 1 == 1 {
                self.clip(sorting, number, &corners.each[k]);
            } else if certain >> k & 1 == 1
                || sorting.shows(doubled_area_of(sorting.vertices, &corners.each[k]))
            {
                let band = |j: f32| ((sorting.size.1 - 1 - j as u32) / BAND_ROWS) as u16;
                let is_large = large >> k & 1 == 1;
                self.kept.push(Kept {
                    number,
                    first_band: band(top[k]),
                    last_band: band(bottom[k]),
                    is_large,
                });
            }
        }
    }

    /// A triangle that crosses the border of the clipped volume, or lies outside.
    #[cold]
    fn clip(&mut self, sorting: &Sorting, number: Number, corners: &[u32; 3]) {
        let to_screen = &sorting.to_screen;
        let positions = sorting.part.mesh.positions();
        let clip_from_world = to_screen.clip_from_world.as_dmat4();
        let clip = corners.map(|index| {
            let p_world = to_screen.world_from_object.transform_point3(positions[index as usize]);
            clip_from_world * p_world.as_dvec3().extend(1.0)
        });
        if is_beside(&clip) {
            return;
        }
        let pieces = crate::project_clip(clip, sorting.size.0, sorting.size.1).triangles();
        let pieces = pieces.filter(|on_screen| sorting.shows(on_screen.doubled_area() as f64));
        self.pieces.extend(pieces.map(|on_screen| Piece { number, on_screen }));
    }

    /// Finds the bands that any triangle reaches.
    fn find_bands(&mut self, height: u32) {
        let kept = self.kept.iter().map(|kept| (u32::from(kept.first_band), u32::from(kept.last_band)));
        let pieces = self.pieces.iter().filter_map(|piece| piece.bands(height));
        let whole = kept.chain(pieces).reduce(|a, b| (a.0.min(b.0), a.1.max(b.1)));
        let (first, count) = whole.map_or((0, 0), |(first, last)| (first, last + 1 - first));
        (self.first_band, self.band_count) = (first, count);
    }

    /// Counts the triangles of each bin, then puts each into its place: twice over the list, without a list a bin.
    fn fill_bins(&mut self) {
        let bins = 2 * self.band_count as usize;
        self.starts.clear();
        self.starts.resize(bins + 1, 0);
        for bin in self.kept.iter().flat_map(|kept| kept.bins(self.first_band)) {
            self.starts[bin + 1] += 1;
        }
        for bin in 0..bins {
            self.starts[bin + 1] += self.starts[bin];
        }
        self.numbers.clear();
        self.numbers.resize(self.starts[bins] as usize, 0);
        for kept in &self.kept {
            for bin in kept.bins(self.first_band) {
                self.numbers[self.starts[bin] as usize] = kept.number;
                self.starts[bin] += 1;
            }
        }
        // Each start has moved to its end, which is the next one's start.
        self.starts.rotate_right(1);
        self.starts[0] = 0;
    }
}

impl Piece {
    /// The first and the last band that it may reach, from the top; `None` if it lies above or below the screen.
    fn bands(&self, height: u32) -> Option<(u32, u32)> {
        let [a, b, c] = self.on_screen.vertices.map(|vertex| vertex.position.y);
        // Snapping moves a vertex by less than a pixel.
        let (lowest, highest) = (a.min(b).min(c) - 1.0, a.max(b).max(c) + 1.0);
        let top = f64::from(height) - 1.0;
        let band = |j: f64| (top - j.clamp(0.0, top)) as u32 / BAND_ROWS;
        (lowest <= top && highest >= 0.0).then(|| (band(highest), band(lowest)))
    }
}

impl Kept {
    /// Its bins in a chunk that begins with band `first`.
    fn bins(&self, first: u32) -> impl Iterator<Item = usize> + use<> {
        let (is_large, first) = (usize::from(self.is_large), first as usize);
        (self.first_band..=self.last_band).map(move |band| 2 * (usize::from(band) - first) + is_large)
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
    let ([ax, ay], [bx, by], [cx, cy]) = (place(a), place(b), place(c));
    (bx - ax) * (cy - ay) - (by - ay) * (cx - ax)
}

fn doubled_area_of(vertices: &[Vertex], corners: &[u32; 3]) -> f64 {
    let [a, b, c] = corners.map(|index| &vertices[index as usize]);
    doubled_area(a, b, c)
}

/// x and y, in f64.
#[inline(always)]
pub(crate) fn place(vertex: &Vertex) -> [f64; 2] {
    [f64::from(vertex[0]), f64::from(vertex[1])]
}

/// Whether all corners lie beyond the same side of what is seen, so that nothing can be left.
fn is_beside(clip: &[DVec4; 3]) -> bool {
    let all = |test: fn(&DVec4) -> bool| clip.iter().all(test);
    // Visible points have w < 0 and |x|, |y|, |z| ≤ −w; the pixels reach half a pixel less far than that. Before the near
    // plane is z < w, beyond the far one −z < w.
    all(|p| p.z < p.w)
        || all(|p| -p.z < p.w)
        || all(|p| p.x > -p.w && p.w < 0.0)
        || all(|p| -p.x > -p.w && p.w < 0.0)
        || all(|p| p.y > -p.w && p.w < 0.0)
        || all(|p| -p.y > -p.w && p.w < 0.0)
}
