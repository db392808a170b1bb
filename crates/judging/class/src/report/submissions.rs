//! Who has how many points? A row a student, to be sorted by every column and searched, with a cell for each exercise.

use maud::{Markup, html};

use crate::results::{Kind, Outcome, Results, Submission, Verdict};

use super::charts::percent;
use super::foreign::{cut, line, plain};

/// A longer name is cut where it stands among others; the feedback has it whole.
const MOST_OF_A_NAME: usize = 80;

/// The table of all submissions and what finds one in it.
pub(crate) fn table(results: &Results) -> Markup {
    html! {
        div.search hidden {
            label for="search" { "Find a submission" }
            input #search type="search" autocomplete="off" spellcheck="false" aria-describedby="searched";
            p #searched.soft { "By student, id, folder or an outcome: timed out, say." }
            p #matches role="status" aria-live="polite" {}
        }
        div.scroll role="region" aria-labelledby="submissions" tabindex="0" {
            table #class.sortable {
                thead {
                    tr {
                        (head("Student", false))
                        (head("Id", false))
                        (head("Points", true))
                        (head("Share", true))
                        (head("Passed", true))
                        (head("Notices", true))
                        @for exercise in &results.course.exercises {
                            th.heat scope="col" data-number {
                                button type="button" disabled title=(exercise.title) { (exercise.name) }
                            }
                        }
                    }
                }
                tbody { @for submission in &results.submissions { (row(results, submission)) } }
            }
        }
    }
}

/// The head of a column that can be sorted, if the script runs.
pub(crate) fn head(name: &str, number: bool) -> Markup {
    html! { th scope="col" data-number[number] { button type="button" disabled { (name) } } }
}

fn row(results: &Results, submission: &Submission) -> Markup {
    let passed = submission.verdicts.iter().filter(|it| it.outcome == Outcome::Passed).count();
    let share =
        if submission.of == 0 { 0.0 } else { f64::from(submission.points) / f64::from(submission.of) };
    html! {
        tr data-words=(words(submission)) {
            th scope="row" { (link(submission)) }
            td.id { (line(&submission.id)) }
            td.number { (submission.points) }
            td.number { (percent(share)) }
            td.number { (passed) }
            td.number { @if !submission.notices.is_empty() { (submission.notices.len()) } }
            @for exercise in &results.course.exercises {
                (cell(submission.verdicts.iter().find(|it| it.exercise == exercise.name)))
            }
        }
    }
}

/// What a search finds beside what the row shows: the folder, and what came of the exercises that did not pass.
fn words(submission: &Submission) -> String {
    let mut outcomes: Vec<Outcome> = submission.verdicts.iter().map(|it| it.outcome).collect();
    outcomes.sort_unstable();
    outcomes.dedup();
    let words = outcomes.iter().filter(|it| **it != Outcome::Passed).map(|it| it.word());
    std::iter::once(line(&submission.source).as_str()).chain(words).collect::<Vec<_>>().join(" ")
}

/// The points, with a mark where it is no wrong answer but none.
fn cell(verdict: Option<&Verdict>) -> Markup {
    let Some(verdict) = verdict else { return html! { td {} } };
    let (class, mark) = match verdict.outcome.kind() {
        Kind::Right => ("a", ""),
        Kind::Wrong if verdict.points > 0 => ("b", ""),
        Kind::Wrong => ("c", ""),
        Kind::Absent => return html! { td.n title=(verdict.outcome.word()) { "·" } },
        _ => ("d", "!"),
    };
    html! { td class=(class) title=(verdict.outcome.word()) { (verdict.points) (mark) } }
}

/// The student's name, leading to the feedback.
pub(crate) fn link(submission: &Submission) -> Markup {
    let name = plain(&submission.student);
    let name = if name.trim().is_empty() { line(&submission.id) } else { line(&name) };
    html! { a href=(feedback(&submission.id)) { bdi { (cut(&name, MOST_OF_A_NAME)) } } }
}

/// Where a student's feedback lies, as an address.
fn feedback(id: &str) -> String {
    let mut address = String::from("feedback/");
    for byte in id.bytes() {
        if byte.is_ascii_alphanumeric() || matches!(byte, b'-' | b'_' | b'.') {
            address.push(char::from(byte));
        } else {
            address.push_str(&format!("%{byte:02X}"));
        }
    }
    address.push_str(".html");
    address
}
