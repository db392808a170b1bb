//! What does Exercism's website read of a test runner? `results.json`, version 3: whether all passed, and each test in order.
//!
//! The runner ends with exit code 0 whatever came of the tests. `error` on top means that no test was run, and then `message` says why; else
//! `message` is null. A test's `output`, what the code printed, has at most 500 characters, and says so where it was cut; messages have at most
//! 65,535. `task_id` is the number of the exercise, from 1.

use serde::Serialize;

use crate::report::account;
use crate::report::foreign::cut;
use crate::results::{Course, Submission};

use super::json;
use super::tests::{Printed, Status, Suite, Test as OurTest, suites};

/// A message may have so many characters. Counted in bytes, since a database counts them too.
const MOST_OF_A_MESSAGE: usize = 65_535;
/// A test's output may have so many characters.
const MOST_OF_AN_OUTPUT: usize = 500;

#[derive(Serialize)]
struct Results {
    version: u32,
    status: &'static str,
    message: Option<String>,
    tests: Vec<Test>,
}

#[derive(Serialize)]
struct Test {
    name: String,
    status: &'static str,
    message: Option<String>,
    output: Option<String>,
    test_code: String,
    task_id: usize,
}

pub(super) fn results(course: &Course, submission: &Submission) -> String {
    let suites = suites(course, submission, Printed::Apart);
    let was_run = suites.iter().any(|suite| !suite.verdict.laws.is_empty());
    let all_pass = suites.iter().flat_map(|suite| &suite.tests).all(|test| test.status == Status::Passed);
    let (status, message) = match (was_run, all_pass) {
        (false, _) => ("error", Some(cut(&why_none_was_run(&suites), MOST_OF_A_MESSAGE))),
        (true, true) => ("pass", None),
        (true, false) => ("fail", None),
    };
    let tests = suites.iter().enumerate().flat_map(|(at, suite)| {
        suite.tests.iter().enumerate().map(move |(law, test)| self::test(at + 1, suite, test, law == 0))
    });
    json(&Results { version: 3, status, message, tests: tests.collect() })
}

fn why_none_was_run(suites: &[Suite<'_>]) -> String {
    let said = suites.iter().map(|suite| {
        let said = account::beside_the_laws(suite.verdict);
        let said = if said.is_empty() { account::headline(suite.verdict) } else { said };
        format!("{}: {said}", suite.name)
    });
    let said: Vec<String> = said.collect();
    if said.is_empty() { "There is nothing to test.".to_owned() } else { said.join("\n\n") }
}

fn test(task: usize, suite: &Suite<'_>, test: &OurTest, is_first: bool) -> Test {
    let status = match test.status {
        Status::Passed => "pass",
        Status::Failed => "fail",
        Status::Error | Status::NotRun => "error",
    };
    // What was printed cannot be told apart by laws; it stands once.
    let output = if is_first { account::printed(suite.verdict) } else { None };
    Test {
        name: format!("{}: {}", suite.name, test.statement),
        status,
        message: (test.status != Status::Passed).then(|| cut(&test.message, MOST_OF_A_MESSAGE)),
        output: output.map(|text| cut(&text, MOST_OF_AN_OUTPUT)),
        test_code: test.statement.clone(),
        task_id: task,
    }
}
