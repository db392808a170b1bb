//! Which figures are measurements? Those about how one number grows with another.

use crate::figure::Figure;

/// In the order of the lecture.
pub(crate) static ALL: &[&Figure] = &[&depth_step::FIGURE];

mod depth_step;
