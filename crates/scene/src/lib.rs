//! How does a text become a picture? A scene file is read, made ready, and rendered by any renderer.
#![forbid(unsafe_code)]

pub mod builtin;
pub mod error;
pub mod load;
pub mod names;
pub mod prepare;
pub mod render;
pub mod scene;
mod shading_stub;

pub use builtin::Builtin;
pub use error::SceneError;
pub use load::{Loaded, load};
pub use names::{Named, Renderer, Show, UnknownName, parse_name};
pub use prepare::{Prepared, prepare};
pub use render::{RenderError, Rendered, render};
pub use scene::{DepthBits, Lens, Object, Optics, Scene, Settings, Shape, Surface, Transform, View};
pub use shading_stub::Shading;
