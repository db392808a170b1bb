//! How is a class judged so that nothing is lost? Submission by submission, each kept as soon as it is judged.

use std::collections::BTreeSet;
use std::fs;
use std::io;
use std::panic::{self, AssertUnwindSafe};
use std::path::{Path, PathBuf};

use course::Exercise;
use grader::{Judge, Judgement, Outcome as Judged};
use rayon::prelude::*;

use crate::checkpoint::{self, Checkpoint, Conditions};
use crate::course_snapshot;
use crate::digest::Digest;
use crate::intake::{Class, Entry, Taken};
use crate::partition::Partition;
use crate::results::{Listed, Results, SCHEMA, Seeds, Submission, VERSION, Verdict};
use crate::verdict::verdict;

/// Writes a file whole or not at all.
pub type Write<'a> = &'a (dyn Fn(&Path, &[u8]) -> io::Result<()> + Sync);

/// How a class is graded.
pub struct Grading<'a> {
    /// Judges each file.
    pub judge: &'a Judge,
    /// How inputs are chosen.
    pub seeds: Seeds,
    /// The share that is judged here; all where there is none.
    pub partition: Option<Partition>,
    /// The folder of the report.
    pub report: &'a Path,
    /// Whether what is kept there from an earlier run counts.
    pub resume: bool,
    /// Whether students' code is confined.
    pub sandboxed: bool,
    /// How files are written.
    pub write: Write<'a>,
    /// Is told of every submission as it is done, from any thread; whether it was known before is the second.
    pub done: &'a (dyn Fn(&Submission, bool) + Sync),
}

/// A class that could not be graded to the end. What was judged is kept.
#[derive(Debug, thiserror::Error)]
#[error("cannot write {path}: {error}")]
pub struct GradeError {
    /// The file.
    pub path: PathBuf,
    /// What the system says: the disk is full, …
    pub error: io::Error,
}

impl Grading<'_> {
    /// Judges every submission of the share, on all processors.
    ///
    /// # Errors
    /// [`GradeError`]: what was judged cannot be kept.
    pub fn grade(&self, class: &Class) -> Result<Results, GradeError> {
        let folder = self.report.join(checkpoint::FOLDER);
        fs::create_dir_all(&folder).map_err(|error| GradeError { path: folder.clone(), error })?;
        let course = course_snapshot::course();
        let count = class.entries.len();
        let share: Vec<&Entry> = class
            .entries
            .iter()
            .enumerate()
            .filter(|(place, entry)| self.partition.is_none_or(|share| share.holds(&entry.id, *place, count)))
            .map(|(_, entry)| entry)
            .collect();
        let submissions: Vec<Submission> = share
            .par_iter()
            .map(|entry| self.submission(entry, &course.version))
            .collect::<Result<_, _>>()?;
        self.forget_others(&share);
        let mut results = Results {
            schema: SCHEMA.to_owned(),
            version: VERSION,
            partition: self.partition.map(|share| share.to_string()),
            course,
            seeds: self.seeds.clone(),
            sandboxed: self.sandboxed,
            remarks: class.remarks.clone(),
            roster: Vec::new(),
            submissions,
            digest: None,
        };
        if self.partition.is_some() {
            results.roster = class.entries.par_iter().map(listed).collect();
            results.digest = Some(results.digest_of_content());
        }
        Ok(results)
    }

    fn submission(&self, entry: &Entry, course: &str) -> Result<Submission, GradeError> {
        let seed = self.seeds.of(&entry.id);
        let taken = entry.take();
        let problem = taken.as_ref().err().map(|error| format!("the submission cannot be read: {error}"));
        let taken = taken.unwrap_or_default();
        let conditions = Conditions {
            course: course.to_owned(),
            fingerprint: fingerprint(&taken),
            seed,
            sandboxed: self.sandboxed,
            limits: format!("{:?}", self.judge.limits),
        };
        let known = Checkpoint::read(self.report, &entry.id)
            .filter(|kept| self.resume && kept.conditions == conditions && !kept.failed());
        let is_known = known.is_some();
        let kept = match known {
            Some(kept) => kept,
            None => {
                let verdicts = match problem {
                    Some(problem) => failed(seed, &problem).iter().map(verdict).collect(),
                    None => self.verdicts(&taken, seed),
                };
                let kept = Checkpoint::new(conditions, verdicts);
                let path = checkpoint::path(self.report, &entry.id);
                let written = kept.bytes().and_then(|bytes| (self.write)(&path, &bytes));
                written.map_err(|error| GradeError { path, error })?;
                kept
            }
        };
        let submission = assembled(entry, taken, kept);
        (self.done)(&submission, is_known);
        Ok(submission)
    }

    /// One verdict an exercise, whatever happens.
    fn verdicts(&self, taken: &Taken, seed: u64) -> Vec<Verdict> {
        let judged = panic::catch_unwind(AssertUnwindSafe(|| self.judgements(taken, seed)));
        let judgements = match judged {
            Ok(Ok(judgements)) => judgements,
            Ok(Err(error)) => failed(seed, &format!("the files cannot be laid out for judging: {error}")),
            Err(_) => failed(seed, "the grader panicked"),
        };
        judgements.iter().map(verdict).collect()
    }

    /// Lays the files out in a folder of their own and judges them there; those that nobody touched need no compiler.
    fn judgements(&self, taken: &Taken, seed: u64) -> io::Result<Vec<Judgement>> {
        fs::create_dir_all(&self.judge.scratch)?;
        let folder = tempfile::Builder::new().prefix("submission-").tempdir_in(&self.judge.scratch)?;
        let mut files: Vec<(&Exercise, PathBuf)> = Vec::new();
        for exercise in course::all() {
            let file = folder.path().join(exercise.path());
            match taken.files.get(exercise.name) {
                Some(bytes) if exercise.is_untouched(bytes) => continue,
                Some(bytes) => {
                    fs::create_dir_all(file.parent().unwrap_or(folder.path()))?;
                    fs::write(&file, bytes)?;
                }
                None => {}
            }
            files.push((exercise, file));
        }
        let mut judge = self.judge.clone();
        judge.compiler.root = folder.path().to_owned();
        let files: Vec<(&Exercise, &Path)> =
            files.iter().map(|(exercise, file)| (*exercise, file.as_path())).collect();
        let judgements = judge.judge_all(&files, seed);
        let mut judgements = judgements.into_iter().peekable();
        let each = course::all().iter().map(|exercise| {
            let judged = judgements.next_if(|judgement| judgement.exercise == exercise.name);
            judged.unwrap_or_else(|| Judgement::not_started(exercise, seed))
        });
        Ok(each.collect())
    }

    /// What is kept of students who are no longer in the class, or in another share, goes.
    fn forget_others(&self, share: &[&Entry]) {
        let ids: BTreeSet<&str> = share.iter().map(|entry| entry.id.as_str()).collect();
        let Ok(entries) = fs::read_dir(self.report.join(checkpoint::FOLDER)) else { return };
        for path in entries.flatten().map(|entry| entry.path()) {
            let id = path.file_stem().and_then(|stem| stem.to_str());
            if !id.is_some_and(|id| ids.contains(id)) {
                // Left behind, it does no harm.
                let _ = fs::remove_file(path);
            }
        }
    }
}

impl Seeds {
    /// The seed of a student's inputs.
    pub fn of(&self, id: &str) -> u64 {
        if self.per_student {
            // Fits a number of any language.
            Digest::of([&self.seed.to_le_bytes()[..], id.as_bytes()]).number() >> 16
        } else {
            self.seed
        }
    }
}

fn failed(seed: u64, why: &str) -> Vec<Judgement> {
    let of = |exercise: &Exercise| Judgement {
        outcome: Judged::GraderError(why.to_owned()),
        ..Judgement::not_started(exercise, seed)
    };
    course::all().iter().map(of).collect()
}

fn fingerprint(taken: &Taken) -> String {
    let texts = taken.files.iter().flat_map(|(name, bytes)| [name.as_bytes(), bytes.as_slice()]);
    Digest::of(texts).hexadecimal()
}

/// A submission as every part lists it.
fn listed(entry: &Entry) -> Listed {
    Listed { id: entry.id.clone(), fingerprint: fingerprint(&entry.take().unwrap_or_default()) }
}

fn assembled(entry: &Entry, taken: Taken, kept: Checkpoint) -> Submission {
    let mut notices = entry.notices.clone();
    notices.extend(taken.notices);
    Submission {
        id: entry.id.clone(),
        student: entry.student.clone(),
        source: entry.source.clone(),
        fingerprint: kept.conditions.fingerprint,
        seed: kept.conditions.seed,
        points: kept.verdicts.iter().map(|verdict| verdict.points).sum(),
        of: kept.verdicts.iter().map(|verdict| verdict.of).sum(),
        notices,
        verdicts: kept.verdicts,
    }
}
