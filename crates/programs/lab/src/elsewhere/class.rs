//! The commands that grade a class, in a program that cannot.

use clap::Subcommand;

use crate::cli::Outcome;
use crate::elsewhere::{self, Words};
use crate::failure::Failure;

/// The commands for lecturers; what follows them is for the program that has them.
#[derive(Debug, Subcommand)]
pub(crate) enum Command {
    /// Judge a folder of submissions, and write the reports
    #[command(disable_help_flag = true)]
    Grade(Words),
    /// Put the parts of a partitioned grading together
    #[command(disable_help_flag = true)]
    Merge(Words),
    /// Write the students' edition: tasks, stubs and worked examples, without solutions
    #[command(disable_help_flag = true)]
    Handout(Words),
    /// Write an autograder for a course platform
    #[command(disable_help_flag = true)]
    Export(Words),
    /// Audit the exercises' laws: right programs must be accepted, wrong ones rejected
    #[command(disable_help_flag = true)]
    Audit(Words),
    /// Say what this system can keep from students' code
    #[command(disable_help_flag = true)]
    Doctor(Words),
}

/// Hands over to the program that grades.
///
/// # Errors
/// [`Failure`] if cargo does not start.
pub(crate) fn run(_command: &Command) -> Result<Outcome, Failure> {
    // Judging two hundred submissions is worth a longer build.
    elsewhere::run("class", "grading")
}
