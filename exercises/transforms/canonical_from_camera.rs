//! From the camera to the canonical cube (L2 and L3).
//!
//! Give the 4×4 matrix that carries the viewing volume, a pyramid without its top, to the cube [−1, 1]³: S · C · P. P is the
//! perspective matrix (it makes the pyramid a box), C moves the middle of the box to the origin, S scales it:
//!
//!     2/(r−l)    0       0    0     1 0 0 −(l+r)/2     n 0  0    0
//!        0    2/(t−b)    0    0     0 1 0 −(b+t)/2     0 n  0    0
//!        0       0    2/(n−f) 0  ·  0 0 1 −(n+f)/2  ·  0 0 n+f −fn
//!        0       0       0    1     0 0 0     1        0 0  1    0
//!
//! The slide prints r−1, with a one, where it means r−l, and its factors in the order of time (E1).
//!
//! - `volume`: the window's sides `left`, `right`, `bottom`, `top` (l, r, b, t) on the near plane, `near` and `far` (n, f) with
//!   0 > n > f; in camera coordinates.
//! - The image of (x, y, z, 1) is looked at after division by its fourth coordinate: the near plane becomes z = +1, the
//!   far plane z = −1, left and bottom −1, right and top +1. The matrix times any number but 0 is as good.
//! - No input is degenerate: l < r and b < t.
//!
//! glam: `Mat4::from_scale`, `Mat4::from_translation`, `Mat4::from_cols(column, column, column, column)`, `vec3`, `vec4`.

use glam::Mat4;
use vocabulary::ViewVolume;

pub fn canonical_from_camera(volume: ViewVolume) -> Mat4 {
    todo!()
}
