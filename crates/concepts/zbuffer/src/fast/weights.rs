//! Where in its triangle is what a pixel shows? For eight pixels of a row at once, whichever triangles they show.

use fearless_simd::prelude::*;
use fearless_simd::{Simd, f32x8, f64x4, mask32x8};

use geometry::{Barycentric, Mesh};
use glam::DVec3;

use crate::fast::eight::{Corners, Eight};
use crate::fast::projected::{Number, Projected};
use crate::fast::vertices::{Rest, Vertex};
use crate::rasterize::Setup;
use crate::screen::{SUBPIXELS, ScreenTriangle, ScreenVertex};

/// α, β and γ of eight pixels, and those of which they are not known.
pub struct Weights<S: Simd> {
    /// α, β, γ, perspective-correct (E9): computed in f64 as [`crate::rasterize()`] does, so that hardly one in ten million differs in its last bit.
    pub columns: [f32x8<S>; 3],
    /// Pixels of triangles that were clipped: for them ask [`Singly`].
    pub is_clipped: mask32x8<S>,
}

impl Projected {
    /// The weights in pixels (i, j), (i + 1, j), … (i + 7, j).
    ///
    /// - `corners`: those of the triangle that each pixel shows, counted through the positions of all parts:
    ///   [`Projected::first_vertex`].
    #[inline(always)]
    pub fn weights<S: Simd>(&self, simd: S, corners: &Corners, i: u32, j: u32) -> Weights<S> {
        let eight = Eight::gather(simd, &self.vertices, corners);
        let x = three!(k => eight.corners[k][0].widen());
        let y = three!(k => eight.corners[k][1].widen());
        let w = three!(k => eight.corners[k][3].widen());
        let (step, first) = (SUBPIXELS as f64, f64::from(i));
        let columns = f64x4::load_array(simd, [first, first + 1.0, first + 2.0, first + 3.0]) * step;
        let row = f64x4::splat(simd, step * f64::from(j));
        let low = four([three!(k => x[k].0), three!(k => y[k].0), three!(k => w[k].0)], columns, row);
        let high =
            four([three!(k => x[k].1), three!(k => y[k].1), three!(k => w[k].1)], columns + 4.0 * step, row);
        Weights { columns: three!(k => low[k].narrow(high[k])), is_clipped: eight.is_outside() }
    }
}

/// The slide's way to the weights of single pixels: the only one where the triangle was clipped.
#[derive(Debug, Default)]
pub struct Singly {
    /// Some triangles that were asked about, and their parts made ready, each at a place that follows from its number: neighbours
    /// mostly ask about the same.
    known: [Option<(Number, Vec<Setup>)>; 8],
}

impl Singly {
    /// The weights in pixel (i, j), which shows triangle `number`, as [`crate::rasterize()`] gives them.
    ///
    /// - `mesh`: that of the triangle's part.
    ///
    /// # Panics
    /// If there is no such triangle, or if `mesh` is not its part's.
    pub fn weights(
        &mut self,
        projected: &Projected,
        mesh: &Mesh,
        number: Number,
        (i, j): (u32, u32),
    ) -> Barycentric {
        let place = &mut self.known[number as usize % 8];
        place.take_if(|(known, _)| *known != number);
        let (_, setups) = place.get_or_insert_with(|| (number, ready(projected, mesh, number)));
        let fragment = setups.iter().find_map(|setup| setup.fragment_at(i, j));
        fragment.map_or(Barycentric::from_beta_gamma(1.0 / 3.0, 1.0 / 3.0), |fragment| fragment.weights)
    }
}

/// What is left of a triangle after clipping, made ready for its pixels.
fn ready(projected: &Projected, mesh: &Mesh, number: Number) -> Vec<Setup> {
    let part = projected.part_of(number);
    let corners = projected.corners(part, mesh, (number - projected.first_number(part)) as usize);
    if corners.iter().any(|(vertex, _)| vertex[0].is_nan()) {
        projected.pieces_of(number).iter().filter_map(|piece| Setup::new(&piece.on_screen)).collect()
    } else {
        Setup::new(&on_screen(corners)).into_iter().collect()
    }
}

/// The triangle as the slide's rasterizer takes it.
fn on_screen([a, b, c]: [(&Vertex, &Rest); 3]) -> ScreenTriangle {
    let vertex = |(vertex, rest): (&Vertex, &Rest), weights: Barycentric| {
        let [x, y, z] = three!(k => f64::from(vertex[k]) + f64::from(rest[k]));
        let pixels = 1.0 / SUBPIXELS as f64;
        ScreenVertex { position: DVec3::new(x * pixels, y * pixels, z), inv_w: vertex[3], weights }
    };
    ScreenTriangle {
        vertices: [vertex(a, Barycentric::A), vertex(b, Barycentric::B), vertex(c, Barycentric::C)],
    }
}

/// The weights in four pixels: each edge function times 1/w of the vertex opposite, over their sum. All terms have one sign:
/// nothing cancels.
#[inline(always)]
fn four<S: Simd>([x, y, w]: [[f64x4<S>; 3]; 3], column: f64x4<S>, row: f64x4<S>) -> [f64x4<S>; 3] {
    let edge =
        |from: usize, to: usize| (x[to] - x[from]) * (row - y[from]) - (y[to] - y[from]) * (column - x[from]);
    let shares = [edge(1, 2) * w[0], edge(2, 0) * w[1], edge(0, 1) * w[2]];
    // One division for three: the last bits of f64 are lost in the rounding to f32.
    let inverse = f64x4::splat(row.token(), 1.0) / (shares[0] + shares[1] + shares[2]);
    [shares[0] * inverse, shares[1] * inverse, shares[2] * inverse]
}
