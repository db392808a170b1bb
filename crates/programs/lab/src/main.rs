//! How do I solve an exercise, see a scene, or show a figure of the lecture? With `cargo lab`.
//!
//! [`cli`] says what can be typed. [`student`] holds what an exercise needs, [`pictures`] what draws, [`class`] what a lecturer needs, [`live`] what a browser shows; the latter three
//! are features, so that a student's first build is short. Beneath them, [`unfinished`] writes a file whole or not at all, [`signals`] keeps that promise when somebody presses Ctrl-C,
//! [`speech`] writes to the terminal, and [`failure`] says what went wrong.

#![forbid(unsafe_code)]

mod checkout;
#[cfg(not(feature = "class"))]
#[path = "elsewhere/class.rs"]
mod class;
#[cfg(feature = "class")]
mod class;
mod cli;
#[cfg(any(test, not(all(feature = "pictures", feature = "class", feature = "live"))))]
mod elsewhere;
mod failure;
#[cfg(not(feature = "live"))]
#[path = "elsewhere/live.rs"]
mod live;
#[cfg(feature = "live")]
mod live;
#[cfg(not(feature = "pictures"))]
#[path = "elsewhere/pictures.rs"]
mod pictures;
#[cfg(feature = "pictures")]
mod pictures;
mod signals;
mod speech;
mod student;
mod unfinished;

use std::process::ExitCode;

use clap::Parser;

use cli::{Cli, Command, Outcome};
use failure::Failure;

fn main() -> ExitCode {
    // Before anything else: this process may have been started to become another, confined.
    if let Some(code) = sandbox::launched() {
        return code;
    }
    let cli = Cli::parse();
    match signals::watch().and_then(|()| run(&cli)) {
        Ok(Outcome::Done) => ExitCode::SUCCESS,
        Ok(_) => ExitCode::from(1),
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
        Some(Command::Pictures(asked)) => pictures::run(asked),
        Some(Command::Class(asked)) => class::run(asked),
        Some(Command::Live(asked)) => live::run(asked),
        None => student::board::run(&cli.board),
    }
}
