//! Verdicts saved submission by submission, so that an interrupted run continues where it stopped.

use std::fs;
use std::io;
use std::path::{Path, PathBuf};

use serde::{Deserialize, Serialize};

use crate::digest::Digest;
use crate::results::{Outcome, Verdict};

/// The folder in a report that holds one checkpoint per submission.
pub const FOLDER: &str = "judged";

/// A submission's verdicts, with everything they depend on.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Checkpoint {
    pub(crate) conditions: Conditions,
    pub(crate) verdicts: Vec<Verdict>,
    /// The SHA-256 of the two above when they were written: hexadecimal.
    digest: String,
}

/// Everything that a verdict depends on. A submission is judged again if any of these differs.
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

impl Checkpoint {
    pub(crate) fn new(conditions: Conditions, verdicts: Vec<Verdict>) -> Self {
        let digest = digest(&conditions, &verdicts);
        Self { conditions, verdicts, digest }
    }

    /// What is kept under this id; `None` where nothing is, or nothing that can be read, or where somebody has changed it: then it is judged again.
    pub(crate) fn read(report: &Path, id: &str) -> Option<Self> {
        let kept: Self = serde_json::from_slice(&fs::read(path(report, id)).ok()?).ok()?;
        (!kept.was_changed()).then_some(kept)
    }

    /// Whether it is no longer as it was written.
    pub(crate) fn was_changed(&self) -> bool {
        self.digest != digest(&self.conditions, &self.verdicts)
    }

    /// Whether the grader failed at something: next time it may not.
    pub(crate) fn failed(&self) -> bool {
        self.verdicts.iter().any(|verdict| verdict.outcome == Outcome::GraderError)
    }

    pub(crate) fn bytes(&self) -> io::Result<Vec<u8>> {
        Ok(serde_json::to_vec(self)?)
    }
}

fn digest(conditions: &Conditions, verdicts: &[Verdict]) -> String {
    let json = serde_json::to_vec(&(conditions, verdicts));
    Digest::of([json.unwrap_or_default().as_slice()]).hexadecimal()
}
