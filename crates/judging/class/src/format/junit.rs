//! What is JUnit XML? Suites of test cases; what went wrong with a case stands inside it.
//!
//! There is no standard; [`general`] is what its readers agree on. A law that does not hold is a `failure`, one for which there was no value
//! an `error`, one that was not tried `skipped`. What the student's code printed is the suite's `system-out`.
//!
//! [`codegrade`] is what CodeGrade's AutoTest V1 reads safely: nothing but cases within a suite, no child in a case that passes (it would lose
//! its marks), `weight` for the points, and no `skipped`, which might be left out of the total.

use maud::{Markup, PreEscaped, html};

use crate::report::account;
use crate::report::foreign::{cut, line};
use crate::results::{Course, Submission};

use super::tests::{Printed, Status, Suite, Test, notices, suites};

const DECLARATION: &str = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n";

/// So many bytes of text in one case.
const MOST_OF_A_TEXT: usize = 16_000;

/// How many cases went how.
#[derive(Default)]
struct Counts {
    tests: usize,
    failures: usize,
    errors: usize,
    skipped: usize,
}

impl Counts {
    fn of<'a>(tests: impl Iterator<Item = &'a Test>) -> Self {
        let mut counts = Self::default();
        for test in tests {
            counts.tests += 1;
            match test.status {
                Status::Passed => {}
                Status::Failed => counts.failures += 1,
                Status::Error => counts.errors += 1,
                Status::NotRun => counts.skipped += 1,
            }
        }
        counts
    }
}

pub(super) fn general(course: &Course, submission: &Submission) -> String {
    let suites = suites(course, submission, Printed::Apart);
    let counts = Counts::of(suites.iter().flat_map(|suite| &suite.tests));
    let markup = html! {
        testsuites name="lightlab" tests=(counts.tests) failures=(counts.failures) errors=(counts.errors)
            skipped=(counts.skipped) time="0"
        {
            @for suite in &suites { "\n" (general_suite(suite)) }
            @if let Some(said) = said(submission) { "\n" (said) }
            "\n"
        }
    };
    format!("{DECLARATION}{}\n", markup.into_string())
}

fn general_suite(suite: &Suite<'_>) -> Markup {
    let counts = Counts::of(suite.tests.iter());
    html! {
        testsuite name=(suite.name) tests=(counts.tests) failures=(counts.failures) errors=(counts.errors)
            skipped=(counts.skipped) time="0"
        {
            @for test in &suite.tests {
                "\n" testcase name=(test.name) classname=(suite.name) time="0" {
                    @match test.status {
                        Status::Passed => {}
                        Status::Failed => failure message=(short(test)) type="law" { (text(test)) }
                        Status::Error => error message=(short(test)) type=(suite.verdict.outcome.word()) { (text(test)) }
                        Status::NotRun => skipped message="not tried" {}
                    }
                }
            }
            @if let Some(printed) = account::printed(suite.verdict) { "\n" (PreEscaped(element("system-out", &printed))) }
            "\n"
        }
    }
}

/// What a student may read of the whole, as a suite without cases: JUnit has no other place for it.
fn said(submission: &Submission) -> Option<Markup> {
    let notices = notices(submission);
    (!notices.is_empty()).then(|| {
        html! {
            testsuite name="notices" tests="0" failures="0" errors="0" skipped="0" time="0" {
                (PreEscaped(element("system-out", &cut(&notices.join("\n"), MOST_OF_A_TEXT))))
            }
        }
    })
}

pub(super) fn codegrade(course: &Course, submission: &Submission) -> String {
    let suites = suites(course, submission, Printed::InTheMessage);
    let markup = html! { testsuites { @for suite in &suites { "\n" (codegrade_suite(suite)) } "\n" } };
    format!("{DECLARATION}{}\n", markup.into_string())
}

fn codegrade_suite(suite: &Suite<'_>) -> Markup {
    let counts = Counts::of(suite.tests.iter());
    let weight: u32 = suite.tests.iter().map(|test| test.of).sum();
    html! {
        testsuite name=(suite.name) tests=(counts.tests) failures=(counts.failures + counts.skipped) errors=(counts.errors)
            skipped="0" weight=(weight)
        {
            @for test in &suite.tests {
                "\n" testcase name=(test.statement) classname=(suite.name) time="0" weight=(test.of) {
                    @match test.status {
                        Status::Passed => {}
                        Status::Error => error message=(short(test)) { (text(test)) }
                        Status::Failed | Status::NotRun => failure message=(short(test)) { (text(test)) }
                    }
                }
            }
            "\n"
        }
    }
}

fn text(test: &Test) -> String {
    cut(&test.message, MOST_OF_A_TEXT)
}

/// The message's first line.
fn short(test: &Test) -> String {
    line(test.message.lines().next().unwrap_or(""))
}

/// An element whose name Rust's macros do not take.
fn element(name: &str, text: &str) -> String {
    let text = html! { (text) }.into_string();
    format!("<{name}>{text}</{name}>")
}
