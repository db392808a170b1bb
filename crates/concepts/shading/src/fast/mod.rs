//! How does the picture come out in a fraction of the time? Each visible pixel is coloured once, and eight at a time.
//!
//! The slide's loop (L16) computes a colour for every fragment that is nearer than those before it, one after the other. Here, on top of
//! [`zbuffer::fast`], which finds what each pixel shows:
//!
//! 1. **Vertices are lit once** (Gouraud, L38), eight at a time, where a vertex has one normal and one material; the six triangles around share the colour.
//! 2. **Colours after visibility.** A band of rows is coloured while its depths are still near the processor; nothing is computed for what is hidden (E16).
//! 3. **Eight pixels of a row at once**, whichever triangles they show: their weights, their normals, and the lighting model
//!    ([`lighting::fast`]). Where all eight show the same triangle, its corners are looked up once.
//! 4. **What is special goes the slide's way**: pixels whose triangle is seen so nearly edge-on that rounding decides on its side, normals that are missing
//!    or cancel out, neighbours of different objects.
//!
//! `cargo bench -p shading -- shadings` gives the ratio to [`crate::render_plain`]; the README quotes it. The picture is the slide's but for rounding in
//! the colours, as `tests/it/fast.rs` derives: highlights of exponent p are right to (p + 2) · 2⁻¹⁸ under two lights of at most 1. It does not depend on the processor or the
//! number of threads.
//!
//! Depths have 32 bits: for 24 and 16, and for painters, there is [`crate::render()`]. Where that also says what each pixel shows and what it cost, this gives the picture alone.

mod attributes;
mod colors;
mod known;
mod rows;

use canvas::{Image, Rgb};
use rayon::prelude::*;
use transforms::Pipeline;
use zbuffer::fast::{BAND_ROWS, Band, MeshInstance, Projected};

pub use zbuffer::fast::Faces;

use crate::{Shading, World};
use attributes::Attributes;
use known::Known;
use rows::Coloring;

/// Draws pictures, one after the other, in the same memory: for live views, where the scene is drawn again and again.
///
/// ```
/// use canvas::{Image, Rgb};
/// use geometry::shapes::icosphere;
/// use glam::{Mat4, Vec3, vec3};
/// use lighting::{Highlight, Light, Material};
/// use shading::fast::{Faces, Renderer};
/// use shading::{Object, Shading, World};
/// use transforms::{Camera, Pipeline, ViewVolume};
///
/// let ball = icosphere(3)?;
/// let materials = [Material::new(vec3(0.7, 0.1, 0.05), 64.0)];
/// let lights = [Light::Point { position: vec3(2.0, 4.0, 6.0), color: Rgb::ONE }];
/// let (mut renderer, mut image) = (Renderer::new(), Image::new(60, 40, Rgb::ZERO));
/// for turn in 0..3 {
///     let world_from_object = Mat4::from_rotation_y(0.1 * turn as f32);
///     let objects = [Object { mesh: &ball, world_from_object, materials: &materials }];
///     let world =
///         World { objects: &objects, lights: &lights, background: Rgb::ZERO, highlight: Highlight::Blinn };
///     let camera = Camera::look_at(vec3(0.0, 0.0, 4.0), Vec3::ZERO, Vec3::Y)?;
///     let pipeline = Pipeline::new(camera, ViewVolume::from_fov_y(0.7, 1.5, -1.0, -9.0)?, 60, 40)?;
///     // A ball is closed: its fronts are enough.
///     renderer.render_into(&world, &pipeline, Shading::Phong, Faces::Front, &mut image);
///     assert!(image.get(30, 20).x > 0.1);
/// }
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
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

    /// Draws the world over `image`: what was in it before does not matter.
    ///
    /// - `faces`: [`Faces::Both`] for the slide's picture; fronts alone save work on closed surfaces.
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
        let parts: Vec<MeshInstance> = world
            .objects
            .iter()
            .map(|object| MeshInstance { mesh: object.mesh, world_from_object: object.world_from_object })
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
