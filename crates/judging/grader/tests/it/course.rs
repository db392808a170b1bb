//! Does every exercise hold what it promises, compiled and asked like a student's file? The stub is not started, right solutions pass, every
//! misconception fails and is recognized; as texts, which is how they are shown and handed out. Two programs of a kind for each exercise by day, all at night.

use crate::bench::Bench;
use course::{Exercise, Program};
use grader::{Judgement, Outcome};

/// So many files are compiled into one worker: more take longer together than in turn, and one that is broken costs them all.
const TOGETHER: usize = 60;

/// Judges these programs as students' files, many in one worker.
fn judged<'a>(
    bench: &Bench,
    programs: &'a [Submission],
) -> impl Iterator<Item = (&'a Submission, Judgement)> {
    programs.chunks(TOGETHER).flat_map(|some| {
        let files: Vec<(&Exercise, &[u8])> =
            some.iter().map(|it| (it.exercise, it.text.as_bytes())).collect();
        some.iter().zip(bench.judge_mixed(&files))
    })
}

/// A program of the course as a student would hand it in.
struct Submission {
    exercise: &'static Exercise,
    name: &'static str,
    text: String,
}

/// These programs of every exercise.
fn submissions(chosen: impl Fn(&'static Exercise) -> Vec<&'static Program>) -> Vec<Submission> {
    let of = |exercise: &'static Exercise| {
        let text = |program| exercise.submission(program).expect("its text");
        chosen(exercise).into_iter().map(move |it| Submission { exercise, name: it.name, text: text(it) })
    };
    course::all().iter().flat_map(of).collect()
}

#[test]
fn every_stub_is_not_started() {
    let bench = Bench::new();
    let stubs = course::all().iter().map(|exercise| Submission {
        exercise,
        name: "stub",
        text: exercise.stub.to_owned(),
    });
    for (stub, judgement) in judged(&bench, &stubs.collect::<Vec<_>>()) {
        assert_eq!(judgement.outcome, Outcome::NotStarted, "{}", stub.exercise.name);
        assert_eq!(judgement.points, 0, "{}", stub.exercise.name);
    }
}

#[test]
fn every_right_solution_passes_as_a_students_file() {
    let programs = testkit::effort(2, usize::MAX);
    let right = submissions(|it| [&it.reference].into_iter().chain(&it.variants).take(programs).collect());
    for (program, judgement) in judged(&Bench::new(), &right) {
        let who = format!("{} by {}", program.exercise.name, program.name);
        assert_eq!(judgement.outcome, Outcome::Passed, "{who}: {:?}", judgement.counterexample());
        assert_eq!(judgement.points, program.exercise.points(), "{who}");
    }
}

#[test]
fn every_misconception_fails_as_a_students_file_and_is_recognized() {
    let programs = testkit::effort(2, usize::MAX);
    let wrong = submissions(|it| it.misconceptions.iter().map(|m| &m.program).take(programs).collect());
    let mistaken: Vec<String> = judged(&Bench::new(), &wrong)
        .filter_map(|(program, judgement)| {
            let seen = judgement.looks_like.map(|it| it.misconception);
            let recognized = judgement.outcome == Outcome::Wrong && seen == Some(program.name);
            let (exercise, outcome) = (program.exercise.name, judgement.outcome);
            (!recognized).then(|| format!("{exercise} by {}: {outcome:?}, looks like {seen:?}", program.name))
        })
        .collect();
    assert!(mistaken.is_empty(), "{}", mistaken.join("\n"));
}

#[test]
fn one_that_does_not_compile_costs_no_other() {
    let bench = Bench::new();
    let exercise = course::find("rotate_about_point").expect("the exercise");
    let right = exercise.submission(&exercise.reference).expect("its text");
    let sources = [right.clone(), "fn torn(".to_owned(), right, String::new()];
    let outcomes: Vec<Outcome> =
        bench.judge_together(exercise, &sources).into_iter().map(|judgement| judgement.outcome).collect();
    assert_eq!(outcomes[0], Outcome::Passed);
    assert!(matches!(outcomes[1], Outcome::DoesNotCompile { .. }), "{:?}", outcomes[1]);
    assert_eq!(outcomes[2], Outcome::Passed);
    assert!(matches!(outcomes[3], Outcome::Unreadable(_)), "{:?}", outcomes[3]);
}
