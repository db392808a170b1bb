//! Where does somebody stand, and how much is seen from there?

use glam::Vec3;

/// Three axes: unit vectors at right angles, u × v = w.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Basis {
    /// The first axis; a camera's right.
    pub u: Vec3,
    /// The second axis; a camera's up.
    pub v: Vec3,
    /// The third axis; a camera looks along −w.
    pub w: Vec3,
}

/// The viewing volume (L7): a window on the near plane, in camera coordinates, and how far one sees through it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ViewVolume {
    /// The window's left side, u = l.
    pub left: f32,
    /// Its right side, u = r.
    pub right: f32,
    /// Its lower side, v = b.
    pub bottom: f32,
    /// Its upper side, v = t.
    pub top: f32,
    /// The near plane, w = n < 0.
    pub near: f32,
    /// The far plane, w = f < n.
    pub far: f32,
}
