//! Which polygon does a pixel show? The nearest, by a depth buffer or by drawing from back to front.
//!
//! - [`clip`]: cuts off what lies before the near plane or beyond the far one, before the division by w.
//! - [`screen`]: triangles on the screen, in fixed-point pixels.
//! - [`mod@rasterize`]: the pixels of a triangle, each sample on a shared edge exactly once.
//! - [`mod@sample`]: the numbers behind that, for one pixel.
//! - [`depth_buffer`]: the nearest depth so far (L16).
//! - [`depth_format`]: a depth in 32, 24 or 16 bits, and what that cannot tell apart (L20).
//! - [`mod@draw`]: the z-buffer algorithm of the slide (L16), and how often it computes a colour in vain (E16).
//! - [`fast`]: the same answers for whole meshes, many triangles and pixels at a time.
//! - [`painter`]: the painter's algorithm, occlusion cycles and what to do about them (L13, L14).
//!
//! Depth is canonical z, affine on the screen: near +1, far −1, **larger is nearer**. Pixels are (i, j), j upwards.

#![forbid(unsafe_code)]

pub mod clip;
pub mod depth_buffer;
pub mod depth_format;
pub mod draw;
pub mod fast;
pub mod painter;
mod plane;
pub mod rasterize;
pub mod sample;
pub mod screen;

pub use clip::{ScreenPolygon, project, project_clip};
pub use depth_buffer::{DepthBand, DepthBuffer};
pub use depth_format::DepthFormat;
pub use rasterize::{rasterize, rasterize_rows};
pub use screen::{Fragment, ScreenTriangle, ScreenVertex};

/// Compiles and runs the examples of the README.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct ReadmeExamples;
