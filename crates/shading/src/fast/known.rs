//! What was computed for a triangle already? A triangle is seen in several pixels of several rows; its corners' colours are kept
//! for a while.

use canvas::Rgb;

use zbuffer::fast::{NONE, Number};

use crate::fast::rows::Coloring;
use crate::mode::{flat_color, gouraud_colors};
use crate::{Facet, Object, Shading, Surface};

/// The corners' colours of some triangles, each at a place that follows from its number: a newer one takes the place.
#[derive(Debug)]
pub(crate) struct Known {
    colors: Vec<(Number, [Rgb; 3])>,
}

/// How many are kept: as many as a band of rows shows of most meshes.
const PLACES: usize = 1 << 10;

impl Default for Known {
    fn default() -> Self {
        Self { colors: vec![(NONE, [Rgb::ZERO; 3]); PLACES] }
    }
}

impl Known {
    /// c₀, c₁, c₂ by the slide's functions (L37, L38); for flat shading all three are the triangle's.
    pub(crate) fn corner_colors(
        &mut self,
        number: Number,
        object: &Object,
        triangle: usize,
        coloring: &Coloring,
    ) -> [Rgb; 3] {
        let place = &mut self.colors[number as usize % PLACES];
        if place.0 != number {
            let facet = Facet::new(object, triangle, coloring.lighting.eye);
            let colors = match coloring.shading {
                Shading::Flat => [flat_color(&facet, &coloring.lighting); 3],
                Shading::Gouraud | Shading::Phong => gouraud_colors(&facet, &coloring.lighting),
            };
            *place = (number, colors);
        }
        place.1
    }

    /// The triangle made ready as the slide's loop does.
    pub(crate) fn surface<'a>(
        &mut self,
        _number: Number,
        object: &Object,
        triangle: usize,
        coloring: &'a Coloring,
    ) -> Surface<'a> {
        let facet = Facet::new(object, triangle, coloring.lighting.eye);
        Surface::new(coloring.shading, facet, coloring.lighting)
    }
}
