//! What lies in the folder of a report? Files that are all made from the results.

use std::path::{Path, PathBuf};

use crate::merge::RESULTS;
use crate::results::{Results, Seeds};

/// The file that says with which seed a run was begun, so that it can be gone on with.
pub const RUN: &str = "run.json";

/// Every file of a report but what is kept of each submission, in the order in which they are to be written: the results last, so that whoever
/// finds them finds all.
pub fn files(results: &Results) -> impl Iterator<Item = (PathBuf, Vec<u8>)> {
    let last = [(PathBuf::from(RESULTS), results_json(results))];
    last.into_iter()
}

/// `results.json`: all but pictures.
fn results_json(results: &Results) -> Vec<u8> {
    let mut plain = results.clone();
    for verdict in plain.submissions.iter_mut().flat_map(|submission| &mut submission.verdicts) {
        verdict.picture = None;
    }
    lines(serde_json::to_string_pretty(&plain))
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
