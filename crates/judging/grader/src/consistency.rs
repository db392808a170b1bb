//! Two checks that a function computes its answer from its arguments: it answers a repeated call the same, and it is not constant.
//!
//! Laws that compare two calls (do, undo) also hold for a function that remembers its calls, and many laws hold for a function that always
//! returns the same value. Neither earns points.

use std::slice;

use course::trial::{Examination, Outcome, Tried, examine};
use course::{Answerer, Exercise, Fault, InProcess, Reply, Value, diagnosis, values};
use worker::identical;

/// Maximum number of answered calls that are repeated.
const REPEATED: usize = 200;

/// A call that gave two different answers.
#[derive(Clone, Debug, PartialEq)]
pub struct InconsistentCall {
    /// The arguments.
    pub arguments: Vec<Value>,
    /// The first answer.
    pub first: Value,
    /// The answer to the same call in a new process, among other calls.
    pub again: Reply,
}

/// Repeats calls in a new process, the last one first, and returns the first call whose answer differs.
///
/// # Errors
/// [`Fault`]: there is no fresh process.
pub(crate) fn unsteady(
    examination: &Examination,
    fresh: &mut dyn Answerer,
) -> Result<Option<InconsistentCall>, Fault> {
    let answered = &examination.answered;
    let step = answered.len().div_ceil(REPEATED).max(1);
    let repeated: Vec<&(Vec<Value>, Value)> = answered.iter().rev().step_by(step).collect();
    let questions: Vec<Vec<Value>> = repeated.iter().map(|(arguments, _)| arguments.clone()).collect();
    let replies = fresh.ask(&questions)?;
    let otherwise = repeated.into_iter().zip(replies).find(|((_, first), again)| match again {
        Reply::Value(again) => !same(first, again),
        Reply::Panicked(_) | Reply::Lost(_) => true,
    });
    Ok(otherwise.map(|((arguments, first), again)| InconsistentCall {
        arguments: arguments.clone(),
        first: first.clone(),
        again,
    }))
}

/// True if the function gives nearly always one answer, though calls were made that have different right answers, and every law that holds also holds
/// for a function that gives this answer and no other. How it fails in the other calls does not matter.
///
/// # Errors
/// [`Fault`]: a law is at fault.
pub(crate) fn is_constant(exercise: &Exercise, seed: u64, examination: &Examination) -> Result<bool, Fault> {
    let answered = sample(examination);
    let given: Vec<&Value> = answered.iter().map(|(_, answer)| answer).collect();
    let Some((usual, times)) = most_frequent(&given) else { return Ok(false) };
    let right = right_answers(exercise, &answered);
    let vary = right.iter().flatten().any(|answer| right.iter().flatten().any(|other| !same(answer, other)));
    if examination.passed() || !vary || (times as f64) < NEARLY * given.len() as f64 {
        return Ok(false);
    }
    // Where there are few answers to choose from, the usual one may be right as a rule. So what tells is how often another comes where another is right.
    let elsewhere =
        given.iter().zip(&right).filter(|(_, right)| right.as_ref().is_some_and(|right| !same(right, usual)));
    let (moved, all) = elsewhere
        .fold((0, 0), |(moved, all), (answer, _)| (moved + usize::from(!same(answer, usual)), all + 1));
    if moved as f64 >= OFTEN * f64::from(all) {
        return Ok(false);
    }
    let constant = examine(exercise, seed, &mut Always(usual))?;
    let kept = |law: &Tried| matches!(law.outcome, Outcome::Kept(_));
    Ok(examination.laws.iter().zip(&constant.laws).all(|(law, constant)| !kept(law) || kept(constant)))
}

/// A function is nearly constant that gives this share of its answers alike. Wrong programs that people write reach it too, but most keep a law that
/// no constant keeps.
const NEARLY: f64 = 0.9;

/// A function that gives another answer in this share of the calls in which the usual one is wrong is no constant: so does a sphere that is sought at the
/// origin. A constant that varies in one call of forty does not.
const OFTEN: f64 = 0.05;

/// Some of the calls, evenly, but none with which a smaller counterexample was sought.
fn sample(examination: &Examination) -> Vec<&(Vec<Value>, Value)> {
    let mut sought = examination.sought.iter().peekable();
    let answered = examination.answered.iter().enumerate();
    let answered: Vec<_> = answered
        .filter(|(at, _)| sought.next_if(|next| *next == at).is_none())
        .map(|(_, call)| call)
        .collect();
    answered.iter().copied().step_by(answered.len().div_ceil(2 * REPEATED).max(1)).collect()
}

/// The value that occurs most often, and how often.
fn most_frequent<'a>(values: &[&'a Value]) -> Option<(&'a Value, usize)> {
    let times = |one: &Value| values.iter().filter(|other| same(one, other)).count();
    values.iter().map(|one| (*one, times(one))).max_by_key(|(_, times)| *times)
}

fn right_answers(exercise: &Exercise, answered: &[&(Vec<Value>, Value)]) -> Vec<Option<Value>> {
    let questions: Vec<Vec<Value>> = answered.iter().map(|(arguments, _)| arguments.clone()).collect();
    values(&mut InProcess(exercise.reference.function), &questions)
}

/// Gives one answer to everything.
struct Always<'a>(&'a Value);

impl Answerer for Always<'_> {
    fn ask(&mut self, questions: &[Vec<Value>]) -> Result<Vec<Reply>, Fault> {
        Ok(questions.iter().map(|_| Reply::Value(self.0.clone())).collect())
    }
}

/// The same but for rounding (sums in the order of a hash table differ by that), or the same NaN.
fn same(a: &Value, b: &Value) -> bool {
    identical(slice::from_ref(a), slice::from_ref(b)) || diagnosis::same(a, b)
}

#[cfg(test)]
mod tests {
    use super::*;

    use worker::glam::{Mat4, Vec3};
    use worker::vocabulary::{Basis, Sphere};

    #[test]
    fn no_wrong_program_that_people_write_is_taken_for_a_constant() {
        for exercise in course::all() {
            for misconception in &exercise.misconceptions {
                // This one gives no light at all but in one call of sixteen, and nothing else that it gives is right.
                let dark = misconception.program.name == "reflected_into_the_surface";
                let function = misconception.program.function;
                let examination = examine(exercise, 1, &mut InProcess(function)).expect("examined");
                let constant = is_constant(exercise, 1, &examination).expect("laws");
                assert_eq!(constant, dark, "{} by {}", exercise.name, misconception.program.name);
            }
        }
    }

    /// Says that light comes through but in one place, where a worked example asks.
    fn light_but_in_one_place(_point: Vec3, light: Vec3, spheres: &[Sphere]) -> bool {
        light == Vec3::new(0.0, 6.0, 1.0) && spheres.len() == 2
    }

    /// Gives nothing but in one call of forty.
    fn nothing_as_a_rule(eye: Vec3, frame: Basis) -> Mat4 {
        let bits = [eye.x, eye.y, eye.z, frame.u.x, frame.v.y].map(f32::to_bits);
        let mixed = bits.iter().fold(7_u32, |sum, bits| sum.wrapping_mul(0x9e37_79b1) ^ bits ^ (bits >> 15));
        if (mixed >> 7).is_multiple_of(40) { Mat4::from_scale(Vec3::new(1.0, 1.0, -1.0)) } else { Mat4::ZERO }
    }

    #[test]
    fn a_constant_is_none_the_less_one_for_a_few_other_answers() {
        let shadow =
            worker::function!(light_but_in_one_place, (point: Vec3, light: Vec3, spheres: &[Sphere]) -> bool);
        let nothing = worker::function!(nothing_as_a_rule, (eye: Vec3, frame: Basis) -> Mat4);
        for (name, function) in [("in_shadow", shadow), ("camera_from_world", nothing)] {
            let exercise = course::find(name).expect("the exercise");
            for seed in 1..=4 {
                let examination = examine(exercise, seed, &mut InProcess(function)).expect("examined");
                assert!(is_constant(exercise, seed, &examination).expect("laws"), "{name}, seed {seed}");
            }
        }
    }

    #[test]
    fn the_most_frequent_value_is_found_among_others() {
        let values = [1.0, 2.0, 2.0, 3.0].map(Value::Number);
        let found = most_frequent(&values.each_ref());
        assert_eq!(found, Some((&values[1], 2)));
        assert_eq!(most_frequent(&[]), None);
    }
}
