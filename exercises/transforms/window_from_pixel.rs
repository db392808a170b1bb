//! From the pixel to the window (L8).
//!
//! A ray through pixel (i, j) crosses the window [l, r] × [b, t] on the view plane in the point (u_s, v_s). Give the 3×3 matrix
//! that carries (i, j, 1) to (u_s, v_s, 1):
//!
//!     translate(l, b) · scale((r−l)/n_x, (t−b)/n_y) · translate(½, ½)
//!
//! so that u_s = l + (r−l)·(i+½)/n_x and v_s = b + (t−b)·(j+½)/n_y (L9). One matrix on the slide has an error: find it (E14).
//!
//! The screen is [−½, n_x−½] × [−½, n_y−½]: pixel (i, j) reaches from i−½ to i+½ and from j−½ to j+½. j runs upwards.
//!
//! - `volume`: the window's sides `left`, `right`, `bottom`, `top` (l, r, b, t) in camera coordinates. near and far play no part.
//! - `width`, `height`: n_x and n_y, at least 1. No input is degenerate: l < r and b < t.
//! - A point is a column (x, y, 1).
//!
//! glam: `Mat3::from_translation`, `Mat3::from_scale` (both take a `Vec2`), or `mat3` with three columns.

use glam::Mat3;
use vocabulary::ViewVolume;

pub fn window_from_pixel(volume: ViewVolume, width: u32, height: u32) -> Mat3 {
    todo!()
}
