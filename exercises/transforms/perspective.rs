//! The perspective matrix (L2).
//!
//! Give the 4×4 matrix P that turns the pyramid between the near and the far plane into a box:
//!
//!     n 0  0    0
//!     0 n  0    0
//!     0 0 n+f −fn
//!     0 0  1    0
//!
//! P maps a point (x, y, z, 1) of camera space to (x', y', z', w'); the image is (x'/w', y'/w', z'/w'), after division by w'.
//! Points of the near plane stay where they are; points of the far plane keep their z; what lies between keeps its order.
//!
//! - `near`, `far`: n and f, the z-coordinates of the two planes. The camera looks along −z, so both are negative: 0 > n > f.
//!   The slides never say so (E2).
//! - No input is degenerate. Only the images after division are looked at: P times any number but 0 is as good.
//!
//! glam: `Mat4::from_cols(column, column, column, column)`, `vec4`; four columns, not rows.

use glam::Mat4;

pub fn perspective(near: f32, far: f32) -> Mat4 {
    todo!()
}
