//! What does the eye see along a ray? Ray tracing, in image order: for every pixel, which object comes first (L21, L43).
//!
//! - [`viewing`]: from a pixel to its ray (L9, L46, E13).
//! - [`triangle`]: the 3×3 system in (β, γ, t), three ways to solve it, the slide's `raytri`, and a test without leaks
//!   (L48–L54, E10, E11).
//! - [`sphere`] and [`plane`]: the exact surfaces.
//! - [`world`]: all there is to see. An [`object`] is a shape somewhere, with a [`surface`]; a [`TracedMesh`] is shared by
//!   its instances.
//! - [`query`]: the nearest hit and any hit, by the slide's loop over everything and by the [`fast`] search.
//! - [`shadow`]: does the light reach the point? (L56, E12)
//! - [`optics`]: Snell's law and Fresnel's equations.
//! - [`color`]: the slide's `raycolor` (L57), then the recursive one with mirrors and glass (L58).
//! - [`picture`]: all pixels (L55), and the object under the mouse (L44).
//!
//! This crate knows nothing of rasterization, so that where both draw the same picture, that is evidence for both.
//! Read [`viewing`] first, then [`triangle`], then [`query`] and [`color`].

#![forbid(unsafe_code)]

pub mod color;
pub mod fast;
pub mod mesh;
pub mod object;
pub mod optics;
pub mod picture;
pub mod plane;
pub mod query;
pub mod shadow;
mod space;
pub mod sphere;
pub mod surface;
pub mod triangle;
pub mod viewing;
pub mod world;

pub use color::{LEAST_SHARE, local_color, ray_color};
pub use geometry::Ray;
pub use mesh::TracedMesh;
pub use object::{Object, ObjectError, Shape};
pub use picture::{Settings, covers_anything, pick, render, render_rows, visible, visible_brute};
pub use query::{Hit, HitRecord, Search, all_met, any_hit, any_hit_brute, nearest, nearest_brute};
pub use surface::{Optics, Surface};
pub use viewing::{viewing_ray, visible_interval};
pub use world::{Interpolation, World};

#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct ReadmeExamples;
