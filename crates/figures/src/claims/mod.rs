//! Is what the slides say true? Each sentence is put on trial, and the verdict comes out of the run.
//!
//! A [`Claim`] examines itself: it tries the sentence on many inputs, or measures. The [`Verdict`] is reached by
//! [`judge`], never typed in; what is typed in is what we expect, so that a change in the code that turns a verdict is seen.

mod judgement;

pub use judgement::{Evidence, Examination, Trial, Verdict, judge};

use crate::figure::{Drawing, Text};

/// A sentence of the slides and what becomes of it.
#[derive(Debug)]
pub struct Claim {
    /// The item or error of the lecture: `E3`, `L26`.
    pub number: &'static str,
    /// A name of its own, in lower case with dashes: one item may hold several claims.
    pub name: &'static str,
    /// The slide's words, in Dutch, or its formula; short.
    pub quote: &'static str,
    /// The same in English.
    pub translation: &'static str,
    /// What is true, in a sentence; with the condition, if there is one.
    pub truth: Text,
    /// The verdict that the run must reach.
    pub expected: Verdict,
    /// The functions that produced the evidence: `lighting::blinn_highlight`.
    pub code: &'static [&'static str],
    /// Runs the slide's version beside the right one, or measures.
    pub examine: fn() -> Examination,
    /// The slide's version and the right one as pictures, where it can be seen.
    pub pictures: Option<fn() -> crate::Drawn>,
}

/// A claim after its run.
#[derive(Debug)]
pub struct Report {
    /// What was examined.
    pub claim: &'static Claim,
    /// What came out.
    pub examination: Examination,
}

impl Report {
    /// Whether the verdict is the expected one.
    #[must_use]
    pub fn is_as_expected(&self) -> bool {
        self.examination.verdict == self.claim.expected
    }
}

impl Claim {
    /// Runs it.
    #[must_use]
    pub fn run(&'static self) -> Report {
        Report { claim: self, examination: (self.examine)() }
    }

    /// What its files are called by: `E3-blinn-always-positive`.
    #[must_use]
    pub fn stem(&self) -> String {
        format!("{}-{}", self.number, self.name)
    }

    /// Whether `asked` means this claim: its number, its name or its stem, in any case.
    #[must_use]
    pub fn is_called(&self, asked: &str) -> bool {
        [self.number, self.name].iter().any(|name| name.eq_ignore_ascii_case(asked))
            || self.stem().eq_ignore_ascii_case(asked)
    }
}

/// Every claim: those of the items in the order of the lecture, then the errors.
#[must_use]
pub fn all() -> Vec<&'static Claim> {
    let mut claims: Vec<&'static Claim> = ALL.to_vec();
    claims.sort_by_key(|claim| crate::item(claim.number));
    claims
}

/// The claims that a number or a name means.
#[must_use]
pub fn find(asked: &str) -> Vec<&'static Claim> {
    all().into_iter().filter(|claim| claim.is_called(asked)).collect()
}

static ALL: &[&Claim] = &[];

/// The slide's version beside the right one.
pub(crate) fn pair(slide: Drawing, right: Drawing) -> crate::Drawn {
    Ok(vec![slide, right])
}
