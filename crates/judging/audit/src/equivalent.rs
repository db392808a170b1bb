//! Which mutants are no less right than the original, and why?
//!
//! They are listed in `equivalent.diff`, each as the lines that change, under the exercise's name and the reason:
//!
//! ```text
//! == ray_sphere
//! # A ray that touches may count as a hit or not: the task leaves it open.
//! - if discriminant < 0.0 {
//! + if discriminant <= 0.0 {
//! ```
//!
//! A reason holds for all changes up to the next reason. An entry that no mutant has, or whose mutant is rejected, is a mistake of the list.

use crate::mutants::Change;

/// The list.
const LIST: &str = include_str!("../equivalent.diff");

/// A mutant that is as right as the original.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Equivalent {
    /// The exercise's name.
    pub exercise: String,
    /// Its lines before…
    pub before: Vec<String>,
    /// …and after.
    pub after: Vec<String>,
    /// Why nothing is wrong with it.
    pub reason: String,
    /// The line of the list, from 1.
    pub line: usize,
}

impl Equivalent {
    /// Whether it is this change of that exercise.
    pub fn is(&self, exercise: &str, change: &Change) -> bool {
        self.exercise == exercise && self.before == change.before && self.after == change.after
    }
}

/// All of them.
pub fn all() -> Vec<Equivalent> {
    read(LIST)
}

fn read(list: &str) -> Vec<Equivalent> {
    let mut found: Vec<Equivalent> = Vec::new();
    let (mut exercise, mut reason) = (String::new(), String::new());
    // What the line before this one was.
    let mut previous = ' ';
    for (at, line) in list.lines().enumerate() {
        let (mark, text) = line.split_at(line.len().min(2));
        let text = text.trim();
        match mark {
            "==" => text.clone_into(&mut exercise),
            "# " if previous == '#' => reason = format!("{reason} {text}"),
            "# " => text.clone_into(&mut reason),
            "- " | "+ " => {
                let begins = mark == "- " && previous != '-';
                if begins || found.is_empty() {
                    let (exercise, reason) = (exercise.clone(), reason.clone());
                    found.push(Equivalent { exercise, reason, before: vec![], after: vec![], line: at + 1 });
                }
                if let Some(last) = found.last_mut() {
                    let side = if mark == "- " { &mut last.before } else { &mut last.after };
                    side.push(text.to_owned());
                }
            }
            _ => {}
        }
        previous = mark.chars().next().unwrap_or(' ');
    }
    found
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_reason_holds_for_all_changes_beneath_it() {
        let list = "== one\n# Because\n# of this.\n- a\n+ b\n- a\n- c\n+ d\n\n# Else.\n- e\n== two\n# Why.\n- a\n+ b\n";
        let read = read(list);
        let reasons: Vec<&str> = read.iter().map(|it| it.reason.as_str()).collect();
        assert_eq!(reasons, ["Because of this.", "Because of this.", "Else.", "Why."]);
        assert_eq!(read[1].before, ["a", "c"]);
        assert_eq!(read[1].after, ["d"]);
        assert_eq!(read[2].after, [""; 0]);
        assert_eq!((read[3].exercise.as_str(), read[3].line), ("two", 14));
    }

    #[test]
    fn the_list_names_exercises_and_gives_reasons() {
        for Equivalent { exercise, reason, before, line, .. } in all() {
            assert!(course::find(&exercise).is_some(), "line {line}: no exercise {exercise:?}");
            assert!(reason.len() > 20 && reason.ends_with('.'), "line {line}: no reason");
            assert!(!before.is_empty(), "line {line}: nothing changes");
        }
    }
}
