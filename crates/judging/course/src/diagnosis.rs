//! Which misconception does a wrong answer look like? The one that gives the same wrong answers.

use worker::Value;

use crate::answerer::{InProcess, Reply};
use crate::exercise::{Exercise, Misconception};

/// Two answers are the same if their numbers are no further apart, relative for those above 1. Far above rounding, far below
/// the difference that a misconception makes.
const SAME: f32 = 1e-3;

/// So many inputs at least on which misconception and solution differ: fewer may be an accident.
const FEWEST_TELLING: usize = 2;

/// Of the telling inputs, the share on which the student's answer must be that of the misconception.
const LEAST_AGREEMENT: f64 = 0.9;

/// A misconception that a wrong function looks like.
#[derive(Clone, Copy, Debug)]
pub struct Diagnosis<'a> {
    /// Which.
    pub misconception: &'a Misconception,
    /// On so many inputs misconception and solution differ…
    pub telling: usize,
    /// …and on so many of these the function gives the misconception's answer.
    pub agreeing: usize,
}

/// The misconception that a function looks like, by the answers that it gave. `None` if it looks like none of those known.
///
/// Of several, the one that agrees on the most telling inputs, and where these are as many, the one that agrees with the
/// function on more inputs altogether.
pub fn diagnose<'a>(exercise: &'a Exercise, answered: &[(Vec<Value>, Value)]) -> Option<Diagnosis<'a>> {
    let right: Vec<Option<Value>> =
        answered.iter().map(|(question, _)| value_of(exercise.reference.function, question)).collect();
    let looks = exercise.misconceptions.iter().filter_map(|misconception| {
        let mut telling = 0;
        let mut agreeing = 0;
        let mut alike = 0;
        for ((question, given), right) in answered.iter().zip(&right) {
            let (Some(right), Some(wrong)) = (right, value_of(misconception.program.function, question))
            else {
                continue;
            };
            let agrees = same(given, &wrong);
            alike += usize::from(agrees);
            if !same(right, &wrong) {
                telling += 1;
                agreeing += usize::from(agrees);
            }
        }
        let enough = telling >= FEWEST_TELLING && agreeing as f64 >= LEAST_AGREEMENT * telling as f64;
        enough.then_some((alike, Diagnosis { misconception, telling, agreeing }))
    });
    // The first of the best, so that the order in the exercise's file decides where nothing else does.
    let best = looks.reduce(|best, next| {
        let better = (next.1.agreeing, next.0) > (best.1.agreeing, best.0);
        if better { next } else { best }
    });
    best.map(|(_, diagnosis)| diagnosis)
}

fn value_of(function: worker::Function, question: &[Value]) -> Option<Value> {
    match InProcess(function).reply(question) {
        Ok(Reply::Value(value)) => Some(value),
        _ => None,
    }
}

/// Whether two answers are the same but for rounding. NaN is not the same as anything.
pub fn same(a: &Value, b: &Value) -> bool {
    a.distance(b).is_some_and(|distance| distance <= SAME)
}
