//! What would OpenGL say? The same volume in its conventions (E2).
//!
//! | | here | OpenGL |
//! |---|---|---|
//! | near and far | w-coordinates, 0 > n > f | distances, 0 < near < far |
//! | clip w of a visible point | z_camera, negative | −z_camera, positive |
//! | canonical z | near +1, far −1 | near −1, far +1 |
//! | visible in clip space | −w ≥ x ≥ w, and so on | −w ≤ x ≤ w, and so on |
//!
//! Hence S·C·P = diag(−1, −1, 1, −1) · OpenGL's frustum matrix, and the other way round with the same diagonal.

use glam::{Mat4, vec4};

use crate::{ViewVolume, canonical_from_camera};

/// diag(−1, −1, 1, −1): from this crate's clip space to OpenGL's, and back: it is its own inverse.
///
/// After division by w only z changes its sign.
pub const OPENGL_CLIP_FROM_CLIP: Mat4 = Mat4::from_cols(
    vec4(-1.0, 0.0, 0.0, 0.0),
    vec4(0.0, -1.0, 0.0, 0.0),
    vec4(0.0, 0.0, 1.0, 0.0),
    vec4(0.0, 0.0, 0.0, -1.0),
);

/// OpenGL's frustum matrix for the same volume: its near and far are the distances −n and −f.
///
/// A law holds it against `glam::camera::rh::proj::opengl::frustum`.
///
/// # Panics
/// If the volume is degenerate ([`ViewVolume::validate`]).
#[must_use]
pub fn opengl_clip_from_camera(volume: &ViewVolume) -> Mat4 {
    OPENGL_CLIP_FROM_CLIP * canonical_from_camera(volume)
}
