//! Where on the screen is each vertex of a mesh? Eight at a time, and each only once however many triangles share it.

use fearless_simd::prelude::*;
use fearless_simd::{Level, Simd, dispatch, f32x4, f32x8, f64x4};
use glam::{Mat4, Vec3};

use crate::clip::{GUARD_BAND, Viewport};
use crate::screen::SUBPIXELS;

/// A vertex on the screen: x and y in 1/256 pixels, whole numbers; canonical z; 1/w. Four numbers side by side are loaded
/// at once.
///
/// x is NaN if a triangle with this vertex has to be clipped, or is not there at all.
pub(crate) type Vertex = [f32; 4];

/// Whether a triangle with this vertex has to go the slide's way, by [`crate::project_clip`].
pub(crate) fn is_outside(vertex: &Vertex) -> bool {
    vertex[0].is_nan()
}

/// The way of a mesh's positions to the screen.
#[derive(Clone, Copy, Debug)]
pub(crate) struct ToScreen {
    pub(crate) world_from_object: Mat4,
    pub(crate) clip_from_world: Mat4,
    pub(crate) viewport: Viewport,
}

impl ToScreen {
    /// Where `positions` (object space) are on the screen: the numbers that [`crate::project`] gives and
    /// [`crate::ScreenVertex::snapped`] rounds, bit for bit.
    pub(crate) fn vertices(&self, positions: &[Vec3], vertices: &mut [Vertex]) {
        dispatch!(Level::new(), simd => self.all(simd, positions, vertices));
    }

    #[inline(always)]
    fn all<S: Simd>(&self, simd: S, positions: &[Vec3], vertices: &mut [Vertex]) {
        for (positions, vertices) in positions.chunks(8).zip(vertices.chunks_mut(8)) {
            let at = |k: usize| positions[k.min(positions.len() - 1)];
            let p: [f32x8<S>; 3] = std::array::from_fn(|axis| f32x8::from_fn(simd, |k| at(k)[axis]));
            let eight = self.eight(simd, p);
            if let Ok(eight_vertices) = <&mut [Vertex; 8]>::try_from(&mut *vertices) {
                store(eight, eight_vertices);
            } else {
                let mut last = [[0.0; 4]; 8];
                store(eight, &mut last);
                vertices.copy_from_slice(&last[..vertices.len()]);
            }
        }
    }

    /// x, y, z, 1/w of eight vertices.
    #[inline(always)]
    fn eight<S: Simd>(&self, simd: S, [x, y, z]: [f32x8<S>; 3]) -> [f32x8<S>; 4] {
        let splat = |c: f32| f32x8::splat(simd, c);
        // Column times coordinate, added in glam's order: so the roundings are those of one vertex alone.
        let m = self.world_from_object.to_cols_array_2d();
        let world: [f32x8<S>; 3] = std::array::from_fn(|row| {
            splat(m[3][row]) + (splat(m[2][row]) * z + (splat(m[1][row]) * y + splat(m[0][row]) * x))
        });
        let m = self.clip_from_world.to_cols_array_2d();
        let [x, y, z] = world;
        let clip: [f32x8<S>; 4] = std::array::from_fn(|row| {
            ((splat(m[0][row]) * x + splat(m[1][row]) * y) + splat(m[2][row]) * z) + splat(m[3][row])
        });
        let halves = clip.map(|column| column.widen());
        let low = self.four(simd, halves.map(|half| half.0));
        let high = self.four(simd, halves.map(|half| half.1));
        let columns: [f32x8<S>; 5] = std::array::from_fn(|k| low[k].narrow(high[k]));
        let [x, y, z, inv_w, inside] = columns;
        let zero = splat(0.0);
        // What f32 makes of 1/w counts: a vertex very near the eye has none.
        let is_there = inside.simd_gt(zero) & inv_w.simd_lt(zero) & inv_w.simd_gt(splat(f32::NEG_INFINITY));
        let snap = |pixel: f32x8<S>| pixel_in_subpixels(simd, pixel);
        [is_there.select(snap(x), splat(f32::NAN)), snap(y), z, inv_w]
    }

    /// x and y in pixels, z, 1/w, and 1 or 0 for inside or not, of four vertices in clip space. In f64, as clipping does.
    #[inline(always)]
    fn four<S: Simd>(&self, simd: S, [x, y, z, w]: [f64x4<S>; 4]) -> [f64x4<S>; 5] {
        let splat = |c: f64| f64x4::splat(simd, c);
        let (guard, zero) = (self.viewport.guard(), splat(0.0));
        let (w_x, w_y) = (w * splat(-guard.x), w * splat(-guard.y));
        let inside = (z - w).simd_ge(zero)
            & (zero - z - w).simd_ge(zero)
            & (x + w_x).simd_ge(zero)
            & (w_x - x).simd_ge(zero)
            & (y + w_y).simd_ge(zero)
            & (w_y - y).simd_ge(zero);
        let inv_w = splat(1.0) / w;
        let pixel = |c: f64x4<S>, half: f64, center: f64| {
            let pixel = splat(half) * (c * inv_w) + splat(center);
            pixel.max(splat(-GUARD_BAND)).min(splat(GUARD_BAND))
        };
        let (half, center) = (self.viewport.half_size, self.viewport.center);
        let z = (z * inv_w).max(splat(-1.0)).min(splat(1.0));
        let is_inside = inside.select(splat(1.0), zero);
        [pixel(x, half.x, center.x), pixel(y, half.y, center.y), z, inv_w, is_inside]
    }
}

/// Snapped to 1/256 pixel: up to 2²⁴, so that f32 holds the whole number.
#[inline(always)]
fn pixel_in_subpixels<S: Simd>(simd: S, pixel: f32x8<S>) -> f32x8<S> {
    // Times a power of two is exact in f32 too; `round` rounds halves away from zero, as f64's own does.
    (pixel * f32x8::splat(simd, SUBPIXELS as f32)).round()
}

/// Columns to vertices.
#[inline(always)]
fn store<S: Simd>(columns: [f32x8<S>; 4], vertices: &mut [Vertex; 8]) {
    let halves = columns.map(|column| column.split());
    let (low, high) = vertices.as_flattened_mut().split_at_mut(16);
    f32x4::store_four_interleaved(halves.map(|half| half.0), low);
    f32x4::store_four_interleaved(halves.map(|half| half.1), high);
}
