//! Does every drawing stand whatever the answer is? Drawn from the counterexamples of all misconceptions, and from damaged answers.

use course::trial::{Examination, examine};
use course::{Exercise, InProcess, Picture, Reply, Value};
use rayon::prelude::*;
use testkit::effort;

/// What is no coordinate of a point on a sheet.
const STRANGE: [f32; 5] = [f32::NAN, f32::INFINITY, f32::NEG_INFINITY, 1e30, -0.0];

/// The last call of the first counterexample, as a grader draws it, with the answer put through `damage`.
fn drawn(
    exercise: &Exercise,
    wrong: InProcess,
    examination: &Examination,
    damage: impl Fn(&Value) -> Value,
) -> Option<Picture> {
    let (_, counterexample) = examination.counterexample()?;
    let (arguments, reply) = counterexample.calls.last()?;
    let Reply::Value(given) = reply else { return None };
    let damaged = damage(given);
    exercise.picture(arguments, Some(&damaged), &mut { wrong })
}

fn assert_sound(picture: &Picture, who: &str) {
    assert!(picture.svg.starts_with("<svg") && picture.svg.ends_with("</svg>"), "{who}: no SVG");
    for strange in ["NaN", "inf"] {
        let in_a_path = picture.svg.split(" d=\"").skip(1).any(|path| {
            let data = path.split('"').next().unwrap_or_default();
            data.contains(strange)
        });
        let in_a_place = [" x=\"", " y=\"", "cx=\"", "cy=\"", " r=\"", "points=\""]
            .iter()
            .any(|name| picture.svg.split(name).skip(1).any(|place| place.starts_with(strange)));
        assert!(!in_a_path && !in_a_place, "{who}: {strange} in the drawing");
    }
    if let Some(text) = &picture.text {
        assert!(text.lines().count() <= 20, "{who}: the text is too long");
        assert!(text.lines().all(|line| line.chars().count() <= 76), "{who}: the text is too wide");
    }
}

/// All numbers of a value, the `at`-th one of each vector or matrix replaced.
fn with_number(value: &Value, at: usize, number: f32) -> Value {
    let in_list = |numbers: &[f32]| {
        let mut numbers = numbers.to_vec();
        let place = at % numbers.len().max(1);
        if let Some(entry) = numbers.get_mut(place) {
            *entry = number;
        }
        numbers
    };
    match value {
        Value::Number(_) => Value::Number(number),
        Value::Vector(numbers) => Value::Vector(in_list(numbers)),
        Value::Matrix(numbers) => Value::Matrix(in_list(numbers)),
        Value::List(values) => Value::List(values.iter().map(|v| with_number(v, at, number)).collect()),
        Value::Record(record) => {
            let mut record = record.clone();
            for (_, field) in &mut record.fields {
                *field = with_number(field, at, number);
            }
            Value::Record(record)
        }
        Value::Nothing | Value::Truth(_) | Value::Whole(_) => value.clone(),
    }
}

/// One damage for each misconception, another one for the next; at night all of them for each.
fn damages(number: usize) -> Vec<(f32, usize)> {
    let all: Vec<(f32, usize)> =
        STRANGE.iter().flat_map(|strange| (0..16).map(|at| (*strange, at))).collect();
    let one = vec![all[number * 7 % all.len()]];
    effort(one, all)
}

#[test]
fn every_drawing_stands_for_every_misconception_and_for_damaged_answers() {
    let all =
        course::all().iter().flat_map(|exercise| exercise.misconceptions.iter().map(move |m| (exercise, m)));
    let numbered: Vec<_> = all.enumerate().collect();
    numbered.into_par_iter().for_each(|(number, (exercise, misconception))| {
        let wrong = InProcess(misconception.program.function);
        let examination = examine(exercise, 1, &mut wrong.clone()).unwrap_or_else(|fault| panic!("{fault}"));
        let who = format!("{} by {}", exercise.name, misconception.program.name);
        if let Some(picture) = drawn(exercise, wrong, &examination, Value::clone) {
            assert_sound(&picture, &who);
        }
        for (strange, at) in damages(number) {
            let damage = |value: &Value| with_number(value, at, strange);
            if let Some(picture) = drawn(exercise, wrong, &examination, damage) {
                assert_sound(&picture, &format!("{who}, {strange} at {at}"));
            }
        }
    });
}
