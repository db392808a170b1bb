//! What does the page show? Drawings as files hold them, so that a page can be made of files that were drawn earlier.

use claims::{Claim, Verdict};
use figures::{Figure, Words};

/// A drawing as a file holds it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Shown {
    /// What sets it apart from the figure's other drawings; empty if it is the only one.
    pub name: String,
    /// What somebody learns from it who cannot see it.
    pub alt: Words,
    /// The file's content.
    pub medium: Medium,
}

/// The content of a drawing's file.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Medium {
    /// The bytes of a PNG file.
    Png(Vec<u8>),
    /// The text of an SVG file that this crate drew.
    Svg(String),
}

/// A figure on the page.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Entry {
    /// Its name in links: `L31-exponent-strip`.
    pub stem: String,
    /// The items and errors that it shows.
    pub numbers: Vec<&'static str>,
    /// The slide's title.
    pub title: Words,
    /// What there is to see.
    pub caption: Words,
    /// The values it was drawn with, in a line.
    pub values: String,
    /// Its drawings.
    pub drawings: Vec<Shown>,
}

impl Entry {
    /// The figure with drawings that were made with `values`.
    #[must_use]
    pub fn new(figure: &Figure, values: String, drawings: Vec<Shown>) -> Self {
        Self {
            stem: figure.stem(),
            numbers: figure.numbers.to_vec(),
            title: figure.title.into(),
            caption: figure.caption.into(),
            values,
            drawings,
        }
    }
}

/// A claim on the page, after its run.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Trial {
    /// Its name in links: `E3-h-is-always-positive`.
    pub stem: String,
    /// The item or error of the lecture.
    pub number: &'static str,
    /// The slide's words, Dutch.
    pub quote: &'static str,
    /// The same in English.
    pub translation: &'static str,
    /// What is true.
    pub truth: Words,
    /// What the run came to.
    pub verdict: Verdict,
    /// Whether that is the recorded verdict, and our own version stood its trial.
    pub is_as_expected: bool,
    /// What backs it, a sentence each, English.
    pub evidence: Vec<String>,
    /// The functions that produced the evidence.
    pub code: Vec<&'static str>,
    /// The slide's version and the right one, where it can be seen.
    pub drawings: Vec<Shown>,
}

impl Trial {
    /// The claim after its run: what it came to, whether that was expected, what backs it, and pictures.
    #[must_use]
    pub fn new(
        claim: &Claim,
        (verdict, is_as_expected): (Verdict, bool),
        evidence: Vec<String>,
        drawings: Vec<Shown>,
    ) -> Self {
        Self {
            stem: claim.stem(),
            number: claim.number,
            quote: claim.quote,
            translation: claim.translation,
            truth: claim.truth.into(),
            verdict,
            is_as_expected,
            evidence,
            code: claim.code.to_vec(),
            drawings,
        }
    }
}
