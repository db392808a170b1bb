//! PrairieLearn's results.json.

use base64::Engine;
use base64::engine::general_purpose::STANDARD;
use class::format::Format;
use class::results::Outcome;
use serde::Deserialize;

use crate::formats::{laws, submissions, written};
use crate::made_up::{JUDGED, hostile, perfect, submission, without_answer};

/// A longer file is refused.
const MOST: usize = 1_000_000;

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Results {
    gradable: bool,
    score: Option<f64>,
    #[serde(default)]
    format_errors: Vec<String>,
    message: String,
    tests: Vec<Test>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Test {
    name: String,
    description: String,
    points: f64,
    max_points: f64,
    message: String,
    output: String,
    #[serde(default)]
    images: Vec<Image>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Image {
    label: String,
    url: String,
}

fn read(text: &str) -> Results {
    assert!(text.len() <= MOST, "{} bytes", text.len());
    serde_json::from_str(text).expect("PrairieLearn's fields")
}

#[test]
fn prairielearn_reads_a_score_and_tests_that_add_up() {
    for submission in submissions() {
        let results = read(&written(Format::Prairielearn, &submission));
        assert_eq!(results.score.is_some(), results.gradable);
        assert_eq!(results.format_errors.is_empty(), results.gradable);
        let (points, of) = (f64::from(submission.points), f64::from(submission.of));
        assert!(
            results
                .score
                .is_none_or(|score| (0.0..=1.0).contains(&score) && (score * of - points).abs() < 1e-9)
        );
        assert_eq!(results.tests.iter().map(|it| it.points).sum::<f64>(), points);
        assert_eq!(results.tests.iter().map(|it| it.max_points).sum::<f64>(), of);
        assert_eq!(results.tests.len(), laws(&submission).1);
        assert!(results.message.contains(&format!("{} of {} points", submission.points, submission.of)));
        for test in &results.tests {
            assert!(!test.name.is_empty() && !test.description.is_empty());
            assert_eq!(test.message.is_empty(), test.points == test.max_points, "{}", test.name);
            assert!(test.output.is_empty() || !test.message.is_empty());
        }
    }
}

#[test]
fn prairielearn_shows_drawings_that_are_images() {
    let drawn = JUDGED.iter().map(|it| it[1].clone()).collect();
    let student = submission("x", "X", Vec::new(), drawn);
    let results = read(&written(Format::Prairielearn, &student));
    let images: Vec<&Image> = results.tests.iter().flat_map(|it| &it.images).collect();
    assert!(images.len() > 20, "only {} drawings", images.len());
    for image in images {
        let svg = image.url.strip_prefix("data:image/svg+xml;base64,").expect("a drawing");
        let svg = String::from_utf8(STANDARD.decode(svg).expect("base64")).expect("UTF-8");
        assert!(roxmltree::Document::parse(&svg).is_ok() && !image.label.is_empty());
    }
}

#[test]
fn prairielearn_leaves_out_drawings_before_it_refuses_the_file() {
    let mut verdict = JUDGED.iter().flatten().find(|it| it.picture.is_some()).expect("a drawing").clone();
    let picture = verdict.picture.as_mut().expect("a drawing");
    picture.svg = picture.svg.replace("</svg>", &format!("<desc>{}</desc></svg>", "long ".repeat(300_000)));
    let results = read(&written(Format::Prairielearn, &submission("x", "X", Vec::new(), vec![verdict])));
    assert!(results.tests.iter().all(|it| it.images.is_empty()) && results.score.is_some());
}

#[test]
fn prairielearn_takes_no_attempt_for_what_could_not_be_judged() {
    let gradable = |outcomes: &[Outcome]| {
        let verdicts = course::all()
            .iter()
            .zip(outcomes)
            .map(|(it, outcome)| without_answer(it, *outcome, "words"))
            .collect();
        read(&written(Format::Prairielearn, &submission("x", "X", Vec::new(), verdicts))).gradable
    };
    assert!(!gradable(&[Outcome::DoesNotCompile, Outcome::Missing]));
    assert!(gradable(&[Outcome::DoesNotCompile, Outcome::Panicked]));
    assert!(!gradable(&[Outcome::Panicked, Outcome::GraderError]));
    assert!(read(&written(Format::Prairielearn, &perfect())).gradable);
    let hostile = read(&written(Format::Prairielearn, &hostile()));
    // Of two exercises the grader failed on.
    assert_eq!(hostile.format_errors.len(), 2);
}
