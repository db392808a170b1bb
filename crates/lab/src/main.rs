//! How do I solve an exercise, see a scene, or show a figure of the lecture? With `cargo lab`.
//!
//! [`cli`] says what can be typed; each command has a file of its name: [`render`], [`compare`], [`figures`], [`claims`], [`scenes`], and in
//! [`student`] what an exercise needs. Beneath them,
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
mod student;
mod unfinished;

use std::process::ExitCode;

use clap::Parser;

use cli::{Cli, Command, Outcome};
use failure::Failure;

fn main() -> ExitCode {
    let cli = Cli::parse();
    match signals::watch().and_then(|()| run(&cli)) {
        Ok(Outcome::Done) => ExitCode::SUCCESS,
        Ok(Outcome::Differs | Outcome::Unexpected) => ExitCode::from(1),
        Err(failure) => {
            speech::complain(&failure);
            ExitCode::from(2)
        }
    }
}

fn run(cli: &Cli) -> Result<Outcome, Failure> {
    match &cli.command {
        Some(Command::Check(asked)) => student::check::run(asked),
        Some(Command::Watch(asked)) => student::watch::run(asked),
        Some(Command::Hint(asked)) => student::hint::run(asked),
        Some(Command::Solution(asked)) => student::solution::run(asked),
        Some(Command::Reset(asked)) => student::reset::run(asked),
        Some(Command::Render(asked)) => render::run(asked),
        Some(Command::Compare(asked)) => compare::run(asked),
        Some(Command::Figures(asked)) => figures::run(asked),
        Some(Command::Claims(asked)) => claims::run(asked),
        Some(Command::Scenes(asked)) => scenes::run(asked),
        None => student::board::run(&cli.board),
    }
}
