//! The nearest of several spheres along a ray (L43, L47, L52).
//!
//! A ray crosses the surfaces of spheres at several t. Give the smallest of them with
//!
//!     t0 < t < t1
//!
//! and the index of its sphere in the list, as Some((index, t)); `None` if there is none.
//!
//! - `ray`: origin e and direction d, not zero, of any length: t counts steps of d. `spheres`: any number, also none.
//! - `t0`, `t1`: 0 ≤ t0 < t1; t1 may be f32::INFINITY.
//! - Spheres may overlap, and the ray may start inside one. A sphere that is entered before t0 and left after it is met where
//!   the ray leaves it.
//! - Rays that only touch, two crossings at one t, and crossings at t0 or t1 themselves do not occur.
//!
//! What you wrote for `ray_sphere` helps: copy it into this file as a function of its own.

use vocabulary::{Ray, Sphere};

pub fn nearest_hit(ray: Ray, spheres: &[Sphere], t0: f32, t1: f32) -> Option<(usize, f32)> {
    todo!()
}
