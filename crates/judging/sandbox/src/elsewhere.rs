//! What does a system do that confines nothing? It says so.

use std::ffi::{OsStr, OsString};
use std::process::{Child, Command, ExitStatus};

use crate::checkup::Check;
use crate::confinement::{Calls, Confinement};
use crate::launcher::Launcher;

/// There is nothing to launch with.
pub(crate) const THIS_PROGRAM: Option<&str> = None;

pub(crate) fn in_a_group_of_its_own(_command: &mut Command) {}

pub(crate) fn confine(_confinement: &Confinement, _starter: u32) -> Result<(), String> {
    Err("this system confines nothing".to_owned())
}

pub(crate) fn become_program(
    program: &OsStr,
    _calls: Calls,
    _arguments: impl Iterator<Item = OsString>,
) -> String {
    format!("{} cannot be started in this process", program.display())
}

/// Ends a program.
///
/// # Errors
/// What the system gives.
pub fn end(child: &mut Child) -> std::io::Result<ExitStatus> {
    let _ = child.kill();
    child.wait()
}

/// Waits until a program ends by itself.
///
/// # Errors
/// What the system gives.
pub fn finish(child: &mut Child) -> std::io::Result<ExitStatus> {
    child.wait()
}

pub(crate) fn attempt(_what: &str, _arguments: &[OsString]) -> Option<bool> {
    None
}

pub(crate) fn checks(_launcher: &Launcher) -> Vec<Check> {
    Vec::new()
}
