//! Many files of one exercise compiled into one worker, leaving out those that do not compile.

use std::path::Path;

use course::{Answerer, Exercise};

use crate::compile::{NotCompiled, SourceFile};
use crate::judge::{Judge, Worker};
use crate::judgement::Outcome;
use crate::process::Process;

/// Files of one exercise, compiled into one worker as far as they compile.
pub struct Batch<'a> {
    judge: &'a Judge,
    exercise: &'a Exercise,
    worker: Option<Worker>,
    /// The number of each file's function in the worker; `None` for a file that does not compile.
    places: Vec<Option<u32>>,
}

impl Judge {
    /// Compiles many files of one exercise together, leaving out those that do not compile.
    ///
    /// # Errors
    /// An [`Outcome`] that is no file's doing: no compiler, no room, or a refusal that names none of the files.
    pub fn batch<'a>(&'a self, exercise: &'a Exercise, files: &[&Path]) -> Result<Batch<'a>, Outcome> {
        let parts: Vec<SourceFile<'_>> = files.iter().map(|file| SourceFile { exercise, file }).collect();
        let (worker, left) = self.worker_of_most(&parts).map_err(NotCompiled::outcome)?.unzip();
        let place = |at| left.as_ref()?.iter().position(|it| *it == at).map(|place| place as u32);
        Ok(Batch { judge: self, exercise, worker, places: (0..files.len()).map(place).collect() })
    }
}

impl Batch<'_> {
    /// One who answers for a file's function, in a process of its own; `None` if the file does not compile.
    pub fn answerer(&self, file: usize) -> Option<impl Answerer + use<>> {
        let worker = self.worker.as_ref()?;
        let place = (*self.places.get(file)?)?;
        let launcher = self.judge.sandbox.as_ref();
        Some(Process::new(&worker.program, place, self.exercise, self.judge.limits, launcher))
    }
}
