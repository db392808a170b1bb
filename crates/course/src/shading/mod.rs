//! How do a few normals make a smooth surface?

use crate::Exercise;

/// The exercises about shading.
pub(crate) fn exercises() -> Vec<Exercise> {
    Vec::new()
}
