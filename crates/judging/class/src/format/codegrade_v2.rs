//! What does CodeGrade's AutoTest V2 read? Messages of JSON, one a line, on file descriptor 3; one of over 250 kB is dropped.
//!
//! There are two: the tests, and the points. Suites and cases weigh what they are worth, so that both come to the same share. A law that
//! was not tried is a failure here: a skipped case may be left out of the total, which would make a crash worth points.

use serde::Serialize;

use crate::report::account;
use crate::report::foreign::cut;
use crate::results::{Course, Submission};

use super::tests::{Printed, Status, Test, notices, suites};
use super::{json, within};

/// A message longer than this is dropped; a little is kept back.
const MOST: usize = 240_000;

#[derive(Serialize)]
struct UnitTests {
    tag: &'static str,
    results: Vec<Suite>,
}

#[derive(Serialize)]
#[serde(rename_all = "camelCase")]
struct Suite {
    id: String,
    name: String,
    weight: String,
    test_cases: Vec<Case>,
}

#[derive(Serialize)]
struct Case {
    name: String,
    status: &'static str,
    description: String,
    weight: String,
    reason: String,
    stdout: String,
    stderr: String,
}

#[derive(Serialize)]
struct Points {
    tag: &'static str,
    points: String,
}

pub(super) fn messages(course: &Course, submission: &Submission) -> String {
    let tests = within(MOST, |length| {
        json(&UnitTests { tag: "unit-test", results: cases(course, submission, length) })
    });
    let points = json(&Points { tag: "points", points: format!("{}/{}", submission.points, submission.of) });
    format!("{tests}\n{points}\n")
}

fn cases(course: &Course, submission: &Submission, length: usize) -> Vec<Suite> {
    // There is no place for what is said of the whole; it stands where it is read first.
    let mut said = notices(submission).join("\n");
    let suite = |suite: super::tests::Suite<'_>| {
        // What was printed cannot be told apart by laws; it stands once.
        let printed = account::printed(suite.verdict).unwrap_or_default();
        let mut shown = [std::mem::take(&mut said), printed].join("\n").trim().to_owned();
        let case = |test: Test| Case {
            name: test.name,
            status: if test.status == Status::Passed { "success" } else { "failure" },
            description: test.statement,
            weight: test.of.to_string(),
            reason: cut(&test.message, length),
            stdout: cut(&std::mem::take(&mut shown), length),
            stderr: String::new(),
        };
        Suite {
            id: suite.name.clone(),
            name: format!("{} ({})", suite.title, suite.name),
            weight: suite.tests.iter().map(|test| test.of).sum::<u32>().to_string(),
            test_cases: suite.tests.into_iter().map(case).collect(),
        }
    };
    suites(course, submission, Printed::Apart).into_iter().map(suite).collect()
}
