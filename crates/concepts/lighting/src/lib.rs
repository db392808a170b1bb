//! How bright is a point of a surface? A lighting model answers from material, lights and directions (L22).
//!
//! - [`vectors`]: the reflected direction and the halfway vector (L31, L33).
//! - [`mod@lambert`]: diffuse light (L26–L28).
//! - [`highlight`]: the two forms of the specular highlight, side by side (L30, L31, L34).
//! - [`material`] and [`light`]: what the models take (L22, L24).
//! - [`model`]: the Phong and Blinn–Phong lighting models, for one light and for several (L32, L34).
//! - [`fast`]: the same for eight points at once.
//!
//! All directions are unit vectors in one common space and start at the surface: `n` the normal, `to_light`, `to_eye`.
//! Colours are linear RGB and never clamped here (E8). The *Phong lighting model* is not *Phong shading*: that interpolates
//! normals and may use any lighting model (L42).

#![forbid(unsafe_code)]

pub mod fast;
pub mod highlight;
pub mod lambert;
pub mod light;
pub mod material;
pub mod model;
pub mod vectors;

pub use highlight::{Highlight, blinn_highlight, phong_highlight};
pub use lambert::lambert;
pub use light::{Illumination, Light};
pub use material::Material;
pub use model::{SurfacePoint, blinn_phong, lit, phong};
pub use vectors::{halfway, reflect};

/// A colour in linear RGB: proportional to light, so that colours may be added and scaled. No upper end.
pub type Rgb = glam::Vec3;

#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct ReadmeExamples;
