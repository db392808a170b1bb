//! How do the parts of a class that several machines judged become one?
//!
//! Nobody may be lost on the way, and no points changed: each part lists the whole class, and bears a digest of what it says.

mod error;
#[cfg(test)]
mod tests;

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};

use crate::checkpoint::{self, Checkpoint};
use crate::partition::Partition;
use crate::results::{Listed, Results, SCHEMA, Submission, VERSION};

pub use error::MergeError;

/// The name of the file that says all but pictures.
pub const RESULTS: &str = "results.json";

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
/// [`MergeError`]: they cannot be read, or are not as they were written.
pub fn read_with_pictures(report: &Path) -> Result<Results, MergeError> {
    complete(report, read(report)?)
}

/// The results of a report, with the pictures that lie beside them.
fn complete(report: &Path, mut results: Results) -> Result<Results, MergeError> {
    if results.digest.as_ref().is_some_and(|digest| *digest != results.digest_of_content()) {
        return Err(MergeError::Changed { path: report.join(RESULTS) });
    }
    for submission in &mut results.submissions {
        with_pictures(report, submission)?;
    }
    Ok(results)
}

fn with_pictures(report: &Path, submission: &mut Submission) -> Result<(), MergeError> {
    let path = checkpoint::path(report, &submission.id);
    let bytes = fs::read(&path).map_err(|error| MergeError::Io { path: path.clone(), error })?;
    let kept: Checkpoint = serde_json::from_slice(&bytes)
        .map_err(|error| MergeError::Torn { path: path.clone(), what: error.to_string() })?;
    if kept.was_changed() {
        return Err(MergeError::Changed { path });
    }
    let mut without = kept.verdicts.clone();
    without.iter_mut().for_each(|verdict| verdict.picture = None);
    if without != submission.verdicts {
        return Err(MergeError::Torn { path, what: format!("holds other verdicts than {RESULTS}") });
    }
    submission.verdicts = kept.verdicts;
    Ok(())
}

/// The results of one part of a class.
struct PartialResults<'a> {
    folder: &'a Path,
    results: Results,
    share: Partition,
}

impl<'a> PartialResults<'a> {
    fn read(folder: &'a Path) -> Result<Self, MergeError> {
        let results = read(folder)?;
        let share = results.partition.as_deref().and_then(|share| share.parse().ok());
        match share {
            // A class has at least one submission.
            Some(share) if results.digest.is_some() && !results.roster.is_empty() => {
                Ok(Self { folder, results: complete(folder, results)?, share })
            }
            _ => Err(MergeError::NotAPart { path: folder.join(RESULTS) }),
        }
    }
}

/// Puts parts together: the same results as if one machine had judged all.
///
/// # Errors
/// [`MergeError`]: a part cannot be read, is missing, there twice, was changed, is of another class or was judged otherwise than the others.
pub fn merge(folders: &[PathBuf]) -> Result<Results, MergeError> {
    let parts: Vec<PartialResults<'_>> =
        folders.iter().map(|folder| PartialResults::read(folder)).collect::<Result<_, _>>()?;
    let Some((first, others)) = parts.split_first() else {
        return Err(MergeError::Missing { of: 1, missing: "1".to_owned() });
    };
    for other in others {
        alike(first, other)?;
        same_class(first, other)?;
    }
    nobody_twice(&parts)?;
    all_parts(&parts)?;
    everybody_once(&parts)?;
    Ok(together(parts))
}

fn alike(one: &PartialResults<'_>, other: &PartialResults<'_>) -> Result<(), MergeError> {
    let (a, b) = (&one.results, &other.results);
    let differs = [
        (a.course != b.course, "the version of the course"),
        (a.seeds != b.seeds, "the seed"),
        (a.sandboxed != b.sandboxed, "the sandbox"),
        (!one.share.shares_like(&other.share), "the way of sharing (--partition)"),
    ];
    match differs.into_iter().find(|(differs, _)| *differs) {
        Some((_, what)) => {
            Err(MergeError::Unlike { one: one.folder.to_owned(), other: other.folder.to_owned(), what })
        }
        None => Ok(()),
    }
}

/// Whether both list the same submissions.
fn same_class(one: &PartialResults<'_>, other: &PartialResults<'_>) -> Result<(), MergeError> {
    let (a, b) = (by_id(&one.results.roster), by_id(&other.results.roster));
    let only_in = |part: &PartialResults<'_>, id: &str| format!("only {} lists {id}", part.folder.display());
    let what = a
        .iter()
        .find_map(|(id, fingerprint)| match b.get(id) {
            None => Some(only_in(one, id)),
            Some(other) if other != fingerprint => Some(format!("what {id} handed in differs")),
            Some(_) => None,
        })
        .or_else(|| b.keys().find(|id| !a.contains_key(*id)).map(|id| only_in(other, id)));
    match what {
        Some(what) => {
            Err(MergeError::OtherClass { one: one.folder.to_owned(), other: other.folder.to_owned(), what })
        }
        None => Ok(()),
    }
}

fn by_id(roster: &[Listed]) -> BTreeMap<&str, &str> {
    roster.iter().map(|listed| (listed.id.as_str(), listed.fingerprint.as_str())).collect()
}

fn nobody_twice(parts: &[PartialResults<'_>]) -> Result<(), MergeError> {
    let mut owners: BTreeMap<&str, &Path> = BTreeMap::new();
    for part in parts {
        for Submission { id, .. } in &part.results.submissions {
            if let Some(other) = owners.insert(id, part.folder) {
                let (one, other) = (other.to_owned(), part.folder.to_owned());
                return Err(MergeError::Twice { one, other, id: id.clone() });
            }
        }
    }
    Ok(())
}

/// Parts say how many there are.
fn all_parts(parts: &[PartialResults<'_>]) -> Result<(), MergeError> {
    let of = parts[0].share.of();
    let is_there = |number: usize| parts.iter().any(|part| part.share.part() == number);
    let missing: Vec<String> =
        (1..=of).filter(|number| !is_there(*number)).map(|number| number.to_string()).collect();
    if missing.is_empty() { Ok(()) } else { Err(MergeError::Missing { of, missing: missing.join(", ") }) }
}

/// Every submission of the class is in a part, as it was when the class was listed.
fn everybody_once(parts: &[PartialResults<'_>]) -> Result<(), MergeError> {
    let judged: BTreeMap<&str, (&PartialResults<'_>, &str)> = parts
        .iter()
        .flat_map(|part| part.results.submissions.iter().map(move |it| (part, it)))
        .map(|(part, it)| (it.id.as_str(), (part, it.fingerprint.as_str())))
        .collect();
    for Listed { id, fingerprint } in &parts[0].results.roster {
        match judged.get(id.as_str()) {
            None => return Err(MergeError::Nowhere { id: id.clone() }),
            Some((part, judged)) if judged != fingerprint => {
                return Err(MergeError::ChangedMeanwhile { part: part.folder.to_owned(), id: id.clone() });
            }
            Some(_) => {}
        }
    }
    Ok(())
}

/// The whole, from parts that fit together.
fn together(parts: Vec<PartialResults<'_>>) -> Results {
    let mut parts = parts.into_iter().map(|part| part.results);
    let mut whole = parts.next().expect("at least one part");
    for part in parts {
        whole.submissions.extend(part.submissions);
        let unknown: Vec<String> =
            part.remarks.into_iter().filter(|remark| !whole.remarks.contains(remark)).collect();
        whole.remarks.extend(unknown);
    }
    whole.submissions.sort_by(|a, b| a.id.cmp(&b.id));
    Results { partition: None, roster: Vec::new(), digest: None, ..whole }
}
