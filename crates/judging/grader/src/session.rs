//! Calls to a student's function outside of its laws, for example to draw with it.

use std::path::Path;
use std::time::Duration;

use course::{Answerer, Exercise, Fault, Reply, Value};
use sandbox::Launcher;

use crate::compile::SourceFile;
use crate::judge::{Judge, Worker, bytes_of, unreadable};
use crate::judgement::Outcome;
use crate::process::{Limits, Process};

/// A student's compiled function, which can be called any number of times. The program is deleted when this is dropped.
#[derive(Debug)]
pub struct CompiledFunction {
    worker: Worker,
    exercise: &'static Exercise,
    limits: Limits,
    launcher: Option<Launcher>,
}

/// A session with a student's function in a process of its own. The first call starts the process; after a call that did not return, the
/// next call starts another. The process ends when the session is dropped.
#[derive(Debug)]
pub struct Session<'a> {
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
    pub fn open(&self, exercise: &'static Exercise, file: &Path) -> Result<CompiledFunction, Outcome> {
        if let Some(outcome) = unreadable(file) {
            return Err(outcome);
        }
        if bytes_of(file).is_some_and(|bytes| exercise.is_untouched(&bytes)) {
            return Err(Outcome::NotStarted);
        }
        let worker = self.worker(&[SourceFile { exercise, file }]).map_err(|error| error.outcome())?;
        Ok(CompiledFunction { worker, exercise, limits: self.limits, launcher: self.sandbox.clone() })
    }
}

impl CompiledFunction {
    /// A conversation from now on: the limit on all calls together begins with it.
    pub fn ask(&self) -> Session<'_> {
        self.ask_within(self.limits)
    }

    /// The same, each call and all together limited to this time.
    pub fn ask_for(&self, whole: Duration) -> Session<'_> {
        self.ask_within(Limits { time: self.limits.time.min(whole), whole, ..self.limits })
    }

    fn ask_within(&self, limits: Limits) -> Session<'_> {
        let process = Process::new(&self.worker.program, 0, self.exercise, limits, self.launcher.as_ref());
        Session { process, _worker: &self.worker }
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

impl Answerer for Session<'_> {
    fn ask(&mut self, questions: &[Vec<Value>]) -> Result<Vec<Reply>, Fault> {
        self.process.ask(questions)
    }
}
