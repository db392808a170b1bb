//! What does an exercise speak with, beside glam? A few plain structs: fields and nothing else, so that no method does the
//! exercise's work.
//!
//! Every field is public, every struct can be written down where it is needed and compared.

#![forbid(unsafe_code)]

mod geometry;
mod lighting;
mod raytrace;
mod transforms;
mod zbuffer;

pub use geometry::{Barycentric, Ray, Sphere, Triangle, Triangle2};
pub use lighting::{Light, Material, SurfacePoint};
pub use raytrace::{Ball, Lamp, MirrorBall, TriangleHit};
pub use transforms::{Basis, ViewVolume};
pub use zbuffer::{Buffers, Fragment, Occlusion, Pixel};

#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct ReadmeExamples;
