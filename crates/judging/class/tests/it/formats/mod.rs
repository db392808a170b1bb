//! Would each platform accept what is written for it? Read back by strict readers: no field that the platform does not know, every one that it
//! wants, counts and sums exact, lengths within its limits.

mod codegrade_v2;
mod exercism;
mod github_classroom;
mod gradescope;
mod junit;
mod prairielearn;

use crate::made_up::{SECRET, absent, hostile, outline, perfect};
use class::format::{Format, NoFormat};
use class::results::{LawResult, Submission};

/// Submissions of every kind.
fn submissions() -> Vec<Submission> {
    let mut all = crate::made_up::class(12).submissions;
    all.extend([absent(), perfect(), hostile()]);
    all
}

/// A submission in a format.
fn written(format: Format, submission: &Submission) -> String {
    format.of(&outline(), submission)
}

/// So many laws are kept, of so many of the course.
fn laws(submission: &Submission) -> (usize, usize) {
    let kept = submission
        .verdicts
        .iter()
        .flat_map(|it| &it.laws)
        .filter(|it| matches!(it.result, LawResult::Kept(_)));
    (kept.count(), outline().exercises.iter().map(|it| it.laws.len()).sum())
}

#[test]
fn a_format_is_found_by_its_name() {
    for format in Format::ALL {
        assert_eq!(format.name().parse(), Ok(format));
    }
    assert_eq!("moodle".parse::<Format>(), Err(NoFormat("moodle".to_owned())));
    let said = NoFormat("moodle".to_owned()).to_string();
    assert!(Format::ALL.iter().all(|format| said.contains(format.name())), "{said}");
}

#[test]
fn the_same_submission_gives_the_same_bytes() {
    for format in Format::ALL {
        assert_eq!(written(format, &hostile()), written(format, &hostile()), "{format}");
    }
}

#[test]
fn nothing_for_the_staff_is_in_any_format() {
    let hidden = SECRET.trim_start_matches('/');
    for format in Format::ALL {
        let mut text = written(format, &hostile());
        if format == Format::GithubClassroom {
            text = github_classroom::decoded(&text);
        }
        assert!(!text.contains(hidden), "{format}");
        assert!(
            text.contains("was ignored") || !says_notices(format),
            "{format} leaves out the student's notice"
        );
    }
}

/// Whether the format has a place for what is said of the whole.
fn says_notices(format: Format) -> bool {
    !matches!(format, Format::CodegradeV1 | Format::Exercism)
}

#[test]
fn nothing_moves_a_cursor_in_any_format() {
    for format in Format::ALL {
        let text = written(format, &hostile());
        let text = if format == Format::GithubClassroom { github_classroom::decoded(&text) } else { text };
        // In JSON a control character is written as an escape.
        for escape in ["\u{1b}", "\\u001b", "\\u0000", "\\b", "\\f", "\u{202e}", "\u{9b}", "\0"] {
            let text = if escape.starts_with('\\') { text.replace("\\\\", "") } else { text.clone() };
            assert!(!text.contains(escape), "{format} holds {escape:?}");
        }
    }
}
