//! Where on the screen is each vertex of a mesh? Eight at a time, and each only once however many triangles share it.

use fearless_simd::prelude::*;
use fearless_simd::{Level, Simd, dispatch, f32x8, f64x4};
use glam::{DVec2, Mat4, Vec3};

use crate::clip::{GUARD_BAND, Viewport};
use crate::fast::eight::{load_columns, store_columns};
use crate::screen::SUBPIXELS;

/// A vertex on the screen: x and y in 1/256 pixels, whole numbers; canonical z; 1/w. Four numbers side by side are loaded
/// at once.
///
/// x is NaN if a triangle with this vertex has to be clipped, or is not there at all.
pub(crate) type Vertex = [f32; 4];

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
        let way = Way::new(simd, self);
        for (positions, vertices) in positions.chunks(8).zip(vertices.chunks_mut(8)) {
            store_columns(way.eight(simd, load_columns(simd, positions)), vertices);
        }
    }
}

/// The same, spread out over the lanes.
struct Way<S: Simd> {
    /// Rows of the matrices, each entry eight times.
    world_from_object: [[f32x8<S>; 4]; 3],
    clip_from_world: [[f32x8<S>; 4]; 4],
    guard: [f64x4<S>; 2],
    half_size: [f64x4<S>; 2],
    center: [f64x4<S>; 2],
}

impl<S: Simd> Way<S> {
    #[inline(always)]
    fn new(simd: S, to_screen: &ToScreen) -> Self {
        let m = to_screen.world_from_object.transpose().to_cols_array_2d();
        let n = to_screen.clip_from_world.transpose().to_cols_array_2d();
        let (guard, viewport) = (to_screen.viewport.guard(), &to_screen.viewport);
        let pair = |v: DVec2| [f64x4::splat(simd, v.x), f64x4::splat(simd, v.y)];
        Self {
            world_from_object: [row(simd, m[0]), row(simd, m[1]), row(simd, m[2])],
            clip_from_world: [row(simd, n[0]), row(simd, n[1]), row(simd, n[2]), row(simd, n[3])],
            guard: pair(-guard),
            half_size: pair(viewport.half_size),
            center: pair(viewport.center),
        }
    }

    /// x, y, z, 1/w of eight vertices.
    #[inline(always)]
    fn eight(&self, simd: S, object: [f32x8<S>; 3]) -> [f32x8<S>; 4] {
        let splat = |c: f32| f32x8::splat(simd, c);
        let world = three!(k => map_affine(&self.world_from_object[k], &object));
        let m = &self.clip_from_world;
        let (x, y) = (map(&m[0], &world).widen(), map(&m[1], &world).widen());
        let (z, w) = (map(&m[2], &world).widen(), map(&m[3], &world).widen());
        let low = self.four(simd, [x.0, y.0, z.0, w.0]);
        let high = self.four(simd, [x.1, y.1, z.1, w.1]);
        let [x, y] = [low[0].narrow(high[0]), low[1].narrow(high[1])];
        let [z, inv_w, inside] = [low[2].narrow(high[2]), low[3].narrow(high[3]), low[4].narrow(high[4])];
        // What f32 makes of 1/w counts: a vertex very near the eye has none.
        let is_there =
            inside.simd_gt(splat(0.0)) & inv_w.simd_lt(splat(0.0)) & inv_w.simd_gt(splat(f32::NEG_INFINITY));
        [is_there.select(snap(simd, x), splat(f32::NAN)), snap(simd, y), z, inv_w]
    }

    /// x and y in pixels, z, 1/w, and 1 or 0 for inside or not, of four vertices in clip space. In f64, as clipping does.
    #[inline(always)]
    fn four(&self, simd: S, [x, y, z, w]: [f64x4<S>; 4]) -> [f64x4<S>; 5] {
        let (zero, one) = (f64x4::splat(simd, 0.0), f64x4::splat(simd, 1.0));
        let (w_x, w_y) = (w * self.guard[0], w * self.guard[1]);
        let inside = (z - w).simd_ge(zero)
            & (zero - z - w).simd_ge(zero)
            & (x + w_x).simd_ge(zero)
            & (w_x - x).simd_ge(zero)
            & (y + w_y).simd_ge(zero)
            & (w_y - y).simd_ge(zero);
        let inv_w = one / w;
        let band = f64x4::splat(simd, GUARD_BAND);
        let x = self.half_size[0] * (x * inv_w) + self.center[0];
        let y = self.half_size[1] * (y * inv_w) + self.center[1];
        let z = (z * inv_w).max(zero - one).min(one);
        let within = |pixel: f64x4<S>| pixel.max(zero - band).min(band);
        [within(x), within(y), z, inv_w, inside.select(one, zero)]
    }
}

#[inline(always)]
fn row<S: Simd>(simd: S, entries: [f32; 4]) -> [f32x8<S>; 4] {
    let [x, y, z, w] = entries;
    [f32x8::splat(simd, x), f32x8::splat(simd, y), f32x8::splat(simd, z), f32x8::splat(simd, w)]
}

/// A row of an affine matrix times (x, y, z, 1), added in the order in which glam adds: so each vertex is rounded as if it were alone.
#[inline(always)]
fn map_affine<S: Simd>(row: &[f32x8<S>; 4], [x, y, z]: &[f32x8<S>; 3]) -> f32x8<S> {
    row[3] + (row[2] * *z + (row[1] * *y + row[0] * *x))
}

/// A row of any matrix times (x, y, z, 1), again in glam's order.
#[inline(always)]
fn map<S: Simd>(row: &[f32x8<S>; 4], [x, y, z]: &[f32x8<S>; 3]) -> f32x8<S> {
    ((row[0] * *x + row[1] * *y) + row[2] * *z) + row[3]
}

/// Snapped to 1/256 pixel: up to 2²⁴, so that f32 holds the whole number.
#[inline(always)]
fn snap<S: Simd>(simd: S, pixel: f32x8<S>) -> f32x8<S> {
    // Times a power of two is exact in f32 too; `round` rounds halves away from zero, as f64's own does.
    (pixel * f32x8::splat(simd, SUBPIXELS as f32)).round()
}
