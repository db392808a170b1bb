//! What can be typed after the commands that grade a class?

use std::path::PathBuf;

use clap::{Args, Subcommand};

/// The commands for lecturers.
#[derive(Debug, Subcommand)]
pub(crate) enum Command {
    /// Judge a folder of submissions, and write the reports
    Grade(GradeArgs),
}

/// `cargo lab grade`.
#[derive(Args, Debug)]
pub(crate) struct GradeArgs {
    /// The class: a folder with a folder or zip archive for each student
    #[arg(value_name = "DIR")]
    pub(crate) submissions: PathBuf,

    /// Where the reports go: a new or empty folder
    #[arg(long, value_name = "REPORT")]
    pub(crate) out: PathBuf,
}
