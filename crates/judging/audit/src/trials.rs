//! How are the exercises' laws put on trial?

use std::fs;
use std::path::{Path, PathBuf};

use course::diagnosis::diagnose;
use course::trial::{EXAMPLES, Examination, Outcome, examine};
use course::{Exercise, Fault, InProcess, Program};
use grader::{Batch, Judge};
use rayon::prelude::*;

use crate::equivalent::{self, Equivalent};
use crate::mutants::{self, Mutant};
use crate::place;
use crate::report::{Audited, Caught, Mutants, Recognized, Report, Share, Survivor};

/// So many seeds for every right program, unless asked otherwise.
pub const SEEDS: u64 = 1000;

/// So many seeds for every misconception.
const SEEDS_OF_MISCONCEPTIONS: u64 = 5;

/// So many seeds for a mutant, until one rejects it.
const SEEDS_OF_MUTANTS: u64 = 5;

/// Why there is no report.
#[derive(Debug, thiserror::Error)]
pub enum AuditError {
    /// The slide's solution cannot be changed.
    #[error("{exercise}: the slide's solution is not read as Rust: {why}")]
    Unread {
        /// Of this exercise.
        exercise: &'static str,
        /// What is wrong with it.
        why: String,
    },
    /// Files for the compiler cannot be written.
    #[error("no mutants can be written to {}: {error}", folder.display())]
    Unwritten {
        /// Into this folder.
        folder: PathBuf,
        /// Why.
        error: std::io::Error,
    },
    /// The one who judges cannot go on.
    #[error("{exercise}: {why}")]
    Judge {
        /// At this exercise.
        exercise: &'static str,
        /// Why.
        why: String,
    },
}

/// The laws that a wrong program broke, by their places; the worked examples are the first.
type Broke = Vec<usize>;

/// What became of a mutant: with the last seed that it was tried with the laws that it broke, none if all seeds accept it. `None` if it does not
/// compile.
type Tried = Option<(u64, Broke)>;

/// Puts exercises on trial: right programs with so many `seeds`, misconceptions and mutants with a few. `progress` is told of each exercise that
/// is done, from any thread.
///
/// The same exercises and seeds give the same report.
///
/// # Errors
/// [`AuditError`]: no report can be made. What the report itself holds against an exercise is none.
pub fn audit(
    exercises: &[&Exercise],
    judge: &Judge,
    seeds: u64,
    progress: &(dyn Fn(&Audited) + Sync),
) -> Result<Report, AuditError> {
    let equivalent = equivalent::all();
    let audited: Result<Vec<(Audited, Vec<String>)>, AuditError> = exercises
        .par_iter()
        .map(|exercise| {
            let audited = one(exercise, judge, seeds, &equivalent)?;
            progress(&audited.0);
            Ok(audited)
        })
        .collect();
    let (exercises, errors): (Vec<Audited>, Vec<Vec<String>>) = audited?.into_iter().unzip();
    Ok(Report { exercises, errors: errors.concat() })
}

fn one(
    exercise: &Exercise,
    judge: &Judge,
    seeds: u64,
    equivalent: &[Equivalent],
) -> Result<(Audited, Vec<String>), AuditError> {
    let fault = |fault: Fault| AuditError::Judge { exercise: exercise.name, why: fault.to_string() };
    let variants = variants(exercise, seeds).map_err(fault)?;
    let (misconceptions, mut broke) = misconceptions(exercise).map_err(fault)?;
    let submission = exercise.submission(&exercise.reference).unwrap_or_default();
    let unread =
        |e: &dyn std::fmt::Display| AuditError::Unread { exercise: exercise.name, why: e.to_string() };
    let made = mutants::mutants(&submission).map_err(|e| unread(&e))?;
    let tried = tried(exercise, judge, &made)?;
    let errors = errors(exercise, &made, &tried, equivalent);
    let mut mutants = Mutants::default();
    for (mutant, tried) in made.into_iter().zip(tried) {
        let Some((seed, broken)) = tried else { continue };
        mutants.total += 1;
        if broken.is_empty() {
            mutants.survivors.push(survivor(exercise, &submission, mutant, equivalent));
            continue;
        }
        mutants.rejected += 1;
        if seed > 1 {
            mutants.late.push((seed, survivor(exercise, &submission, mutant, equivalent)));
        }
        broke.push(broken);
    }
    let laws = caught(exercise, &broke);
    Ok((Audited { name: exercise.name, variants, misconceptions, mutants, laws }, errors))
}

/// Right programs, in this process.
fn variants(exercise: &Exercise, seeds: u64) -> Result<Share, Fault> {
    let programs: Vec<&Program> = [&exercise.reference].into_iter().chain(&exercise.variants).collect();
    let accepted = |program: &&Program| -> Result<bool, Fault> {
        let passes = |seed| Ok(examine(exercise, seed, &mut InProcess(program.function))?.passed());
        let passed: Result<Vec<bool>, Fault> = (0..seeds).into_par_iter().map(passes).collect();
        Ok(passed?.into_iter().all(|passed| passed))
    };
    let accepted: Result<Vec<bool>, Fault> = programs.iter().map(accepted).collect();
    Ok(Share { accepted: accepted?.into_iter().filter(|it| *it).count(), total: programs.len() })
}

/// Wrong programs that people write, in this process, and the laws that they break with the first seed.
fn misconceptions(exercise: &Exercise) -> Result<(Recognized, Vec<Broke>), Fault> {
    let mut recognized = Recognized { total: exercise.misconceptions.len(), ..Recognized::default() };
    let mut all_broke = Vec::new();
    for misconception in &exercise.misconceptions {
        let (mut rejected, mut diagnosed) = (true, true);
        for seed in 1..=SEEDS_OF_MISCONCEPTIONS {
            let examination = examine(exercise, seed, &mut InProcess(misconception.program.function))?;
            let seen = diagnose(exercise, &examination.answered);
            rejected &= !examination.passed();
            diagnosed &= seen.is_some_and(|it| it.misconception.program.name == misconception.program.name);
            if seed == 1 {
                all_broke.push(broken(&examination));
            }
        }
        recognized.rejected += usize::from(rejected);
        recognized.diagnosed += usize::from(diagnosed);
    }
    Ok((recognized, all_broke))
}

/// For each mutant the laws that it breaks: none if it is accepted with every seed, `None` if it does not compile.
fn tried(exercise: &Exercise, judge: &Judge, mutants: &[Mutant]) -> Result<Vec<Tried>, AuditError> {
    let unwritten = |error| AuditError::Unwritten { folder: judge.scratch.clone(), error };
    fs::create_dir_all(&judge.scratch).map_err(unwritten)?;
    let folder = tempfile::Builder::new().prefix("mutants-").tempdir_in(&judge.scratch).map_err(unwritten)?;
    let files: Vec<PathBuf> = (0..mutants.len()).map(|at| folder.path().join(format!("{at}.rs"))).collect();
    for (file, mutant) in files.iter().zip(mutants) {
        fs::write(file, &mutant.text).map_err(unwritten)?;
    }
    let fault = |why: String| AuditError::Judge { exercise: exercise.name, why };
    let paths: Vec<&Path> = files.iter().map(PathBuf::as_path).collect();
    let batch = judge.batch(exercise, &paths).map_err(|outcome| fault(format!("{outcome:?}")))?;
    let all: Result<Vec<Tried>, Fault> =
        (0..mutants.len()).into_par_iter().map(|at| ask(exercise, &batch, at)).collect();
    all.map_err(|it| fault(it.to_string()))
}

fn ask(exercise: &Exercise, batch: &Batch<'_>, at: usize) -> Result<Tried, Fault> {
    for seed in 1..=SEEDS_OF_MUTANTS {
        let Some(mut answerer) = batch.answerer(at) else { return Ok(None) };
        let examination = examine(exercise, seed, &mut answerer)?;
        if !examination.passed() {
            return Ok(Some((seed, broken(&examination))));
        }
    }
    Ok(Some((SEEDS_OF_MUTANTS, Broke::new())))
}

/// The laws that did not hold, by their places.
fn broken(examination: &Examination) -> Broke {
    let tried = examination.laws.iter().enumerate();
    tried.filter(|(_, law)| matches!(law.outcome, Outcome::Failed(_))).map(|(at, _)| at).collect()
}

/// How many each law caught, and how many it alone.
fn caught(exercise: &Exercise, broke: &[Broke]) -> Vec<Caught> {
    let names = [EXAMPLES].into_iter().chain(exercise.laws.iter().map(course::Law::name));
    let count = |(at, name)| Caught {
        name,
        catches: broke.iter().filter(|laws| laws.contains(&at)).count(),
        alone: broke.iter().filter(|laws| ***laws == [at]).count(),
    };
    names.enumerate().map(count).collect()
}

fn survivor(exercise: &Exercise, submission: &str, mutant: Mutant, equivalent: &[Equivalent]) -> Survivor {
    let listed = equivalent.iter().find(|it| it.is(exercise.name, &mutant.change));
    Survivor {
        line: place::in_the_course(exercise, submission, mutant.line).unwrap_or(mutant.line),
        reason: listed.map(|it| it.reason.clone()),
        change: mutant.change,
    }
}

/// Entries of the list of equivalent mutants that are wrong.
fn errors(
    exercise: &Exercise,
    mutants: &[Mutant],
    tried: &[Tried],
    equivalent: &[Equivalent],
) -> Vec<String> {
    let here = equivalent.iter().filter(|it| it.exercise == exercise.name);
    here.filter_map(|entry| {
        let its: Vec<&Tried> = mutants
            .iter()
            .zip(tried)
            .filter(|(m, _)| entry.is(exercise.name, &m.change))
            .map(|(_, t)| t)
            .collect();
        let wrong = if its.iter().all(|it| it.is_none()) {
            "no mutant that compiles is changed so: remove the entry"
        } else if its.iter().any(|it| it.as_ref().is_some_and(|(_, broke)| !broke.is_empty())) {
            "the mutant is rejected, so it is not equivalent: remove the entry"
        } else {
            return None;
        };
        Some(format!("crates/judging/audit/equivalent.diff:{}: {wrong}", entry.line))
    })
    .collect()
}
