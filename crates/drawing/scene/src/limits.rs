//! How much is too much? The bounds that keep a hostile or mistyped file from eating memory and time.

/// The greatest width and height of a picture in pixels.
pub const GREATEST_SIDE: u32 = 16_384;

/// The most pixels of a picture: 8192 × 8192, which is 800 MB and as much as [`canvas::codec`] reads back.
pub const MOST_PIXELS: u64 = 8192 * 8192;

/// The most samples that a rasterizer keeps at once, about 3 GB. A 4K picture with 2 × 2 samples a pixel fits.
pub const MOST_SAMPLES: u64 = 1 << 25;

/// The most samples along each side of a pixel: 256 in all, where the steps of an 8-bit picture end.
pub const GREATEST_SAMPLES: u32 = 16;

/// The deepest recursion of rays. Light that has been mirrored 64 times is gone, and the stack still holds.
pub const GREATEST_DEPTH: u32 = 64;

/// The most triangles of a scene, each copy of a mesh counted: as many as 4 GB hold on their way to the screen.
pub const MOST_TRIANGLES: u64 = 50_000_000;

/// The most triangles for the painter's algorithm, which compares them in pairs where their boxes overlap.
pub const MOST_PAINTED: usize = 1_000_000;

/// The most copies of all objects together.
pub const MOST_COPIES: u64 = 100_000;

/// The greatest coordinate in a scene, also after all transforms. The square of an area is a fourth power of a length,
/// and (10^9)^4 = 10^36 still fits in `f32`.
pub const GREATEST_COORDINATE: f32 = 1e9;

/// Distance from the origin, in sizes of the object, from which on f32 positions leave its shape less than 12 of their 24
/// bits: at a size of 1 from 4096 on. Then the renderers' pictures begin to differ, and [`crate::Prepared::warnings`] says so.
pub const FAR_IN_SIZES: f32 = 4096.0;

/// The least length or factor, but for 0: the inverse of [`GREATEST_COORDINATE`], for the same reason.
pub const LEAST_LENGTH: f32 = 1e-9;

/// The greatest exponent of a highlight: [`lighting::highlight::GREATEST_EXPONENT`].
pub const GREATEST_EXPONENT: f32 = lighting::highlight::GREATEST_EXPONENT;

/// The greatest refractive index: twice that of anything clear. (Diamond has 2.4, germanium in infrared light 4.)
pub const GREATEST_REFRACTIVE_INDEX: f32 = 10.0;

/// The largest scene file in bytes that is read.
pub const MOST_SCENE_BYTES: u64 = 64 << 20;

/// The largest OBJ or MTL file in bytes that is read.
pub const MOST_MESH_BYTES: u64 = 1 << 30;
