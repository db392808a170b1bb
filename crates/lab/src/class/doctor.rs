//! `cargo lab doctor`: what can this system keep from students' code?

use sandbox::{Check, Finding, Launcher};
use serde_json::json;

use super::args::DoctorArgs;
use crate::cli::Outcome;
use crate::failure::Failure;
use crate::speech::say;

/// Tries everything and says what came of it; something that grading needs and that is missing is no success.
///
/// # Errors
/// [`Failure`] if standard output takes nothing.
pub(crate) fn run(asked: &DoctorArgs) -> Result<Outcome, Failure> {
    let checks = sandbox::doctor(Launcher::this_program().as_ref());
    let missing = checks.iter().filter(|check| check.needed && !check.enforced()).count();
    if asked.json {
        let checks: Vec<_> = checks.iter().map(Check::json).collect();
        say(&format!("{:#}", json!({ "ready": missing == 0, "checks": checks })))?;
    } else {
        say(&table(&checks))?;
        say(match missing {
            0 => "\nAll that grading needs is enforced here.",
            _ => {
                "\nSomething that grading needs is missing here; `cargo lab grade` refuses unless it is told --unsafe-no-sandbox."
            }
        })?;
    }
    Ok(if missing == 0 { Outcome::Done } else { Outcome::Unexpected })
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
