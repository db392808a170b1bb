//! How does a text become a picture? A scene file is read, made ready, and rendered by any renderer.
#![forbid(unsafe_code)]

pub mod builtin;
pub mod error;
mod frame;
pub mod limits;
pub mod load;
mod mtl;
pub mod names;
mod nearest;
mod parse;
mod parse_object;
pub mod prepare;
pub mod render;
pub mod scene;
mod show;
mod value;
pub mod write;

pub use builtin::Builtin;
pub use error::SceneError;
pub use load::{Loaded, load};
pub use names::{Named, Renderer, Show, UnknownName, parse_name};
pub use prepare::{Prepared, prepare};
pub use render::{RenderError, Rendered, render};
pub use scene::{Lens, Object, Scene, Settings, Shape, Transform, View};
pub use shading::Shading;
pub use zbuffer::DepthFormat;
