//! Does a submission that attacks get the outcome that is its own, no points, and nothing of anybody else's?
//!
//! - `reaching`: files, sockets, processes, signals.
//! - `taking`: time, memory, threads, disk.
//! - `answering`: the channel of answers.
//! - `compiling`: what is done to the compiler.

mod answering;
mod compiling;
mod reaching;
mod taking;

use crate::bench::{Bench, in_function};
use grader::{Judgement, Outcome};

/// A right answer.
const RIGHT: &str = "Mat3::from_translation(p) * Mat3::from_angle(theta) * Mat3::from_translation(-p)";

/// Judges files one after another, and then an honest one, which must come out as if nothing had been.
fn judged(sources: &[Vec<u8>]) -> Vec<Judgement> {
    let Some(bench) = Bench::confined() else { return Vec::new() };
    let judgements = sources.iter().map(|source| bench.judge(source)).collect();
    assert_honest(&bench.judge(&in_function(RIGHT)));
    judgements
}

/// The same of functions with these bodies, which are compiled together. Each is asked in a process of its own all the same.
fn judged_bodies(bodies: &[&str]) -> Vec<Judgement> {
    let Some(bench) = Bench::confined() else { return Vec::new() };
    let with_honest: Vec<&str> = bodies.iter().copied().chain([RIGHT]).collect();
    let mut judgements = bench.judge_bodies(&with_honest);
    assert_honest(&judgements.pop().expect("the last one"));
    judgements
}

/// Asserts that nothing of what came before harmed a right program.
fn assert_honest(after: &Judgement) {
    assert_eq!(after.outcome, Outcome::Passed, "the one after it: {after:?}");
    assert_eq!(after.points, after.of);
    assert!(after.printed.out.text.is_empty() && after.printed.err.text.is_empty(), "{:?}", after.printed);
}

/// Asserts that each of these expressions, which are true where an attack succeeds, is false: where one succeeds, the answers are right.
fn assert_refused(attacks: &[String]) {
    let body = |attack: &String| format!("if {attack} {{ return {RIGHT}; }}\n    panic!(\"refused\")");
    let bodies: Vec<String> = attacks.iter().map(body).collect();
    let bodies: Vec<&str> = bodies.iter().map(String::as_str).collect();
    for (judgement, attack) in judged_bodies(&bodies).iter().zip(attacks) {
        match &judgement.outcome {
            Outcome::Panicked(panic) if panic.message == "refused" => {}
            other => panic!("{attack}: {other:?}"),
        }
        assert_eq!(judgement.points, 0, "{attack}");
    }
}

/// Asserts what becomes of each of these bodies, none of which gets a point.
fn assert_outcomes(bodies: &[&str], expected: impl Fn(&Outcome) -> bool) {
    for (judgement, body) in judged_bodies(bodies).iter().zip(bodies) {
        assert!(expected(&judgement.outcome), "{body}: {:?}", judgement.outcome);
        assert_eq!(judgement.points, 0, "{body}: {judgement:?}");
    }
}
