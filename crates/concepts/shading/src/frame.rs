//! What came out: a picture, and for each pixel what it shows and what it cost.

use canvas::{DepthImage, Image, Rgb, row_from_j};
use geometry::Barycentric;
use glam::Vec3;
use zbuffer::Fragment;

/// A picture with its evidence. The lists have one entry a pixel, rows from the top down, as [`Image::pixels`].
#[derive(Clone, Debug, PartialEq)]
pub struct Frame {
    /// The colours, linear and not clamped.
    pub image: Image,
    /// What each pixel shows; `None` is the background.
    pub visible: Vec<Option<Visible>>,
    /// How often the slide's loop computes a colour for the pixel: shading inside the loop is repeated for every fragment
    /// that is drawn over an earlier one (E16).
    pub shaded: Vec<u32>,
    /// What the painter's algorithm met; `None` for the z-buffer.
    pub painter: Option<PainterReport>,
}

/// What a pixel shows.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Visible {
    /// Which object, as an index into [`crate::World::objects`].
    pub object: usize,
    /// Which of its mesh's triangles.
    pub triangle: usize,
    /// Canonical z, not quantized: near +1, far −1.
    pub z: f32,
    /// Where in the triangle.
    pub weights: Barycentric,
    /// The unit normal there, on the side of the eye, world space: that of the triangle for flat shading, the interpolated
    /// one otherwise.
    pub n_world: Vec3,
}

impl Visible {
    /// The record of a fragment of the triangle named (object, triangle); its normal is still to come.
    pub(crate) fn of_fragment((object, triangle): (usize, usize), fragment: &Fragment) -> Self {
        Self { object, triangle, z: fragment.z as f32, weights: fragment.weights, n_world: Vec3::ZERO }
    }
}

/// What stood in the way of an order from back to front (L14).
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct PainterReport {
    /// The cycles that were met, each with its polygons as (object, triangle).
    pub cycles: Vec<Vec<(usize, usize)>>,
    /// How many polygons were cut in two to break them (Newell).
    pub splits: usize,
    /// Whether the polygons were too entangled to find out, within [`crate::MOST_COMPARISONS`], what hides what. Then nothing
    /// was drawn.
    pub gave_up: bool,
}

impl Frame {
    /// A frame that shows the background only.
    pub(crate) fn new(width: u32, height: u32, background: Rgb) -> Self {
        let pixels = width as usize * height as usize;
        Self {
            image: Image::new(width, height, background),
            visible: vec![None; pixels],
            shaded: vec![0; pixels],
            painter: None,
        }
    }

    /// What pixel (i, j) shows, j upwards; `None` is the background.
    ///
    /// # Panics
    /// If the pixel lies outside the image.
    #[must_use]
    pub fn visible_at(&self, i: u32, j: u32) -> Option<Visible> {
        self.visible[self.index(i, j)]
    }

    /// The depths of what is visible.
    #[must_use]
    pub fn depth(&self) -> DepthImage {
        let (width, height) = (self.image.width(), self.image.height());
        let mut depth = DepthImage::new(width, height);
        for j in 0..height {
            for i in 0..width {
                if let Some(visible) = self.visible_at(i, j) {
                    depth.set(i, j, visible.z);
                }
            }
        }
        depth
    }

    pub(crate) fn index(&self, i: u32, j: u32) -> usize {
        assert!(
            i < self.image.width(),
            "pixel column i = {i} outside an image of width {}",
            self.image.width()
        );
        row_from_j(j, self.image.height()) as usize * self.image.width() as usize + i as usize
    }
}
