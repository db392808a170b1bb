//! What is there to draw, and what meets it?

use glam::{Vec2, Vec3};

/// A triangle in space; from the front its corners run anticlockwise.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Triangle {
    /// The first corner.
    pub a: Vec3,
    /// The second corner.
    pub b: Vec3,
    /// The third corner.
    pub c: Vec3,
}

/// A triangle on the screen, in pixels, y upwards.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Triangle2 {
    /// The first corner.
    pub a: Vec2,
    /// The second corner.
    pub b: Vec2,
    /// The third corner.
    pub c: Vec2,
}

/// Barycentric coordinates: the point αa + βb + γc, α + β + γ = 1 (L48).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Barycentric {
    /// The weight of corner a.
    pub alpha: f32,
    /// The weight of corner b.
    pub beta: f32,
    /// The weight of corner c.
    pub gamma: f32,
}

/// The half line origin + t·direction, t ≥ 0; the direction need not have unit length (L46).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ray {
    /// Where it starts, t = 0.
    pub origin: Vec3,
    /// One step of t.
    pub direction: Vec3,
}

/// A sphere.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sphere {
    /// The point that all points of the surface are equally far from.
    pub center: Vec3,
    /// How far.
    pub radius: f32,
}
