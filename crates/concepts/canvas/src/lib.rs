//! Where do colours go? Into an image of linear light, and from there into files.
//!
//! - [`Image`]: linear RGB, one `f32` a channel, not clamped: a highlight may be brighter than the paper (E8).
//! - [`DepthImage`]: one depth a pixel, larger is nearer.
//! - [`srgb`]: the curve between light and the numbers in a PNG file; the one place where colours are clamped.
//! - [`codec`]: images to and from the bytes of PNG (8 and 16 bit) and OpenEXR files.
//! - [`mod@compare`]: pictures side by side, and what differs between two of them.
//!
//! Pixels are named as on the slides: (i, j), i to the right, j **upwards** from 0. Files store rows from the top down;
//! [`row_from_j`] is the one place where the two meet.
//!
//! Read [`mod@image`] first, then [`srgb`].

#![forbid(unsafe_code)]

pub mod codec;
pub mod compare;
pub mod depth;
mod exr_header;
mod exr_luminance;
mod heat;
pub mod image;
pub mod srgb;

pub use crate::codec::{CodecError, Format};
pub use crate::compare::{Difference, SizeMismatch, difference, side_by_side};
pub use crate::depth::DepthImage;
pub use crate::image::{Image, Rgb, row_from_j};

/// Compiles and runs the examples of the README.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct ReadmeExamples;
