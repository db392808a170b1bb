//! CodeGrade AutoTest V2's messages.

use class::format::Format;
use serde::Deserialize;

use crate::formats::{laws, submissions, written};

/// Messages that are longer are dropped.
const MOST: usize = 250_000;

#[derive(Deserialize)]
#[serde(tag = "tag", rename_all = "kebab-case", deny_unknown_fields)]
enum Message {
    UnitTest { results: Vec<Suite> },
    Points { points: String },
}

#[derive(Deserialize)]
#[serde(rename_all = "camelCase", deny_unknown_fields)]
struct Suite {
    id: String,
    name: String,
    weight: String,
    test_cases: Vec<Case>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Case {
    name: String,
    status: Status,
    description: String,
    weight: String,
    reason: String,
    stdout: String,
    #[serde(rename = "stderr")]
    _stderr: String,
}

#[derive(Deserialize, PartialEq)]
#[serde(rename_all = "snake_case")]
enum Status {
    Success,
    Failure,
}

fn number(text: &str) -> u32 {
    text.parse().expect("a whole number as a string")
}

#[test]
fn codegrade_v2_reads_two_messages_that_say_the_same() {
    for submission in submissions() {
        let text = written(Format::CodegradeV2, &submission);
        let lines: Vec<&str> = text.strip_suffix('\n').expect("the last line ends").split('\n').collect();
        assert_eq!(lines.len(), 2);
        assert!(lines.iter().all(|line| line.len() <= MOST), "{} bytes", lines[0].len());
        let messages: Vec<Message> =
            lines.iter().map(|line| serde_json::from_str(line).expect("a message")).collect();
        let [Message::UnitTest { results }, Message::Points { points }] = &messages[..] else {
            panic!("tests, then points");
        };
        assert_eq!(*points, format!("{}/{}", submission.points, submission.of));
        let mut got = 0;
        for suite in results {
            assert!(!suite.id.is_empty() && suite.name.contains(&suite.id));
            let weights: u32 = suite.test_cases.iter().map(|it| number(&it.weight)).sum();
            assert_eq!(number(&suite.weight), weights, "{}", suite.id);
            for case in &suite.test_cases {
                assert!(!case.name.is_empty() && !case.description.is_empty());
                let passed = case.status == Status::Success;
                got += if passed { number(&case.weight) } else { 0 };
                assert_eq!(case.reason.is_empty(), passed, "{}: {}", suite.id, case.name);
            }
        }
        assert_eq!(got, submission.points);
        let cases: Vec<&Case> = results.iter().flat_map(|it| &it.test_cases).collect();
        assert_eq!(
            (cases.iter().filter(|it| it.status == Status::Success).count(), cases.len()),
            laws(&submission)
        );
        let printed = cases.iter().filter(|it| !it.stdout.is_empty()).count();
        assert!(printed <= results.len() + 1, "what was printed stands once an exercise");
    }
}
