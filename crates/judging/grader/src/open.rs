//! How is a student's function asked something else than its laws? To draw with it, say.

use std::path::Path;
use std::time::Duration;

use course::{Answerer, Exercise, Fault, Reply, Value};
use sandbox::Launcher;

use crate::compile::Part;
use crate::judge::{Judge, Worker, bytes_of, unreadable};
use crate::judgement::Outcome;
use crate::process::{Limits, Process};

/// A student's function, compiled, to be asked as often as one likes. The program goes with it.
#[derive(Debug)]
pub struct Opened {
    worker: Worker,
    exercise: &'static Exercise,
    limits: Limits,
    launcher: Option<Launcher>,
}

/// A conversation with a student's function, in a process of its own that ends with it. The first question starts it; after a call that did
/// not come back the next question starts another.
#[derive(Debug)]
pub struct Asked<'a> {
    process: Process,
    /// The program must stay until its process has ended.
    _worker: &'a Worker,
}

impl Judge {
    /// Compiles one file, to ask its function whatever one likes.
    ///
    /// # Errors
    /// What [`Judge::judge`] would say of a file that cannot be asked: it cannot be read, it does not compile, or the grader is at fault. A
    /// file as it was handed out is not started, which is seen without compiling it.
    pub fn open(&self, exercise: &'static Exercise, file: &Path) -> Result<Opened, Outcome> {
        if let Some(outcome) = unreadable(file) {
            return Err(outcome);
        }
        if bytes_of(file).is_some_and(|bytes| exercise.is_untouched(&bytes)) {
            return Err(Outcome::NotStarted);
        }
        let worker = self.worker(&[Part { exercise, file }]).map_err(|error| error.outcome())?;
        Ok(Opened { worker, exercise, limits: self.limits, launcher: self.sandbox.clone() })
    }
}

impl Opened {
    /// A conversation from now on: the limit on all calls together begins with it.
    pub fn ask(&self) -> Asked<'_> {
        self.ask_within(self.limits)
    }

    /// The same, each call and all together limited to this time.
    pub fn ask_for(&self, whole: Duration) -> Asked<'_> {
        self.ask_within(Limits { time: self.limits.time.min(whole), whole, ..self.limits })
    }

    fn ask_within(&self, limits: Limits) -> Asked<'_> {
        let process = Process::new(&self.worker.program, 0, self.exercise, limits, self.launcher.as_ref());
        Asked { process, _worker: &self.worker }
    }

    /// The compiled program.
    pub fn program(&self) -> &Path {
        &self.worker.program
    }

    /// The exercise whose function it is.
    pub fn exercise(&self) -> &'static Exercise {
        self.exercise
    }
}

impl Answerer for Asked<'_> {
    fn ask(&mut self, questions: &[Vec<Value>]) -> Result<Vec<Reply>, Fault> {
        self.process.ask(questions)
    }
}
