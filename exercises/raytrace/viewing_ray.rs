//! The viewing ray of a pixel (L46, L9).
//!
//! Give the ray p(t) = e + t(s − e) from the eye e through the centre s of the pixel (i, j) in the window:
//!
//!     u_s = l + (r − l)(i + ½)/n_x
//!     v_s = b + (t − b)(j + ½)/n_y
//!     s = u_s u + v_s v + n w       in camera coordinates, where the eye is the origin
//!
//! - `eye`: e, in world coordinates. `basis`: the camera's axes u, v, w, in world coordinates too; it looks along −w.
//! - `volume`: left l, right r, bottom b, top t of the window, and its plane w = n (near), n < 0.
//! - `width`, `height`: n_x and n_y, the number of pixels. `i`, `j`: the pixel; i runs to the right, j upwards, both from 0.
//! - Give the ray in world coordinates, its direction with the length that makes p(1) = s. No input is degenerate.

use glam::Vec3;
use vocabulary::{Basis, Ray, ViewVolume};

pub fn viewing_ray(
    eye: Vec3,
    basis: Basis,
    volume: ViewVolume,
    width: u32,
    height: u32,
    i: u32,
    j: u32,
) -> Ray {
    todo!()
}
