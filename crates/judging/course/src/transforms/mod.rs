//! How does a point of the world find its pixel?

mod camera_frame;
mod camera_from_world;
mod canonical_from_camera;
mod change_of_basis;
mod change_of_basis_inverse;
mod drawing;
mod inputs;
mod perspective;
mod rotate_about_point;
mod screen_from_canonical;
mod window_from_pixel;

use crate::Exercise;

/// The exercises about transforms.
pub(crate) fn exercises() -> Vec<Exercise> {
    vec![
        rotate_about_point::exercise(),
        change_of_basis::exercise(),
        change_of_basis_inverse::exercise(),
        camera_frame::exercise(),
        camera_from_world::exercise(),
        perspective::exercise(),
        canonical_from_camera::exercise(),
        screen_from_canonical::exercise(),
        window_from_pixel::exercise(),
    ]
}
