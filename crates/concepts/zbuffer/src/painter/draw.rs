//! How does a plan become a picture? Piece after piece, each over what is there.

use super::piece::Piece;
use super::plan::Plan;
use crate::rasterize::rasterize_rows;
use crate::screen::{Fragment, ScreenTriangle};

/// Calls `draw` for every pixel of every piece on a screen of `width` × `height` pixels, from back to front: the last
/// fragment of a pixel is its nearest.
///
/// `triangles` are those that the plan was made for; `draw` gets the triangle's index too. Every fragment of every
/// triangle comes exactly once.
///
/// ```
/// use glam::{Vec3, vec3};
/// use zbuffer::painter;
/// # use geometry::Barycentric;
/// # use zbuffer::{ScreenTriangle, ScreenVertex};
/// # let triangle = |corners: [Vec3; 3]| ScreenTriangle {
/// #     vertices: corners.map(|position| ScreenVertex { position: position.as_dvec3(), inv_w: -1.0, weights: Barycentric::A }),
/// # };
/// // A ramp that passes through a wall at x = 4.
/// let ramp = triangle([vec3(0.0, -1.0, 0.4), vec3(8.0, -1.0, -0.4), vec3(0.0, 9.0, 0.4)]);
/// let wall = triangle([vec3(-1.0, 1.0, 0.0), vec3(9.0, 1.0, 0.0), vec3(4.0, 4.0, 0.0)]);
/// let triangles = [ramp, wall];
/// let plan = painter::plan(&triangles);
/// assert!(plan.cycles[0].is_piercing());
///
/// let mut row = [None; 8];
/// painter::for_each_fragment(&plan, &triangles, 8, 8, |triangle, fragment| {
///     if fragment.j == 2 {
///         row[fragment.i as usize] = Some(triangle);
///     }
/// });
/// assert_eq!(row, [0, 0, 0, 0, 1, 1, 1, 1].map(Some));
/// ```
///
/// # Panics
/// If a piece is of a triangle that is not there, and as [`rasterize`](crate::rasterize()).
pub fn for_each_fragment(
    plan: &Plan,
    triangles: &[ScreenTriangle],
    width: u32,
    height: u32,
    mut draw: impl FnMut(usize, Fragment),
) {
    for piece in &plan.pieces {
        let triangle = &triangles[piece.triangle];
        for_each_pixel(piece, triangle, width, height, |fragment| draw(piece.triangle, fragment));
    }
}

/// The fragments of one piece. A cut one is drawn row by row, as it often has few of its triangle's pixels.
fn for_each_pixel(
    piece: &Piece,
    triangle: &ScreenTriangle,
    width: u32,
    height: u32,
    mut draw: impl FnMut(Fragment),
) {
    let Some((columns, rows)) = piece.box_to_search() else {
        return rasterize_rows(triangle, width, 0..height, draw);
    };
    for j in rows.filter(|j| (0..i64::from(height)).contains(j)) {
        let span = piece.span(columns.clone(), j);
        if !span.is_empty() {
            let j = j as u32;
            rasterize_rows(triangle, width, j..j + 1, |fragment| {
                if span.contains(&i64::from(fragment.i)) && piece.covers(fragment.i, fragment.j) {
                    draw(fragment);
                }
            });
        }
    }
}
