//! What does a ray meet, and what colour does it bring back?

use crate::Exercise;

/// The exercises about raytrace.
pub(crate) fn exercises() -> Vec<Exercise> {
    Vec::new()
}
