//! How does a scene become a picture, and what do the lecture's figures and claims show?
//!
//! [`args`] says what can be typed; each command has a file of its name: [`render`], [`compare`], [`figures`], [`claims`], [`scenes`]. [`output`]
//! checks where a picture may go, [`progress`] draws the bar, [`faults`] says what was wrong.

mod args;
mod claims;
mod compare;
mod faults;
mod figures;
mod output;
mod progress;
mod render;
mod scenes;

pub(crate) use args::Command;

use crate::cli::Outcome;
use crate::failure::Failure;

/// Does what was asked for.
///
/// # Errors
/// [`Failure`], each command's own.
pub(crate) fn run(command: &Command) -> Result<Outcome, Failure> {
    match command {
        Command::Render(asked) => render::run(asked),
        Command::Compare(asked) => compare::run(asked),
        Command::Figures(asked) => figures::run(asked),
        Command::Claims(asked) => claims::run(asked),
        Command::Scenes(asked) => scenes::run(asked),
    }
}
