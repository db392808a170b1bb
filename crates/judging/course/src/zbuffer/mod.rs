//! Which polygon does a pixel show?

mod barycentric;
mod covers;
mod depth_at;
mod drawing;
mod inputs;
mod painters_order;
mod rasterize;
#[allow(clippy::module_inception, reason = "the concept and the exercise have one name in the lecture")]
mod zbuffer;

use crate::Exercise;

/// The exercises about zbuffer.
pub(crate) fn exercises() -> Vec<Exercise> {
    vec![
        barycentric::exercise(),
        covers::exercise(),
        depth_at::exercise(),
        rasterize::exercise(),
        zbuffer::exercise(),
        painters_order::exercise(),
    ]
}
