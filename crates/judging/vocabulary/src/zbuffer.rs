//! What is left of polygons on the screen, and what hides what?

use glam::Vec3;

/// A pixel; its sample lies at the point (i, j), in the middle of the pixel.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Pixel {
    /// Its column, counted from the left.
    pub i: u32,
    /// Its row, counted upwards.
    pub j: u32,
}

/// What a polygon leaves in one pixel.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Fragment {
    /// The pixel's column, counted from the left.
    pub i: u32,
    /// The pixel's row, counted upwards.
    pub j: u32,
    /// The depth; larger is nearer.
    pub z: f32,
    /// The polygon's colour there.
    pub colour: Vec3,
}

/// The rgb-buffer and the z-buffer of a screen (L16): row j, column i is `rgb[j][i]` and `z[j][i]`.
#[derive(Clone, Debug, PartialEq)]
pub struct Buffers {
    /// The colour of each pixel.
    pub rgb: Vec<Vec<Vec3>>,
    /// The depth of each pixel.
    pub z: Vec<Vec<f32>>,
}

/// One polygon hides a part of another; polygons have numbers, from 0.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Occlusion {
    /// The polygon that is partly hidden.
    pub behind: usize,
    /// The polygon that hides it.
    pub in_front: usize,
}
