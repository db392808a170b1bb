//! What is known of a class once it has been graded? Every report is made from this, and from nothing else.
//!
//! As JSON it is `results.json`. Whoever reads such a file sees first whether it is one, and of which [`VERSION`]; within a version
//! fields are neither removed nor given another meaning.

mod outcome;

pub use outcome::{Kind, Outcome};

use serde::{Deserialize, Serialize};

use crate::digest::Digest;

/// What kind of file it is.
pub const SCHEMA: &str = "lightlab-results";

/// The version of the kind.
pub const VERSION: u32 = 1;

/// A class, graded.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Results {
    /// [`SCHEMA`].
    pub schema: String,
    /// [`VERSION`].
    pub version: u32,
    /// The share of the class that this is, "count:1/3"; absent where it is the whole class.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub partition: Option<String>,
    /// What was judged by.
    pub course: Course,
    /// How inputs were chosen.
    pub seeds: Seeds,
    /// Whether every submission was judged in the sandbox.
    pub sandboxed: bool,
    /// What is in the class's folder but is nobody's submission: a sentence for each reason. For the staff; may hold any characters.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub remarks: Vec<String>,
    /// In a part: every submission of the whole class, so that `merge` can tell that all parts are of one class and nobody is lost.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub roster: Vec<Listed>,
    /// One a student, in the order of their ids.
    pub submissions: Vec<Submission>,
    /// In a part: [`Results::digest_of_content`] when it was written, so that `merge` can tell that nobody has changed it.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub digest: Option<String>,
}

/// A submission of the class, as every part lists it.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Listed {
    /// The student's id.
    pub id: String,
    /// The fingerprint of what was handed in, as in [`Submission::fingerprint`].
    pub fingerprint: String,
}

impl Results {
    /// The SHA-256 of everything but pictures and the digest itself: hexadecimal.
    ///
    /// It shows a change by accident or by hand. Whoever wants to deceive can compute it anew.
    pub fn digest_of_content(&self) -> String {
        let json = serde_json::to_vec(&Self { digest: None, ..self.without_pictures() });
        Digest::of([json.unwrap_or_default().as_slice()]).hexadecimal()
    }

    /// A copy as it stands in `results.json`: drawings are in the feedback alone.
    pub(crate) fn without_pictures(&self) -> Self {
        let mut plain = self.clone();
        for verdict in plain.submissions.iter_mut().flat_map(|submission| &mut submission.verdicts) {
            verdict.picture = None;
        }
        plain
    }
}

/// The exercises as they were when they judged.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Course {
    /// Changes with any exercise and with what tries them: hexadecimal.
    pub version: String,
    /// In the order in which they are best done.
    pub exercises: Vec<Exercise>,
}

impl Course {
    /// The exercise of this name.
    pub fn exercise(&self, name: &str) -> Option<&Exercise> {
        self.exercises.iter().find(|exercise| exercise.name == name)
    }
}

/// An exercise, outlined.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Exercise {
    /// The function's name, and the file's without `.rs`.
    pub name: String,
    /// The concept, and the folder.
    pub concept: String,
    /// Its title in English.
    pub title: String,
    /// The lecture's items that it is about: "L31, E3".
    pub items: String,
    /// What a right solution gets.
    pub points: u32,
    /// Its laws; the worked examples count as the first.
    pub laws: Vec<Law>,
    /// Known wrong programs: what diagnoses may name.
    pub misconceptions: Vec<Misconception>,
}

impl Exercise {
    /// The law of this name.
    pub fn law(&self, name: &str) -> Option<&Law> {
        self.laws.iter().find(|law| law.name == name)
    }
}

/// A law, outlined.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Law {
    /// Its name.
    pub name: String,
    /// What it states.
    pub statement: String,
    /// What keeping it is worth.
    pub points: u32,
}

/// A known wrong program.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Misconception {
    /// Its name.
    pub name: String,
    /// To be read after "This looks like: ".
    pub looks_like: String,
}

/// How inputs were chosen.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Seeds {
    /// The seed asked for; each submission says which one it was judged with.
    pub seed: u64,
    /// Whether each student has inputs of their own, made from the seed and the student's id.
    pub per_student: bool,
}

/// What one student handed in, judged.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Submission {
    /// Unlike any other's, and fit for a file name on every system: letters, digits, `-`, `_`, `.`.
    pub id: String,
    /// The student as the folder or archive says; may hold any characters.
    pub student: String,
    /// The folder or archive it was read from, as it is named in the class's folder; may hold any characters.
    pub source: String,
    /// Of all that was judged: hexadecimal.
    pub fingerprint: String,
    /// The seed of its inputs.
    pub seed: u64,
    /// The sum of the points.
    pub points: u32,
    /// What they could have been.
    pub of: u32,
    /// What there is to say beside the verdicts: what was ignored, and why.
    pub notices: Vec<Notice>,
    /// One an exercise, in the course's order.
    pub verdicts: Vec<Verdict>,
}

/// A remark on a submission.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Notice {
    /// Who may read it.
    pub audience: Audience,
    /// A sentence.
    pub text: String,
}

/// Who may read something.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Audience {
    /// The student, and the staff.
    Student,
    /// The staff alone.
    Staff,
}

/// What came of one exercise.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Verdict {
    /// The exercise's name.
    pub exercise: String,
    /// Repeats the verdict: `cargo lab check --token …`.
    pub token: String,
    /// The whole in a word.
    pub outcome: Outcome,
    /// The same in a sentence or two, where the laws do not say it all.
    pub sentence: Option<String>,
    /// What rustc says; may hold any characters.
    pub compiler: Option<String>,
    /// The line of the student's file that the sentence or the compiler is about, from 1.
    pub line: Option<u32>,
    /// The points of the laws that hold.
    pub points: u32,
    /// The points of all laws.
    pub of: u32,
    /// How each law went, in the exercise's order; empty where none was tried.
    pub laws: Vec<LawVerdict>,
    /// The misconception that the answers are those of.
    pub looks_like: Option<LooksLike>,
    /// The counterexample, drawn. Not in `results.json`: pictures stand in the feedback.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub picture: Option<Picture>,
    /// What the student's code printed on standard output, the beginning; may hold any characters.
    pub printed: String,
}

/// How one law went.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct LawVerdict {
    /// Its name.
    pub name: String,
    /// What the student gets for it.
    pub points: u32,
    /// What keeping it is worth.
    pub of: u32,
    /// How it went.
    pub result: LawResult,
}

/// How one law went.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum LawResult {
    /// It held for so many inputs.
    Kept(u32),
    /// It did not hold.
    Failed(Counterexample),
    /// It was not tried.
    NotRun,
}

/// The smallest input found on which a law does not hold.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Counterexample {
    /// Which worked example it is, if it is one.
    pub example: Option<String>,
    /// The calls that show it.
    pub calls: Vec<Call>,
    /// What is wrong about them; nothing where the last call gave no value.
    pub broken: Option<String>,
    /// What would help.
    pub help: String,
}

/// A call and what came of it.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Call {
    /// "rotate_about_point(theta = 1.5, p = (1, 2))".
    pub call: String,
    /// "(0, 1)", or "a panic: …", or "no answer"; a panic's words may hold any characters.
    pub gave: String,
}

/// A misconception, and how sure it is.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct LooksLike {
    /// Its name.
    pub misconception: String,
    /// To be read after "This looks like: ".
    pub what: String,
    /// What would help.
    pub help: String,
    /// On so many inputs the answers are the misconception's…
    pub agreeing: usize,
    /// …of so many on which that one is not right.
    pub telling: usize,
}

/// A counterexample, drawn.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Picture {
    /// SVG, ours but for the numbers.
    pub svg: String,
    /// The same for a terminal, if it is small enough.
    pub text: Option<String>,
}
