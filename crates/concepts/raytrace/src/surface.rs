//! What does a surface do with light? What the lighting model says, and what mirrors and glass do beyond it.

use canvas::Rgb;
use lighting::Material;

/// What becomes of light that meets a surface, beyond the lighting model (L58).
#[derive(Clone, Copy, Debug, PartialEq, Default)]
pub enum Optics {
    /// Only the lighting model.
    #[default]
    Opaque,
    /// A mirror: the reflected ray's colour is added.
    Mirror {
        /// The share that is reflected, linear RGB, 0 to 1.
        reflectance: Rgb,
    },
    /// Clear: the ray splits in two by Snell's law and Fresnel's equations.
    ///
    /// The inside is where the surface's front does not look: behind the corner order of a triangle, in the ball of a
    /// sphere. The mesh must be closed for that to mean anything.
    Glass {
        /// n of the inside; the outside is air with index 1. Glass has about 1.5, water 1.33.
        refractive_index: f32,
        /// The tint: the share of the passing light that gets through the surface, linear RGB, 0 to 1. It counts once a
        /// surface, so twice for a ball, and not by the length of the way inside.
        transmittance: Rgb,
    },
    /// Half transparent: own light and what lies straight behind are mixed. Nothing is bent or reflected, and both sides of
    /// the surface look alike.
    Dissolved {
        /// The share of its own light, 0 to 1: opacity · own + (1 − opacity) · behind. 1 is opaque. Of the light on its way to
        /// other surfaces it lets 1 − opacity through.
        opacity: f32,
    },
}

/// What a surface is made of.
#[derive(Clone, Copy, Debug, PartialEq, Default)]
pub struct Surface {
    /// What the lighting model needs (L22). A perfect mirror or clear glass has diffuse 0.
    pub material: Material,
    /// What goes beyond it. That the shares of both add up to at most 1 (L24) is up to whoever chooses them.
    pub optics: Optics,
}

impl Surface {
    /// An opaque surface.
    #[must_use]
    pub fn opaque(material: Material) -> Self {
        Self { material, optics: Optics::Opaque }
    }
}
