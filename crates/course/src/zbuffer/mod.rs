//! Which polygon does a pixel show?

use crate::Exercise;

/// The exercises about zbuffer.
pub(crate) fn exercises() -> Vec<Exercise> {
    Vec::new()
}
