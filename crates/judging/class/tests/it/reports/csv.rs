//! The table of points.

use class::report::grades_csv;

use crate::made_up::{class, everyone, submission};

/// Reads a table as RFC 4180 has it, and nothing else.
pub(crate) fn strict_csv(text: &str) -> Vec<Vec<String>> {
    let mut rows = vec![vec![String::new()]];
    let mut rest = text.chars().peekable();
    while let Some(c) = rest.next() {
        let row = rows.last_mut().expect("at least one");
        let cell = row.last_mut().expect("at least one");
        match c {
            '"' => {
                assert!(cell.is_empty(), "a quote within {cell:?}");
                loop {
                    match rest.next().expect("a quote ends") {
                        '"' if rest.peek() == Some(&'"') => cell.push(rest.next().expect("a quote")),
                        '"' => break,
                        c => cell.push(c),
                    }
                }
                assert!(matches!(rest.peek(), Some(',' | '\r')), "something after {cell:?}");
            }
            ',' => row.push(String::new()),
            '\r' => {
                assert_eq!(rest.next(), Some('\n'));
                rows.push(vec![String::new()]);
            }
            '\n' => panic!("a line feed alone"),
            c => cell.push(c),
        }
    }
    assert_eq!(rows.pop(), Some(vec![String::new()]), "the last line ends too");
    rows
}

#[test]
fn the_table_of_points_is_read_by_a_strict_reader() {
    let results = everyone();
    let text = grades_csv(&results);
    let rows = strict_csv(text.strip_prefix('\u{feff}').expect("a byte order mark"));
    let exercises: Vec<&str> = results.course.exercises.iter().map(|it| it.name.as_str()).collect();
    assert_eq!(rows[0], ["id", "student", "points", "of"].into_iter().chain(exercises).collect::<Vec<_>>());
    assert_eq!(rows.len(), 1 + results.submissions.len());
    for (row, submission) in rows[1..].iter().zip(&results.submissions) {
        assert_eq!(row.len(), 4 + 35);
        assert_eq!(
            (&row[0], &row[2], &row[3]),
            (&submission.id, &submission.points.to_string(), &submission.of.to_string())
        );
        let sum: u32 = row[4..].iter().map(|points| points.parse::<u32>().expect("a number")).sum();
        assert_eq!(sum, submission.points);
    }
}

#[test]
fn no_cell_is_a_formula() {
    let mut results = class(0);
    for (at, start) in
        ["=", "+", "-", "@", "\t=", "\r=", "\n=", " =", "\u{1b}[m=", "\u{ff1d}"].iter().enumerate()
    {
        results.submissions.push(submission(
            &format!("-{at}"),
            &format!("{start}cmd()"),
            Vec::new(),
            Vec::new(),
        ));
    }
    results.course.exercises.clear();
    for row in &strict_csv(grades_csv(&results).trim_start_matches('\u{feff}'))[1..] {
        for cell in row {
            assert!(!cell.starts_with(['=', '+', '-', '@', '\t', '\r', '\n', '\u{ff1d}']), "{cell:?}");
        }
    }
}
