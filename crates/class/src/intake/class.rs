//! Who is in the class, and which of the folders, archives and loose files is whose?

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::io;
use std::path::{Path, PathBuf};

use super::candidates::{is_of_an_exercise, is_stray, listed, quoted};
use super::names::{self, Named};
use super::{Entry, Place};
use crate::results::{Audience, Notice};
use crate::sum::Sum;

/// An id is cut to so many characters, with the fingerprint behind it.
const LONGEST_ID: usize = 48;

/// A class: its submissions, not yet read.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Class {
    /// One a student, in the order of their ids.
    pub entries: Vec<Entry>,
    /// What in the class's folder belongs to nobody.
    pub remarks: Vec<String>,
}

/// There is no class to grade.
#[derive(Debug, thiserror::Error)]
pub enum ClassError {
    /// The folder cannot be read.
    #[error("cannot read {path}: {error}")]
    Io {
        /// The folder.
        path: PathBuf,
        /// What the system says.
        error: io::Error,
    },
    /// Nothing in it is a submission.
    #[error(
        "{0} holds no submission: neither folders nor zip archives, nor files with the name of an exercise"
    )]
    Empty(PathBuf),
}

/// All that belongs to one student, in the order of the attempts.
type Attempts = Vec<(Named, String, PathBuf)>;

impl Class {
    /// Looks through the class's folder.
    ///
    /// # Errors
    /// [`ClassError`]: it cannot be read, or holds no submission.
    pub fn read(folder: &Path) -> Result<Self, ClassError> {
        let failed = |error| ClassError::Io { path: folder.to_owned(), error };
        let mut students: BTreeMap<String, Attempts> = BTreeMap::new();
        let mut nobodys = Vec::new();
        for entry in fs::read_dir(folder).map_err(failed)? {
            let entry = entry.map_err(failed)?;
            let name = entry.file_name().to_string_lossy().into_owned();
            if is_stray(&name) {
                continue;
            }
            match whose(&name, entry.file_type().map_err(failed)?) {
                Some(named) => {
                    students.entry(named.key.clone()).or_default().push((named, name, entry.path()));
                }
                None => nobodys.push(name),
            }
        }
        if students.is_empty() {
            return Err(ClassError::Empty(folder.to_owned()));
        }
        nobodys.sort();
        let remarks = match nobodys.len() {
            0 => Vec::new(),
            _ => vec![format!("nobody's submission, and ignored: {}", listed(&nobodys))],
        };
        Ok(Self { entries: entries(students), remarks })
    }

    /// A class of one: the whole folder, or archive, is a submission.
    ///
    /// # Errors
    /// [`ClassError::Io`]: it is not there.
    pub fn single(path: &Path) -> Result<Self, ClassError> {
        let real = fs::canonicalize(path).map_err(|error| ClassError::Io { path: path.to_owned(), error })?;
        let name = real.file_name().unwrap_or_default().to_string_lossy().into_owned();
        let named = Named { attempt: String::new(), ..names::read(stem(&name), true) };
        let students = BTreeMap::from([(named.key.clone(), vec![(named, name, real)])]);
        Ok(Self { entries: entries(students), remarks: Vec::new() })
    }
}

/// Whose a folder, an archive or a loose file is; `None` for what is nobody's.
fn whose(name: &str, kind: fs::FileType) -> Option<Named> {
    let is_archive = kind.is_file() && name.to_lowercase().ends_with(".zip");
    if kind.is_dir() || is_archive {
        let named = names::read(stem(name), false);
        // A loose file's name keeps its ending; an archive's own name says nothing.
        return Some(Named { own_name: None, ..named });
    }
    let named = names::read(name, true);
    // Links lead elsewhere, and a platform's notes about a submission are no part of it.
    (kind.is_file() && is_of_an_exercise(named.own_name.as_deref()?)).then_some(named)
}

fn stem(name: &str) -> &str {
    let end = name.len().saturating_sub(4);
    match name.get(end..) {
        Some(ending) if ending.eq_ignore_ascii_case(".zip") => &name[..end],
        _ => name,
    }
}

fn entries(students: BTreeMap<String, Attempts>) -> Vec<Entry> {
    let mut taken = BTreeSet::new();
    let mut entries: Vec<Entry> =
        students.into_iter().map(|(key, attempts)| entry(&key, attempts, &mut taken)).collect();
    entries.sort_by(|a, b| a.id.cmp(&b.id));
    entries
}

fn entry(key: &str, mut attempts: Attempts, taken: &mut BTreeSet<String>) -> Entry {
    // Beside a folder or archive, loose files of the same student are an attempt like any other.
    attempts.sort_by(|a, b| (&a.0.attempt, &a.1).cmp(&(&b.0.attempt, &b.1)));
    let mut notices = Vec::new();
    let mut staff = |text: String| notices.push(Notice { audience: Audience::Staff, text });
    let loose = attempts.iter().all(|(named, _, _)| named.own_name.is_some());
    if attempts.iter().any(|(named, _, _)| named.late) {
        staff("Its name says that it came late.".to_owned());
    }
    let kept = if loose { loose_files(&mut attempts) } else { attempts.len().saturating_sub(1) };
    let earlier: Vec<String> = attempts.drain(..kept).map(|(_, name, _)| name).collect();
    if !earlier.is_empty() {
        staff(format!("The latest attempt was judged, not {}.", listed(&earlier)));
    }
    let source = attempts.last().map(|(_, name, _)| name.clone()).unwrap_or_default();
    let student = attempts.last().map(|(named, _, _)| named.student.clone()).unwrap_or_default();
    let places =
        attempts.into_iter().map(|(named, _, path)| Place { path, own_name: named.own_name }).collect();
    Entry { id: id(key, taken), student, source, notices, places }
}

/// Of loose files, each name counts once, in its latest form: puts those that are passed over first, and says how many they are.
fn loose_files(attempts: &mut Attempts) -> usize {
    let mut names = BTreeSet::new();
    let mut kept: Attempts = Vec::new();
    let mut passed_over: Attempts = Vec::new();
    for attempt in attempts.drain(..).rev() {
        let fresh = names.insert(attempt.0.own_name.clone());
        if fresh { kept.push(attempt) } else { passed_over.push(attempt) }
    }
    let count = passed_over.len();
    attempts.extend(passed_over.into_iter().rev().chain(kept.into_iter().rev()));
    count
}

/// A name for files: letters, digits, `-`, `_`; where something else had to go, a fingerprint keeps it unlike any other.
fn id(key: &str, taken: &mut BTreeSet<String>) -> String {
    let plain: String = key
        .chars()
        .map(|c| if c.is_ascii_alphanumeric() || "-_".contains(c) { c } else { '_' })
        .take(LONGEST_ID)
        .collect();
    let lower = plain.to_ascii_lowercase();
    let unchanged = plain == key && !key.is_empty() && !is_device(&lower) && taken.insert(lower);
    if unchanged {
        return plain;
    }
    let id = format!("{plain}-{}", &Sum::of([key.as_bytes()]).hexadecimal()[..10]);
    taken.insert(id.to_ascii_lowercase());
    id
}

/// Names that Windows keeps for devices.
fn is_device(lower: &str) -> bool {
    matches!(lower, "con" | "prn" | "aux" | "nul")
        || (lower.len() == 4 && (lower.starts_with("com") || lower.starts_with("lpt")))
}

/// For messages.
impl std::fmt::Display for Entry {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(&quoted(&self.student))
    }
}
