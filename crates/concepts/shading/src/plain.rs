//! The z-buffer algorithm as the slide has it, with shading inside the loop (L16, L21).

use transforms::Pipeline;
use zbuffer::{DepthBuffer, DepthFormat, project, rasterize};

use crate::{Facet, Frame, Shading, Surface, Visible, World};

/// Draws object by object, triangle by triangle, pixel by pixel: the nearer wins (L16).
///
/// A colour is computed for every fragment that is nearer than all before it, though a later one may hide it (E16).
/// [`crate::render()`] gives the same frame, bit for bit, and computes only the colours that stay.
///
/// # Panics
/// If an object's matrix is not finite, or if the screen is too large for [`zbuffer::project`].
#[must_use]
pub fn render_plain(world: &World, pipeline: &Pipeline, shading: Shading, format: DepthFormat) -> Frame {
    world.check();
    let (width, height) = (pipeline.width(), pipeline.height());
    let clip_from_world = pipeline.clip_from_world();
    let lighting = world.lighting(pipeline);

    // The background colour everywhere, and the farthest depth.
    let mut frame = Frame::new(width, height, world.background);
    let mut depth = DepthBuffer::new(width, height, format);

    for (index, object) in world.objects.iter().enumerate() {
        for triangle in 0..object.mesh.len() {
            let facet = Facet::new(object, triangle, lighting.eye);
            let surface = Surface::new(shading, facet, lighting);
            // Clipping can leave several triangles, or none.
            for part in project(&clip_from_world, width, height, &facet.corners).triangles() {
                rasterize(&part, width, height, |fragment| {
                    if depth.test_and_set(fragment.i, fragment.j, fragment.z) {
                        let pixel = frame.index(fragment.i, fragment.j);
                        frame.image.pixels_mut()[pixel] = surface.color(fragment.weights);
                        frame.shaded[pixel] += 1;
                        let n_world = surface.normal(fragment.weights);
                        let visible = Visible::of_fragment((index, triangle), &fragment);
                        frame.visible[pixel] = Some(Visible { n_world, ..visible });
                    }
                });
            }
        }
    }
    frame
}
