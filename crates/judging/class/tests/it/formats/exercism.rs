//! Exercism's results.json, version 3.

use class::format::Format;
use class::results::Outcome;
use serde::Deserialize;

use crate::formats::{laws, submissions, written};
use crate::made_up::{hostile, outline, submission, without_answer};

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Results {
    version: u32,
    status: Status,
    message: Option<String>,
    tests: Vec<Test>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Test {
    name: String,
    status: Status,
    message: Option<String>,
    output: Option<String>,
    test_code: String,
    task_id: usize,
}

#[derive(Deserialize, PartialEq, Debug, Clone, Copy)]
#[serde(rename_all = "snake_case")]
enum Status {
    Pass,
    Fail,
    Error,
}

#[test]
fn exercism_reads_every_test_in_order_and_within_its_limits() {
    let mut seen = Vec::new();
    for submission in submissions() {
        let results: Results =
            serde_json::from_str(&written(Format::Exercism, &submission)).expect("Exercism's fields");
        assert_eq!(results.version, 3);
        let passed = results.tests.iter().filter(|it| it.status == Status::Pass).count();
        assert_eq!((passed, results.tests.len()), laws(&submission));
        assert_eq!(results.status == Status::Pass, passed == results.tests.len());
        // `error` on top means that no test was run; only then is there a message on top.
        assert_eq!(results.status == Status::Error, submission.verdicts.iter().all(|it| it.laws.is_empty()));
        assert_eq!(results.message.is_some(), results.status == Status::Error);
        assert!(results.message.is_none_or(|it| !it.is_empty() && it.chars().count() <= 65_535));
        let order: Vec<String> = outline()
            .exercises
            .iter()
            .flat_map(|it| it.laws.iter().map(|law| format!("{}: {}", it.name, law.statement)))
            .collect();
        assert_eq!(results.tests.iter().map(|it| it.name.clone()).collect::<Vec<_>>(), order);
        for test in &results.tests {
            assert_eq!(test.message.is_none(), test.status == Status::Pass);
            assert!(test.message.as_ref().is_none_or(|it| !it.is_empty() && it.chars().count() <= 65_535));
            assert!(test.output.as_ref().is_none_or(|it| it.chars().count() <= 500));
            assert!((1..=35).contains(&test.task_id) && !test.test_code.is_empty());
        }
        seen.push(results.status);
    }
    assert!([Status::Pass, Status::Fail, Status::Error].iter().all(|it| seen.contains(it)), "{seen:?}");
}

#[test]
fn exercism_is_told_where_an_output_was_cut() {
    let results: Results =
        serde_json::from_str(&written(Format::Exercism, &hostile())).expect("Exercism's fields");
    let output = results.tests.iter().find_map(|it| it.output.as_deref()).expect("it prints");
    assert!(output.contains("more bytes)"), "{output}");
}

#[test]
fn exercism_reads_a_long_compiler_message_within_the_limit() {
    let long = "error: this does not end\n".repeat(10_000);
    let verdicts =
        course::all().iter().map(|it| without_answer(it, Outcome::DoesNotCompile, &long)).collect();
    let all_broken = submission("x", "X", Vec::new(), verdicts);
    let results: Results =
        serde_json::from_str(&written(Format::Exercism, &all_broken)).expect("Exercism's fields");
    let message = results.message.expect("why");
    assert!(results.status == Status::Error && message.contains("mismatched types"));
    assert!((60_000..=65_535).contains(&message.len()), "{} bytes", message.len());
}
