//! What does PrairieLearn read of an external grader? `/grade/results/results.json`, at most 1 MB: a score between 0 and 1, and tests.
//!
//! `gradable: false` makes a submission invalid: no attempt is lost, and no points. So it is with one of which nothing could be judged, since
//! nothing compiles or is there, and with one on which the grader itself failed; then `format_errors` says why and there is no score.
//!
//! A picture's `url` goes into an `<img>` as it is, so a drawing is an SVG there: in an image nothing of it can run. The last pictures are left out
//! where they would take too much of the file.

use base64::Engine;
use base64::engine::general_purpose::STANDARD;
use serde::Serialize;

use crate::report::account;
use crate::report::foreign::{cut, is_harmless_svg, line};
use crate::results::{Course, Kind, Submission};

use super::tests::{Printed, Suite, Test as OurTest, notices, suites};
use super::{json, within};

/// A longer file is refused; a little is kept back.
const MOST: usize = 990_000;
/// So much of it may be pictures.
const MOST_OF_PICTURES: usize = 600_000;

#[derive(Serialize)]
struct Results {
    gradable: bool,
    #[serde(skip_serializing_if = "Option::is_none")]
    score: Option<f64>,
    #[serde(skip_serializing_if = "Vec::is_empty")]
    format_errors: Vec<String>,
    message: String,
    tests: Vec<Test>,
}

#[derive(Serialize)]
struct Test {
    name: String,
    description: String,
    points: u32,
    max_points: u32,
    message: String,
    output: String,
    #[serde(skip_serializing_if = "Vec::is_empty")]
    images: Vec<Image>,
}

#[derive(Serialize)]
struct Image {
    label: String,
    url: String,
}

pub(super) fn results(course: &Course, submission: &Submission) -> String {
    within(MOST, |length| whole(course, submission, length))
}

fn whole(course: &Course, submission: &Submission, length: usize) -> String {
    let suites = suites(course, submission, Printed::Apart);
    let format_errors = why_not_gradable(&suites, length);
    let gradable = format_errors.is_empty();
    let share =
        if submission.of == 0 { 0.0 } else { f64::from(submission.points) / f64::from(submission.of) };
    let said: Vec<String> = std::iter::once(format!("{} of {} points", submission.points, submission.of))
        .chain(notices(submission))
        .collect();
    let mut room = MOST_OF_PICTURES;
    json(&Results {
        gradable,
        score: gradable.then_some(share),
        format_errors,
        message: cut(&said.join("\n"), length.max(100)),
        tests: suites.iter().flat_map(|suite| tests(suite, length, &mut room)).collect(),
    })
}

/// A sentence an exercise that keeps the submission from being judged; none where it was judged.
fn why_not_gradable(suites: &[Suite<'_>], length: usize) -> Vec<String> {
    let kind = |suite: &Suite<'_>| suite.verdict.outcome.kind();
    let failed = suites.iter().any(|suite| kind(suite) == Kind::InternalError);
    let nothing = suites.iter().all(|suite| matches!(kind(suite), Kind::CompileError | Kind::Absent));
    let is_why = |suite: &&Suite<'_>| if failed { kind(suite) == Kind::InternalError } else { nothing };
    let why = |suite: &Suite<'_>| {
        let sentence = account::sentence(suite.verdict).unwrap_or_else(|| account::headline(suite.verdict));
        cut(&format!("{}: {}", suite.name, line(&sentence)), length.max(100))
    };
    let errors: Vec<String> = suites.iter().filter(is_why).map(why).collect();
    if errors.is_empty() && suites.is_empty() {
        vec!["There is nothing to judge.".to_owned()]
    } else {
        errors
    }
}

fn tests(suite: &Suite<'_>, length: usize, room: &mut usize) -> Vec<Test> {
    let mut images = image(suite, room);
    let mut printed = account::printed(suite.verdict).unwrap_or_default();
    let mut test = |test: &OurTest| {
        // What belongs to the exercise stands with its first law that is not kept.
        let (images, output) = if test.message.is_empty() {
            (Vec::new(), String::new())
        } else {
            (std::mem::take(&mut images), std::mem::take(&mut printed))
        };
        Test {
            name: format!("{}: {}", suite.name, test.name),
            description: test.statement.clone(),
            points: test.points,
            max_points: test.of,
            message: cut(&test.message, length),
            output: cut(&output, length),
            images,
        }
    };
    suite.tests.iter().map(&mut test).collect()
}

/// The drawing, if there is room for it.
fn image(suite: &Suite<'_>, room: &mut usize) -> Vec<Image> {
    let drawn = suite.verdict.picture.as_ref().filter(|picture| is_harmless_svg(&picture.svg));
    let Some(picture) = drawn else { return Vec::new() };
    let url = format!("data:image/svg+xml;base64,{}", STANDARD.encode(&picture.svg));
    let Some(left) = room.checked_sub(url.len()) else { return Vec::new() };
    *room = left;
    vec![Image { label: format!("{}: the counterexample, drawn", suite.name), url }]
}
