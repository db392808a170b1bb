//! Gradescope's results.json, as its specification has it.

use class::format::Format;
use serde::Deserialize;

use crate::formats::{laws, submissions, written};
use crate::made_up::perfect;

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Results {
    score: f64,
    output: String,
    output_format: TextFormat,
    visibility: Visibility,
    stdout_visibility: Visibility,
    tests: Vec<Test>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Test {
    score: f64,
    max_score: f64,
    status: Status,
    name: String,
    name_format: TextFormat,
    number: String,
    output: String,
    output_format: TextFormat,
    visibility: Visibility,
}

#[derive(Deserialize, PartialEq, Debug)]
#[serde(rename_all = "snake_case")]
enum Visibility {
    Hidden,
    AfterDueDate,
    AfterPublished,
    Visible,
}

#[derive(Deserialize, PartialEq, Debug)]
#[serde(rename_all = "snake_case")]
enum TextFormat {
    Text,
    SimpleFormat,
    Html,
    Md,
    Ansi,
}

#[derive(Deserialize, PartialEq, Debug)]
#[serde(rename_all = "snake_case")]
enum Status {
    Passed,
    Failed,
}

#[test]
fn gradescope_reads_scores_that_add_up() {
    for submission in submissions() {
        let text = written(Format::Gradescope, &submission);
        assert!(text.len() <= 1_000_000, "{} bytes", text.len());
        let results: Results = serde_json::from_str(&text).expect("Gradescope's fields");
        assert_eq!(results.score, f64::from(submission.points));
        assert_eq!(results.tests.iter().map(|it| it.score).sum::<f64>(), results.score);
        assert_eq!(results.tests.iter().map(|it| it.max_score).sum::<f64>(), f64::from(submission.of));
        assert_eq!(results.tests.len(), laws(&submission).1);
        let passed = results.tests.iter().filter(|it| it.status == Status::Passed);
        assert_eq!(passed.count(), laws(&submission).0);
        for test in &results.tests {
            assert_eq!(test.score == test.max_score, test.status == Status::Passed, "{}", test.name);
            assert_eq!(test.output.is_empty(), test.status == Status::Passed, "{}", test.name);
            assert_eq!((&test.name_format, &test.output_format), (&TextFormat::Text, &TextFormat::Text));
            // A hidden test hides the total from the students.
            assert_eq!(test.visibility, Visibility::Visible);
            assert!(!test.name.contains('\n'));
        }
        assert_eq!(
            (results.visibility, results.stdout_visibility),
            (Visibility::Visible, Visibility::Hidden)
        );
        assert!(results.output_format == TextFormat::Md && !results.output.is_empty());
    }
}

#[test]
fn gradescope_numbers_laws_within_exercises() {
    let text = written(Format::Gradescope, &perfect());
    let results: Results = serde_json::from_str(&text).expect("Gradescope's fields");
    assert_eq!(results.tests[0].number, "1.1");
    let numbers: Vec<(u32, u32)> = results
        .tests
        .iter()
        .map(|it| it.number.split_once('.').expect("a point"))
        .map(|(exercise, law)| (exercise.parse().expect("a number"), law.parse().expect("a number")))
        .collect();
    assert!(numbers.is_sorted() && numbers.last().is_some_and(|last| last.0 == 35));
}
