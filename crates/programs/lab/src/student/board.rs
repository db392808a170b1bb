//! `cargo lab` alone: how far am I, and what comes next?

use course::{Concept, Exercise};
use serde_json::json;

use super::check::judge_all;
use super::ink::{bad, faint, good, strong, typed};
use super::which::{self, Meant};
use super::workbench::{SEED, Workbench, is_untouched};
use crate::cli::{BoardArgs, Outcome};
use crate::failure::Failure;
use crate::speech::say;

/// One exercise on the board.
#[derive(Debug)]
pub(crate) struct Row {
    /// The exercise.
    pub(crate) exercise: &'static Exercise,
    /// The outcome's word.
    pub(crate) outcome: String,
    /// The points.
    pub(crate) points: u32,
}

impl Row {
    /// Whether all its laws hold.
    pub(crate) fn passed(&self) -> bool {
        self.outcome == grader::Outcome::Passed.word()
    }

    fn begun(&self) -> bool {
        self.outcome != grader::Outcome::NotStarted.word()
    }
}

/// Prints the board.
///
/// # Errors
/// [`Failure`] outside of a project, or if nobody can judge here.
pub(crate) fn run(asked: &BoardArgs) -> Result<Outcome, Failure> {
    let bench = Workbench::find()?;
    let rows = rows(&bench)?;
    if asked.json {
        say(&format!("{:#}", record(&bench, &rows)))?;
    } else {
        say(&text(&bench, &rows))?;
    }
    Ok(Outcome::Done)
}

/// How every exercise stands now. What has changed since it was judged is judged.
///
/// # Errors
/// [`Failure`] if nobody can judge here.
pub(crate) fn rows(bench: &Workbench) -> Result<Vec<Row>, Failure> {
    let all = which::all(bench);
    let memory = bench.memory();
    let is_known = |Meant { exercise, file }: &Meant| {
        is_untouched(exercise, file) || memory.standing(exercise, file).is_some()
    };
    let changed: Vec<Meant> = all.iter().filter(|meant| !is_known(meant)).cloned().collect();
    if !changed.is_empty() {
        let judge = bench.judge(None)?;
        judge_all(bench, &judge, &changed, SEED, false);
    }
    let memory = bench.memory();
    let row = |Meant { exercise, file }| {
        let standing = if is_untouched(exercise, &file) { None } else { memory.standing(exercise, &file) };
        let (outcome, points) = match standing {
            Some(standing) => (standing.outcome, standing.points),
            None if file.is_file() => (grader::Outcome::NotStarted.word().to_owned(), 0),
            None => ("missing".to_owned(), 0),
        };
        Row { exercise, outcome, points }
    };
    Ok(all.into_iter().map(row).collect())
}

/// What to do next: what was begun first, then the first whose prerequisites have passed.
pub(crate) fn next(rows: &[Row]) -> Option<&Row> {
    let passed = |name: &&str| rows.iter().any(|row| row.exercise.name == *name && row.passed());
    let open: Vec<&Row> = rows.iter().filter(|row| !row.passed()).collect();
    let ready = |row: &&&Row| row.exercise.prerequisites.iter().all(&passed);
    open.iter().find(|row| row.begun()).or_else(|| open.iter().find(ready)).or_else(|| open.first()).copied()
}

/// The board and what to do next: at most 24 lines of 80 columns.
fn text(bench: &Workbench, rows: &[Row]) -> String {
    let mut lines = vec![table(rows)];
    lines.extend(next_lines(bench, next(rows)));
    lines.join("\n")
}

/// The board alone, which leaves room for other lines.
pub(crate) fn table(rows: &[Row]) -> String {
    let passed = rows.iter().filter(|row| row.passed()).count();
    let points: u32 = rows.iter().map(|row| row.points).sum();
    let of: u32 = rows.iter().map(|row| row.exercise.points()).sum();
    let mut lines =
        vec![format!("{}  {passed} of {} done, {points} of {of} points", strong("lightlab"), rows.len())];
    for concept in Concept::ALL {
        let cells: Vec<String> =
            rows.iter().filter(|row| row.exercise.concept == concept).map(cell).collect();
        for (at, pair) in cells.chunks(2).enumerate() {
            let label = if at == 0 { strong(&format!("{:11}", concept.name())) } else { " ".repeat(11) };
            lines.push(format!("{label}{}", pair.join("  ")).trim_end().to_owned());
        }
    }
    lines.join("\n")
}

/// A mark, the name, and the points or what happened: 33 columns.
fn cell(row: &Row) -> String {
    let points = format!("{}/{}", row.points, row.exercise.points());
    let (mark, state) = match row.outcome.as_str() {
        "passed" => (good("✓"), points),
        "not started" => (faint("·"), format!("-/{}", row.exercise.points())),
        "wrong" => (bad("✗"), points),
        _ => (bad("!"), points),
    };
    let name = format!("{:24}", row.exercise.name);
    let name = if row.outcome == "not started" { faint(&name) } else { name };
    format!("{mark} {name}{state:>6}")
}

fn next_lines(bench: &Workbench, next: Option<&Row>) -> Vec<String> {
    let Some(Row { exercise, outcome, .. }) = next else {
        return vec![good("All exercises are done.")];
    };
    let state = if outcome == "not started" { String::new() } else { format!(" ({outcome})") };
    vec![
        format!("next: {}{state}, {}", strong(exercise.title.english), exercise.items),
        format!("  edit  {}", typed(&bench.shown(&bench.file(exercise)))),
        format!(
            "  run   {}    verdict on every save; {}",
            typed("cargo lab watch"),
            typed("cargo lab --help")
        ),
    ]
}

/// What a machine wants to know.
fn record(bench: &Workbench, rows: &[Row]) -> serde_json::Value {
    json!({
        "exercises": rows.iter().map(|row| json!({
            "name": row.exercise.name,
            "concept": row.exercise.concept.name(),
            "title": { "en": row.exercise.title.english, "nl": row.exercise.title.dutch },
            "items": row.exercise.items,
            "file": bench.file(row.exercise).display().to_string(),
            "outcome": row.outcome,
            "points": row.points,
            "of": row.exercise.points(),
        })).collect::<Vec<_>>(),
        "next": next(rows).map(|row| row.exercise.name),
        "points": rows.iter().map(|row| row.points).sum::<u32>(),
        "of": rows.iter().map(|row| row.exercise.points()).sum::<u32>(),
    })
}
