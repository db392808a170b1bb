//! The command that serves the page, in a program that cannot.

use clap::Subcommand;

use crate::cli::Outcome;
use crate::elsewhere::{self, Words};
use crate::failure::Failure;

/// The command that serves the page; what follows it is for the program that can.
#[derive(Debug, Subcommand)]
pub(crate) enum Command {
    /// Show the lecture live in a browser: every figure moves, also with your own functions
    #[command(disable_help_flag = true)]
    Play(Words),
}

/// Hands over to the program that serves.
///
/// # Errors
/// [`Failure`] if cargo does not start.
pub(crate) fn run(_command: &Command) -> Result<Outcome, Failure> {
    elsewhere::run("live", "release")
}

/// Does nothing: nothing runs here.
#[cfg(unix)]
pub(crate) fn abandon() {}
