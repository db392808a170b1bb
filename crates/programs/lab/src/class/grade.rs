//! `cargo lab grade`: what is each submission worth?

use std::fs;
use std::hash::{BuildHasher, RandomState};
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicUsize, Ordering};

use class::intake::{Class, ClassError};
use class::results::{Outcome as Word, Results, Seeds, Submission};
use class::{GradeError, Grading, RUN, changes, read, read_run, run_json};
use grader::Judge;

use sandbox::Launcher;

use super::args::{GradeArgs, Seed, Which};
use super::doctor::launcher;
use super::report::{self, write};
use crate::cli::Outcome;
use crate::failure::{Failure, reason};
use crate::speech::{say, tell, warn};
use crate::student::workbench::{SEED, Workbench};

/// Judges a class and writes the reports.
///
/// # Errors
/// [`Failure`] for a class that cannot be read, or a report that cannot be written. What was judged until then is kept.
pub(crate) fn run(asked: &GradeArgs) -> Result<Outcome, Failure> {
    let bench = Workbench::find()?;
    let class = class(asked)?;
    for remark in &class.remarks {
        warn(remark);
    }
    let launcher = launcher(asked.unsafe_no_sandbox)?;
    let old = asked.compare.as_deref().map(read).transpose().map_err(|e| not_a_report(&e))?;
    not_among_submissions(asked)?;
    report::prepare(&asked.out, asked.resume)?;
    let seeds = seeds(asked);
    let run = asked.out.join(RUN);
    write(&run, &run_json(&seeds)).map_err(|e| report::unwritten(&run, &e))?;
    let scratch = Scratch::beside(&bench.scratch, &asked.out)?;
    let results = threads(asked.jobs)?.install(|| {
        let judge = judge(&bench, &scratch.0, launcher)?;
        graded(asked, &judge, &class, seeds)
    })?;
    report::write_all(&asked.out, &results, &asked.format)?;
    said(asked, &results)?;
    let changed = old.map(|old| changes(&old, &results));
    if let Some(changes) = &changed {
        say(changes.to_string().trim_end())?;
    }
    let looked_at = results.submissions.iter().all(|submission| !failed(submission));
    let unchanged = changed.is_none_or(|changes| changes.changed.is_empty());
    Ok(if looked_at && unchanged { Outcome::Done } else { Outcome::Unexpected })
}

fn class(asked: &GradeArgs) -> Result<Class, Failure> {
    let class =
        if asked.single { Class::single(&asked.submissions) } else { Class::read(&asked.submissions) };
    class.map_err(|error| match error {
        ClassError::Io { path, error } => {
            Failure::io("read", &path, &error, "name the folder that holds the submissions")
        }
        ClassError::Empty(_) => Failure::new(
            error.to_string(),
            "name the folder that holds one folder or zip archive for each student; for one submission alone add --single",
        ),
    })
}

pub(super) fn not_a_report(error: &class::MergeError) -> Failure {
    Failure::new(error.to_string(), "name the folder that `cargo lab grade` wrote with --out")
}

/// The next run would take the report for a student.
fn not_among_submissions(asked: &GradeArgs) -> Result<(), Failure> {
    let Ok(submissions) = fs::canonicalize(&asked.submissions) else { return Ok(()) };
    let report = std::path::absolute(&asked.out).unwrap_or_else(|_| asked.out.clone());
    // The folder need not be there yet: the nearest one that is says where it will be.
    let place = report.ancestors().find_map(|folder| fs::canonicalize(folder).ok()).unwrap_or(report);
    if place.starts_with(submissions) {
        return Err(Failure::new(
            format!("the report {} would lie among the submissions", asked.out.display()),
            "name another folder with --out",
        ));
    }
    Ok(())
}

fn seeds(asked: &GradeArgs) -> Seeds {
    let begun = if asked.resume { read_run(&asked.out) } else { None };
    let seed = match (asked.seed, &begun) {
        (Some(Seed::Given(seed)), _) => seed,
        // The same command again goes on with the number that was drawn. It has 48 bits, so that any program that reads the report reads the same.
        (Some(Seed::Fresh), None) => RandomState::new().hash_one(std::process::id()) >> 16,
        (_, Some(begun)) => begun.seed,
        (None, None) => SEED,
    };
    let per_student = match asked.seeds {
        Some(which) => which == Which::PerStudent,
        None => begun.is_some_and(|begun| begun.per_student),
    };
    Seeds { seed, per_student }
}

fn threads(jobs: Option<usize>) -> Result<rayon::ThreadPool, Failure> {
    // With 0 rayon takes as many as there are processors.
    rayon::ThreadPoolBuilder::new()
        .num_threads(jobs.unwrap_or(0))
        .build()
        .map_err(|e| Failure::new(format!("cannot start threads: {e}"), "ask for fewer with --jobs"))
}

/// One who judges; that nobody can be judged here is known before the first submission is.
fn judge(bench: &Workbench, scratch: &Path, launcher: Option<Launcher>) -> Result<Judge, Failure> {
    let mut judge = bench.judge(None)?;
    judge.scratch = scratch.to_owned();
    judge.compiler.color = false;
    judge.sandbox = launcher;
    judge.rehearse().map_err(|what| {
        Failure::new(format!("nobody's code can be judged here: {what}"), "see what `cargo lab doctor` says")
    })?;
    Ok(judge)
}

fn graded(asked: &GradeArgs, judge: &Judge, class: &Class, seeds: Seeds) -> Result<Results, Failure> {
    let done = AtomicUsize::new(0);
    let grading = Grading {
        judge,
        seeds,
        partition: asked.partition,
        report: &asked.out,
        resume: asked.resume,
        sandboxed: judge.sandbox.is_some(),
        write: &write,
        done: &|submission, known| {
            let number = done.fetch_add(1, Ordering::Relaxed) + 1;
            if !asked.quiet {
                tell(&progress(number, class.entries.len(), submission, known));
            }
        },
    };
    grading.grade(class).map_err(|GradeError { path, error }| {
        let remedy = format!(
            "free some space, or see that it can be written; then go on with `cargo lab grade {} --out {} --resume`",
            asked.submissions.display(),
            asked.out.display()
        );
        Failure::new(format!("cannot write {}: {}", path.display(), reason(&error)), remedy)
    })
}

fn progress(number: usize, of: usize, submission: &Submission, known: bool) -> String {
    let Submission { id, points, of: most, .. } = submission;
    let known = if known { ", known" } else { "" };
    format!("{number} of {of}  {id}  {points} of {most} points{known}")
}

/// Whether a person has to look.
pub(super) fn failed(submission: &Submission) -> bool {
    submission.verdicts.iter().any(|verdict| verdict.outcome == Word::GraderError)
}

fn said(asked: &GradeArgs, results: &Results) -> Result<(), Failure> {
    let count = results.submissions.len();
    let points: u64 = results.submissions.iter().map(|submission| u64::from(submission.points)).sum();
    let of = results.submissions.first().map_or(0, |submission| submission.of);
    let mean = points as f64 / count.max(1) as f64;
    say(&format!("{count} submissions, {mean:.1} of {of} points on average"))?;
    say(&format!(
        "seed {}{}",
        results.seeds.seed,
        if results.seeds.per_student { ", per student" } else { "" }
    ))?;
    if results.seeds.seed == SEED && !results.seeds.per_student {
        say("These inputs are those that students have; the last word belongs to `--seed fresh`.")?;
    }
    let failed: Vec<&str> =
        results.submissions.iter().filter(|it| failed(it)).map(|it| it.id.as_str()).collect();
    if !failed.is_empty() {
        warn(&format!("the grader failed at something of {}: look at class.html", failed.join(", ")));
    }
    say(&format!("{}", asked.out.join("class.html").display()))
}

/// A folder for what is compiled on the way, this run's own. What earlier runs of the same report left behind, which were killed, goes.
struct Scratch(PathBuf);

impl Scratch {
    fn beside(scratch: &Path, report: &Path) -> Result<Self, Failure> {
        let report = fs::canonicalize(report).unwrap_or_else(|_| report.to_owned());
        let prefix = format!("grade-{:016x}-", course::fingerprint(report.to_string_lossy().bytes()));
        for entry in fs::read_dir(scratch).into_iter().flatten().flatten() {
            let name = entry.file_name().to_string_lossy().into_owned();
            let run = name.strip_prefix(&prefix).map(|process| Path::new("/proc").join(process));
            // Where nobody can say whether that run lives, it stays.
            if cfg!(target_os = "linux") && run.is_some_and(|run| !run.exists()) {
                let _ = fs::remove_dir_all(entry.path());
            }
        }
        let folder = scratch.join(format!("{prefix}{}", std::process::id()));
        fs::create_dir_all(&folder).map_err(|e| {
            Failure::io("make the folder", &folder, &e, "free some space, or make it writable")
        })?;
        Ok(Self(folder))
    }
}

impl Drop for Scratch {
    fn drop(&mut self) {
        let _ = fs::remove_dir_all(&self.0);
    }
}
