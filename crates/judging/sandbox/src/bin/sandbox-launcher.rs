//! A program that can do nothing but launch: the smallest main function with [`sandbox::launched`] at its top.

#![forbid(unsafe_code)]

use std::process::ExitCode;

fn main() -> ExitCode {
    sandbox::launched().unwrap_or(ExitCode::FAILURE)
}
