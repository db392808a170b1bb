//! What is a student's file worth, and if it is wrong, how?

use std::fs;
use std::io;
use std::path::{Path, PathBuf};

use course::diagnosis::diagnose;
use course::trial::{Examination, examine};
use course::{Exercise, Fault, Loss, Picture, Reply};
use rayon::prelude::*;
use sandbox::Launcher;

use crate::compile::{Compiler, NotCompiled, SourceFile};
use crate::consistency;
use crate::judgement::{Forfeit, Judgement, LooksLike, Outcome, Unreadable};
use crate::libraries::{Build, Libraries};
use crate::process::{Limits, Process};
use crate::token::Token;

/// A file over this size is not the solution of an exercise, in bytes.
pub const LONGEST_FILE: u64 = 1 << 20;

/// Judges students' files.
#[derive(Clone, Debug)]
pub struct Judge {
    /// Makes workers of them.
    pub compiler: Compiler,
    /// What these may take.
    pub limits: Limits,
    /// A folder for what is made on the way; each judgement uses a folder of its own in it, and removes it.
    pub scratch: PathBuf,
    /// Where the libraries are remembered, and how they are built again after an update of Rust; `None` if they are not.
    pub memory: Option<(PathBuf, Build)>,
    /// Confines rustc and workers; `None` for one's own files.
    pub sandbox: Option<Launcher>,
}

impl Judge {
    /// One who does all its work in `folder`, with the usual limits and without a sandbox.
    pub fn in_folder(libraries: Libraries, folder: &Path) -> Self {
        Self {
            compiler: Compiler { libraries, root: folder.to_owned(), color: false },
            limits: Limits::default(),
            scratch: folder.join("scratch"),
            memory: None,
            sandbox: None,
        }
    }

    /// Judges one file by the laws of one exercise. Nothing that the file does makes this fail: what goes wrong is in the
    /// judgement, and what is not the student's doing is [`Outcome::GraderError`].
    pub fn judge(&self, exercise: &Exercise, file: &Path, seed: u64) -> Judgement {
        let blank = Judgement::blank(exercise, Token::new(exercise, seed));
        if let Some(outcome) = unreadable(file) {
            return Judgement { outcome, ..blank };
        }
        match self.worker(&[SourceFile { exercise, file }]) {
            Ok(worker) => self.examine(exercise, &worker, 0, seed),
            Err(error) => Judgement { outcome: error.outcome(), ..blank },
        }
    }

    /// Compiles a worker without any student's file and starts it: what is wrong then is wrong for everybody, and no student's doing.
    ///
    /// # Errors
    /// What is wrong.
    pub fn rehearse(&self) -> Result<(), String> {
        let exercise = course::all().first().ok_or("there is no exercise")?;
        let worker = self.worker(&[]).map_err(|error| match error.outcome() {
            Outcome::DoesNotCompile { message, .. } => message,
            outcome => outcome.sentence().unwrap_or_default(),
        })?;
        let launcher = self.sandbox.as_ref();
        Process::new(&worker.program, 0, exercise, self.limits, launcher).rehearse().map_err(|fault| fault.0)
    }

    /// Judges many files, on all processors. They are compiled together, which takes little longer than one. If that fails, those that rustc names
    /// are compiled on their own, so that one that does not compile costs no other; and where it names none, all are.
    pub fn judge_all(&self, files: &[(&Exercise, &Path)], seed: u64) -> Vec<Judgement> {
        let readable: Vec<SourceFile<'_>> = files
            .iter()
            .filter(|(_, file)| unreadable(file).is_none())
            .map(|(exercise, file)| SourceFile { exercise, file })
            .collect();
        let together = if readable.len() > 1 { self.worker_of_most(&readable).ok().flatten() } else { None };
        let judge = |(exercise, file): &(&Exercise, &Path)| {
            let shared = together.as_ref().and_then(|(worker, left)| {
                let is_this =
                    |at: &usize| readable[*at].file == *file && readable[*at].exercise.name == exercise.name;
                Some((worker, left.iter().position(is_this)?))
            });
            match shared {
                Some((worker, place)) => self.examine(exercise, worker, place as u32, seed),
                None => self.judge(exercise, file, seed),
            }
        };
        files.par_iter().map(judge).collect()
    }

    /// A worker of as many of these files as compile together, and the places of those; `None` if none does. Files that rustc says are wrong are left
    /// out and the others compiled again, which may take a few rounds: a compiler that gives up early does not name all.
    ///
    /// # Errors
    /// [`NotCompiled`]: that is no file's doing, or rustc does not say whose.
    pub(crate) fn worker_of_most(
        &self,
        parts: &[SourceFile<'_>],
    ) -> Result<Option<(Worker, Vec<usize>)>, NotCompiled> {
        let mut left: Vec<usize> = (0..parts.len()).collect();
        while !left.is_empty() {
            let some: Vec<SourceFile<'_>> = left.iter().map(|at| parts[*at]).collect();
            match self.worker(&some) {
                Ok(worker) => return Ok(Some((worker, left))),
                Err(NotCompiled::Refused { blamed, .. }) if !blamed.is_empty() => {
                    let places = left.iter().enumerate().filter(|(place, _)| !blamed.contains(place));
                    left = places.map(|(_, at)| *at).collect();
                }
                Err(other) => return Err(other),
            }
        }
        Ok(None)
    }

    /// Compiles files into one worker.
    pub(crate) fn worker(&self, parts: &[SourceFile<'_>]) -> Result<Worker, NotCompiled> {
        let folder = fs::create_dir_all(&self.scratch)
            .and_then(|()| tempfile::Builder::new().prefix("worker-").tempdir_in(&self.scratch))
            .map_err(|e| {
                NotCompiled::Failed(format!("no folder for the worker in {}: {e}", self.scratch.display()))
            })?;
        let program =
            self.compile(parts, folder.path()).map_err(|error| self.explained(error, parts, &folder))?;
        Ok(Worker { program, _folder: folder })
    }

    /// A failure that points into no file is the files' doing if a worker without any of them can be made.
    fn explained(
        &self,
        error: NotCompiled,
        parts: &[SourceFile<'_>],
        folder: &tempfile::TempDir,
    ) -> NotCompiled {
        match error {
            NotCompiled::Unexplained(words) if !parts.is_empty() && self.rehearse().is_ok() => {
                let words = words.replace(&*folder.path().to_string_lossy(), "…");
                NotCompiled::unlinked(self.sandbox.is_none().then_some(words))
            }
            other => other,
        }
    }

    fn compile(&self, parts: &[SourceFile<'_>], folder: &Path) -> Result<PathBuf, NotCompiled> {
        let first = self.limits.compiling;
        match (self.compiler.worker(parts, folder, first, self.sandbox.as_ref()), &self.memory) {
            (Err(NotCompiled::OldKit), Some((memory, build))) => {
                Libraries::forget(memory);
                let libraries = Libraries::remembered(&self.compiler.root, *build, memory)
                    .map_err(|e| NotCompiled::Failed(e.to_string()))?;
                Compiler { libraries, ..self.compiler.clone() }.worker(
                    parts,
                    folder,
                    first,
                    self.sandbox.as_ref(),
                )
            }
            (result, _) => result,
        }
    }

    /// Asks one function of a worker.
    fn examine(&self, exercise: &Exercise, worker: &Worker, function: u32, seed: u64) -> Judgement {
        let blank = Judgement::blank(exercise, Token::new(exercise, seed));
        let launcher = self.sandbox.as_ref();
        let process = || Process::new(&worker.program, function, exercise, self.limits, launcher);
        let mut asked = process();
        let examination = examine(exercise, seed, &mut asked);
        let unbegun = asked.unbegun();
        let (printed, surplus) = asked.finish();
        if surplus {
            let outcome = Outcome::Crashed("it sent more answers than it was asked for".to_owned());
            return Judgement { outcome, forfeit: Some(Forfeit::Ended), printed, ..blank };
        }
        if unbegun.is_some() && self.rehearse().is_ok() {
            let outcome = Outcome::Crashed("it ended before it was asked anything".to_owned());
            return Judgement { outcome, forfeit: Some(Forfeit::Ended), printed, ..blank };
        }
        let weighed = examination
            .and_then(|examination| weigh(exercise, examination, process, blank.clone()))
            .unwrap_or_else(|fault| Judgement { outcome: Outcome::GraderError(fault.to_string()), ..blank });
        Judgement { printed, ..weighed }
    }
}

/// A compiled worker; its folder goes with it.
#[derive(Debug)]
pub(crate) struct Worker {
    pub(crate) program: PathBuf,
    _folder: tempfile::TempDir,
}

/// What an examination comes to.
///
/// # Errors
/// [`Fault`]: there is no further process to ask.
fn weigh(
    exercise: &Exercise,
    examination: Examination,
    process: impl Fn() -> Process,
    blank: Judgement,
) -> Result<Judgement, Fault> {
    let mut outcome = outcome(&examination);
    let mut fresh = process();
    let gains = examination.points() > 0 && !matches!(outcome, Outcome::Exited(_) | Outcome::Crashed(_));
    // Nothing is to be gained by answering twice where nothing is gained.
    if gains && let Some(twice) = consistency::unsteady(&examination, &mut fresh)? {
        outcome = Outcome::Unsteady(Box::new(twice));
    }
    let forfeit = match &outcome {
        Outcome::Unsteady(_) => Some(Forfeit::Unsteady),
        Outcome::Exited(_) | Outcome::Crashed(_) => Some(Forfeit::Ended),
        _ if gains && consistency::is_constant(exercise, blank.token.seed, &examination)? => {
            Some(Forfeit::Constant)
        }
        _ => None,
    };
    let wrong = matches!(outcome, Outcome::Wrong);
    let looks_like = if wrong { looks_like(exercise, &examination) } else { None };
    let picture = if wrong { picture(exercise, &examination, fresh) } else { None };
    let points = if forfeit.is_some() { 0 } else { examination.points() };
    Ok(Judgement { outcome, points, forfeit, laws: examination.laws, looks_like, picture, ..blank })
}

/// The counterexample's last call, drawn.
fn picture(exercise: &Exercise, examination: &Examination, mut process: Process) -> Option<Picture> {
    let (_, counterexample) = examination.counterexample()?;
    let (arguments, reply) = counterexample.calls.last()?;
    let Reply::Value(given) = reply else { return None };
    exercise.picture(arguments, Some(given), &mut process)
}

/// The bytes of a student's file; `None` if there is none, or it is no file of a solution's size: a device, a pipe, a disk image.
pub fn bytes_of(file: &Path) -> Option<Vec<u8>> {
    let metadata = fs::metadata(file).ok()?;
    if !metadata.is_file() || metadata.len() > LONGEST_FILE { None } else { fs::read(file).ok() }
}

/// What can be said of a file without compiling it.
pub(crate) fn unreadable(file: &Path) -> Option<Outcome> {
    let missing = |why| Some(Outcome::Unreadable(why));
    match fs::metadata(file) {
        Err(e) if e.kind() == io::ErrorKind::NotFound => return missing(Unreadable::Missing),
        Err(e) => return missing(Unreadable::Io(e.to_string())),
        Ok(metadata) if !metadata.is_file() => return missing(Unreadable::NotAFile),
        Ok(metadata) if metadata.len() > LONGEST_FILE => return missing(Unreadable::TooLong),
        Ok(_) => {}
    }
    match fs::read(file) {
        Err(e) => missing(Unreadable::Io(e.to_string())),
        Ok(bytes) => match std::str::from_utf8(&bytes) {
            Ok(text) if text.trim_start_matches('\u{feff}').trim().is_empty() => missing(Unreadable::Empty),
            Ok(_) => None,
            Err(e) => {
                let line = 1 + bytes[..e.valid_up_to()].iter().filter(|byte| **byte == b'\n').count();
                missing(Unreadable::NotUtf8 { line })
            }
        },
    }
}

/// One word for the whole: that of the first law that does not hold.
fn outcome(examination: &Examination) -> Outcome {
    if examination.not_started {
        return Outcome::NotStarted;
    }
    if let Some(late) = examination.exhausted {
        return Outcome::TimedOut(late);
    }
    let Some((_, counterexample)) = examination.counterexample() else {
        return if examination.passed() {
            Outcome::Passed
        } else {
            Outcome::GraderError("some laws were not tried, though none failed".to_owned())
        };
    };
    match counterexample.calls.last() {
        Some((_, Reply::Panicked(panic))) => Outcome::Panicked(panic.clone()),
        Some((_, Reply::Lost(Loss::TimedOut(limit)))) => Outcome::TimedOut(*limit),
        Some((_, Reply::Lost(Loss::OutOfMemory))) => Outcome::OutOfMemory,
        Some((_, Reply::Lost(Loss::TooManyThreads))) => Outcome::TooManyThreads,
        Some((_, Reply::Lost(Loss::StackOverflow))) => Outcome::StackOverflow,
        Some((_, Reply::Lost(Loss::Exited(code)))) => Outcome::Exited(*code),
        Some((_, Reply::Lost(Loss::Crashed(how)))) => Outcome::Crashed(how.clone()),
        Some((_, Reply::Value(_))) | None => Outcome::Wrong,
    }
}

fn looks_like(exercise: &Exercise, examination: &Examination) -> Option<LooksLike> {
    diagnose(exercise, &examination.answered).map(|diagnosis| LooksLike {
        misconception: diagnosis.misconception.program.name,
        what: diagnosis.misconception.looks_like,
        help: diagnosis.misconception.help,
        agreeing: diagnosis.agreeing,
        telling: diagnosis.telling,
    })
}
