//! What was computed for a triangle already? A triangle is seen in several pixels of several rows; its corners' colours are kept
//! for a while.

use canvas::Rgb;
use geometry::Barycentric;
use zbuffer::fast::{NONE, Number, Singly};

use crate::fast::rows::Coloring;
use crate::mode::{flat_color, gouraud_colors, phong_color};
use crate::{Facet, Object, Shading};

/// The corners' colours of some triangles, each at a place that follows from its number: a newer one takes the place.
#[derive(Debug)]
pub(crate) struct Known {
    colors: Vec<(Number, [Rgb; 3])>,
    facets: Vec<Option<(Number, Facet)>>,
    pub(crate) singly: Singly,
}

/// How many are kept: as many as a band of rows shows of most meshes.
const PLACES: usize = 1 << 10;

/// How many facets are kept: of the few triangles that go the slide's way.
const FACETS: usize = 1 << 6;

impl Default for Known {
    fn default() -> Self {
        Self {
            colors: vec![(NONE, [Rgb::ZERO; 3]); PLACES],
            facets: vec![None; FACETS],
            singly: Singly::default(),
        }
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

    /// The slide's colour where the triangle's barycentric coordinates are `weights`.
    pub(crate) fn color(
        &mut self,
        number: Number,
        object: &Object,
        triangle: usize,
        weights: Barycentric,
        coloring: &Coloring,
    ) -> Rgb {
        if coloring.shading != Shading::Phong {
            let [c0, c1, c2] = self.corner_colors(number, object, triangle, coloring);
            let is_flat = coloring.shading == Shading::Flat;
            return if is_flat { c0 } else { weights.interpolate(c0, c1, c2) };
        }
        let place = &mut self.facets[number as usize % FACETS];
        place.take_if(|(known, _)| *known != number);
        let new = || (number, Facet::new(object, triangle, coloring.lighting.eye));
        let (_, facet) = place.get_or_insert_with(new);
        phong_color(facet, &coloring.lighting, weights)
    }
}
