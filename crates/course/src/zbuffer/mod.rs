//! Which polygon does a pixel show?

mod barycentric;
mod covers;
mod inputs;

use crate::Exercise;

/// The exercises about zbuffer.
pub(crate) fn exercises() -> Vec<Exercise> {
    vec![barycentric::exercise(), covers::exercise()]
}
