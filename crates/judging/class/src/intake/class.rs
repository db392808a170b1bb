//! Who is in the class, and which of the folders, archives and loose files is whose?

use std::collections::{BTreeMap, BTreeSet};
use std::ffi::OsStr;
use std::fs;
use std::io;
use std::path::{Path, PathBuf};

use super::candidates::{is_hidden, is_of_an_exercise, is_stray, listed, quoted};
use super::names::{self, Kind, Named};
use super::{Entry, Place};
use crate::digest::Digest;
use crate::results::{Audience, Notice};

/// An id is cut to so many characters, with the fingerprint behind it.
const LONGEST_ID: usize = 48;

/// A class: its submissions, not yet read.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Class {
    /// One a student, in the order of their ids.
    pub entries: Vec<Entry>,
    /// What in the class's folder belongs to nobody: a sentence for each reason.
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
        let mut nobodys: BTreeMap<Nobodys, Vec<String>> = BTreeMap::new();
        let found: Vec<fs::DirEntry> = fs::read_dir(folder).and_then(Iterator::collect).map_err(failed)?;
        let names: BTreeSet<String> =
            found.iter().map(|entry| stem(&spelled(&entry.file_name())).to_owned()).collect();
        for entry in found {
            let name = spelled(&entry.file_name());
            if name == "__MACOSX" || name == ".DS_Store" {
                continue;
            }
            match whose(&name, entry.file_type().map_err(failed)?, &names) {
                Ok(named) => {
                    students.entry(named.key.clone()).or_default().push((named, name, entry.path()));
                }
                Err(reason) => nobodys.entry(reason).or_default().push(name),
            }
        }
        if students.is_empty() {
            return Err(ClassError::Empty(folder.to_owned()));
        }
        let remarks = nobodys.into_iter().map(|(reason, names)| reason.remark(names)).collect();
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

/// Why something in the class's folder is nobody's submission.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
enum Nobodys {
    /// Its name begins with a dot.
    Hidden,
    /// It leads elsewhere.
    Link,
    /// It is a folder that tools make.
    Stray,
    /// It is a file, but neither an archive nor of an exercise.
    Other,
}

impl Nobodys {
    fn remark(self, mut names: Vec<String>) -> String {
        names.sort();
        let names = listed(&names);
        // Last, since there may be many of them.
        match self {
            Self::Hidden => format!(
                "hidden, so nobody's submission (if one is a student's, give it a name that does not begin with a dot): {names}"
            ),
            Self::Link => format!(
                "symbolic links, so not followed (if one is a student's, copy what it points to): {names}"
            ),
            Self::Stray => {
                format!("made by tools, so nobody's submission (if one is a student's, rename it): {names}")
            }
            Self::Other => format!("nobody's submission, and ignored: {names}"),
        }
    }
}

/// Returns the student who owns this folder, archive or loose file, or the reason why nobody does.
fn whose(name: &str, kind: fs::FileType, names: &BTreeSet<String>) -> Result<Named, Nobodys> {
    if is_stray(name) {
        return Err(Nobodys::Stray);
    }
    if is_hidden(name) {
        return Err(Nobodys::Hidden);
    }
    if kind.is_symlink() {
        return Err(Nobodys::Link);
    }
    if kind.is_dir() {
        return Ok(
            names::of_a_platform(name, Kind::Folder).unwrap_or_else(|| names::of_a_person(name, names))
        );
    }
    if !kind.is_file() {
        return Err(Nobodys::Other);
    }
    let is_archive = name.to_lowercase().ends_with(".zip");
    match names::of_a_platform(name, Kind::File) {
        // A platform's notes about a submission are no part of it.
        Some(named) => {
            let own = named.own_name.as_deref().unwrap_or_default();
            if is_archive || is_of_an_exercise(own) { Ok(named) } else { Err(Nobodys::Other) }
        }
        None if is_archive => {
            let name = stem(name);
            Ok(names::of_a_platform(name, Kind::Folder).unwrap_or_else(|| names::of_a_person(name, names)))
        }
        None => Err(Nobodys::Other),
    }
}

/// A name as text. Where it is none, its bytes tell it apart from others that look the same.
fn spelled(name: &OsStr) -> String {
    match name.to_str() {
        Some(name) => name.to_owned(),
        None => {
            let sum = Digest::of([name.as_encoded_bytes()]).hexadecimal();
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

/// Returns a name for files: letters, digits, `-`, `_`. Where something else had to go, a fingerprint keeps it unlike any other.
///
/// It does not begin with `-`: a spreadsheet would compute it and a shell take it for a flag, and a table that escapes it would show another id.
fn id(key: &str, taken: &mut BTreeSet<String>) -> String {
    let fits = |at: usize, c: char| c.is_ascii_alphanumeric() || c == '_' || (c == '-' && at > 0);
    let plain: String =
        key.chars().enumerate().map(|(at, c)| if fits(at, c) { c } else { '_' }).take(LONGEST_ID).collect();
    let lower = plain.to_ascii_lowercase();
    let unchanged = plain == key && !key.is_empty() && !is_device(&lower) && taken.insert(lower);
    if unchanged {
        return plain;
    }
    let sum = Digest::of([key.as_bytes()]).hexadecimal();
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
