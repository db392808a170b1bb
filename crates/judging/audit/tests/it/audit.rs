//! Does an audit find what it looks for? On cheap exercises, on one whose laws are left out, and on one whose right answers are wrong.

use std::path::Path;
use std::sync::LazyLock;

use audit::{Audited, Report, audit};
use course::{Example, Exercise, Misconception, Program, trial};
use grader::{Build, Judge, Libraries};

/// How many seeds each program is tried with.
fn seeds() -> u64 {
    testkit::effort(4, 20)
}

/// An audit of one exercise, in a folder of its own.
fn audited(exercise: &Exercise) -> Report {
    static LIBRARIES: LazyLock<Libraries> = LazyLock::new(|| {
        let root = Path::new(env!("CARGO_MANIFEST_DIR")).ancestors().nth(3).expect("crates/judging/audit");
        Libraries::build(root, Build::of_the_workspace()).expect("the libraries are built")
    });
    let folder = tempfile::tempdir().expect("a folder");
    let judge = Judge::in_folder(LIBRARIES.clone(), folder.path());
    audit(&[exercise], &judge, seeds(), &|_| ()).expect("a report")
}

/// An exercise of the course without worked examples and laws but these.
fn with_laws(exercise: &Exercise, examples: Vec<Example>, laws: Vec<course::Law>) -> Exercise {
    Exercise {
        examples,
        laws,
        variants: exercise.variants.clone(),
        misconceptions: exercise.misconceptions.clone(),
        ..*exercise
    }
}

fn find(name: &str) -> &'static Exercise {
    course::find(name).expect("the exercise")
}

fn only(report: &Report) -> &Audited {
    assert_eq!(report.exercises.len(), 1);
    &report.exercises[0]
}

#[test]
fn an_exercise_with_good_laws_meets_all_targets() {
    let exercise = find("lambert");
    let report = audited(exercise);
    let lambert = only(&report);
    assert!(report.met(), "{}", report.table());
    assert_eq!(lambert.variants.accepted, 1 + exercise.variants.len());
    assert_eq!(lambert.misconceptions.diagnosed, exercise.misconceptions.len());
    assert!(lambert.mutants.rejected >= 10, "{}", report.table());
    assert_eq!(lambert.laws[0].name, trial::EXAMPLES);
    let most = lambert.mutants.rejected + exercise.misconceptions.len();
    assert!(
        lambert.laws.iter().all(|law| law.alone <= law.catches && law.catches <= most),
        "{:?}",
        lambert.laws
    );
}

#[test]
fn without_laws_every_wrong_program_survives() {
    let report = audited(&with_laws(find("lambert"), vec![], vec![]));
    let lambert = only(&report);
    assert!(!report.met());
    assert_eq!((lambert.mutants.rejected, lambert.misconceptions.rejected), (0, 0));
    assert_eq!(lambert.mutants.survivors.len(), lambert.mutants.total);
    // The slide's line, and what was made of it.
    let survivor = &lambert.mutants.survivors[0];
    let line = find("lambert").source.lines().nth(survivor.line - 1).expect("a line").trim();
    assert_eq!(survivor.change.before, [line]);
    assert!(report.table().contains(&format!("+ {}", survivor.change.after[0])), "{}", report.table());
}

#[test]
fn one_weak_example_lets_some_mutants_through_and_catches_the_others_alone() {
    let exercise = find("lambert");
    let example = &exercise.examples[0];
    let answer = example.answer.clone();
    let head_on = Example::new(example.caption, example.arguments.clone(), answer, 1e-3);
    let report = audited(&with_laws(exercise, vec![head_on], vec![]));
    let lambert = only(&report);
    assert!(!report.met(), "{}", report.table());
    assert!(0 < lambert.mutants.rejected && lambert.mutants.rejected < lambert.mutants.total);
    assert_eq!(lambert.laws[0].alone, lambert.laws[0].catches);
    assert!(lambert.laws[0].alone >= lambert.mutants.rejected);
}

#[test]
fn a_right_program_that_is_refused_and_a_misconception_that_is_not_recognized_are_counted() {
    let exercise = find("lambert");
    let wrong: Program = exercise.misconceptions[0].program;
    let right = Misconception { program: exercise.variants[0], ..exercise.misconceptions[0] };
    let report = audited(&Exercise {
        examples: vec![],
        laws: std::iter::once(strict()).collect(),
        variants: vec![wrong],
        misconceptions: vec![right],
        ..*exercise
    });
    let lambert = only(&report);
    assert_eq!((lambert.variants.accepted, lambert.variants.total), (0, 2));
    assert_eq!((lambert.misconceptions.rejected, lambert.misconceptions.diagnosed), (1, 0));
    assert!(!report.met());
}

#[test]
fn a_wrong_entry_in_the_list_of_equivalent_mutants_is_an_error() {
    let exercise = find("camera_from_world");
    let listed = audit::equivalent::all().into_iter().filter(|it| it.exercise == exercise.name).count();
    assert!(listed > 0, "the test needs an exercise with equivalent mutants");
    let rejected = audited(&with_laws(exercise, vec![], vec![strict()]));
    assert_eq!(rejected.errors.len(), listed);
    assert!(rejected.errors[0].contains("the mutant is rejected"), "{:?}", rejected.errors);
    let gone = audited(&Exercise { reference: exercise.variants[0], ..with_laws(exercise, vec![], vec![]) });
    assert!(gone.errors[0].contains("no mutant that compiles"), "{:?}", gone.errors);
    assert!(!gone.met() && gone.table().contains("equivalent.diff:"));
}

/// A law that no program keeps.
fn strict() -> course::Law {
    course::Law::of("nothing_is_right", 1, "Nothing is right.", "Give up.")
        .over(proptest::strategy::Just(()), |(), _| course::that(false, || "wrong".to_owned()))
}

#[test]
fn the_same_audit_gives_the_same_bytes_in_the_form_that_is_promised() {
    let exercise = find("halfway");
    let (one, other) = (audited(exercise), audited(exercise));
    assert_eq!(one.json().to_string(), other.json().to_string());
    assert_eq!(one.table(), other.table());
    let json = one.json();
    let halfway = &json["exercises"][0];
    assert_eq!(halfway["name"], "halfway");
    for (group, fields) in [
        ("variants", &["accepted", "total"][..]),
        ("misconceptions", &["rejected", "diagnosed", "total"]),
        ("mutants", &["rejected", "equivalent", "total"]),
    ] {
        assert!(fields.iter().all(|field| halfway[group][field].is_u64()), "{group}: {halfway}");
    }
    assert!(halfway["mutants"]["survivors"].is_array());
    assert!(halfway["laws"].as_array().expect("laws").iter().all(|law| law["alone"].is_u64()));
}
