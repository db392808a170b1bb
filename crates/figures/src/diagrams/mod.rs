//! Which figures are made of lines? Those about vectors, angles and planes; every length in them is computed.

mod worked_example;

use crate::figure::Figure;

/// In the order of the lecture.
pub(crate) static ALL: &[&Figure] = &[&worked_example::FIGURE];
