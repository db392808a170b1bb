//! Many files of one exercise, of which some may not compile: which do, and what do they answer? One worker for all of them.

use std::path::Path;

use course::{Answerer, Exercise};

use crate::compile::{NotCompiled, Part};
use crate::judge::{Judge, Worker};
use crate::judgement::Outcome;
use crate::process::Process;

/// Files compiled into one worker, but for those that do not compile.
pub struct Crowd<'a> {
    judge: &'a Judge,
    exercise: &'a Exercise,
    worker: Option<Worker>,
    /// The place of each file's function in the worker.
    places: Vec<Option<u32>>,
}

impl Judge {
    /// Compiles many files of one exercise together, but for those that do not compile.
    ///
    /// # Errors
    /// An [`Outcome`] that is no file's doing: no compiler, no room, or a refusal that names none of the files.
    pub fn crowd<'a>(&'a self, exercise: &'a Exercise, files: &[&Path]) -> Result<Crowd<'a>, Outcome> {
        let parts: Vec<Part<'_>> = files.iter().map(|file| Part { exercise, file }).collect();
        let (worker, left) = self.worker_of_most(&parts).map_err(NotCompiled::outcome)?.unzip();
        let place = |at| left.as_ref()?.iter().position(|it| *it == at).map(|place| place as u32);
        Ok(Crowd { judge: self, exercise, worker, places: (0..files.len()).map(place).collect() })
    }
}

impl Crowd<'_> {
    /// One who answers for a file's function, in a process of its own; `None` if the file does not compile.
    pub fn answerer(&self, file: usize) -> Option<impl Answerer + use<>> {
        let worker = self.worker.as_ref()?;
        let place = (*self.places.get(file)?)?;
        let launcher = self.judge.sandbox.as_ref();
        Some(Process::new(&worker.program, place, self.exercise, self.judge.limits, launcher))
    }
}
