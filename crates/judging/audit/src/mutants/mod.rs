//! Which wrong programs are one slip away from a right one?
//!
//! The right one's text is read as Rust, and at each place something is changed that a tired student might write: another operator, a sign, a
//! border, two arguments exchanged, a call left out. Only the text changes, so a mutant looks like the original but for a line or two; whether it
//! compiles is for the compiler to say. Read `finder` next.

mod calls;
mod choices;
mod finder;
mod names;
mod numbers;
mod operators;
#[cfg(test)]
mod tests;

use std::collections::BTreeSet;
use std::ops::Range;

use syn::visit::Visit;

/// A program that differs from a right one in a single place.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Mutant {
    /// The whole file.
    pub text: String,
    /// The line of the change, from 1.
    pub line: usize,
    /// The change.
    pub change: Change,
}

/// What was changed.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Change {
    /// In a few words: "border moved".
    pub kind: &'static str,
    /// The lines that changed, as they were, without indentation.
    pub before: Vec<String>,
    /// The same as they are now.
    pub after: Vec<String>,
}

/// A change of the text, not yet made.
#[derive(Clone, Debug, PartialEq, Eq)]
struct Edit {
    kind: &'static str,
    range: Range<usize>,
    text: String,
}

/// All mutants of the functions in a file, in the order of their places; each text once.
///
/// # Errors
/// The file is not Rust.
pub fn mutants(text: &str) -> Result<Vec<Mutant>, syn::Error> {
    let file = syn::parse_file(text)?;
    let mut finder = finder::Finder::new(text);
    finder.visit_file(&file);
    let mut edits = finder.edits;
    edits.sort_by_key(|edit| (edit.range.start, edit.range.end));
    let mut met = BTreeSet::from([text.to_owned()]);
    let made = edits.iter().map(|edit| made(text, edit));
    Ok(made
        .filter(|mutant| met.insert(mutant.text.clone()) && syn::parse_file(&mutant.text).is_ok())
        .collect())
}

fn made(text: &str, edit: &Edit) -> Mutant {
    let changed = format!("{}{}{}", &text[..edit.range.start], edit.text, &text[edit.range.end..]);
    let (at, before, after) = difference(text, &changed);
    Mutant { line: at + 1, change: Change { kind: edit.kind, before, after }, text: changed }
}

/// The first line in which two texts differ, from 0, and the lines of both that differ, trimmed; empty ones are left out.
fn difference(a: &str, b: &str) -> (usize, Vec<String>, Vec<String>) {
    let (a, b): (Vec<&str>, Vec<&str>) = (a.lines().collect(), b.lines().collect());
    let first = a.iter().zip(&b).take_while(|(a, b)| a == b).count();
    let most = a.len().min(b.len()) - first;
    let last = a.iter().rev().zip(b.iter().rev()).take(most).take_while(|(a, b)| a == b).count();
    let lines = |of: &[&str]| -> Vec<String> {
        let trimmed = of[first..of.len() - last].iter().map(|line| line.trim().to_owned());
        trimmed.filter(|line| !line.is_empty()).collect()
    };
    (first, lines(&a), lines(&b))
}
