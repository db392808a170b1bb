//! What does this system enforce? Each thing is tried by a program that is confined, and not read off a version.

use std::ffi::{OsStr, OsString};
use std::io::Write;
use std::process::ExitCode;

use serde_json::{Value as Json, json};

use crate::here;
use crate::launcher::Launcher;

/// The first argument of a program that is to try something it should not be able to do.
pub(crate) const MARK: &str = "--attempt-confined";

/// Something that was tried.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Check {
    /// What enforces it: "Landlock: files".
    pub name: &'static str,
    /// What a confined program tried.
    pub tried: &'static str,
    /// Whether there is no confinement without it; otherwise it is a second line behind something else.
    pub needed: bool,
    /// What came of it.
    pub finding: Finding,
}

/// What came of a try.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Finding {
    /// The system refused it.
    Enforced,
    /// The system let it happen, or could not confine the program.
    Missing {
        /// What happened.
        why: String,
        /// What to do about it.
        remedy: &'static str,
    },
}

impl Check {
    /// Whether the system refused what was tried.
    pub fn enforced(&self) -> bool {
        self.finding == Finding::Enforced
    }

    /// For machines.
    pub fn json(&self) -> Json {
        let (why, remedy) = match &self.finding {
            Finding::Enforced => (Json::Null, Json::Null),
            Finding::Missing { why, remedy } => (json!(why), json!(remedy)),
        };
        json!({
            "name": self.name,
            "tried": self.tried,
            "needed": self.needed,
            "enforced": self.enforced(),
            "why": why,
            "remedy": remedy,
        })
    }
}

/// Tries what a confinement promises, with programs that `launcher` starts. Takes a second or two: one of them uses up its time.
///
/// Whoever grades goes on only if all that is needed is enforced.
pub fn doctor(launcher: Option<&Launcher>) -> Vec<Check> {
    let checks = launcher.map(here::checks).unwrap_or_default();
    if checks.is_empty() {
        return vec![Check {
            name: "confinement",
            tried: "nothing",
            needed: true,
            finding: Finding::Missing {
                why: "this system has no Landlock and no seccomp".to_owned(),
                remedy: "use Linux on x86-64 or aarch64, or a virtual machine that is made for this alone",
            },
        }];
    }
    checks
}

/// What is needed and not enforced, by name. Nothing may be, or no program is confined.
pub fn missing(checks: &[Check]) -> Vec<&'static str> {
    checks.iter().filter(|check| check.needed && !check.enforced()).map(|check| check.name).collect()
}

/// Tries what the arguments say, in a process that is already confined. Success: it was refused.
pub(crate) fn attempt(mut arguments: impl Iterator<Item = OsString>) -> ExitCode {
    let what = arguments.next().unwrap_or_default();
    let arguments: Vec<OsString> = arguments.collect();
    match what.to_str().and_then(|what: &str| here::attempt(what, &arguments)) {
        Some(true) => {
            let _ = std::io::stdout().write_all(REFUSED.as_bytes());
            ExitCode::SUCCESS
        }
        Some(false) => ExitCode::from(POSSIBLE),
        None => ExitCode::from(UNKNOWN),
    }
}

/// What an attempt says that was refused.
pub(crate) const REFUSED: &str = "refused";

/// The exit code of an attempt that succeeded, and should not have.
pub(crate) const POSSIBLE: u8 = 1;

/// The exit code of an attempt that is none.
const UNKNOWN: u8 = 2;

/// So that arguments are compared as what they are.
#[allow(dead_code, reason = "only where something is confined")]
pub(crate) fn text(argument: Option<&OsString>) -> Option<&str> {
    argument.map(OsString::as_os_str).and_then(OsStr::to_str)
}
