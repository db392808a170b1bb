//! `cargo lab hint`: how could I go on? One hint at a time, each saying more.

use serde_json::json;

use super::ink::{faint, strong};
use super::verdict::wrapped;
use super::which;
use super::workbench::Workbench;
use crate::cli::{HintArgs, Outcome};
use crate::failure::Failure;
use crate::speech::say;

/// Prints the next hint, or the one that was asked for; after the last one the last one again.
///
/// # Errors
/// [`Failure`] if there is no such exercise.
pub(crate) fn run(asked: &HintArgs) -> Result<Outcome, Failure> {
    let bench = Workbench::find()?;
    let exercise = which::one(&bench, &asked.name)?;
    let level = match asked.level {
        Some(level) => level,
        None => next_level(&bench, exercise),
    };
    let hint = exercise.hints[level - 1];
    if asked.json {
        let record =
            json!({ "exercise": exercise.name, "level": level, "of": exercise.hints.len(), "hint": hint });
        say(&format!("{record:#}"))?;
    } else {
        say(&text(exercise, level))?;
    }
    Ok(Outcome::Done)
}

/// The next hint of an exercise, from 1; from now on it counts as read.
pub(crate) fn next_level(bench: &Workbench, exercise: &course::Exercise) -> usize {
    let mut memory = bench.memory();
    let level = (memory.hints(exercise) + 1).min(exercise.hints.len());
    memory.note_hints(exercise, level);
    memory.write();
    level
}

/// A hint, with its number.
pub(crate) fn text(exercise: &course::Exercise, level: usize) -> String {
    let of = exercise.hints.len();
    let heading = strong(&format!("{}, hint {level} of {of}", exercise.name));
    let after =
        if level < of { faint("The same command again says more.") } else { faint("This was the last one.") };
    format!("{heading}\n{}\n{after}", wrapped(exercise.hints[level - 1], "  "))
}
