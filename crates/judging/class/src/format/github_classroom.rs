//! What does GitHub Classroom's reporter read? An environment variable `<ID>_RESULTS`, base64 of JSON.
//!
//! The reporter adds up the scores of the tests; earlier ones computed passed / total × `max_score`. Both must give the same number, so here a test
//! is a point: a law of three points is three tests, of which the first says what there is to say.
//!
//! Linux passes no variable of over 128 KiB to a program, and base64 makes four bytes of three: texts are cut until it fits.

use base64::Engine;
use base64::engine::general_purpose::STANDARD;
use serde::Serialize;

use crate::report::account;
use crate::report::foreign::cut;
use crate::results::{Course, Submission};

use super::tests::{Printed, Suite, Test as OurTest, notices, suites};
use super::{json, within};

/// Its base64, with the variable's name, is below 128 KiB.
const MOST: usize = 96_000;

#[derive(Serialize)]
struct Results {
    version: u32,
    status: &'static str,
    max_score: u32,
    tests: Vec<Test>,
}

#[derive(Serialize)]
struct Test {
    name: String,
    status: &'static str,
    score: u32,
    message: String,
    test_code: String,
}

pub(super) fn results(course: &Course, submission: &Submission) -> String {
    let json = within(MOST, |length| {
        let mut tests: Vec<Test> = suites(course, submission, Printed::InTheMessage)
            .iter()
            .flat_map(|suite| points(suite, length))
            .collect();
        // There is no place for what is said of the whole; it stands where it is read first.
        if let Some(first) = tests.first_mut() {
            let said: Vec<String> =
                notices(submission).into_iter().chain([std::mem::take(&mut first.message)]).collect();
            first.message = cut(said.join("\n").trim(), length);
        }
        let all_pass = tests.iter().all(|test| test.status == "pass");
        let max_score = tests.len() as u32;
        json(&Results { version: 1, status: if all_pass { "pass" } else { "fail" }, max_score, tests })
    });
    STANDARD.encode(json)
}

fn points(suite: &Suite<'_>, length: usize) -> Vec<Test> {
    suite
        .tests
        .iter()
        .flat_map(|test| (0..test.of).map(move |point| one(suite, test, point, length)))
        .collect()
}

/// The test of one point of a law, counted from 0.
fn one(suite: &Suite<'_>, test: &OurTest, point: u32, length: usize) -> Test {
    let passed = point < test.points;
    // The first that fails.
    let speaks = point == test.points;
    let which = if test.of > 1 { format!(" ({} of {})", point + 1, test.of) } else { String::new() };
    let repeatable = speaks && !suite.verdict.laws.is_empty();
    Test {
        name: format!("{}: {}{which}", suite.name, test.name),
        status: if passed { "pass" } else { "fail" },
        score: u32::from(passed),
        message: if speaks { cut(&test.message, length) } else { String::new() },
        test_code: if repeatable { account::again(suite.verdict) } else { String::new() },
    }
}
