//! Recursive ray tracing: mirrors that show mirrors (L58).
//!
//! Each ball has a colour and mirrors a share of what is around it. A ray sees
//!
//!     the background                                    if it hits nothing
//!     color + mirror · (what the reflected ray sees)    of the nearest ball that it hits
//!
//! The reflected ray starts where the ray hit, in the direction r = d − 2(d·n)n, n being the unit normal there.
//!
//! - `ray`: origin outside all balls, direction d of any length. `balls`: sphere, color and mirror (0 to 1) of each.
//! - `depth`: how many reflections are followed. With depth 0 the reflected ray sees the background, whatever stands there;
//!   with depth 1 it may hit a ball, whose own reflected ray sees the background; and so on.
//! - Count only hits with t > 0.001: the reflected ray must not hit the point that it starts from.
//! - Rays that only touch, and ties, do not occur. Colours are not clamped.
//!
//! What you wrote for `nearest_hit` helps: copy it into this file.

use glam::Vec3;
use vocabulary::{MirrorBall, Ray};

pub fn ray_color_recursive(ray: Ray, balls: &[MirrorBall], background: Vec3, depth: u32) -> Vec3 {
    todo!()
}
