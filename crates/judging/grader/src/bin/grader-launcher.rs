//! A program that can do nothing but launch, for tests: what `cargo lab` is when it grades.

#![forbid(unsafe_code)]

use std::process::ExitCode;

fn main() -> ExitCode {
    sandbox::launched().unwrap_or(ExitCode::FAILURE)
}
