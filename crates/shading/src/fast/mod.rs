//! How does the picture come out in a tenth of the time?
mod attributes;
mod known;
mod rows;

use canvas::{Image, Rgb};
use rayon::prelude::*;
use transforms::Pipeline;
use zbuffer::fast::{BAND_ROWS, Band, Part, Projected};

pub use zbuffer::fast::Faces;

use crate::{Shading, World};
use attributes::Attributes;
use known::Known;
use rows::Coloring;

/// Draws pictures, one after the other, in the same memory.
#[derive(Debug, Default)]
pub struct Renderer {
    projected: Projected,
    attributes: Attributes,
}

impl Renderer {
    /// A renderer that has drawn nothing yet.
    #[must_use]
    pub fn new() -> Self {
        Self::default()
    }

    /// Draws the world over `image`.
    ///
    /// # Panics
    /// If the image has not the size of the pipeline's screen, or as [`crate::render()`].
    pub fn render_into(
        &mut self,
        world: &World,
        pipeline: &Pipeline,
        shading: Shading,
        faces: Faces,
        image: &mut Image,
    ) {
        world.check();
        let size = (pipeline.width(), pipeline.height());
        assert_eq!((image.width(), image.height()), size, "the image has not the size of the screen");
        if image.pixels().is_empty() {
            return;
        }
        let parts: Vec<Part> = world
            .objects
            .iter()
            .map(|object| Part { mesh: object.mesh, world_from_object: object.world_from_object })
            .collect();
        self.projected.project(&parts, pipeline, faces);
        let lighting = world.lighting(pipeline);
        self.attributes.prepare(world, shading, &lighting);
        let coloring = Coloring {
            world,
            lighting,
            shading,
            fronts_only: faces == Faces::Front,
            projected: &self.projected,
            attributes: &self.attributes,
            height: size.1,
        };
        let bands = image.pixels_mut().par_chunks_mut((size.0 * BAND_ROWS) as usize).enumerate();
        bands.for_each_init(
            || (Band::default(), Known::default()),
            |(band, known), (b, pixels): (usize, &mut [Rgb])| {
                band.draw(b as u32, coloring.projected, &parts);
                coloring.color(band, known, pixels);
            },
        );
    }
}

/// Draws the world: the picture of [`crate::render()`] with a depth buffer of 32 bits, but for rounding in the colours.
///
/// # Panics
/// As [`crate::render()`].
#[must_use]
pub fn render(world: &World, pipeline: &Pipeline, shading: Shading) -> Image {
    let mut image = Image::new(pipeline.width(), pipeline.height(), world.background);
    Renderer::new().render_into(world, pipeline, shading, Faces::Both, &mut image);
    image
}
