//! Where on the screen is each vertex of a mesh? Eight at a time, and each only once however many triangles share it.

use fearless_simd::prelude::*;
use fearless_simd::{Level, Simd, dispatch, f32x8, f64x4};
use glam::{DVec2, Mat4, Vec3};

use crate::clip::{DEPTH_GRID, GUARD_BAND, PIXEL_GRID, Viewport};
use crate::fast::eight::{load_columns, store_columns};
use crate::screen::SUBPIXELS;

/// A vertex on the screen: x and y in 1/256 pixels, whole numbers up to 2²⁴, which f32 holds; canonical z; 1/w. Four numbers side by side are loaded
/// at once.
///
/// x is NaN if a triangle with this vertex has to be clipped, or is not there at all.
pub(crate) type Vertex = [f32; 4];

/// What rounding left over in a [`Vertex`]: how far it was projected to the right of and above its snapped place, in 1/256 pixels, and how
/// much nearer. Each is exact: projecting rounds to a grid for which the bits of both numbers together are enough.
pub(crate) type Rest = [f32; 4];

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
    pub(crate) fn vertices(&self, positions: &[Vec3], vertices: &mut [Vertex], rests: &mut [Rest]) {
        dispatch!(Level::new(), simd => self.all(simd, positions, vertices, rests));
    }

    #[inline(always)]
    fn all<S: Simd>(&self, simd: S, positions: &[Vec3], vertices: &mut [Vertex], rests: &mut [Rest]) {
        let way = Way::new(simd, self);
        let to = vertices.chunks_mut(8).zip(rests.chunks_mut(8));
        for (positions, (vertices, rests)) in positions.chunks(8).zip(to) {
            let (columns, left_over) = way.eight(simd, load_columns(simd, positions));
            store_columns(columns, vertices);
            store_columns(left_over, rests);
        }
    }
}

/// The same, spread out over the lanes.
struct Way<S: Simd> {
    /// Rows of the matrices, each entry eight times.
    world_from_object: [[f32x8<S>; 4]; 3],
    clip_from_world: [[f64x4<S>; 4]; 4],
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
            clip_from_world: [wide(simd, n[0]), wide(simd, n[1]), wide(simd, n[2]), wide(simd, n[3])],
            guard: pair(-guard),
            half_size: pair(viewport.half_size),
            center: pair(viewport.center),
        }
    }

    /// x, y, z, 1/w of eight vertices, and what rounding leaves over.
    #[inline(always)]
    fn eight(&self, simd: S, object: [f32x8<S>; 3]) -> ([f32x8<S>; 4], [f32x8<S>; 4]) {
        let splat = |c: f32| f32x8::splat(simd, c);
        let world = three!(k => map_affine(&self.world_from_object[k], &object).widen());
        let low = self.four(simd, three!(k => world[k].0));
        let high = self.four(simd, three!(k => world[k].1));
        let (x, y) = ((low[0].round(), high[0].round()), (low[1].round(), high[1].round()));
        let [z, inv_w, inside] = [low[2].narrow(high[2]), low[3].narrow(high[3]), low[4].narrow(high[4])];
        let wide_z = z.widen();
        let rests = [
            (low[0] - x.0).narrow(high[0] - x.1),
            (low[1] - y.0).narrow(high[1] - y.1),
            (low[2] - wide_z.0).narrow(high[2] - wide_z.1),
            splat(0.0),
        ];
        // What f32 makes of 1/w counts: a vertex very near the eye has none.
        let is_there =
            inside.simd_gt(splat(0.0)) & inv_w.simd_lt(splat(0.0)) & inv_w.simd_gt(splat(f32::NEG_INFINITY));
        ([is_there.select(x.0.narrow(x.1), splat(f32::NAN)), y.0.narrow(y.1), z, inv_w], rests)
    }

    /// x and y in 1/256 pixels, z, 1/w, and 1 or 0 for inside or not, of four vertices of the world. In f64, as clipping does.
    #[inline(always)]
    fn four(&self, simd: S, world: [f64x4<S>; 3]) -> [f64x4<S>; 5] {
        let m = &self.clip_from_world;
        let [x, y, z, w] = [map(&m[0], &world), map(&m[1], &world), map(&m[2], &world), map(&m[3], &world)];
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
        // Pixels become 1/256 pixels by a power of two: exact.
        let placed = |pixel: f64x4<S>| (within(pixel) + PIXEL_GRID - PIXEL_GRID) * SUBPIXELS as f64;
        [placed(x), placed(y), z + DEPTH_GRID - DEPTH_GRID, inv_w, inside.select(one, zero)]
    }
}

#[inline(always)]
fn row<S: Simd>(simd: S, entries: [f32; 4]) -> [f32x8<S>; 4] {
    let [x, y, z, w] = entries;
    [f32x8::splat(simd, x), f32x8::splat(simd, y), f32x8::splat(simd, z), f32x8::splat(simd, w)]
}

#[inline(always)]
fn wide<S: Simd>(simd: S, entries: [f32; 4]) -> [f64x4<S>; 4] {
    let [x, y, z, w] = entries.map(|entry| f64x4::splat(simd, f64::from(entry)));
    [x, y, z, w]
}

/// A row of an affine matrix times (x, y, z, 1), added in the order in which glam adds: so each vertex is rounded as if it were alone.
#[inline(always)]
fn map_affine<S: Simd>(row: &[f32x8<S>; 4], [x, y, z]: &[f32x8<S>; 3]) -> f32x8<S> {
    row[3] + (row[2] * *z + (row[1] * *y + row[0] * *x))
}

/// A row of any matrix times (x, y, z, 1), again in glam's order.
#[inline(always)]
fn map<S: Simd>(row: &[f64x4<S>; 4], [x, y, z]: &[f64x4<S>; 3]) -> f64x4<S> {
    ((row[0] * *x + row[1] * *y) + row[2] * *z) + row[3]
}
