//! Why may a law's being kept not be worth its points? A function of an exercise depends on its arguments, and on nothing else.
//!
//! Laws that compare two calls (do it, undo it) are also kept by a function that remembers what it was asked; many a law is kept by a function
//! that says the same to everything. Neither has computed what was asked for.

use std::slice;

use course::trial::Examination;
use course::{Answerer, Exercise, Fault, InProcess, Reply, Value, diagnosis, values};
use worker::identical;

/// So many of the answered calls are repeated at most.
const REPEATED: usize = 200;

/// A call that was answered in two ways.
#[derive(Clone, Debug, PartialEq)]
pub struct Twice {
    /// What it was called with.
    pub arguments: Vec<Value>,
    /// What it gave at first.
    pub first: Value,
    /// What it gave when it was asked again, in a fresh process, among other calls.
    pub again: Reply,
}

/// Repeats calls in a fresh process, the last first; the call that is answered otherwise than before, if there is one.
///
/// # Errors
/// [`Fault`]: there is no fresh process.
pub(crate) fn unsteady(examination: &Examination, fresh: &mut dyn Answerer) -> Result<Option<Twice>, Fault> {
    let answered = &examination.answered;
    let step = answered.len().div_ceil(REPEATED).max(1);
    let repeated: Vec<&(Vec<Value>, Value)> = answered.iter().rev().step_by(step).collect();
    let questions: Vec<Vec<Value>> = repeated.iter().map(|(arguments, _)| arguments.clone()).collect();
    let replies = fresh.ask(&questions)?;
    let otherwise = repeated.into_iter().zip(replies).find(|((_, first), again)| match again {
        Reply::Value(again) => !same(first, again),
        Reply::Panicked(_) | Reply::Lost(_) => true,
    });
    Ok(otherwise.map(|((arguments, first), again)| Twice {
        arguments: arguments.clone(),
        first: first.clone(),
        again,
    }))
}

/// Whether one answer was given to every call, though calls were made that have different right answers.
pub(crate) fn is_constant(exercise: &Exercise, examination: &Examination) -> bool {
    let Some((_, one)) = examination.answered.first() else { return false };
    if examination.passed() || !examination.answered.iter().all(|(_, answer)| same(answer, one)) {
        return false;
    }
    let questions: Vec<Vec<Value>> =
        examination.answered.iter().map(|(arguments, _)| arguments.clone()).collect();
    let right = values(&mut InProcess(exercise.reference.function), &questions);
    right.iter().flatten().any(|answer| right.iter().flatten().any(|other| !same(answer, other)))
}

/// The same but for rounding (sums in the order of a hash table differ by that), or the same NaN.
fn same(a: &Value, b: &Value) -> bool {
    identical(slice::from_ref(a), slice::from_ref(b)) || diagnosis::same(a, b)
}
