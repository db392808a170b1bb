//! What lies in the folder of a report? Files that are all made from the results.

use std::path::{Path, PathBuf};

use crate::format::Format;
use crate::merge::RESULTS;
use crate::report::{class_page, feedback_markdown, feedback_page, grades_csv};
use crate::results::{Results, Seeds};

/// The file that says with which seed a run was begun, so that it can be gone on with.
pub const RUN: &str = "run.json";

/// Every file of a report but what is kept of each submission, in the order in which they are to be written: the results last, so that whoever
/// finds them finds all.
pub fn files<'a>(
    results: &'a Results,
    formats: &'a [Format],
) -> impl Iterator<Item = (PathBuf, Vec<u8>)> + 'a {
    let each = results.submissions.iter().flat_map(move |submission| {
        let id = &submission.id;
        let course = &results.course;
        let feedback = [
            (PathBuf::from(format!("feedback/{id}.html")), feedback_page(course, submission)),
            (PathBuf::from(format!("feedback/{id}.md")), feedback_markdown(course, submission)),
        ];
        let platforms = formats.iter().map(move |format| {
            let path = PathBuf::from(format!("{}/{id}.{}", format.name(), format.extension()));
            (path, format.of(course, submission))
        });
        feedback.into_iter().chain(platforms).map(|(path, text)| (path, text.into_bytes()))
    });
    // Made only when it is their turn: a page of a large class is large.
    let class: [(&str, Make); 3] = [
        ("class.html", |results| class_page(results).into_bytes()),
        ("grades.csv", |results| grades_csv(results).into_bytes()),
        (RESULTS, results_json),
    ];
    each.chain(class.into_iter().map(move |(name, make)| (PathBuf::from(name), make(results))))
}

type Make = fn(&Results) -> Vec<u8>;

/// `results.json`: all but pictures.
fn results_json(results: &Results) -> Vec<u8> {
    lines(serde_json::to_string_pretty(&results.without_pictures()))
}

/// `run.json`.
pub fn run_json(seeds: &Seeds) -> Vec<u8> {
    lines(serde_json::to_string_pretty(seeds))
}

/// Reads `run.json`; `None` where there is none that can be read.
pub fn read_run(report: &Path) -> Option<Seeds> {
    serde_json::from_slice(&std::fs::read(report.join(RUN)).ok()?).ok()
}

/// Strings and numbers can always be written.
fn lines(json: serde_json::Result<String>) -> Vec<u8> {
    let mut text = json.unwrap_or_default();
    text.push('\n');
    text.into_bytes()
}
