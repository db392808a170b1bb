//! The colour that a ray sees (L55, L57).
//!
//! The slide's raycolor, for balls and one lamp:
//!
//!     if the ray hits a ball at the point p (the nearest, t > 0):
//!         c = c_r c_a                                              ambient
//!         if p's shadow ray to the lamp crosses no ball:
//!             c = c + c_r c_l max(0, n·l) + c_l max(0, h·n)^p
//!         return c
//!     otherwise return the background
//!
//! - `ray`: origin and direction, the direction of any length. `balls`: sphere, colour c_r and exponent p of each.
//! - `lamp`: its position and its light c_l. `ambient`: c_a. `background`: what a ray sees that hits nothing.
//! - n: the ball's unit normal at p; l: unit vector from p to the lamp; e: unit vector from p to the ray's origin;
//!   h = (e + l)/|e + l|. Colours are multiplied channel by channel; nothing is clamped.
//! - The shadow ray counts crossings with 0.001 < t < 1, where t = 0 is p and t = 1 the lamp.
//! - The ray's origin and the lamp are outside all balls. Rays that only touch, and ties, do not occur.
//!
//! What you wrote for `nearest_hit` and `in_shadow` helps: copy it into this file.

use glam::Vec3;
use vocabulary::{Ball, Lamp, Ray};

pub fn ray_color(ray: Ray, balls: &[Ball], lamp: Lamp, ambient: Vec3, background: Vec3) -> Vec3 {
    todo!()
}
