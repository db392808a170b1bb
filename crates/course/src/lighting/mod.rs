//! How bright is a point of a surface?

use crate::Exercise;

/// The exercises about lighting.
pub(crate) fn exercises() -> Vec<Exercise> {
    Vec::new()
}
