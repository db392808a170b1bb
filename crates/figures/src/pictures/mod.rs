//! Which figures are made of pixels? Those that a renderer draws.

mod cornell_box;

use crate::figure::Figure;

/// In the order of the lecture.
pub(crate) static ALL: &[&Figure] = &[&cornell_box::FIGURE];
