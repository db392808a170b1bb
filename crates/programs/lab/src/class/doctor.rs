//! `cargo lab doctor`: what can this system keep from students' code?

use sandbox::{Check, Finding, Launcher};
use serde_json::json;

use super::args::DoctorArgs;
use crate::cli::Outcome;
use crate::failure::Failure;
use crate::speech::{say, warn};

/// Tries everything and says what came of it; something that grading needs and that is missing is no success.
///
/// # Errors
/// [`Failure`] if standard output takes nothing.
pub(crate) fn run(asked: &DoctorArgs) -> Result<Outcome, Failure> {
    let checks = sandbox::doctor(Launcher::this_program().as_ref());
    let ready = sandbox::missing(&checks).is_empty();
    if asked.json {
        let checks: Vec<_> = checks.iter().map(Check::json).collect();
        say(&format!("{:#}", json!({ "ready": ready, "checks": checks })))?;
    } else {
        say(&table(&checks))?;
        say(if ready {
            "\nAll that grading needs is enforced here."
        } else {
            "\nSomething that grading needs is missing here; `cargo lab grade` refuses unless it is told --unsafe-no-sandbox."
        })?;
    }
    Ok(if ready { Outcome::Done } else { Outcome::Unexpected })
}

/// A line for each check; beneath it what to do, where something is missing.
fn table(checks: &[Check]) -> String {
    let width = checks.iter().map(|check| check.name.chars().count()).max().unwrap_or_default();
    let lines: Vec<String> = checks.iter().map(|check| line(check, width)).collect();
    lines.join("\n")
}

fn line(check: &Check, width: usize) -> String {
    let (name, tried) = (check.name, check.tried);
    match &check.finding {
        Finding::Enforced => format!("enforced  {name:width$}  tried {tried}: refused"),
        Finding::Missing { why, remedy } => {
            let word = if check.needed { "MISSING " } else { "not here" };
            format!(
                "{word}  {name:width$}  tried {tried}: {}\n          {:width$}  to do: {remedy}",
                why.trim(),
                ""
            )
        }
    }
}

/// Who starts students' code confined; `None` if it is to run with all that the lecturer may do.
///
/// # Errors
/// [`Failure`] if this system does not enforce all that is needed, and nobody said that it may be missing.
pub(super) fn launcher(unsafe_no_sandbox: bool) -> Result<Option<Launcher>, Failure> {
    if unsafe_no_sandbox {
        warn("students' code runs with all that you may do yourself, on this machine");
        return Ok(None);
    }
    let launcher = Launcher::this_program();
    let checks = sandbox::doctor(launcher.as_ref());
    let missing = sandbox::missing(&checks);
    if missing.is_empty() {
        return Ok(launcher);
    }
    Err(Failure::new(
        format!("this system cannot confine students' code: {}", missing.join(", ")),
        "`cargo lab doctor` says what to do; --unsafe-no-sandbox grades all the same: only for people you trust, or on a machine that you can throw away",
    ))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_missing_comes_with_what_to_do() {
        let finding = Finding::Missing { why: "it was possible".to_owned(), remedy: "boot another kernel" };
        let missing = Check { name: "files", tried: "to read", needed: true, finding };
        let enforced = Check { finding: Finding::Enforced, name: "sockets", ..missing.clone() };
        let shown = table(&[missing, enforced]);
        assert!(shown.starts_with("MISSING   files    tried to read: it was possible\n"), "{shown}");
        assert!(
            shown.contains("to do: boot another kernel\nenforced  sockets  tried to read: refused"),
            "{shown}"
        );
    }
}
