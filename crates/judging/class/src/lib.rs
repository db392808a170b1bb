//! How are two hundred submissions graded with one command, and what is said about them?
//!
//! - [`intake`]: who handed in what.
//! - [`Grading`]: has each judged, keeps what was judged, goes on where a run was ended.
//! - [`merge()`]: puts together what several machines judged; [`changes()`]: compares with an older report.
//! - [`handout`]: what students are given, without solutions.
//! - [`results`]: what is known of a class once it has been graded; every report is made from it.
//! - [`report`]: pages for the lecturer and for each student, and a table of points.
//! - [`mod@format`]: one student's results as a learning platform reads them.
//! - [`export`]: a folder with an autograder that is ready for a platform.

#![forbid(unsafe_code)]

mod changes;
mod checkpoint;
mod course_snapshot;
mod digest;
pub mod export;
pub mod format;
mod grading;
pub mod handout;
pub mod intake;
mod merge;
mod partition;
pub mod report;
mod report_folder;
pub mod results;
mod verdict;

pub use changes::{Change, Changes, changes};
pub use checkpoint::FOLDER as KEPT;
pub use course_snapshot::course;
pub use grading::{GradeError, Grading, Write};
pub use merge::{MergeError, RESULTS, merge, read, read_with_pictures};
pub use partition::{NoPartition, Partition};
pub use report_folder::{RUN, files, read_run, run_json};
