//! The worked examples, one module an exercise.

use std::fmt::Debug;

/// Demands that an answer is the wanted one, up to `tolerance` for each number, relative for those above 1.
#[track_caller]
fn close(given: &impl Debug, wanted: &impl Debug, tolerance: f32) {
    let (given, wanted) = (format!("{given:?}"), format!("{wanted:?}"));
    let words = |text: &str| -> Vec<String> { text.split([' ', ',', '(', ')', '[', ']']).map(str::to_owned).collect() };
    let (a, b) = (words(&given), words(&wanted));
    let alike = a.len() == b.len() && a.iter().zip(&b).all(|(a, b)| are_close(a, b, tolerance));
    assert!(alike, "the answer is {given}, should be {wanted}");
}

/// Whether two words are the same, or two numbers close to each other.
fn are_close(a: &str, b: &str, tolerance: f32) -> bool {
    match (a.parse::<f32>(), b.parse::<f32>()) {
        (Ok(a), Ok(b)) => a == b || (a - b).abs() <= tolerance * a.abs().max(b.abs()).max(1.0),
        _ => a == b,
    }
}

