//! How is a class graded? Commands for lecturers; each has a file of its name.
//!
//! [`args`] says what can be typed, [`report`] puts files on the disk.

mod args;
mod audit;
mod doctor;
mod export;
mod grade;
mod handout;
mod merge;
mod report;

pub(crate) use args::Command;

use crate::cli::Outcome;
use crate::failure::Failure;

/// Does what was asked for.
///
/// # Errors
/// [`Failure`], each command's own.
pub(crate) fn run(command: &Command) -> Result<Outcome, Failure> {
    match command {
        Command::Grade(asked) => grade::run(asked),
        Command::Merge(asked) => merge::run(asked),
        Command::Handout(asked) => handout::run(asked),
        Command::Audit(asked) => audit::run(asked),
        Command::Export(asked) => export::run(asked),
        Command::Doctor(asked) => doctor::run(asked),
    }
}
