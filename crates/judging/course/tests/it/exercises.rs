//! Is every exercise whole, are right answers accepted and wrong ones recognized? Our own solutions on trial, in this process.

use course::diagnosis::diagnose;
use course::trial::{Examination, Outcome, examine};
use course::{Exercise, InProcess, Program};
use rayon::prelude::*;
use testkit::effort;

/// Number of seeds that every right solution is tried with.
fn seeds_of_the_right() -> u64 {
    effort(5, 1000)
}

/// Number of seeds that every misconception is tried with: each must be found with the student's seed, whichever it is.
fn seeds_of_the_wrong() -> u64 {
    effort(1, 25)
}

fn trial(exercise: &Exercise, program: &Program, seed: u64) -> Examination {
    examine(exercise, seed, &mut InProcess(program.function))
        .unwrap_or_else(|fault| panic!("{} by {}: {fault}", exercise.name, program.name))
}

/// What speaks against a program, for a failing test's message.
fn against(examination: &Examination) -> String {
    let Some((law, counterexample)) = examination.counterexample() else { return "nothing".to_owned() };
    let calls: Vec<String> = counterexample
        .calls
        .iter()
        .map(|(arguments, reply)| {
            let arguments: Vec<String> = arguments.iter().map(ToString::to_string).collect();
            format!("({}) -> {reply:?}", arguments.join(", "))
        })
        .collect();
    let broken = counterexample.broken.as_ref().map(ToString::to_string).unwrap_or_default();
    format!("{}: {broken}\n  {}", law.name, calls.join("\n  "))
}

#[test]
fn every_exercise_is_whole() {
    for exercise in course::all() {
        let name = exercise.name;
        assert!(!exercise.examples.is_empty(), "{name} has no worked example");
        assert!(exercise.laws.len() >= 3, "{name} has fewer than three laws");
        assert!(exercise.variants.len() >= 2, "{name} has fewer than two other right solutions");
        assert!(exercise.misconceptions.len() >= 3, "{name} has fewer than three misconceptions");
        assert!(exercise.hints.iter().all(|hint| hint.len() > 20), "{name} has an empty hint");
        assert!(exercise.explanation.len() > 60, "{name} is not explained");
        assert!(exercise.stub.starts_with("//! "), "{name}: the task does not stand first");
        assert!(exercise.stub.contains(&format!("pub fn {name}(")), "{name}: another function is handed out");
        assert!(exercise.stub.ends_with("    todo!()\n}\n"), "{name}: no todo!() is handed out");
        assert!(exercise.laws.iter().all(|law| law.points() > 0), "{name} has a law worth nothing");
        for prerequisite in exercise.prerequisites {
            assert!(
                course::find(prerequisite).is_some(),
                "{name} needs {prerequisite}, which does not exist"
            );
        }
        let programs = [&exercise.reference]
            .into_iter()
            .chain(&exercise.variants)
            .chain(exercise.misconceptions.iter().map(|m| &m.program));
        for program in programs {
            assert!(
                exercise.submission(program).is_some(),
                "{name}: the text of {} is not found",
                program.name
            );
        }
    }
}

#[test]
fn names_are_unique_and_prerequisites_come_first() {
    let exercises = course::all();
    for (at, exercise) in exercises.iter().enumerate() {
        let before = &exercises[..at];
        assert!(before.iter().all(|other| other.name != exercise.name), "{} stands twice", exercise.name);
        for prerequisite in exercise.prerequisites {
            assert!(
                before.iter().any(|o| o.name == *prerequisite),
                "{prerequisite} before {}",
                exercise.name
            );
        }
        for law in &exercise.laws {
            let same = exercise.laws.iter().filter(|other| other.name() == law.name()).count();
            assert_eq!(same, 1, "{}: law {} stands twice", exercise.name, law.name());
        }
    }
}

#[test]
fn every_right_solution_passes_with_every_seed() {
    course::all().par_iter().for_each(|exercise| {
        for program in [&exercise.reference].into_iter().chain(&exercise.variants) {
            for seed in 0..seeds_of_the_right() {
                let examination = trial(exercise, program, seed);
                assert!(
                    examination.passed(),
                    "{} by {}, seed {seed}: {}",
                    exercise.name,
                    program.name,
                    against(&examination)
                );
                assert_eq!(examination.points(), exercise.points());
            }
        }
    });
}

/// The misconceptions of an exercise that pass or look like something else.
fn mistaken(exercise: &Exercise) -> Vec<String> {
    let mut mistaken = Vec::new();
    for misconception in &exercise.misconceptions {
        for seed in 0..seeds_of_the_wrong() {
            let examination = trial(exercise, &misconception.program, seed);
            let who = format!("{} by {}, seed {seed}", exercise.name, misconception.program.name);
            let seen = diagnose(exercise, &examination.answered).map(|d| d.misconception.program.name);
            if examination.passed() {
                mistaken.push(format!("{who}: passes"));
            } else if seen != Some(misconception.program.name) {
                mistaken.push(format!("{who}: looks like {seen:?}"));
            }
        }
    }
    mistaken
}

#[test]
fn every_misconception_fails_and_is_recognized_as_itself() {
    let mistaken: Vec<String> = course::all().par_iter().flat_map_iter(mistaken).collect();
    assert!(mistaken.is_empty(), "{}", mistaken.join("\n"));
}

#[test]
fn every_law_catches_a_misconception() {
    for exercise in course::all() {
        for law in &exercise.laws {
            let caught = exercise.misconceptions.iter().any(|misconception| {
                let examination = trial(exercise, &misconception.program, 1);
                let tried = examination.laws.iter().find(|tried| tried.name == law.name());
                tried.is_some_and(|tried| matches!(tried.outcome, Outcome::Failed(_)))
            });
            assert!(caught, "{}: law {} catches no misconception", exercise.name, law.name());
        }
    }
}

#[test]
fn the_same_seed_gives_the_same_trial_and_another_one_other_inputs() {
    for exercise in course::all() {
        let asked = |seed| trial(exercise, &exercise.reference, seed).answered;
        assert_eq!(format!("{:?}", asked(7)), format!("{:?}", asked(7)), "{}", exercise.name);
        assert_ne!(format!("{:?}", asked(7)), format!("{:?}", asked(8)), "{}", exercise.name);
    }
}

/// A file of an exercise in which one function calls others.
const SOURCE: &str = "\nfn one(x: f32) -> f32 {\n    two(x) + one_more(x)\n}\n\nfn two(x: f32) -> f32 {\n    three(x)\n}\n\n\
                      fn three(x: f32) -> f32 {\n    x.four()\n}\n\nfn four() {\n}\n\nfn more() {\n}\n";

#[test]
fn a_submission_brings_the_functions_that_it_calls_and_no_others() {
    let exercise = &course::all()[0];
    let stub = "//! A task.\n\npub fn solve(x: f32) -> f32 {\n    todo!()\n}\n";
    let calling = Exercise {
        name: "solve",
        stub,
        source: SOURCE,
        examples: Vec::new(),
        laws: Vec::new(),
        variants: Vec::new(),
        misconceptions: Vec::new(),
        ..*exercise
    };
    let text = calling.submission(&Program { name: "one", ..exercise.reference }).expect("its text");
    let heads: Vec<&str> = text.lines().filter(|line| line.contains("fn ")).collect();
    assert_eq!(
        heads,
        ["pub fn solve(x: f32) -> f32 {", "fn two(x: f32) -> f32 {", "fn three(x: f32) -> f32 {"]
    );
    assert!(text.contains("    two(x) + one_more(x)\n}") && !text.contains("todo!()"), "{text}");
}
