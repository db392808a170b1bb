//! What if this program was built without the commands that were asked for? Then cargo builds them, the first time that one is.
//!
//! What draws and what grades a class takes longer to build than everything that an exercise needs, so `cargo lab` leaves both out
//! (`.cargo/config.toml`): who begins with an exercise waits for half as long.

#[cfg(test)]
mod tests;

use std::ffi::OsString;
use std::process::Command as Process;

use clap::Args;

use crate::checkout;
use crate::cli::Outcome;
use crate::failure::Failure;

/// Whatever was typed.
#[derive(Args, Debug)]
#[cfg_attr(test, allow(dead_code, reason = "a program that has all commands takes the words itself"))]
pub(crate) struct Words {
    #[arg(trailing_var_arg = true, allow_hyphen_values = true, hide = true)]
    _words: Vec<OsString>,
}

/// Hands the whole command line to a program with this feature, built with this profile.
///
/// # Errors
/// [`Failure`] if there is no project to build it from, or cargo does not start.
pub(crate) fn run(feature: &str, profile: &str) -> Result<Outcome, Failure> {
    let Some(root) = checkout::root() else {
        return Err(Failure::new(
            "the project that this program was built in is not found",
            "change to the project's folder: the one with `exercises` and `crates` in it",
        ));
    };
    let mut cargo = Process::new(std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into()));
    cargo
        .args(["run", "--quiet", "--profile", profile, "--package", env!("CARGO_PKG_NAME")])
        .args(["--no-default-features", "--features", feature, "--manifest-path"])
        .arg(root.join("Cargo.toml"))
        .arg("--")
        .args(std::env::args_os().skip(1));
    instead(&mut cargo).map_err(|e| {
        let reason = crate::failure::reason(&e);
        Failure::new(format!("cargo does not start: {reason}"), "see that `cargo --version` works")
    })
}

/// Becomes that program: its exit code, its signals are this one's.
#[cfg(unix)]
fn instead(cargo: &mut Process) -> std::io::Result<Outcome> {
    use std::os::unix::process::CommandExt;
    Err(cargo.exec())
}

/// Runs that program and ends as it ends.
#[cfg(not(unix))]
fn instead(cargo: &mut Process) -> std::io::Result<Outcome> {
    let status = cargo.status()?;
    std::process::exit(status.code().unwrap_or(2))
}
