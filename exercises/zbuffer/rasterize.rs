//! The pixels of a triangle (L16, E10).
//!
//! Give all pixels of the screen whose sample the triangle covers, in any order, each once.
//!
//! - Pixel (i, j) is the square from i − ½ to i + ½ and from j − ½ to j + ½; its sample is its middle, the point (i, j).
//! - The screen has the columns i = 0 … width − 1 and the rows j = 0 … height − 1, j counted upwards.
//! - A sample on a side belongs to the triangle by the top-left rule: if that is a left side or a top side. In a corner both
//!   sides that meet there must be left or top sides.
//! - `triangle`: its corners in pixels, clockwise or anticlockwise. They may lie off the screen; the part on the screen counts.
//!   A triangle without area owns no pixel.
//! - Corners are multiples of ¼ and at most 18 away from 0, so that sums, differences and products of coordinates are exact.
//!
//! glam: `a.min(b)` and `a.max(b)` take the lesser and the greater of each coordinate; `u.perp_dot(v)` is u.x · v.y − u.y · v.x.
//! `glam::vec2(x, y)` is the point (x, y). You may copy your `covers` into the function, as a closure.

use vocabulary::{Pixel, Triangle2};

pub fn rasterize(triangle: Triangle2, width: u32, height: u32) -> Vec<Pixel> {
    todo!()
}
