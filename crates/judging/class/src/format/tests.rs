//! What is a test, for a platform? A law of an exercise: with a name, points, and what to say where it does not hold.

use crate::report::account;
use crate::report::foreign::{line, plain};
use crate::results::{Audience, Course, Exercise, Kind, LawResult, LawVerdict, Outcome, Submission, Verdict};

/// An exercise's tests.
#[derive(Debug)]
pub(super) struct Suite<'a> {
    /// The verdict they are of.
    pub(super) verdict: &'a Verdict,
    /// The exercise's name, one line.
    pub(super) name: String,
    /// The exercise's title, one line.
    pub(super) title: String,
    /// One a law, in order; at least one.
    pub(super) tests: Vec<Test>,
}

/// A law, as a test.
#[derive(Debug)]
pub(super) struct Test {
    /// The law's name, one line.
    pub(super) name: String,
    /// What the law states, one line.
    pub(super) statement: String,
    /// How it went.
    pub(super) status: Status,
    /// The student's points.
    pub(super) points: u32,
    /// What they could be.
    pub(super) of: u32,
    /// What to say; empty where it passed.
    pub(super) message: String,
}

/// Where it is shown what the student's code printed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Printed {
    /// In the message of the first test that did not pass: the platform has no other place.
    InTheMessage,
    /// The format shows it itself.
    Apart,
}

/// How a test went.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Status {
    /// The law holds.
    Passed,
    /// It does not hold.
    Failed,
    /// There was no value that it could hold for.
    Error,
    /// It was not tried.
    NotRun,
}

/// Every exercise of the submission, in order.
pub(super) fn suites<'a>(course: &Course, submission: &'a Submission, printed: Printed) -> Vec<Suite<'a>> {
    let suite = |verdict: &'a Verdict| suite(course.exercise(&verdict.exercise), verdict, printed);
    submission.verdicts.iter().map(suite).collect()
}

/// What a student may read of the submission as a whole, a line each.
pub(super) fn notices(submission: &Submission) -> Vec<String> {
    submission.notices.iter().filter(|it| it.audience == Audience::Student).map(|it| line(&it.text)).collect()
}

fn suite<'a>(exercise: Option<&Exercise>, verdict: &'a Verdict, printed: Printed) -> Suite<'a> {
    let mut tests = if verdict.laws.is_empty() {
        untried(exercise, verdict)
    } else {
        verdict.laws.iter().map(|law| tried(exercise, verdict, law)).collect()
    };
    say_the_rest(&mut tests, verdict, printed);
    Suite {
        verdict,
        name: line(&verdict.exercise),
        title: line(exercise.map_or(&verdict.exercise, |it| &it.title)),
        tests,
    }
}

fn tried(exercise: Option<&Exercise>, verdict: &Verdict, law: &LawVerdict) -> Test {
    let gives_values = matches!(verdict.outcome.kind(), Kind::Right | Kind::Wrong);
    let (status, message) = match &law.result {
        LawResult::Kept(_) => (Status::Passed, String::new()),
        LawResult::Failed(it) => {
            let has_value = it.broken.is_some() || gives_values;
            (if has_value { Status::Failed } else { Status::Error }, account::counterexample(it))
        }
        LawResult::NotRun => (Status::NotRun, "Not tried.".to_owned()),
    };
    let statement = exercise.and_then(|it| it.law(&law.name)).map_or(&law.name, |it| &it.statement);
    Test {
        name: line(&law.name),
        statement: line(statement),
        status,
        points: law.points,
        of: law.of,
        message,
    }
}

/// The tests of a file of which no law could be tried.
fn untried(exercise: Option<&Exercise>, verdict: &Verdict) -> Vec<Test> {
    let laws = exercise.map_or(&[][..], |it| &it.laws);
    if laws.iter().map(|law| law.points).sum::<u32>() != verdict.of || laws.is_empty() {
        return vec![Test {
            name: line(&verdict.exercise),
            statement: line(&verdict.exercise),
            status: Status::Error,
            points: verdict.points,
            of: verdict.of,
            message: String::new(),
        }];
    }
    let test = |(at, law): (usize, &crate::results::Law)| Test {
        name: line(&law.name),
        statement: line(&law.statement),
        status: if at == 0 { Status::Error } else { Status::NotRun },
        points: 0,
        of: law.points,
        message: if at == 0 { String::new() } else { "Not tried.".to_owned() },
    };
    laws.iter().enumerate().map(test).collect()
}

/// What is to say beside the laws goes to the first test that did not pass, on top.
fn say_the_rest(tests: &mut [Test], verdict: &Verdict, printed: Printed) {
    let Some(first) = tests.iter_mut().find(|test| test.status != Status::Passed) else { return };
    let mut parts = vec![account::beside_the_laws(verdict)];
    if !first.message.is_empty() {
        parts.insert(usize::from(verdict.outcome != Outcome::Wrong), first.message.clone());
    }
    let drawn = verdict.picture.as_ref().and_then(|picture| picture.text.as_deref());
    parts.extend(drawn.map(|text| plain(text).trim_end().to_owned()));
    if printed == Printed::InTheMessage {
        parts.extend(account::printed(verdict).map(|text| format!("Your code printed:\n{text}")));
    }
    if !verdict.laws.is_empty() {
        parts.push(format!("The same again: {}", account::again(verdict)));
    }
    parts.retain(|part| !part.is_empty());
    first.message = parts.join("\n\n");
    if first.message.is_empty() {
        first.message = account::headline(verdict);
    }
}
