//! How are two hundred submissions graded with one command, and what is said about them?
//!
//! - [`results`]: what is known of a class once it has been graded; every report is made from it.
//! - [`report`]: pages for the lecturer and for each student, and a table of points.
//! - [`mod@format`]: one student's results as a learning platform reads them.
//! - [`export`]: a folder with an autograder that is ready for a platform.

#![forbid(unsafe_code)]

pub mod export;
pub mod format;
pub mod report;
pub mod results;
