//! GitHub Classroom's results: what the reporter decodes, and what two versions of it compute.

use base64::Engine;
use base64::engine::general_purpose::STANDARD;
use class::format::Format;
use serde::Deserialize;

use crate::formats::{submissions, written};

/// No program gets a longer variable from Linux: MAX_ARG_STRLEN.
const LONGEST_VARIABLE: usize = 131_072;

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Results {
    version: u32,
    status: Status,
    max_score: u32,
    tests: Vec<Test>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Test {
    name: String,
    status: Status,
    score: u32,
    message: String,
    #[serde(rename = "test_code")]
    _test_code: String,
}

#[derive(Deserialize, PartialEq)]
#[serde(rename_all = "snake_case")]
enum Status {
    Pass,
    Fail,
}

/// The JSON in it.
pub(crate) fn decoded(text: &str) -> String {
    String::from_utf8(STANDARD.decode(text).expect("base64 without line ends")).expect("UTF-8")
}

#[test]
fn github_classroom_computes_the_points_by_either_rule() {
    for submission in submissions() {
        let text = written(Format::GithubClassroom, &submission);
        assert!("LIGHTLAB_RESULTS=".len() + text.len() < LONGEST_VARIABLE, "{} bytes", text.len());
        let results: Results = serde_json::from_str(&decoded(&text)).expect("the reporter's fields");
        assert_eq!((results.version, results.max_score), (1, submission.of));
        let sum: u32 = results.tests.iter().map(|it| it.score).sum();
        let passed = results.tests.iter().filter(|it| it.status == Status::Pass).count() as u32;
        assert_eq!(sum, submission.points);
        assert_eq!(passed * results.max_score, sum * results.tests.len() as u32);
        assert_eq!(results.status == Status::Pass, submission.points == submission.of);
        let mut names: Vec<&str> = results.tests.iter().map(|it| it.name.as_str()).collect();
        names.sort_unstable();
        names.dedup();
        assert_eq!(names.len(), results.tests.len(), "two tests have one name");
        assert!(results.tests.iter().all(|it| it.status == Status::Fail || it.score == 1));
        let is_said = results.tests.iter().any(|it| it.status == Status::Fail && !it.message.is_empty());
        assert_eq!(is_said, submission.points < submission.of);
    }
}
