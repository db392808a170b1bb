//! What is said about a file in the end?

use course::trial::{Counterexample, Outcome as LawOutcome, Tried};
use course::{Exercise, Late, Picture, Reply, Value};
use serde_json::{Value as Json, json};
use worker::wire::Panic;

use crate::captured_output::{CapturedOutput, Output};
use crate::consistency::InconsistentCall;
use crate::token::Token;

/// The judgement of one file.
#[derive(Clone, Debug, PartialEq)]
pub struct Judgement {
    /// The exercise's name.
    pub exercise: &'static str,
    /// Where the file lies in the folder of exercises.
    pub path: String,
    /// The names of the function's parameters.
    pub parameters: &'static [&'static str],
    /// Repeats this judgement.
    pub token: Token,
    /// The whole in a word.
    pub outcome: Outcome,
    /// The points of the laws that hold; none where they are forfeited.
    pub points: u32,
    /// Why laws that hold are worth nothing, if so.
    pub forfeit: Option<Forfeit>,
    /// The points of all laws.
    pub of: u32,
    /// How each law went.
    pub laws: Vec<Tried>,
    /// The misconception that a wrong answer looks like.
    pub looks_like: Option<LooksLike>,
    /// The counterexample, drawn.
    pub picture: Option<Picture>,
    /// What the student's code printed.
    pub printed: CapturedOutput,
}

/// The whole in a word. Whatever can become of a file has its own.
#[derive(Clone, Debug, PartialEq)]
pub enum Outcome {
    /// All laws hold.
    Passed,
    /// A law does not hold.
    Wrong,
    /// The same call was answered in two ways.
    Unsteady(Box<InconsistentCall>),
    /// It panicked.
    Panicked(Panic),
    /// A call, or all of them together, took longer than they may.
    TimedOut(Late),
    /// It wanted more memory than it may have.
    OutOfMemory,
    /// It wanted more threads than it may have.
    TooManyThreads,
    /// It calls itself without end.
    StackOverflow,
    /// It ended the process, with this exit code.
    Exited(i32),
    /// Its process was ended otherwise.
    Crashed(String),
    /// Rustc refuses it.
    DoesNotCompile {
        /// As rustc prints it.
        message: String,
        /// What rustc cannot know.
        note: Option<String>,
    },
    /// `todo!()` still stands there.
    NotStarted,
    /// Nothing that could be compiled.
    Unreadable(Unreadable),
    /// An exercise that comes first has not passed.
    Blocked {
        /// Its name.
        by: &'static str,
    },
    /// The grader's own error; never counted against the student.
    GraderError(String),
}

/// Why laws that hold are worth nothing.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Forfeit {
    /// The function does not depend on its arguments alone.
    Unsteady,
    /// The function ended its process, or sent what is no answer.
    Ended,
    /// The function gives one answer to nearly every call, and keeps no law that this answer alone would not keep.
    Constant,
}

impl Forfeit {
    /// In a sentence.
    pub fn sentence(self) -> &'static str {
        match self {
            Self::Unsteady => {
                "No points: laws that hold for a function that changes its answers say nothing about it."
            }
            Self::Ended => {
                "No points: an exercise returns a value, and leaves the process that runs it alone."
            }
            Self::Constant => {
                "No points: the answer is nearly always the same, and the laws that hold would hold if it always were."
            }
        }
    }
}

/// Why a file cannot even be compiled.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Unreadable {
    /// It is not there.
    Missing,
    /// It is a folder, or something else that is not a file.
    NotAFile,
    /// Nothing is in it.
    Empty,
    /// It is no text.
    NotUtf8 {
        /// The first line with something else.
        line: usize,
    },
    /// It is over a MiB long.
    TooLong,
    /// The system does not let it be read.
    Io(String),
}

/// A misconception, and how sure it is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct LooksLike {
    /// Its short name.
    pub misconception: &'static str,
    /// To be read after "This looks like: ".
    pub what: &'static str,
    /// What would help.
    pub help: &'static str,
    /// On so many inputs the answers are the misconception's…
    pub agreeing: usize,
    /// …of so many on which that one is not right.
    pub telling: usize,
}

impl Outcome {
    /// A short name for machines and for the board.
    pub fn word(&self) -> &'static str {
        match self {
            Self::Passed => "passed",
            Self::Wrong => "wrong",
            Self::Unsteady(_) => "unsteady",
            Self::Panicked(_) => "panicked",
            Self::TimedOut(_) => "timed out",
            Self::OutOfMemory => "out of memory",
            Self::TooManyThreads => "too many threads",
            Self::StackOverflow => "stack overflow",
            Self::Exited(_) => "exited",
            Self::Crashed(_) => "crashed",
            Self::DoesNotCompile { .. } => "does not compile",
            Self::NotStarted => "not started",
            Self::Unreadable(Unreadable::Missing) => "missing",
            Self::Unreadable(Unreadable::Empty) => "empty",
            Self::Unreadable(_) => "unreadable",
            Self::Blocked { .. } => "blocked",
            Self::GraderError(_) => "grader error",
        }
    }

    /// What happened, in a sentence or two; nothing where the laws say it all.
    pub fn sentence(&self) -> Option<String> {
        Some(match self {
            Self::Passed | Self::Wrong => return None,
            Self::Unsteady(twice) => format!(
                "The same call gave {}, and when it was asked again {}. A solution depends on its arguments alone: not on what was asked before, on \
                 time or on chance.",
                twice.first,
                gave(&twice.again)
            ),
            Self::Panicked(panic) => panicked(panic),
            Self::TimedOut(late) => timed_out(*late),
            Self::OutOfMemory => "The call below asked for more memory than any exercise needs.".to_owned(),
            Self::TooManyThreads => "The call below started more threads than any exercise needs.".to_owned(),
            Self::StackOverflow => {
                "The call below filled its stack: a function calls itself without end.".to_owned()
            }
            Self::Exited(code) => {
                format!(
                    "The call below ended the whole program with exit code {code}: an exercise returns a value."
                )
            }
            Self::Crashed(how) => format!("The call below ended the program: {how}."),
            Self::DoesNotCompile { .. } => "Rust does not accept the file; the compiler says why.".to_owned(),
            Self::NotStarted => "`todo!()` still stands where the solution goes.".to_owned(),
            Self::Unreadable(why) => unreadable(why),
            Self::Blocked { by } => format!("Comes after {by}, which has not passed yet."),
            Self::GraderError(what) => {
                format!("Something is wrong with the grader, not with the file: {what}. It costs no points.")
            }
        })
    }
}

fn timed_out(late: Late) -> String {
    let seconds = |limit: u64| limit as f64 / 1e3;
    match late {
        Late::Computing(limit) => format!(
            "No answer to the call below after {} s of computing: is there a loop without end?",
            seconds(limit)
        ),
        Late::Waiting(limit) => format!(
            "No answer to the call below after {} s, most of which it waited: an exercise computes, and waits for nothing.",
            seconds(limit)
        ),
        Late::Together(limit) => format!(
            "All calls together took more than {} s of computing and waiting, though no single one took too long.",
            seconds(limit)
        ),
    }
}

fn panicked(panic: &Panic) -> String {
    let at = if panic.file.is_empty() { String::new() } else { format!(" at {}:{}", panic.file, panic.line) };
    let thread = if panic.elsewhere { ", in a thread of its own" } else { "" };
    format!("The code panicked{at}{thread}: {}", panic.message)
}

fn unreadable(why: &Unreadable) -> String {
    match why {
        Unreadable::Missing => "There is no such file; `cargo lab reset` brings it back.".to_owned(),
        Unreadable::NotAFile => "That is not a file.".to_owned(),
        Unreadable::Empty => "The file is empty; `cargo lab reset` brings the task back.".to_owned(),
        Unreadable::NotUtf8 { line } => {
            format!("Line {line} is not UTF-8 text: save the file with that encoding.")
        }
        Unreadable::TooLong => "The file is over one MiB long: that is no solution.".to_owned(),
        Unreadable::Io(error) => format!("The file cannot be read: {error}."),
    }
}

impl Judgement {
    pub(crate) fn blank(exercise: &Exercise, token: Token) -> Self {
        Self {
            exercise: exercise.name,
            path: exercise.path(),
            parameters: exercise.signature.parameters,
            token,
            outcome: Outcome::NotStarted,
            points: 0,
            forfeit: None,
            of: exercise.points(),
            laws: Vec::new(),
            looks_like: None,
            picture: None,
            printed: CapturedOutput::default(),
        }
    }

    /// That an exercise was not judged, because one that comes first has not passed.
    pub fn blocked(exercise: &Exercise, seed: u64, by: &'static str) -> Self {
        Self { outcome: Outcome::Blocked { by }, ..Self::blank(exercise, Token::new(exercise, seed)) }
    }

    /// A file in which nothing has been done yet, seen without compiling it.
    pub fn not_started(exercise: &Exercise, seed: u64) -> Self {
        Self::blank(exercise, Token::new(exercise, seed))
    }

    /// Whether all laws hold.
    pub fn passed(&self) -> bool {
        self.outcome == Outcome::Passed
    }

    /// The counterexample to show, and the law it breaks.
    pub fn counterexample(&self) -> Option<(&Tried, &Counterexample)> {
        course::trial::counterexample(&self.laws)
    }

    /// A call as a person would write it: `rotate_about_point(theta = 1.5, p = (1, 2))`.
    pub fn call(&self, arguments: &[Value]) -> String {
        let arguments: Vec<String> = self
            .parameters
            .iter()
            .zip(arguments)
            .map(|(parameter, argument)| format!("{parameter} = {argument}"))
            .collect();
        format!("{}({})", self.exercise, arguments.join(", "))
    }

    /// For machines. Without what differs from run to run.
    pub fn json(&self) -> Json {
        json!({
            "exercise": self.exercise,
            "path": self.path,
            "token": self.token.to_string(),
            "outcome": self.outcome.word(),
            "sentence": self.outcome.sentence(),
            "compiler": compiler(&self.outcome),
            "points": self.points,
            "of": self.of,
            "forfeit": self.forfeit.map(Forfeit::sentence),
            "laws": self.laws.iter().map(|law| self.law_json(law)).collect::<Vec<_>>(),
            "looks_like": self.looks_like.map(|it| json!({
                "misconception": it.misconception,
                "what": it.what,
                "help": it.help,
                "agreeing": it.agreeing,
                "telling": it.telling,
            })),
            "printed": { "out": printed(&self.printed.out), "err": printed(&self.printed.err) },
        })
    }

    fn law_json(&self, law: &Tried) -> Json {
        let mut json = json!({ "name": law.name, "statement": law.statement, "points": law.points });
        json["outcome"] = match &law.outcome {
            LawOutcome::Kept(inputs) => json!({ "kept": inputs }),
            LawOutcome::NotRun => json!("not run"),
            LawOutcome::Failed(counterexample) => json!({ "failed": {
                "example": counterexample.example,
                "calls": counterexample.calls.iter().map(|(arguments, reply)| json!({
                    "call": self.call(arguments),
                    "gave": gave(reply),
                })).collect::<Vec<_>>(),
                "broken": counterexample.broken.as_ref().map(ToString::to_string),
                "help": counterexample.help,
            }}),
        };
        json
    }
}

/// What came of a call, in words.
pub fn gave(reply: &Reply) -> String {
    match reply {
        Reply::Value(value) => value.to_string(),
        Reply::Panicked(panic) => format!("a panic: {}", panic.message),
        Reply::Lost(_) => "no answer".to_owned(),
    }
}

fn compiler(outcome: &Outcome) -> Json {
    if let Outcome::DoesNotCompile { message, note } = outcome {
        json!({ "message": message, "note": note })
    } else {
        Json::Null
    }
}

fn printed(output: &Output) -> Json {
    json!({ "text": output.text, "dropped": output.dropped })
}
