//! From the canonical cube to the screen: the viewport matrix (L4).
//!
//! Give the 4×4 matrix that carries [−1, 1] × [−1, 1] to a screen of n_x × n_y pixels:
//!
//!     n_x/2   0   0  (n_x−1)/2
//!       0   n_y/2 0  (n_y−1)/2
//!       0     0   1      0
//!       0     0   0      1
//!
//! Pixel (i, j) covers [i−½, i+½] × [j−½, j+½]: its centre has whole coordinates. So the screen is [−½, n_x−½] × [−½, n_y−½].
//! j runs upwards, as y does. z is not touched: the z-buffer wants it later.
//!
//! - `width`, `height`: n_x and n_y, at least 1.
//! - A point is a column (x, y, z, 1). No input is degenerate.
//!
//! In Rust 7 / 2 is 3: turn whole numbers into `f32` first, `width as f32`.
//!
//! glam: `Mat4::from_scale`, `Mat4::from_translation`, or `Mat4::from_cols` with four columns.

use glam::Mat4;

pub fn screen_from_canonical(width: u32, height: u32) -> Mat4 {
    todo!()
}
