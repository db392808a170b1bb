//! What is already known of a submission when a run goes on that was ended?

use std::fs;
use std::io;
use std::path::{Path, PathBuf};

use serde::{Deserialize, Serialize};

use crate::results::{Outcome, Verdict};

/// Where, in the folder of a report, what was judged is kept: one file a submission.
pub const FOLDER: &str = "judged";

/// A submission's verdicts, and on what they depend.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Kept {
    pub(crate) conditions: Conditions,
    pub(crate) verdicts: Vec<Verdict>,
}

/// All that a verdict depends on. What differs in one of these is judged again.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Conditions {
    pub(crate) course: String,
    pub(crate) fingerprint: String,
    pub(crate) seed: u64,
    pub(crate) sandboxed: bool,
    /// Time and memory that a call may take.
    pub(crate) limits: String,
}

pub(crate) fn path(report: &Path, id: &str) -> PathBuf {
    report.join(FOLDER).join(format!("{id}.json"))
}

impl Kept {
    /// What is kept under this id; `None` where nothing is, or nothing that can be read: then it is judged again.
    pub(crate) fn read(report: &Path, id: &str) -> Option<Self> {
        serde_json::from_slice(&fs::read(path(report, id)).ok()?).ok()
    }

    /// Whether the grader failed at something: next time it may not.
    pub(crate) fn failed(&self) -> bool {
        self.verdicts.iter().any(|verdict| verdict.outcome == Outcome::GraderError)
    }

    pub(crate) fn bytes(&self) -> io::Result<Vec<u8>> {
        Ok(serde_json::to_vec(self)?)
    }
}
