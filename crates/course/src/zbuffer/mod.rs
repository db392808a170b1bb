//! Which polygon does a pixel show?

mod barycentric;
mod covers;
mod depth_at;
mod inputs;
mod painters_order;
mod rasterize;
mod z_buffer_algorithm;

use crate::Exercise;

/// The exercises about zbuffer.
pub(crate) fn exercises() -> Vec<Exercise> {
    vec![
        barycentric::exercise(),
        covers::exercise(),
        depth_at::exercise(),
        rasterize::exercise(),
        z_buffer_algorithm::exercise(),
        painters_order::exercise(),
    ]
}
