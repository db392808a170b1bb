//! `cargo lab audit`: how good is the exercises' own judgement?

use std::sync::atomic::{AtomicUsize, Ordering};

use audit::{Audited, audit};
use course::Exercise;

use super::args::AuditArgs;
use crate::cli::Outcome;
use crate::failure::Failure;
use crate::speech::{say, tell};
use crate::student::which;
use crate::student::workbench::Workbench;

/// Puts exercises on trial and says what came of it.
///
/// # Errors
/// [`Failure`] for a name that means no exercise, or if the audit itself cannot go on.
pub(crate) fn run(asked: &AuditArgs) -> Result<Outcome, Failure> {
    let bench = Workbench::find()?;
    let meant = if asked.names.is_empty() { which::all(&bench) } else { which::meant(&bench, &asked.names)? };
    let mut exercises: Vec<&Exercise> = meant.into_iter().map(|meant| meant.exercise).collect();
    exercises.dedup_by_key(|exercise| exercise.name);
    let mut judge = bench.judge(None)?;
    judge.compiler.color = false;
    let done = AtomicUsize::new(0);
    let progress = |audited: &Audited| {
        let number = done.fetch_add(1, Ordering::Relaxed) + 1;
        tell(&format!("{number} of {}  {}", exercises.len(), audited.name));
    };
    let report = audit(&exercises, &judge, asked.seeds, &progress).map_err(|e| {
        Failure::new(e.to_string(), "see that there is room on the disk, and that `cargo lab check` works")
    })?;
    let said = if asked.json { format!("{:#}", report.json()) } else { report.table() };
    say(said.trim_end())?;
    Ok(if report.met() { Outcome::Done } else { Outcome::Unexpected })
}
