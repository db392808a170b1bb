//! How does a mesh of flat triangles come to look round? By what happens between its vertices.
//!
//! - [`normals`]: a normal for each vertex, where the mesh has none (L39).
//! - [`facet`]: one triangle with its normals turned to the eye.
//! - [`mode`]: flat, Gouraud and Phong shading (L37, L38, L40).
//! - [`plain`]: the z-buffer algorithm with shading in its loop, as on the slide (L16).
//! - [`mod@render`]: the same picture faster, by z-buffer or by the painter's algorithm; [`frame`] is what comes out.
//! - [`fast`]: the picture alone, many times as fast.
//!
//! **Phong shading is not the Phong lighting model** (L42). Shading, here, says where between the vertices the lighting
//! model is evaluated and with which normal; the models are in the crate `lighting`, and any goes with any.
//!
//! Read [`mode`] first, then [`normals`], then [`plain`].

#![forbid(unsafe_code)]

pub mod facet;
pub mod fast;
pub mod frame;
pub mod mode;
pub mod normals;
pub mod plain;
mod projected;
pub mod render;
pub mod world;

pub use facet::Facet;
pub use frame::{Frame, PainterReport, Visible};
pub use mode::{Shading, Surface};
pub use normals::{CREASE_ANGLE, vertex_normals, with_vertex_normals};
pub use plain::render_plain;
pub use render::{MOST_COMPARISONS, Visibility, render};
pub use world::{Lighting, Object, World};

#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct ReadmeExamples;
