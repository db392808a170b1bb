//! The commands that draw, in a program that cannot.

use clap::Subcommand;

use crate::cli::Outcome;
use crate::elsewhere::{self, Words};
use crate::failure::Failure;

/// The commands that draw; what follows them is for the program that can.
#[derive(Debug, Subcommand)]
pub(crate) enum Command {
    /// Draw a scene or a mesh and write the picture to a file
    #[command(disable_help_flag = true)]
    Render(Words),
    /// Say whether two pictures are the same, and where they differ
    #[command(disable_help_flag = true)]
    Compare(Words),
    /// Draw the lecture's figures into a folder, with a page that shows them
    #[command(disable_help_flag = true)]
    Figures(Words),
    /// Put the lecture's claims on trial
    #[command(disable_help_flag = true)]
    Claims(Words),
    /// List the built-in scenes, or print one as a scene file
    #[command(disable_help_flag = true)]
    Scenes(Words),
}

/// Hands over to the program that draws.
///
/// # Errors
/// [`Failure`] if cargo does not start.
pub(crate) fn run(_command: &Command) -> Result<Outcome, Failure> {
    elsewhere::run("pictures", "release")
}
