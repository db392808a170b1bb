//! What does a surface do with light? (L22, L24, L25)

use crate::Rgb;

/// The optical properties of a surface: how much it scatters and how it gleams.
///
/// What falls on a surface is absorbed, reflected or transmitted; the shares add up to 1 (L24). `diffuse` is the share
/// that is scattered, so each channel lies between 0 and 1; a matt surface scatters, it does not only absorb (E18).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Material {
    /// c_r: the share of light scattered to all sides, linear RGB, 0 to 1.
    pub diffuse: Rgb,
    /// How strongly the highlight takes the light's own colour (L29), linear RGB. 1 in the lecture, which is why the model
    /// can reflect more than it receives (L35).
    pub specular: Rgb,
    /// p: the highlight's exponent, at least 0; larger is narrower (L31).
    pub exponent: f32,
}

impl Material {
    /// The material of colour `diffuse` with the lecture's full highlight, specular 1.
    ///
    /// ```
    /// use glam::{Vec3, vec3};
    /// let apple = lighting::Material::new(vec3(0.7, 0.1, 0.05), 64.0);
    /// assert_eq!(apple.specular, Vec3::ONE); // the highlight is white, the light's colour (L29)
    /// ```
    #[must_use]
    pub fn new(diffuse: Rgb, exponent: f32) -> Self {
        Self { diffuse, specular: Rgb::ONE, exponent }
    }

    /// The material of colour `diffuse` without a highlight.
    #[must_use]
    pub fn matt(diffuse: Rgb) -> Self {
        Self { diffuse, specular: Rgb::ZERO, exponent: 1.0 }
    }
}

impl Default for Material {
    /// A neutral, slightly glossy grey.
    fn default() -> Self {
        Self { diffuse: Rgb::splat(0.6), specular: Rgb::splat(0.3), exponent: 50.0 }
    }
}
