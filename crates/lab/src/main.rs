//! How do I see a scene, compare two pictures, or start a scene of my own? With `cargo lab`.
//!
//! [`cli`] says what can be typed; each command has a file of its name: [`render`], [`compare`], [`figures`], [`claims`], [`scenes`]. Beneath them,
//! [`output`] checks where a picture may go, [`unfinished`] writes it whole or not at all, [`signals`] keeps that promise when
//! somebody presses Ctrl-C, [`progress`] draws the bar, [`speech`] writes to the terminal, and [`failure`] says what went wrong.

#![forbid(unsafe_code)]

mod claims;
mod cli;
mod compare;
mod failure;
mod figures;
mod output;
mod progress;
mod render;
mod scenes;
mod signals;
mod speech;
mod unfinished;

use std::process::ExitCode;

use clap::{CommandFactory, Parser};

use cli::{Cli, Command, Outcome};
use failure::Failure;

fn main() -> ExitCode {
    let command = Cli::parse().command;
    match signals::watch().and_then(|()| run(command.as_ref())) {
        Ok(Outcome::Done) => ExitCode::SUCCESS,
        Ok(Outcome::Differs | Outcome::Unexpected) => ExitCode::from(1),
        Err(failure) => {
            speech::complain(&failure);
            ExitCode::from(2)
        }
    }
}

fn run(command: Option<&Command>) -> Result<Outcome, Failure> {
    match command {
        Some(Command::Render(asked)) => render::run(asked),
        Some(Command::Compare(asked)) => compare::run(asked),
        Some(Command::Figures(asked)) => figures::run(asked),
        Some(Command::Claims(asked)) => claims::run(asked),
        Some(Command::Scenes(asked)) => scenes::run(asked),
        None => speech::say(Cli::command().render_help().to_string().trim_end()).map(|()| Outcome::Done),
    }
}
