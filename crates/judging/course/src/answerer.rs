//! Who answers for a student's function?

use std::panic::{self, AssertUnwindSafe};

use worker::wire::Panic;
use worker::{Function, Value};

/// Answers questions, each being the arguments of one call.
pub trait Answerer {
    /// Answers in the questions' order. Where a call does not come back, its [`Reply::Lost`] is the last one, and fewer replies
    /// than questions return; the next `ask` begins afresh.
    ///
    /// # Errors
    /// [`Fault`]: something that is not the student's doing.
    fn ask(&mut self, questions: &[Vec<Value>]) -> Result<Vec<Reply>, Fault>;
}

/// What came of one call.
#[derive(Clone, Debug, PartialEq)]
pub enum Reply {
    /// It returned this.
    Value(Value),
    /// It panicked.
    Panicked(Panic),
    /// It never came back.
    Lost(Loss),
}

/// How a call never came back.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Loss {
    /// It ran for longer than it may.
    TimedOut(Late),
    /// It wanted more memory than it may have.
    OutOfMemory,
    /// It wanted more threads than it may have.
    TooManyThreads,
    /// Its stack was full: it calls itself without end.
    StackOverflow,
    /// It ended the process, with this exit code.
    Exited(i32),
    /// The process was ended: by a signal, or by something that no answer is made of.
    Crashed(String),
}

/// Which limit of time a call reached. Each holds that limit in milliseconds.
///
/// Time spent waiting for a busy processor counts nowhere, so the same program is late on an idle machine and on a busy one.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Late {
    /// The call computed for too long.
    Computing(u64),
    /// The call slept, or waited for something that never came.
    Waiting(u64),
    /// All calls together took too long; no single one of them did.
    Together(u64),
}

/// The values that came back, one for each question; `None` where none did, and for all questions after a call that never came back.
pub fn values(answerer: &mut dyn Answerer, questions: &[Vec<Value>]) -> Vec<Option<Value>> {
    let replies = answerer.ask(questions).unwrap_or_default();
    let value = |reply| if let Reply::Value(value) = reply { Some(value) } else { None };
    let mut values: Vec<Option<Value>> = replies.into_iter().map(value).collect();
    values.resize(questions.len(), None);
    values
}

/// Something that is wrong with the one who judges, never counted against the student.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Fault(pub String);

impl std::fmt::Display for Fault {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(&self.0)
    }
}

impl std::error::Error for Fault {}

/// Answers by a function of ours, in this very process: for solutions and misconceptions, never for a student's code.
#[derive(Clone, Copy, Debug)]
pub struct InProcess(pub Function);

impl InProcess {
    /// The reply to one question.
    ///
    /// # Errors
    /// A [`Fault`] if the arguments are not of the function's types.
    pub fn reply(self, question: &[Value]) -> Result<Reply, Fault> {
        match panic::catch_unwind(AssertUnwindSafe(|| (self.0)(question.to_vec()))) {
            Ok(Ok(value)) => Ok(Reply::Value(value)),
            Ok(Err(mismatch)) => Err(Fault(format!("argument {} is of another type", mismatch.parameter))),
            Err(_) => Ok(Reply::Panicked(Panic {
                message: "a panic".to_owned(),
                file: String::new(),
                line: 0,
                elsewhere: false,
            })),
        }
    }
}

impl Answerer for InProcess {
    fn ask(&mut self, questions: &[Vec<Value>]) -> Result<Vec<Reply>, Fault> {
        questions.iter().map(|question| self.reply(question)).collect()
    }
}
