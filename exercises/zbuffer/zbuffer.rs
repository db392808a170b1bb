//! The z-buffer algorithm (L16).
//!
//! 1. Set every pixel of the rgb-buffer to the background colour and every pixel of the z-buffer to the farthest z.
//! 2. For every polygon, for each of its pixels: if its z is nearer than the stored z, store the new colour and the new z.
//!
//! The polygons are rasterized already: `fragments` holds what each leaves in each of its pixels, those of the first polygon
//! first, then those of the second, and so on. Give both buffers after the last one.
//!
//! - Larger z is nearer, and 0 is the farthest, as in the slide's grids (L17). No z is negative.
//! - A fragment with the same z as the stored one is not nearer: it changes nothing.
//! - Buffers are lists of rows: pixel (i, j) is `rgb[j][i]` and `z[j][i]`, j = 0 … height − 1, i = 0 … width − 1. Row 0 is
//!   the lowest of the picture.
//! - Every fragment lies on the screen.
//!
//! std: `vec![vec![0.0; width as usize]; height as usize]`; an index is a usize: `fragment.i as usize`.

use glam::Vec3;
use vocabulary::{Buffers, Fragment};

pub fn zbuffer(fragments: &[Fragment], background: Vec3, width: u32, height: u32) -> Buffers {
    todo!()
}
