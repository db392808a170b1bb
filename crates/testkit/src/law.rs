//! What does a law say, on how many inputs was it tried, and of which kinds were they?

use std::cell::RefCell;
use std::collections::BTreeMap;
use std::fmt::Debug;

use proptest::strategy::Strategy;
use proptest::test_runner::{Config, RngSeed, TestCaseError, TestError, TestRunner};

use crate::effort::effort;
use crate::fingerprint::fingerprint;

/// What checking one input gives: `Ok`, or how the law failed. The macros `prop_assert!` and friends return it.
pub type Outcome = Result<(), TestCaseError>;

/// A sentence that must hold for every input of a strategy.
///
/// The inputs are the same in every run: the seed comes from the sentence. The environment variable
/// `PROPTEST_RNG_SEED` chooses other ones, `PROPTEST_CASES` another number of them. With [`NIGHTLY`](crate::NIGHTLY) set, a law is
/// tried on [`Law::NIGHTLY_FACTOR`] times as many inputs.
///
/// [`Law::demand`] asks for coverage: of all inputs tried, at least the given share must fall in a class. A law about
/// rays that hit says little if one ray in a thousand does.
#[derive(Clone, Debug)]
#[must_use = "a law says nothing before `holds_for`"]
pub struct Law {
    sentence: String,
    cases: u32,
    demands: Vec<(&'static str, f64)>,
}

/// The classes that the inputs of a law fell into; handed to the check, which names them.
#[derive(Debug, Default)]
pub struct Classes {
    counts: RefCell<BTreeMap<&'static str, u32>>,
}

impl Classes {
    /// Counts the input as one of the class `name` if `belongs`.
    pub fn class(&self, name: &'static str, belongs: bool) {
        *self.counts.borrow_mut().entry(name).or_default() += u32::from(belongs);
    }

    /// Adds what one accepted input was counted as.
    fn add(&self, input: &Self) {
        for (name, count) in input.counts.borrow().iter() {
            *self.counts.borrow_mut().entry(name).or_default() += count;
        }
    }
}

impl Law {
    /// The number of inputs unless [`Law::cases`] says otherwise.
    pub const CASES: u32 = 256;

    /// How many times more inputs the nightly script tries.
    pub const NIGHTLY_FACTOR: u32 = 16;

    /// A law, by the sentence that it states.
    pub fn new(sentence: &str) -> Self {
        Self { sentence: sentence.to_owned(), cases: Self::CASES, demands: Vec::new() }
    }

    /// How many inputs to try.
    pub fn cases(mut self, cases: u32) -> Self {
        self.cases = cases;
        self
    }

    /// Demands that at least `share` (0 to 1) of the inputs fall in the class `name`.
    pub fn demand(mut self, name: &'static str, share: f64) -> Self {
        self.demands.push((name, share));
        self
    }

    /// Tries the law.
    ///
    /// # Panics
    /// If an input breaks it: with the sentence, the smallest such input that shrinking found, and the reason. If the
    /// inputs miss a demanded share: with the share of every class. If a demanded class is never named by the check.
    pub fn holds_for<S>(&self, strategy: S, check: impl Fn(S::Value, &Classes) -> Outcome)
    where
        S: Strategy,
        S::Value: Debug,
    {
        if let Err(failure) = self.verdict(strategy, check) {
            panic!("{failure}");
        }
    }

    /// Tries the law and returns why it fails instead of panicking: for programs that report laws, such as a grader.
    ///
    /// # Errors
    /// [`Failure`]: a counterexample or missing coverage.
    pub fn verdict<S>(
        &self,
        strategy: S,
        check: impl Fn(S::Value, &Classes) -> Outcome,
    ) -> Result<(), Failure>
    where
        S: Strategy,
        S::Value: Debug,
    {
        let config = self.config();
        let cases = config.cases;
        // Only inputs that the check accepts count: one that `prop_assume!` turns down was never interesting. Shrinking tries
        // further inputs after a failure; then nobody asks for coverage any more.
        let classes = Classes::default();
        let counted = |input| {
            let of_input = Classes::default();
            check(input, &of_input)?;
            classes.add(&of_input);
            Ok(())
        };
        match TestRunner::new(config).run(&strategy, counted) {
            Ok(()) => self.check_coverage(&classes, cases),
            Err(TestError::Fail(reason, input)) => Err(Failure::Counterexample {
                law: self.sentence.clone(),
                input: format!("{input:#?}"),
                reason: reason.message().to_owned(),
            }),
            Err(TestError::Abort(reason)) => {
                Err(Failure::Aborted { law: self.sentence.clone(), reason: reason.message().to_owned() })
            }
        }
    }

    fn config(&self) -> Config {
        let from_environment = Config::default();
        let mut config = from_environment.clone();
        if std::env::var_os("PROPTEST_CASES").is_none() {
            config.cases = self.cases.saturating_mul(effort(1, Self::NIGHTLY_FACTOR));
        }
        if matches!(from_environment.rng_seed, RngSeed::Random) {
            config.rng_seed = RngSeed::Fixed(fingerprint(self.sentence.bytes()));
        }
        // The seed is fixed: a failing input comes back by itself, without a file that remembers it.
        config.failure_persistence = None;
        config
    }

    fn check_coverage(&self, classes: &Classes, cases: u32) -> Result<(), Failure> {
        let counts = classes.counts.borrow();
        let share = |name: &str| counts.get(name).map(|count| f64::from(*count) / f64::from(cases));
        let met = |(name, demanded): &(&str, f64)| share(name).is_some_and(|share| share >= *demanded);
        if self.demands.iter().all(met) {
            return Ok(());
        }
        let table = self.demands.iter().map(|(name, demanded)| match share(name) {
            Some(share) => format!("  {name}: {:.1} %, demanded {:.1} %\n", 100.0 * share, 100.0 * demanded),
            None => format!("  {name}: the check never names this class\n"),
        });
        Err(Failure::Coverage { law: self.sentence.clone(), cases, table: table.collect() })
    }
}

/// Why a law does not hold.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Failure {
    /// An input on which the law fails, the smallest that shrinking found.
    Counterexample {
        /// The law's sentence.
        law: String,
        /// The input, printed by `Debug`.
        input: String,
        /// What the check said.
        reason: String,
    },
    /// No counterexample, but too few interesting inputs.
    Coverage {
        /// The law's sentence.
        law: String,
        /// How many inputs were tried.
        cases: u32,
        /// One line a demanded class: its share and what was demanded.
        table: String,
    },
    /// The strategy gave no inputs: it rejected too many.
    Aborted {
        /// The law's sentence.
        law: String,
        /// What proptest said.
        reason: String,
    },
}

impl std::fmt::Display for Failure {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Self::Counterexample { law, input, reason } => {
                write!(f, "law broken: {law}\nbecause: {reason}\nsmallest input found: {input}")
            }
            Self::Coverage { law, cases, table } => {
                write!(f, "law not tested well enough: {law}\nof {cases} inputs\n{table}")
            }
            Self::Aborted { law, reason } => write!(f, "law without inputs: {law}\nbecause: {reason}"),
        }
    }
}

impl std::error::Error for Failure {}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prop_assert;

    #[test]
    fn a_false_law_is_refuted_by_its_smallest_counterexample() {
        let failure = Law::new("every number is below 700").verdict(0..1000_u32, |n, _| {
            prop_assert!(n < 700);
            Ok(())
        });
        let Err(Failure::Counterexample { input, .. }) = failure else { panic!("not refuted: {failure:?}") };
        assert_eq!(input, "700");
    }

    #[test]
    fn a_true_law_without_interesting_inputs_is_refused() {
        let law = Law::new("an even number is even").demand("even", 0.5);
        let odd_only = (0..500_u32).prop_map(|n| 2 * n + 1);
        let failure = law.verdict(odd_only, |n, seen| {
            seen.class("even", n.is_multiple_of(2));
            Ok(())
        });
        assert!(matches!(failure, Err(Failure::Coverage { .. })), "{failure:?}");
    }

    #[test]
    fn a_demanded_class_that_is_never_named_is_refused() {
        let failure = Law::new("nothing").demand("hit", 0.0).verdict(0..9_u32, |_, _| Ok(()));
        assert!(matches!(failure, Err(Failure::Coverage { .. })), "{failure:?}");
    }

    #[test]
    fn an_input_that_was_turned_down_covers_nothing() {
        let law = Law::new("small numbers are small").demand("large", 0.1);
        let failure = law.verdict(0..100_u32, |n, seen| {
            seen.class("large", n >= 50);
            proptest::prop_assume!(n < 50);
            Ok(())
        });
        assert!(matches!(failure, Err(Failure::Coverage { .. })), "{failure:?}");
    }

    #[test]
    fn the_same_law_sees_the_same_inputs_again() {
        let inputs = || {
            let seen = RefCell::new(Vec::new());
            Law::new("remember").holds_for(0..u64::MAX, |n, _| {
                seen.borrow_mut().push(n);
                Ok(())
            });
            seen.into_inner()
        };
        assert_eq!(inputs(), inputs());
    }
}
