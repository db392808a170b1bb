//! How do points come into a spreadsheet? As a table of RFC 4180: a row a student, a column an exercise.
//!
//! The file begins with a byte order mark. Who opens it by a double click has Excel, which takes a file without one for Windows-1252 and
//! garbles every name with an accent. LibreOffice, Google Sheets, R's readr and pandas skip the mark; Python's `csv` does with
//! `encoding="utf-8-sig"`. Programs had better read `results.json`.

use crate::results::{Results, Submission};

use super::foreign::line;

/// What tells spreadsheets that it is UTF-8.
const BYTE_ORDER_MARK: char = '\u{feff}';

/// The points of a class: id, student, points, of, then each exercise's points in the course's order. Lines end in CR LF.
pub fn grades_csv(results: &Results) -> String {
    let mut text = String::from(BYTE_ORDER_MARK);
    let exercises: Vec<&str> = results.course.exercises.iter().map(|it| it.name.as_str()).collect();
    let header: Vec<String> =
        ["id", "student", "points", "of"].iter().chain(&exercises).map(|cell| field(cell)).collect();
    push_row(&mut text, &header);
    for submission in &results.submissions {
        push_row(&mut text, &row(submission, &exercises));
    }
    text
}

fn row(submission: &Submission, exercises: &[&str]) -> Vec<String> {
    let points = |name: &&str| {
        let verdict = submission.verdicts.iter().find(|verdict| verdict.exercise == **name);
        verdict.map_or(String::new(), |verdict| verdict.points.to_string())
    };
    let mut cells = vec![
        field(&submission.id),
        field(&submission.student),
        submission.points.to_string(),
        submission.of.to_string(),
    ];
    cells.extend(exercises.iter().map(points));
    cells
}

fn push_row(text: &mut String, cells: &[String]) {
    text.push_str(&cells.join(","));
    text.push_str("\r\n");
}

/// A cell: one line, never a formula, quoted where it must be.
fn field(text: &str) -> String {
    let line = line(text);
    // Decided by the original: a tab in front is gone from the line, and was no accident.
    let formula = [text, &line].iter().any(|text| text.starts_with(begins_a_formula));
    let line = if formula { format!("'{line}") } else { line };
    if line.contains(['"', ',', ';', '\'']) || line.trim() != line {
        format!("\"{}\"", line.replace('"', "\"\""))
    } else {
        line
    }
}

/// What makes a spreadsheet compute, in the wide form too.
fn begins_a_formula(c: char) -> bool {
    matches!(
        c,
        '=' | '+' | '-' | '@' | '\t' | '\r' | '\n' | '\u{ff1d}' | '\u{ff0b}' | '\u{ff0d}' | '\u{ff20}'
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_formula_is_a_text() {
        for (given, cell) in [
            ("=cmd()", "\"'=cmd()\""),
            ("+1", "\"'+1\""),
            ("-1", "\"'-1\""),
            ("@x", "\"'@x\""),
            ("\t=1", "\"'=1\""),
            ("\r=1", "\"'=1\""),
            (" =1", "\"'=1\""),
            ("\u{ff1d}1", "\"'\u{ff1d}1\""),
            ("a=1", "a=1"),
        ] {
            assert_eq!(field(given), cell);
        }
    }

    #[test]
    fn quotes_and_separators_are_quoted() {
        assert_eq!(field("O\"Neil, Bob"), "\"O\"\"Neil, Bob\"");
        assert_eq!(field("two\nlines"), "two lines");
        assert_eq!(field("plain é"), "plain é");
    }
}
