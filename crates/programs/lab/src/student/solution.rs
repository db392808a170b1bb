//! `cargo lab solution`: how does the slide do it? Told after one's own is right, or to the one who insists.

use serde_json::json;

use super::ink::strong;
use super::verdict::wrapped;
use super::which;
use super::workbench::Workbench;
use crate::cli::{Outcome, SolutionArgs};
use crate::failure::Failure;
use crate::speech::say;

/// Prints the slide's solution and what to know about it.
///
/// # Errors
/// [`Failure`] if there is no such exercise, or if it has not passed and nobody insists.
pub(crate) fn run(asked: &SolutionArgs) -> Result<Outcome, Failure> {
    let bench = Workbench::find()?;
    let exercise = which::one(&bench, &asked.name)?;
    if !asked.reveal && !has_passed(&bench, exercise)? {
        return Err(Failure::new(
            format!("{} has not passed yet", exercise.name),
            format!(
                "`cargo lab hint {0}` helps; `cargo lab solution {0} --reveal` shows the solution all the same",
                exercise.name
            ),
        ));
    }
    let solution = exercise.submission(&exercise.reference).ok_or_else(|| {
        Failure::new(
            format!("the solution of {} is not found", exercise.name),
            "this is a mistake of the project's: report it",
        )
    })?;
    if asked.json {
        let record = json!({
            "exercise": exercise.name,
            "solution": solution,
            "explanation": exercise.explanation,
        });
        say(&format!("{record:#}"))?;
    } else {
        // The task above the solution is in the student's own file already.
        let code = solution.lines().skip_while(|line| line.starts_with("//!") || line.is_empty());
        let code: Vec<&str> = code.collect();
        say(&format!(
            "{}\n\n{}\n\n{}",
            strong(exercise.title.english),
            code.join("\n"),
            wrapped(exercise.explanation, "")
        ))?;
    }
    Ok(Outcome::Done)
}

fn has_passed(bench: &Workbench, exercise: &course::Exercise) -> Result<bool, Failure> {
    let file = bench.file(exercise);
    if let Some(standing) = bench.memory().standing(exercise, &file) {
        return Ok(standing.outcome == grader::Outcome::Passed.word());
    }
    let judge = bench.judge(None)?;
    Ok(bench.judge_file(&judge, exercise, &file).passed())
}
