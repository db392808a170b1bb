//! What shines, and on what?

use glam::Vec3;

/// What a surface does with light.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Material {
    /// c_r: the share of light that is scattered to all sides, linear RGB, each between 0 and 1 (L26).
    pub diffuse: Vec3,
    /// p: the highlight's exponent, at least 1; larger is narrower (L31).
    pub exponent: f32,
}

/// Where light comes from (L24). Of both kinds arrives `colour`, c_l, however far away the light is.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Light {
    /// Light from one point to all sides.
    Point {
        /// Where it stands, world space.
        position: Vec3,
        /// c_l, linear RGB.
        colour: Vec3,
    },
    /// Light from so far away that its direction is the same everywhere: the sun.
    Directional {
        /// l: unit vector, from the surface towards the light, world space.
        to_light: Vec3,
        /// c_l, linear RGB.
        colour: Vec3,
    },
}

/// A point of a surface, as a lighting model sees it (L22).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SurfacePoint {
    /// Where it is, world space.
    pub position: Vec3,
    /// n: the unit normal there.
    pub n: Vec3,
    /// e: unit vector, from the point towards the eye.
    pub to_eye: Vec3,
}
