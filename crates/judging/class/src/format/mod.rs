//! How does a learning platform read a student's results? Each in a form of its own, all made from one list of tests: the laws.
//!
//! | name | platform | file |
//! |---|---|---|
//! | `gradescope` | Gradescope | JSON |
//! | `codegrade-v1` | CodeGrade AutoTest V1 | JUnit XML, the subset that is safe there |
//! | `codegrade-v2` | CodeGrade AutoTest V2 | JSON, a message a line |
//! | `junit` | anything that reads JUnit | XML |
//! | `exercism` | Exercism's test runners | JSON, version 3 |
//! | `github-classroom` | GitHub Classroom's reporter | base64 of JSON |
//! | `prairielearn` | PrairieLearn's external grader | JSON |
//!
//! What is for the staff alone is in none of them. Nobody's clock is asked: where a time is required it is 0. Platforms that refuse long
//! files get texts that are cut; points never change by that. `FORMATS.md` says what becomes what.

mod codegrade_v2;
mod exercism;
mod github_classroom;
mod gradescope;
mod junit;
mod prairielearn;
mod tests;

use std::fmt;
use std::str::FromStr;

use crate::results::{Course, Submission};

/// A platform's form.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Format {
    /// Gradescope.
    Gradescope,
    /// CodeGrade AutoTest V1.
    CodegradeV1,
    /// CodeGrade AutoTest V2.
    CodegradeV2,
    /// JUnit XML in general.
    Junit,
    /// Exercism.
    Exercism,
    /// GitHub Classroom.
    GithubClassroom,
    /// PrairieLearn.
    Prairielearn,
}

impl Format {
    /// All of them.
    pub const ALL: [Self; 7] = [
        Self::Gradescope,
        Self::CodegradeV1,
        Self::CodegradeV2,
        Self::Junit,
        Self::Exercism,
        Self::GithubClassroom,
        Self::Prairielearn,
    ];

    /// Its name on the command line, and of the folder with its files.
    pub fn name(self) -> &'static str {
        match self {
            Self::Gradescope => "gradescope",
            Self::CodegradeV1 => "codegrade-v1",
            Self::CodegradeV2 => "codegrade-v2",
            Self::Junit => "junit",
            Self::Exercism => "exercism",
            Self::GithubClassroom => "github-classroom",
            Self::Prairielearn => "prairielearn",
        }
    }

    /// What the names of its files end in.
    pub fn extension(self) -> &'static str {
        match self {
            Self::Gradescope | Self::Exercism | Self::Prairielearn => "json",
            Self::CodegradeV1 | Self::Junit => "xml",
            Self::CodegradeV2 => "jsonl",
            Self::GithubClassroom => "txt",
        }
    }

    /// What the platform reads of one student.
    pub fn of(self, course: &Course, submission: &Submission) -> String {
        match self {
            Self::Gradescope => gradescope::results(course, submission),
            Self::CodegradeV1 => junit::codegrade(course, submission),
            Self::CodegradeV2 => codegrade_v2::messages(course, submission),
            Self::Junit => junit::general(course, submission),
            Self::Exercism => exercism::results(course, submission),
            Self::GithubClassroom => github_classroom::results(course, submission),
            Self::Prairielearn => prairielearn::results(course, submission),
        }
    }
}

impl fmt::Display for Format {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}

/// No platform has this name.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error(
    "no format is called {0:?}; there are gradescope, codegrade-v1, codegrade-v2, junit, exercism, github-classroom, prairielearn"
)]
pub struct NoFormat(pub String);

impl FromStr for Format {
    type Err = NoFormat;

    fn from_str(name: &str) -> Result<Self, NoFormat> {
        Self::ALL.into_iter().find(|it| it.name() == name).ok_or_else(|| NoFormat(name.to_owned()))
    }
}

/// What `make` gives with the longest texts that keep it within `most` bytes: `make` gets how many bytes each text may have.
fn within(most: usize, make: impl Fn(usize) -> String) -> String {
    /// From comfortable to none at all.
    const LENGTHS: [usize; 7] = [16_000, 6_000, 2_000, 700, 250, 80, 0];
    let mut made = String::new();
    for length in LENGTHS {
        made = make(length);
        if made.len() <= most {
            break;
        }
    }
    made
}

/// The JSON of what serde knows to write; it has string keys and finite numbers only, so nothing can go wrong.
fn json(value: &impl serde::Serialize) -> String {
    serde_json::to_string(value).expect("plain structs become JSON")
}
