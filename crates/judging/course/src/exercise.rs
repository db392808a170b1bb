//! What is an exercise?

use std::cell::RefCell;

use worker::{Function, Plain, Value};

use crate::answerer::{Answerer, InProcess, values};
use crate::concept::Concept;
use crate::law::{Law, Stop, close};

/// All there is to know of one exercise. Each stands in a file of its name; a value of this type is made there with every
/// field written out, so that the compiler says what is missing.
#[derive(Debug)]
pub struct Exercise {
    /// Its name: that of the function, and of the file without `.rs`.
    pub name: &'static str,
    /// The concept, and the folder.
    pub concept: Concept,
    /// The lecture's items that it is about: "L10", "L31, E3".
    pub items: &'static str,
    /// Its title.
    pub title: Title,
    /// Exercises to do before this one.
    pub prerequisites: &'static [&'static str],
    /// The student's file as it is handed out: the task in its doc comment, the signature, `todo!()`.
    pub stub: &'static str,
    /// What the function takes and gives.
    pub signature: Signature,
    /// Three hints, each saying more than the one before.
    pub hints: [&'static str; 3],
    /// Worked examples, the lecture's own where there are any; together they are worth [`Exercise::EXAMPLE_POINTS`].
    pub examples: Vec<Example>,
    /// What every right answer satisfies.
    pub laws: Vec<Law>,
    /// The slide's solution.
    pub reference: Program,
    /// Other right solutions, built differently.
    pub variants: Vec<Program>,
    /// Wrong programs that people write.
    pub misconceptions: Vec<Misconception>,
    /// What to know once it is done.
    pub explanation: &'static str,
    /// Draws a counterexample.
    pub draw: fn(&Seen<'_>) -> Option<Picture>,
    /// The text of the exercise's file, where the solutions are read from.
    pub source: &'static str,
}

impl Exercise {
    /// What the worked examples of an exercise are worth together.
    pub const EXAMPLE_POINTS: u32 = 1;

    /// What a right answer gets.
    pub fn points(&self) -> u32 {
        Self::EXAMPLE_POINTS + self.laws.iter().map(Law::points).sum::<u32>()
    }

    /// Draws a call: what it was asked and gave, and what the reference gives. `yours` answers further calls of the same function, for
    /// pictures that take more than one. `None` where there is nothing to draw.
    pub fn picture(
        &self,
        arguments: &[Value],
        given: Option<&Value>,
        yours: &mut dyn Answerer,
    ) -> Option<Picture> {
        let mut reference = InProcess(self.reference.function);
        let right = values(&mut reference, &[arguments.to_vec()]).pop()??;
        let yours = RefCell::new(yours);
        let seen = Seen {
            arguments,
            given,
            right: &right,
            yours: &|questions| values(&mut **yours.borrow_mut(), questions),
            reference: &|questions| values(&mut InProcess(self.reference.function), questions),
        };
        (self.draw)(&seen)
    }

    /// Whether these are the bytes of the file as it was handed out, but for the ends of lines and a byte order mark.
    pub fn is_untouched(&self, bytes: &[u8]) -> bool {
        let bytes = bytes.strip_prefix(b"\xef\xbb\xbf").unwrap_or(bytes);
        bytes.iter().filter(|byte| **byte != b'\r').eq(self.stub.as_bytes())
    }

    /// Where the student's file lies in the folder of exercises: "transforms/rotate_about_point.rs".
    pub fn path(&self) -> String {
        format!("{}/{}.rs", self.concept.name(), self.name)
    }
}

/// In the lecture's two languages.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Title {
    /// For the command line and the reports.
    pub english: &'static str,
    /// As the slides would say it.
    pub dutch: &'static str,
}

/// What a function takes and gives.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Signature {
    /// Its parameters' names.
    pub parameters: &'static [&'static str],
    /// As it is written in Rust: "(theta: f32, p: Vec2) -> Mat3".
    pub text: &'static str,
}

/// A solution, right or wrong: a function of the exercise's file.
#[derive(Clone, Copy, Debug)]
pub struct Program {
    /// The name of the function in that file.
    pub name: &'static str,
    /// The function itself.
    pub function: Function,
}

/// A wrong program that people write, and what would help them.
#[derive(Clone, Copy, Debug)]
pub struct Misconception {
    /// The wrong program.
    pub program: Program,
    /// What it looks like, to be read after "This looks like": "the point is not moved back".
    pub looks_like: &'static str,
    /// The sentence that would help.
    pub help: &'static str,
}

/// A call whose answer is known.
pub struct Example {
    /// Where it comes from or what it shows.
    pub caption: &'static str,
    /// What the function is called with.
    pub arguments: Vec<Value>,
    /// A right answer.
    pub answer: Value,
    /// How far each number may be off, relative for those above 1; `None` where there are several right answers.
    pub tolerance: Option<f32>,
    check: Box<Check>,
}

/// Says whether an answer is right.
type Check = dyn Fn(&Value) -> Result<(), Stop> + Send + Sync;

impl Example {
    /// An example with one right answer, up to a `tolerance` for each number (relative for those above 1).
    pub fn new(
        caption: &'static str,
        arguments: Vec<Value>,
        answer: impl worker::Plain,
        tolerance: f32,
    ) -> Self {
        let answer = answer.into_value();
        let wanted = answer.clone();
        let check = move |given: &Value| close("the answer", given.clone(), wanted.clone(), tolerance);
        Self { caption, arguments, answer, tolerance: Some(tolerance), check: Box::new(check) }
    }

    /// An example with several right answers, of which `answer` is one.
    pub fn with_check(
        caption: &'static str,
        arguments: Vec<Value>,
        answer: impl worker::Plain,
        check: impl Fn(&Value) -> Result<(), Stop> + Send + Sync + 'static,
    ) -> Self {
        Self { caption, arguments, answer: answer.into_value(), tolerance: None, check: Box::new(check) }
    }

    /// Whether this answer is right.
    ///
    /// # Errors
    /// [`Stop::Broken`] with what is wrong.
    pub fn check(&self, given: &Value) -> Result<(), Stop> {
        (self.check)(given)
    }
}

impl std::fmt::Debug for Example {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("Example").field("caption", &self.caption).finish_non_exhaustive()
    }
}

/// A call to draw: what went in, what came out, what should have.
#[derive(Clone, Copy)]
pub struct Seen<'a> {
    /// The arguments.
    pub arguments: &'a [Value],
    /// The student's answer, if there was one.
    pub given: Option<&'a Value>,
    /// The reference's answer.
    pub right: &'a Value,
    /// Further calls of the student's function, many at once, for pictures that take more than one; `None` where no value came back.
    pub yours: &'a Calls<'a>,
    /// The same of the reference.
    pub reference: &'a Calls<'a>,
}

impl Seen<'_> {
    /// An argument by its place, if it is of this type.
    pub(crate) fn argument<T: Plain>(&self, at: usize) -> Option<T> {
        T::from_value(self.arguments.get(at)?.clone())
    }

    /// The student's answer, if there is one of this type.
    pub(crate) fn given_as<T: Plain>(&self) -> Option<T> {
        T::from_value(self.given?.clone())
    }

    /// The reference's answer.
    pub(crate) fn right_as<T: Plain>(&self) -> Option<T> {
        T::from_value(self.right.clone())
    }
}

/// Calls a function with many lists of arguments.
pub type Calls<'a> = dyn Fn(&[Vec<Value>]) -> Vec<Option<Value>> + 'a;

/// A counterexample, drawn.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Picture {
    /// A file of its own: SVG.
    pub svg: String,
    /// The same for a terminal, if it is small enough: lines of at most 76 characters, without colours.
    pub text: Option<String>,
}

/// Declares an exercise's signature: the constant `SIGNATURE`, and a macro `program!` that takes functions of that
/// signature by name.
macro_rules! signature {
    (($($parameter:ident: $type:ty),* $(,)?) -> $answer:ty) => {
        const SIGNATURE: $crate::Signature = $crate::Signature {
            parameters: &[$(stringify!($parameter)),*],
            text: concat!("(", $(stringify!($parameter), ": ", stringify!($type), ", ",)* ") -> ", stringify!($answer)),
        };

        macro_rules! program {
            ($name:ident) => {
                $crate::Program {
                    name: stringify!($name),
                    function: worker::function!($name, ($($parameter: $type),*) -> $answer),
                }
            };
        }
    };
}

/// The arguments of a call, as values.
#[macro_export]
macro_rules! arguments {
    ($($argument:expr),* $(,)?) => { ::std::vec![$($crate::Plain::into_value($argument)),*] };
}

pub(crate) use {arguments, signature};
