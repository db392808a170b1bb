//! Does every exercise hold what it promises, compiled and asked like a student's file? The stub is not started, right solutions pass, every
//! misconception fails and is recognized; as texts, which is how they are shown and handed out.

use crate::bench::Bench;
use course::{Exercise, Program};
use grader::{Judgement, Outcome};

/// Judges programs of an exercise, all of them in one worker.
fn judged(bench: &Bench, exercise: &Exercise, programs: &[&Program]) -> Vec<Judgement> {
    let sources: Vec<String> =
        programs.iter().map(|program| exercise.submission(program).expect("its text")).collect();
    bench.judge_together(exercise, &sources)
}

#[test]
fn every_stub_is_not_started() {
    let bench = Bench::new();
    for exercise in course::all() {
        let judgement = bench.judge_exercise(exercise, exercise.stub.as_bytes(), 1);
        assert_eq!(judgement.outcome, Outcome::NotStarted, "{}", exercise.name);
        assert_eq!(judgement.points, 0, "{}", exercise.name);
    }
}

#[test]
fn every_right_solution_passes_as_a_students_file() {
    let bench = Bench::new();
    for exercise in course::all() {
        let programs: Vec<&Program> = [&exercise.reference].into_iter().chain(&exercise.variants).collect();
        for (program, judgement) in programs.iter().zip(judged(&bench, exercise, &programs)) {
            let who = format!("{} by {}", exercise.name, program.name);
            assert_eq!(judgement.outcome, Outcome::Passed, "{who}: {:?}", judgement.counterexample());
            assert_eq!(judgement.points, exercise.points(), "{who}");
        }
    }
}

#[test]
fn every_misconception_fails_as_a_students_file_and_is_recognized() {
    let bench = Bench::new();
    let mut mistaken = Vec::new();
    for exercise in course::all() {
        let programs: Vec<&Program> = exercise.misconceptions.iter().map(|m| &m.program).collect();
        for (program, judgement) in programs.iter().zip(judged(&bench, exercise, &programs)) {
            let seen = judgement.looks_like.map(|it| it.misconception);
            if judgement.outcome != Outcome::Wrong || seen != Some(program.name) {
                let outcome = judgement.outcome;
                mistaken
                    .push(format!("{} by {}: {outcome:?}, looks like {seen:?}", exercise.name, program.name));
            }
        }
    }
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
