//! Who is in the class, and which of the folders, archives and loose files is whose?

use std::collections::{BTreeMap, BTreeSet};
use std::ffi::OsStr;
use std::fs;
use std::io;
use std::path::{Path, PathBuf};

use super::candidates::{is_of_an_exercise, is_stray, listed, quoted};
use super::names::{self, Kind, Named};
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
        let found: Vec<fs::DirEntry> = fs::read_dir(folder).and_then(Iterator::collect).map_err(failed)?;
        let names: BTreeSet<String> =
            found.iter().map(|entry| stem(&spelled(&entry.file_name())).to_owned()).collect();
        for entry in found {
            let name = spelled(&entry.file_name());
            if name == "__MACOSX" || name == ".DS_Store" {
                continue;
            }
            let named =
                if is_stray(&name) { None } else { whose(&name, entry.file_type().map_err(failed)?, &names) };
            match named {
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
        let named = names::plain(stem(&name));
        let students = BTreeMap::from([(named.key.clone(), vec![(named, name, real)])]);
        Ok(Self { entries: entries(students), remarks: Vec::new() })
    }
}

/// Whose a folder, an archive or a loose file is; `None` for what is nobody's.
fn whose(name: &str, kind: fs::FileType, names: &BTreeSet<String>) -> Option<Named> {
    if kind.is_dir() {
        return Some(
            names::of_a_platform(name, Kind::Folder).unwrap_or_else(|| names::of_a_person(name, names)),
        );
    }
    if !kind.is_file() {
        // Links lead elsewhere.
        return None;
    }
    let is_archive = name.to_lowercase().ends_with(".zip");
    match names::of_a_platform(name, Kind::File) {
        // A platform's notes about a submission are no part of it.
        Some(named) => {
            let own = named.own_name.as_deref().unwrap_or_default();
            (is_archive || is_of_an_exercise(own)).then_some(named)
        }
        None if is_archive => {
            let name = stem(name);
            Some(names::of_a_platform(name, Kind::Folder).unwrap_or_else(|| names::of_a_person(name, names)))
        }
        None => None,
    }
}

/// A name as text. Where it is none, its bytes tell it apart from others that look the same.
fn spelled(name: &OsStr) -> String {
    match name.to_str() {
        Some(name) => name.to_owned(),
        None => {
            let sum = Sum::of([name.as_encoded_bytes()]).hexadecimal();
            format!("{} {}", name.to_string_lossy(), &sum[..6])
        }
    }
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
    let sum = Sum::of([key.as_bytes()]).hexadecimal();
    let ids = (10..=sum.len()).map(|length| format!("{plain}-{}", &sum[..length]));
    // Somebody may bear a name that looks like another's id.
    ids.into_iter().find(|id| taken.insert(id.to_ascii_lowercase())).unwrap_or(sum)
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
