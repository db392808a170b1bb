//! What does a right answer satisfy, whatever program gave it?

use proptest::strategy::{Strategy, ValueTree};
use proptest::test_runner::{Reason, TestRunner};
use worker::{Plain, Value};

use crate::answerer::{Fault, Reply};

/// How many inputs a law is tried on, unless it says otherwise.
const CASES: u32 = 60;

/// A sentence about a function that every right answer satisfies.
///
/// A law does not know the right answer, or not only: it says what is true of it. So every right program is accepted.
pub struct Law {
    name: &'static str,
    points: u32,
    statement: &'static str,
    help: &'static str,
    cases: u32,
    grow: Box<Grow>,
}

/// Makes one input of a law.
type Grow = dyn Fn(&mut TestRunner) -> Result<Box<dyn Case>, Reason> + Send + Sync;

impl Law {
    /// A law without inputs yet; [`Unbound::over`] gives it some.
    ///
    /// - `name`: short, in snake case: "the_centre_stays".
    /// - `statement`: what is true: "The point p stays where it is: M·p = p."
    /// - `help`: for the one who breaks it: a sentence that points at the cause.
    pub fn of(name: &'static str, points: u32, statement: &'static str, help: &'static str) -> Unbound {
        Unbound { name, points, statement, help }
    }

    /// How many inputs to try.
    #[must_use]
    pub fn cases(mut self, cases: u32) -> Self {
        self.cases = cases;
        self
    }

    /// Its short name.
    pub fn name(&self) -> &'static str {
        self.name
    }

    /// What keeping it is worth.
    pub fn points(&self) -> u32 {
        self.points
    }

    /// What is true.
    pub fn statement(&self) -> &'static str {
        self.statement
    }

    /// What helps the one who breaks it.
    pub fn help(&self) -> &'static str {
        self.help
    }

    pub(crate) fn grow(&self, runner: &mut TestRunner) -> Result<Vec<Box<dyn Case>>, Reason> {
        (0..self.cases).map(|_| (self.grow)(runner)).collect()
    }
}

impl std::fmt::Debug for Law {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("Law").field("name", &self.name).finish_non_exhaustive()
    }
}

/// A law without inputs.
#[derive(Clone, Copy, Debug)]
#[must_use = "a law says nothing before `over`"]
pub struct Unbound {
    name: &'static str,
    points: u32,
    statement: &'static str,
    help: &'static str,
}

impl Unbound {
    /// The law over the inputs of a strategy. `check` asks the function on trial and says whether the law holds; it may ask
    /// several times, and is called anew as answers come in: it must depend on nothing but the input and the answers.
    pub fn over<S>(
        self,
        strategy: S,
        check: impl Fn(&S::Value, &Asker<'_>) -> Result<(), Stop> + Clone + Send + Sync + 'static,
    ) -> Law
    where
        S: Strategy + Send + Sync + 'static,
    {
        let grow = move |runner: &mut TestRunner| {
            let tree = strategy.new_tree(runner)?;
            Ok(Box::new(Grown { tree, check: check.clone() }) as Box<dyn Case>)
        };
        let Self { name, points, statement, help } = self;
        Law { name, points, statement, help, cases: CASES, grow: Box::new(grow) }
    }
}

/// One input of a law, whatever its type, and the way to smaller ones.
pub(crate) trait Case {
    fn check(&self, asker: &Asker<'_>) -> Result<(), Stop>;
    fn simplify(&mut self) -> bool;
    fn complicate(&mut self) -> bool;
}

struct Grown<T, F> {
    tree: T,
    check: F,
}

impl<T: ValueTree, F: Fn(&T::Value, &Asker<'_>) -> Result<(), Stop>> Case for Grown<T, F> {
    fn check(&self, asker: &Asker<'_>) -> Result<(), Stop> {
        (self.check)(&self.tree.current(), asker)
    }

    fn simplify(&mut self) -> bool {
        self.tree.simplify()
    }

    fn complicate(&mut self) -> bool {
        self.tree.complicate()
    }
}

/// What a check asks: the function on trial. Questions without an answer yet stop the check; it is called again when they are in.
#[derive(Debug)]
pub struct Asker<'a> {
    pub(crate) known: &'a [(Vec<Value>, Reply)],
}

impl Asker<'_> {
    /// What the function returns for these arguments.
    ///
    /// # Errors
    /// [`Stop`], to be passed on with `?`.
    pub fn ask<R: Plain>(&self, arguments: Vec<Value>) -> Result<R, Stop> {
        let Some((_, reply)) = self.known.iter().find(|(asked, _)| worker::identical(asked, &arguments))
        else {
            return Err(Stop::Pending(arguments));
        };
        match reply {
            Reply::Value(value) => typed(value),
            unanswered => Err(Stop::Unanswered(unanswered.clone())),
        }
    }
}

/// The answer as the type of the function's result.
///
/// # Errors
/// [`Stop::Broken`] if it is of another type, which only a program gives that writes to the channel of answers itself.
pub(crate) fn typed<R: Plain>(answer: &Value) -> Result<R, Stop> {
    R::from_value(answer.clone()).ok_or_else(|| {
        let what = format!("the answer {answer} is not of the function's type");
        Stop::Broken(Broken { what, values: None })
    })
}

/// Why a check ends before its end.
#[derive(Clone, Debug, PartialEq)]
pub enum Stop {
    /// It asked something that has no answer yet.
    Pending(Vec<Value>),
    /// It asked something, and no value came back.
    Unanswered(Reply),
    /// The law does not hold.
    Broken(Broken),
    /// The law itself is at fault.
    Fault(Fault),
}

/// How a law was broken.
#[derive(Clone, Debug, PartialEq)]
pub struct Broken {
    /// What was looked at: "M·p", "the answer", or a sentence of its own where nothing is compared.
    pub what: String,
    /// What it is, and what it should be.
    pub values: Option<(Value, Value)>,
}

impl std::fmt::Display for Broken {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match &self.values {
            Some((given, wanted)) => write!(f, "{} is {given}, should be {wanted}", self.what),
            None => f.write_str(&self.what),
        }
    }
}

/// Demands that `given` is `wanted`, up to `tolerance` for each number, relative for those above 1. A NaN is never right
/// but where NaN is wanted.
///
/// # Errors
/// [`Stop::Broken`] if it is not.
pub fn close<T: Plain>(what: &str, given: T, wanted: T, tolerance: f32) -> Result<(), Stop> {
    let (given, wanted) = (given.into_value(), wanted.into_value());
    if given.distance(&wanted).is_some_and(|distance| distance <= tolerance) {
        return Ok(());
    }
    Err(Stop::Broken(Broken { what: what.to_owned(), values: Some((given, wanted)) }))
}

/// Demands that something is so; `otherwise` says in a sentence what it is instead.
///
/// # Errors
/// [`Stop::Broken`] if it is not.
pub fn that(so: bool, otherwise: impl FnOnce() -> String) -> Result<(), Stop> {
    if so { Ok(()) } else { Err(Stop::Broken(Broken { what: otherwise(), values: None })) }
}
