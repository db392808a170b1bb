//! How does a text become a picture? A scene file is read, made ready, and drawn by any renderer.
//!
//! - [`mod@scene`]: what a scene file says, as plain data; [`mod@write`] gives it back as text.
//! - [`mod@load`]: scene files and bare meshes from the disk, with errors at line and column ([`error`]).
//! - [`builtin`]: the scenes that need no file.
//! - [`mod@prepare`]: meshes and matrices for the renderers.
//! - [`mod@render`]: one function for z-buffer, painter's algorithm and ray tracer (L21).
//! - [`names`]: the words for renderers, shadings and pictures; [`limits`]: how much is too much.
//!
//! The README describes the format of scene files. Read [`mod@scene`] first, then [`mod@render`].

#![forbid(unsafe_code)]

pub mod builtin;
pub mod error;
mod frame;
pub mod limits;
pub mod load;
mod mtl;
pub mod names;
mod parse;
pub mod prepare;
pub mod render;
pub mod scene;
mod show;
pub mod write;

pub use builtin::Builtin;
pub use error::{RenderError, SceneError};
pub use load::{Loaded, load};
pub use names::{Named, Renderer, Show, UnknownName, parse_name};
pub use prepare::{Prepared, prepare};
pub use render::{Rendered, render, render_slide};
pub use scene::{Lens, Object, Scene, Settings, Shape, Transform, View};
pub use shading::Shading;
pub use zbuffer::DepthFormat;

/// Compiles and runs the examples of the README.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct ReadmeExamples;
