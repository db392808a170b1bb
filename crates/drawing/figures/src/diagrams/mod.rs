//! Which figures are made of lines? Those about vectors, angles and planes; every length in them is computed.

mod camera_frame;
mod facing_away;
mod halfway;
mod lambert;
mod octagon;
mod phong_highlight;
mod pixel_grid;
mod plane;
mod rotation;
mod shadow_rays;
mod slice;
mod viewing_ray;
mod viewing_volume;
mod worked_example;

use crate::figure::Figure;

/// In the order of the lecture.
pub(crate) static ALL: &[&Figure] = &[
    &camera_frame::FIGURE,
    &viewing_volume::FIGURE,
    &pixel_grid::FIGURE,
    &rotation::FIGURE,
    &lambert::FIGURE,
    &facing_away::FIGURE,
    &phong_highlight::FIGURE,
    &halfway::FIGURE,
    &octagon::FIGURE,
    &viewing_ray::FIGURE,
    &plane::FIGURE,
    &worked_example::FIGURE,
    &shadow_rays::FIGURE,
];
