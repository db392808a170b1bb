//! Does every drawing stand whatever the answer is? Drawn from the counterexamples of all misconceptions, and from damaged answers.

use course::trial::{Examination, examine};
use course::{Concept, Exercise, InProcess, Picture, Plain, Reply, Value};
use glam::Vec3;
use rayon::prelude::*;
use testkit::effort;
use vocabulary::{Barycentric, Buffers, Pixel};

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

/// The exercises whose drawings show a screen.
fn on_a_screen() -> impl Iterator<Item = &'static Exercise> {
    course::all().iter().filter(|exercise| exercise.concept == Concept::Zbuffer)
}

#[test]
fn every_wrong_answer_to_an_example_of_the_z_buffer_is_drawn() {
    for exercise in on_a_screen() {
        for misconception in &exercise.misconceptions {
            for example in &exercise.examples {
                let Ok(Reply::Value(given)) =
                    InProcess(misconception.program.function).reply(&example.arguments)
                else {
                    continue;
                };
                let who = format!("{} by {}", exercise.name, misconception.program.name);
                let mut wrong = InProcess(misconception.program.function);
                let picture = exercise.picture(&example.arguments, Some(&given), &mut wrong);
                let picture = picture.unwrap_or_else(|| panic!("{who}: no picture"));
                assert_fits(&picture, &who);
            }
        }
    }
}

/// No number of a shape is none, and the text fits a terminal.
fn assert_fits(picture: &Picture, who: &str) {
    let shapes = picture.svg.split('<').filter(|tag| !tag.starts_with("text") && !tag.starts_with("style"));
    for shape in shapes {
        let attributes = shape.split('>').next().unwrap_or_default();
        assert!(!attributes.contains("NaN") && !attributes.contains("inf"), "{who}: {attributes}");
    }
    for line in picture.text.iter().flat_map(|text| text.lines()) {
        assert!(line.chars().count() <= 76, "{who}: {line}");
    }
}

#[test]
fn absurd_answers_break_no_drawing_of_the_z_buffer() {
    let many = Value::List(vec![Value::Whole(7); 1000]);
    let rows = vec![vec![f32::NAN; 2], Vec::new()];
    let absurd = [
        Value::Number(f32::NAN),
        Value::Number(f32::NEG_INFINITY),
        Value::Number(1e38),
        Some(Barycentric { alpha: f32::NAN, beta: f32::INFINITY, gamma: 1e30 }).into_value(),
        Buffers { rgb: vec![vec![Vec3::NAN; 9]; 9], z: rows }.into_value(),
        Buffers { rgb: Vec::new(), z: Vec::new() }.into_value(),
        vec![Pixel { i: u32::MAX, j: 0 }; 50].into_value(),
        Value::Nothing,
        many,
    ];
    for exercise in on_a_screen() {
        for example in &exercise.examples {
            for given in absurd.iter().map(Some).chain([None]) {
                let who = format!("{} given {given:?}", exercise.name);
                let mut right = InProcess(exercise.reference.function);
                let picture = exercise.picture(&example.arguments, given, &mut right);
                assert_fits(&picture.unwrap_or_else(|| panic!("{who}: no picture")), &who);
            }
        }
    }
}
