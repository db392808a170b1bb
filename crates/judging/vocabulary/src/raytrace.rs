//! What does a ray meet, and what does it bring back?

use glam::Vec3;

use crate::Sphere;

/// Where a ray meets a triangle: at e + t·d, which is a + β(b − a) + γ(c − a) (L48, L50).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TriangleHit {
    /// The place on the ray.
    pub t: f32,
    /// The weight of corner b.
    pub beta: f32,
    /// The weight of corner c.
    pub gamma: f32,
}

/// A sphere with a surface that the lighting equation can be evaluated on (L57).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ball {
    /// Its shape.
    pub sphere: Sphere,
    /// What it reflects of red, green and blue light, c_r.
    pub colour: Vec3,
    /// The highlight's exponent p.
    pub exponent: f32,
}

/// A light that shines from one point to all sides.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Lamp {
    /// Where it is.
    pub position: Vec3,
    /// Its light, c_l.
    pub colour: Vec3,
}

/// A sphere that has a colour of its own and mirrors a share of what is around it (L58).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MirrorBall {
    /// Its shape.
    pub sphere: Sphere,
    /// The colour that it shows without its mirror.
    pub colour: Vec3,
    /// The share of what it mirrors: 0 for none, 1 for all.
    pub mirror: f32,
}
