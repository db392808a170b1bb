//! Which figures are measurements? Those about how one number grows with another.

mod crossover;
mod depth_step;
mod faceted_normals;
mod highlight_width;
mod overdraw;

use crate::figure::Figure;

/// In the order of the lecture.
pub(crate) static ALL: &[&Figure] = &[
    &depth_step::FIGURE,
    &crossover::FIGURE,
    &faceted_normals::FIGURE,
    &highlight_width::FIGURE,
    &overdraw::FIGURE,
];
