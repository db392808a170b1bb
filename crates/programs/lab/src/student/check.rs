//! `cargo lab check`: is it right, and if not, where does it fail?

use std::time::Duration;

use course::Exercise;
use grader::{Judge, Judgement, Token, version};
use serde_json::json;

use super::verdict;
use super::which::{self, Meant};
use super::workbench::{SEED, Workbench, is_untouched};
use crate::cli::{CheckArgs, Outcome};
use crate::failure::Failure;
use crate::speech::{say, warn};

/// Judges what was asked for and prints the verdicts.
///
/// # Errors
/// [`Failure`] for a name that means nothing, a token of another version, or if nobody can judge here.
pub(crate) fn run(asked: &CheckArgs) -> Result<Outcome, Failure> {
    let bench = Workbench::find()?;
    let (meant, seed) = chosen(&bench, asked)?;
    if meant.is_empty() {
        say(
            "No exercise has been begun. `cargo lab` shows the first one to do; `cargo lab check --all` checks all.",
        )?;
        return Ok(Outcome::Unexpected);
    }
    let judge = bench.judge(asked.limit.map(Duration::from_secs_f32))?;
    let judgements = judge_all(&bench, &judge, &meant, seed, asked.in_order);
    report(&bench, asked, &meant, &judgements)?;
    let passed = judgements.iter().all(Judgement::passed);
    Ok(if passed { Outcome::Done } else { Outcome::Unexpected })
}

fn chosen(bench: &Workbench, asked: &CheckArgs) -> Result<(Vec<Meant>, u64), Failure> {
    let seed = asked.seed.unwrap_or(SEED);
    if let Some(token) = &asked.token {
        return of_token(bench, token, &asked.names);
    }
    if asked.all {
        return Ok((which::all(bench), seed));
    }
    if asked.names.is_empty() {
        let begun = which::all(bench).into_iter().filter(|meant| !is_untouched(meant.exercise, &meant.file));
        return Ok((begun.collect(), seed));
    }
    Ok((which::meant(bench, &asked.names)?, seed))
}

/// The exercise of a token, by the student's file or the one that is named beside it.
fn of_token(bench: &Workbench, token: &Token, names: &[String]) -> Result<(Vec<Meant>, u64), Failure> {
    let exercise = which::one(bench, &token.exercise)?;
    if token.version != version(exercise) {
        return Err(Failure::new(
            format!(
                "the token is of version {:08x} of {}, this is {:08x}",
                token.version,
                exercise.name,
                version(exercise)
            ),
            "check with the version of the project that made the token, or without it",
        ));
    }
    let file = match names {
        [] => bench.file(exercise),
        names => {
            let others = which::meant(bench, names)?;
            match others.into_iter().find(|other| other.exercise.name == exercise.name) {
                Some(other) => other.file,
                None => {
                    return Err(Failure::new(
                        format!("the token is of {}, not of what is named beside it", exercise.name),
                        "name a file of that exercise, or none",
                    ));
                }
            }
        }
    };
    Ok((vec![Meant { exercise, file }], token.seed))
}

/// Judges on all processors; what came of the student's own files is remembered.
pub(crate) fn judge_all(
    bench: &Workbench,
    judge: &Judge,
    meant: &[Meant],
    seed: u64,
    in_order: bool,
) -> Vec<Judgement> {
    let judgements = bench.judge_files(judge, meant, seed);
    let mut memory = bench.memory();
    for (Meant { exercise, file }, judgement) in meant.iter().zip(&judgements) {
        if seed == SEED && *file == bench.file(exercise) {
            memory.note(exercise, file, judgement);
        }
    }
    memory.write();
    if !in_order {
        return judgements;
    }
    // Blocked is what needs an exercise that has not passed: among those judged now, or as it is remembered.
    let passed = |name: &str| match meant.iter().position(|other| other.exercise.name == name) {
        Some(at) => judgements[at].passed(),
        None => course::find(name).is_some_and(|exercise| {
            let standing = memory.standing(exercise, &bench.file(exercise));
            standing.is_some_and(|standing| standing.outcome == grader::Outcome::Passed.word())
        }),
    };
    let blocked = |exercise: &Exercise| exercise.prerequisites.iter().copied().find(|name| !passed(name));
    let held = meant
        .iter()
        .map(|Meant { exercise, .. }| blocked(exercise).map(|by| Judgement::blocked(exercise, seed, by)));
    held.zip(&judgements).map(|(blocked, judgement)| blocked.unwrap_or_else(|| judgement.clone())).collect()
}

fn report(
    bench: &Workbench,
    asked: &CheckArgs,
    meant: &[Meant],
    judgements: &[Judgement],
) -> Result<(), Failure> {
    if asked.json {
        return say(&format!("{:#}", json(bench, judgements)));
    }
    let single = judgements.len() == 1;
    for (Meant { exercise, file }, judgement) in meant.iter().zip(judgements) {
        let picture = bench.draw(judgement);
        if picture.is_none() && judgement.picture.is_some() {
            warn("the picture of the counterexample cannot be written");
        }
        let picture = picture.map(|path| bench.shown(&path));
        if single || !(judgement.passed() || judgement.outcome == grader::Outcome::NotStarted) {
            say(&verdict::text(judgement, exercise, picture.as_deref(), &bench.shown(file)))?;
            if !single {
                say("")?;
            }
        } else {
            say(&verdict::headline(judgement))?;
        }
    }
    if !single {
        say(&summary(judgements))?;
    }
    Ok(())
}

fn summary(judgements: &[Judgement]) -> String {
    let points: u32 = judgements.iter().map(|judgement| judgement.points).sum();
    let of: u32 = judgements.iter().map(|judgement| judgement.of).sum();
    let passed = judgements.iter().filter(|judgement| judgement.passed()).count();
    format!("{passed} of {} passed, {points} of {of} points", judgements.len())
}

/// For machines.
pub(crate) fn json(bench: &Workbench, judgements: &[Judgement]) -> serde_json::Value {
    let verdicts: Vec<serde_json::Value> = judgements
        .iter()
        .map(|judgement| {
            let mut json = judgement.json();
            json["picture"] = json!(bench.draw(judgement).map(|path| path.display().to_string()));
            json
        })
        .collect();
    json!({
        "verdicts": verdicts,
        "passed": judgements.iter().filter(|judgement| judgement.passed()).count(),
        "points": judgements.iter().map(|judgement| judgement.points).sum::<u32>(),
        "of": judgements.iter().map(|judgement| judgement.of).sum::<u32>(),
    })
}
