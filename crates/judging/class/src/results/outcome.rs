//! What can come of an exercise, in a word?

use serde::{Deserialize, Serialize};

/// The whole in a word.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Outcome {
    /// All laws hold.
    Passed,
    /// A law does not hold.
    Wrong,
    /// Asked the same twice, it answered differently.
    Unsteady,
    /// The code panicked.
    Panicked,
    /// A call did not return in time.
    TimedOut,
    /// It wanted more memory than it may have.
    OutOfMemory,
    /// It wanted more threads than it may have.
    TooManyThreads,
    /// It calls itself without end.
    StackOverflow,
    /// It ended the process.
    Exited,
    /// Its process was ended otherwise, or sent what is no answer.
    Crashed,
    /// Rustc refuses it, or did not come to an end with it.
    DoesNotCompile,
    /// `todo!()` still stands there.
    NotStarted,
    /// There is no such file in the submission.
    Missing,
    /// Nothing is in the file.
    Empty,
    /// The file is no text, or too long.
    Unreadable,
    /// The grader's own fault; a person has to look.
    GraderError,
}

/// What kind of outcome it is: platforms know no finer difference.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// Right.
    Right,
    /// Runs, and gives something wrong.
    Wrong,
    /// Does not compile.
    CompileError,
    /// Ends otherwise than by an answer.
    RuntimeError,
    /// Takes too long.
    TimeLimit,
    /// Takes too much memory.
    MemoryLimit,
    /// Nothing was handed in.
    Absent,
    /// The grader's fault.
    InternalError,
}

impl Outcome {
    /// All of them.
    pub const ALL: [Self; 16] = [
        Self::Passed,
        Self::Wrong,
        Self::Unsteady,
        Self::Panicked,
        Self::TimedOut,
        Self::OutOfMemory,
        Self::TooManyThreads,
        Self::StackOverflow,
        Self::Exited,
        Self::Crashed,
        Self::DoesNotCompile,
        Self::NotStarted,
        Self::Missing,
        Self::Empty,
        Self::Unreadable,
        Self::GraderError,
    ];

    /// As a person says it.
    pub fn word(self) -> &'static str {
        match self {
            Self::Passed => "passed",
            Self::Wrong => "wrong",
            Self::Unsteady => "unsteady",
            Self::Panicked => "panicked",
            Self::TimedOut => "timed out",
            Self::OutOfMemory => "out of memory",
            Self::TooManyThreads => "too many threads",
            Self::StackOverflow => "stack overflow",
            Self::Exited => "exited",
            Self::Crashed => "crashed",
            Self::DoesNotCompile => "does not compile",
            Self::NotStarted => "not started",
            Self::Missing => "missing",
            Self::Empty => "empty",
            Self::Unreadable => "unreadable",
            Self::GraderError => "grader error",
        }
    }

    /// Its kind.
    pub fn kind(self) -> Kind {
        match self {
            Self::Passed => Kind::Right,
            Self::Wrong | Self::Unsteady => Kind::Wrong,
            Self::Panicked | Self::StackOverflow | Self::TooManyThreads | Self::Exited | Self::Crashed => {
                Kind::RuntimeError
            }
            Self::TimedOut => Kind::TimeLimit,
            Self::OutOfMemory => Kind::MemoryLimit,
            Self::DoesNotCompile | Self::Unreadable => Kind::CompileError,
            Self::NotStarted | Self::Missing | Self::Empty => Kind::Absent,
            Self::GraderError => Kind::InternalError,
        }
    }
}
