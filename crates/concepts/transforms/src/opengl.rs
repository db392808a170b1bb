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

#[cfg(test)]
mod tests {
    use super::*;
    use glam::{Vec4, vec3};

    /// The clipping rule of the books, for w > 0: −w ≤ x, y, z ≤ w.
    fn is_inside(clip: Vec4) -> bool {
        clip.truncate().abs().max_element() <= clip.w
    }

    #[test]
    fn the_books_clipping_rule_throws_away_all_that_the_slides_matrices_show() {
        // E2: no signs on the slides. A visible point has clip w < 0, and nothing satisfies −w ≤ x ≤ w.
        let volume = ViewVolume { left: -1.0, right: 3.0, bottom: -2.0, top: 1.0, near: -1.5, far: -40.0 };
        let seen = vec3(1.0, -0.5, -4.0).extend(1.0);
        let beside = vec3(90.0, -0.5, -4.0).extend(1.0);
        assert!((canonical_from_camera(&volume) * seen).w < 0.0);
        assert!(!is_inside(canonical_from_camera(&volume) * seen));
        assert!(is_inside(opengl_clip_from_camera(&volume) * seen));
        assert!(!is_inside(opengl_clip_from_camera(&volume) * beside));
    }
}
