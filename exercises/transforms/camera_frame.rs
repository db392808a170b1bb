//! The camera's frame (Fig 4.8, L6).
//!
//! A camera looks along `gaze`, and `up` says roughly which way is up on its picture. Give its three axes:
//!
//!     w = −gaze / ‖gaze‖          backwards: the camera looks along −w
//!     u = (up × w) / ‖up × w‖     to the right
//!     v = w × u                   up on the picture
//!
//! - `gaze`, `up`: directions in world coordinates, of any length; they need not be at right angles.
//! - Degenerate: return `None` if `gaze` is zero, if `up` is zero, or if `up` is parallel to `gaze` (along it or against it).
//!   Then nothing says where right is.
//! - Numbers are rounded, and the cross product of two parallel vectors may come out as 0.0000001. So compare the sine of the
//!   angle, ‖up × gaze‖ / (‖up‖·‖gaze‖), with a small number like 0.001. No input lies between: where up and gaze are not
//!   parallel up to rounding, they are at least half a degree apart.
//!
//! glam: `cross`, `length`, `normalize`, `try_normalize` (an Option: `None` for a vector of length 0).

use glam::Vec3;
use vocabulary::Basis;

pub fn camera_frame(gaze: Vec3, up: Vec3) -> Option<Basis> {
    todo!()
}
