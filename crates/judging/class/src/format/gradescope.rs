//! What does Gradescope read? `results.json`: a score, and tests with scores of their own.
//!
//! The score on top counts; those of the tests are shown and add up to it. Everything is visible as it stands here: what is hidden from
//! students hides their total as well, so what is for the staff alone is left out instead. `stdout_visibility` hides what the grader's
//! script prints. Texts are `text`, shown as they are, but for the summary, which is Markdown.

use serde::Serialize;

use crate::report::foreign::cut;
use crate::report::markdown::{code, escaped};
use crate::results::{Course, Submission};

use super::tests::{Printed, Status, notices, suites};
use super::{json, within};

/// Far below what the platform stores, and more than anybody reads.
const MOST: usize = 1_000_000;

#[derive(Serialize)]
struct Results {
    score: u32,
    output: String,
    output_format: &'static str,
    visibility: &'static str,
    stdout_visibility: &'static str,
    tests: Vec<Test>,
}

#[derive(Serialize)]
struct Test {
    score: u32,
    max_score: u32,
    status: &'static str,
    name: String,
    name_format: &'static str,
    number: String,
    output: String,
    output_format: &'static str,
    visibility: &'static str,
}

pub(super) fn results(course: &Course, submission: &Submission) -> String {
    within(MOST, |length| {
        json(&Results {
            score: submission.points,
            output: summary(submission),
            output_format: "md",
            visibility: "visible",
            stdout_visibility: "hidden",
            tests: tests(course, submission, length),
        })
    })
}

fn summary(submission: &Submission) -> String {
    let mut lines = vec![format!("**{} of {} points**", submission.points, submission.of)];
    lines.extend(notices(submission).iter().map(|notice| escaped(notice)));
    let rows = submission.verdicts.iter().map(|verdict| {
        let (name, word) = (code(&verdict.exercise), verdict.outcome.word());
        format!("- {name}: {word}, {} of {}", verdict.points, verdict.of)
    });
    lines.push(rows.collect::<Vec<_>>().join("\n"));
    lines.join("\n\n")
}

fn tests(course: &Course, submission: &Submission, length: usize) -> Vec<Test> {
    let mut tests = Vec::new();
    for (exercise, suite) in suites(course, submission, Printed::InTheMessage).into_iter().enumerate() {
        for (law, test) in suite.tests.into_iter().enumerate() {
            tests.push(Test {
                score: test.points,
                max_score: test.of,
                status: if test.status == Status::Passed { "passed" } else { "failed" },
                name: format!("{}: {}", suite.name, test.statement),
                name_format: "text",
                number: format!("{}.{}", exercise + 1, law + 1),
                output: cut(&test.message, length),
                output_format: "text",
                visibility: "visible",
            });
        }
    }
    tests
}
