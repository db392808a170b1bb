//! How does a point of the world find its pixel?

mod rotate_about_point;

use crate::Exercise;

/// The exercises about transforms.
pub(crate) fn exercises() -> Vec<Exercise> {
    vec![rotate_about_point::exercise()]
}
