//! How near is what pixel (i, j) shows?

use crate::{Image, Rgb, row_from_j};

/// One depth a pixel: canonical z, near = +1, far = −1, so larger is nearer. Where nothing was drawn it is
/// [`DepthImage::NOTHING`].
#[derive(Clone, Debug, PartialEq)]
pub struct DepthImage {
    width: u32,
    height: u32,
    depths: Vec<f32>,
}

impl DepthImage {
    /// The depth of a pixel that shows nothing: farther than everything.
    pub const NOTHING: f32 = f32::NEG_INFINITY;

    /// A depth image that shows nothing.
    #[must_use]
    pub fn new(width: u32, height: u32) -> Self {
        Self { width, height, depths: vec![Self::NOTHING; width as usize * height as usize] }
    }

    /// The number of pixels in a row.
    #[must_use]
    pub fn width(&self) -> u32 {
        self.width
    }

    /// The number of rows.
    #[must_use]
    pub fn height(&self) -> u32 {
        self.height
    }

    /// The depth of pixel (i, j), j upwards.
    ///
    /// # Panics
    /// If the pixel lies outside the image.
    #[must_use]
    pub fn get(&self, i: u32, j: u32) -> f32 {
        self.depths[self.index(i, j)]
    }

    /// Gives pixel (i, j) a depth, j upwards.
    ///
    /// # Panics
    /// If the pixel lies outside the image.
    pub fn set(&mut self, i: u32, j: u32, depth: f32) {
        let index = self.index(i, j);
        self.depths[index] = depth;
    }

    /// A grey picture: the nearest depth present is white, the farthest dark grey, nothing black.
    #[must_use]
    pub fn to_image(&self) -> Image {
        let drawn = || self.depths.iter().copied().filter(|z| z.is_finite());
        let nearest = drawn().fold(f32::NEG_INFINITY, f32::max);
        let farthest = drawn().fold(f32::INFINITY, f32::min);
        // A flat scene has one depth only: all of it is nearest.
        let span = (nearest - farthest).max(f32::MIN_POSITIVE);
        let grey = |z: f32| {
            if z.is_finite() { Rgb::splat(1.0 - 0.95 * (nearest - z) / span) } else { Rgb::ZERO }
        };
        Image::from_rows(self.width, self.height, self.depths.iter().map(|z| grey(*z)).collect())
            .expect("one pixel for each depth")
    }

    fn index(&self, i: u32, j: u32) -> usize {
        assert!(i < self.width, "pixel column i = {i} outside an image of width {}", self.width);
        row_from_j(j, self.height) as usize * self.width as usize + i as usize
    }
}
