//! How do the parts of a class that several machines judged become one?

use std::collections::BTreeMap;
use std::fs;
use std::io;
use std::path::{Path, PathBuf};

use crate::kept::{self, Kept};
use crate::partition::Partition;
use crate::results::{Results, SCHEMA, Submission, VERSION};

/// The name of the file that says all but pictures.
pub const RESULTS: &str = "results.json";

/// Parts that do not make a class.
#[derive(Debug, thiserror::Error)]
pub enum MergeError {
    /// A file cannot be read.
    #[error("cannot read {path}: {error}")]
    Io {
        /// The file.
        path: PathBuf,
        /// What the system says.
        error: io::Error,
    },
    /// A file is not what its name says.
    #[error("{path}: {what}")]
    Torn {
        /// The file.
        path: PathBuf,
        /// What is wrong, with line and column.
        what: String,
    },
    /// Parts that were judged differently.
    #[error("{one} and {other} were not judged alike: {what} differs")]
    Unlike {
        /// A part.
        one: PathBuf,
        /// Another one.
        other: PathBuf,
        /// What differs.
        what: &'static str,
    },
    /// A student in two parts.
    #[error("{one} and {other} both hold {id}")]
    Twice {
        /// A part.
        one: PathBuf,
        /// Another one.
        other: PathBuf,
        /// The student.
        id: String,
    },
    /// Not all parts are there.
    #[error("of {of} parts, these are missing: {missing}")]
    Missing {
        /// So many parts there are.
        of: usize,
        /// Their numbers.
        missing: String,
    },
}

/// Reads `results.json` of a report.
///
/// # Errors
/// [`MergeError::Io`], [`MergeError::Torn`].
pub fn read(report: &Path) -> Result<Results, MergeError> {
    let path = report.join(RESULTS);
    let bytes = fs::read(&path).map_err(|error| MergeError::Io { path: path.clone(), error })?;
    let torn = |what: String| MergeError::Torn { path: path.clone(), what };
    // Looked at first, so that another version is called that, and not torn.
    let head: serde_json::Value = serde_json::from_slice(&bytes).map_err(|e| torn(e.to_string()))?;
    if head["schema"] != SCHEMA {
        return Err(torn(format!("no results of a class: there is no \"schema\": \"{SCHEMA}\"")));
    }
    if head["version"] != VERSION {
        return Err(torn(format!(
            "written in version {}, this program reads version {VERSION}",
            head["version"]
        )));
    }
    serde_json::from_slice(&bytes).map_err(|e| torn(e.to_string()))
}

/// Reads a report's results, pictures and all.
///
/// # Errors
/// [`MergeError`]: they cannot be read.
pub fn read_with_pictures(report: &Path) -> Result<Results, MergeError> {
    let mut results = read(report)?;
    for submission in &mut results.submissions {
        with_pictures(report, submission)?;
    }
    Ok(results)
}

fn with_pictures(report: &Path, submission: &mut Submission) -> Result<(), MergeError> {
    let path = kept::path(report, &submission.id);
    let bytes = fs::read(&path).map_err(|error| MergeError::Io { path: path.clone(), error })?;
    let kept: Kept = serde_json::from_slice(&bytes)
        .map_err(|error| MergeError::Torn { path: path.clone(), what: error.to_string() })?;
    let mut without = kept.verdicts.clone();
    without.iter_mut().for_each(|verdict| verdict.picture = None);
    if without != submission.verdicts {
        return Err(MergeError::Torn { path, what: format!("holds other verdicts than {RESULTS}") });
    }
    submission.verdicts = kept.verdicts;
    Ok(())
}

/// Puts parts together.
///
/// # Errors
/// [`MergeError`]: a part cannot be read, is missing, there twice, or was judged otherwise than the others.
pub fn merge(parts: &[PathBuf]) -> Result<Results, MergeError> {
    let read: Vec<(&PathBuf, Results)> =
        parts.iter().map(|part| Ok((part, read_with_pictures(part)?))).collect::<Result<_, MergeError>>()?;
    let mut owners: BTreeMap<String, &PathBuf> = BTreeMap::new();
    let mut shares: BTreeMap<usize, usize> = BTreeMap::new();
    let mut whole: Option<(&PathBuf, Results)> = None;
    for (part, results) in read {
        for submission in &results.submissions {
            if let Some(other) = owners.insert(submission.id.clone(), part) {
                let id = submission.id.clone();
                return Err(MergeError::Twice { one: other.clone(), other: part.clone(), id });
            }
        }
        if let Some(share) = results.partition.as_deref().and_then(|share| share.parse::<Partition>().ok()) {
            shares.insert(share.part(), share.of());
        }
        match &mut whole {
            None => whole = Some((part, results)),
            Some((first, whole)) => {
                alike(first, whole, part, &results)?;
                whole.submissions.extend(results.submissions);
            }
        }
    }
    all_there(&shares)?;
    let Some((_, mut whole)) = whole else {
        return Err(MergeError::Missing { of: 1, missing: "1".to_owned() });
    };
    whole.partition = None;
    whole.submissions.sort_by(|a, b| a.id.cmp(&b.id));
    Ok(whole)
}

fn alike(one: &Path, a: &Results, other: &Path, b: &Results) -> Result<(), MergeError> {
    let differs = [
        (a.course != b.course, "the version of the course"),
        (a.seeds != b.seeds, "the seed"),
        (a.sandboxed != b.sandboxed, "the sandbox"),
    ];
    match differs.into_iter().find(|(differs, _)| *differs) {
        Some((_, what)) => Err(MergeError::Unlike { one: one.to_owned(), other: other.to_owned(), what }),
        None => Ok(()),
    }
}

/// Parts say how many there are.
fn all_there(shares: &BTreeMap<usize, usize>) -> Result<(), MergeError> {
    let Some(of) = shares.values().copied().max() else { return Ok(()) };
    let missing: Vec<String> =
        (1..=of).filter(|part| !shares.contains_key(part)).map(|part| part.to_string()).collect();
    if missing.is_empty() { Ok(()) } else { Err(MergeError::Missing { of, missing: missing.join(", ") }) }
}
