//! Which figures are measurements? Those about how one number grows with another.

mod crossover;
mod depth_on_screen;
mod depth_step;
mod highlight_width;
mod normal_error;
mod overdraw;

use crate::figure::Figure;

/// In the order of the lecture.
pub(crate) static ALL: &[&Figure] = &[
    &depth_step::FIGURE,
    &crossover::FIGURE,
    &normal_error::FIGURE,
    &highlight_width::FIGURE,
    &depth_on_screen::FIGURE,
    &overdraw::FIGURE,
];
