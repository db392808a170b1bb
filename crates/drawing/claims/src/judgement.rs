//! How does a run come to a verdict?

use sheet::Words;

/// What is to be thought of a sentence.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Verdict {
    /// True for every input that was tried.
    Holds,
    /// True where the condition holds, and not always elsewhere.
    HoldsIf(&'static str),
    /// Not true, and no condition that the slide could have meant saves it.
    Refuted,
}

impl Verdict {
    /// "holds", "holds if …" or "refuted". The condition is English in both languages.
    #[must_use]
    pub fn in_words(self) -> Words {
        match self {
            Self::Holds => Words::new("holds", "klopt"),
            Self::HoldsIf(condition) => {
                Words::new(format!("holds if {condition}"), format!("klopt als: {condition}"))
            }
            Self::Refuted => Words::new("refuted", "weerlegd"),
        }
    }

    /// The same in one word, by which a style sheet colours it.
    #[must_use]
    pub fn class(self) -> &'static str {
        match self {
            Self::Holds => "holds",
            Self::HoldsIf(_) => "partly",
            Self::Refuted => "refuted",
        }
    }
}

impl std::fmt::Display for Verdict {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Self::Holds => f.write_str("holds"),
            Self::HoldsIf(condition) => write!(f, "holds if {condition}"),
            Self::Refuted => f.write_str("refuted"),
        }
    }
}

/// The sentence tried on one input.
#[derive(Clone, Debug, PartialEq)]
pub struct Trial {
    /// Whether the sentence was true of it.
    pub holds: bool,
    /// Whether the condition, if there is one, was met; `true` where there is none.
    pub meets_condition: bool,
    /// The input and what came out, in numbers.
    pub numbers: String,
}

impl Trial {
    /// A trial of a sentence without a condition.
    pub fn new(holds: bool, numbers: impl Into<String>) -> Self {
        Self::under(true, holds, numbers)
    }

    /// A trial of a sentence with a condition, which this input meets or not.
    pub fn under(meets_condition: bool, holds: bool, numbers: impl Into<String>) -> Self {
        Self { holds, meets_condition, numbers: numbers.into() }
    }
}

/// What backs a verdict.
#[derive(Clone, Debug, PartialEq)]
pub enum Evidence {
    /// The sentence held in each of so many trials.
    Law {
        /// What held.
        sentence: String,
        /// In how many trials.
        trials: usize,
    },
    /// Numbers for which the sentence is false.
    Counterexample {
        /// Input, the slide's result, and the right one.
        numbers: String,
        /// How many of the trials were like that.
        failures: usize,
        /// Out of so many.
        trials: usize,
    },
    /// Something measured.
    Measurement {
        /// What was measured, and how much it is.
        numbers: String,
    },
    /// The slide's version and the right one, run on one input.
    Comparison {
        /// The input.
        input: String,
        /// What the slide's version gave.
        slide: String,
        /// What the right version gave.
        right: String,
    },
}

impl std::fmt::Display for Evidence {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Self::Law { sentence, trials } => write!(f, "{sentence}, in all of {trials} trials"),
            Self::Counterexample { numbers, failures, trials: 1 } if *failures == 1 => f.write_str(numbers),
            Self::Counterexample { numbers, failures, trials } => {
                write!(f, "{numbers} ({failures} of {trials} trials fail)")
            }
            Self::Measurement { numbers } => f.write_str(numbers),
            Self::Comparison { input, slide, right } => {
                write!(f, "{input}: the slide gives {slide}, right is {right}")
            }
        }
    }
}

/// What a run came to.
#[derive(Clone, Debug, PartialEq)]
pub struct Examination {
    /// The verdict.
    pub verdict: Verdict,
    /// What backs it, the strongest first.
    pub evidence: Vec<Evidence>,
    /// Whether the right version passed its own trials; `true` where it was not put on trial.
    pub right_holds: bool,
}

impl Examination {
    /// The same with one more piece of evidence.
    #[must_use]
    pub fn and(mut self, evidence: Evidence) -> Self {
        self.evidence.push(evidence);
        self
    }

    /// The same with what the slide's version and the right one gave on one input.
    #[must_use]
    pub fn compared(
        self,
        input: impl Into<String>,
        slide: impl Into<String>,
        right: impl Into<String>,
    ) -> Self {
        self.and(Evidence::Comparison { input: input.into(), slide: slide.into(), right: right.into() })
    }

    /// The same with the right version on trial. Unless it holds in each, the claim is not as expected, whatever becomes
    /// of the slide's version.
    #[must_use]
    pub fn with_right(mut self, sentence: &str, trials: &[Trial]) -> Self {
        let right = judge(sentence, None, trials);
        self.right_holds &= right.verdict == Verdict::Holds;
        self.evidence.extend(right.evidence);
        self
    }

    /// The same with one more measurement.
    #[must_use]
    pub fn noted(self, numbers: impl Into<String>) -> Self {
        self.and(Evidence::Measurement { numbers: numbers.into() })
    }
}

/// The verdict of one measurement: what was measured either is what the sentence says or is not.
#[must_use]
pub fn measured(is_as_the_sentence_says: bool, numbers: impl Into<String>) -> Examination {
    let verdict = if is_as_the_sentence_says { Verdict::Holds } else { Verdict::Refuted };
    Examination {
        verdict,
        evidence: vec![Evidence::Measurement { numbers: numbers.into() }],
        right_holds: true,
    }
}

/// The verdict that trials lead to. No failure: it holds. Failures, but none where the condition is met (and it is met
/// somewhere): it holds if. Otherwise it is refuted. The first failure becomes the counterexample.
///
/// # Panics
/// If there is no trial: nothing follows from nothing.
#[must_use]
pub fn judge(sentence: &str, condition: Option<&'static str>, trials: &[Trial]) -> Examination {
    assert!(!trials.is_empty(), "«{sentence}» was tried on nothing");
    let failures = trials.iter().filter(|trial| !trial.holds);
    let count = failures.clone().count();
    let law = |sentence: String, trials| Evidence::Law { sentence, trials };
    let Some(first) = failures.clone().next() else {
        return Examination {
            verdict: Verdict::Holds,
            evidence: vec![law(sentence.to_owned(), trials.len())],
            right_holds: true,
        };
    };
    let counterexample =
        Evidence::Counterexample { numbers: first.numbers.clone(), failures: count, trials: trials.len() };
    let met = trials.iter().filter(|trial| trial.meets_condition).count();
    let fails_although_met = failures.clone().any(|trial| trial.meets_condition);
    match condition {
        Some(condition) if met > 0 && !fails_although_met => Examination {
            verdict: Verdict::HoldsIf(condition),
            evidence: vec![law(format!("{sentence}, if {condition}"), met), counterexample],
            right_holds: true,
        },
        _ => Examination { verdict: Verdict::Refuted, evidence: vec![counterexample], right_holds: true },
    }
}

#[cfg(test)]
mod tests {
    use crate::*;

    fn trial(holds: bool, meets_condition: bool) -> Trial {
        Trial { holds, meets_condition, numbers: "x = 7".to_owned() }
    }

    #[test]
    fn the_verdict_comes_from_the_trials() {
        let verdict = |trials: &[Trial]| judge("x is small", Some("x < 5"), trials).verdict;
        assert_eq!(verdict(&[trial(true, true), trial(true, false)]), Verdict::Holds);
        assert_eq!(verdict(&[trial(true, true), trial(false, false)]), Verdict::HoldsIf("x < 5"));
        assert_eq!(verdict(&[trial(false, true), trial(true, false)]), Verdict::Refuted);
        // A condition that no input meets saves nothing.
        assert_eq!(verdict(&[trial(false, false)]), Verdict::Refuted);
    }

    #[test]
    fn a_counterexample_is_shown_with_its_numbers() {
        let examination = judge("x is small", None, &[trial(true, true), trial(false, true)]);
        assert_eq!(examination.evidence[0].to_string(), "x = 7 (1 of 2 trials fail)");
    }

    #[test]
    fn a_right_version_that_fails_is_not_passed_over() {
        let slide = || judge("x is small", None, &[trial(false, true)]);
        assert!(slide().with_right("x is 7", &[trial(true, true)]).right_holds);
        let wrong = slide().with_right("x is 7", &[trial(true, true), trial(false, true)]);
        assert_eq!((wrong.verdict, wrong.right_holds), (Verdict::Refuted, false));
    }
}
