//! What if this program was built without the commands that were asked for? Then cargo builds them, the first time that one is.
//!
//! What draws and what grades a class takes longer to build than everything that an exercise needs, so `cargo lab` leaves both out
//! (`.cargo/config.toml`): who begins with an exercise waits for half as long.

use std::ffi::OsString;
use std::path::Path;
use std::process::Command as Process;

use clap::Args;

use crate::cli::Outcome;
use crate::failure::Failure;

/// Whatever was typed.
#[derive(Args, Debug)]
pub(crate) struct Words {
    #[arg(trailing_var_arg = true, allow_hyphen_values = true, hide = true)]
    _words: Vec<OsString>,
}

/// Hands the whole command line to a program with this feature, built with this profile.
///
/// # Errors
/// [`Failure`] if cargo does not start.
pub(crate) fn run(feature: &str, profile: &str) -> Result<Outcome, Failure> {
    let manifest = Path::new(env!("CARGO_MANIFEST_DIR")).join("Cargo.toml");
    let mut cargo = Process::new(std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into()));
    cargo
        .args(["run", "--quiet", "--profile", profile, "--package", env!("CARGO_PKG_NAME")])
        .args(["--no-default-features", "--features", feature, "--manifest-path"])
        .arg(manifest)
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
