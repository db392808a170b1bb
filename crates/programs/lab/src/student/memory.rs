//! What was judged before, and which hints were read? A small file that can be lost without harm.

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};

use course::{Exercise, fingerprint};
use grader::{Judgement, bytes_of, version};
use serde_json::{Value as Json, json};

use crate::unfinished::Unfinished;

/// What is remembered of the exercises.
#[derive(Debug)]
pub(crate) struct Memory {
    path: PathBuf,
    entries: BTreeMap<String, Entry>,
}

/// What is remembered of one exercise.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
struct Entry {
    /// Fingerprint of the file that was judged.
    file: u64,
    /// Version of the exercise that judged it.
    version: u32,
    /// The outcome's word.
    outcome: String,
    points: u32,
    /// So many hints were read.
    hints: usize,
}

/// How an exercise stands, as far as is remembered.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Standing {
    /// The outcome's word.
    pub(crate) outcome: String,
    /// The points.
    pub(crate) points: u32,
}

impl Memory {
    /// What the file at `path` says; nothing where it is not there or damaged.
    pub(crate) fn read(path: &Path) -> Self {
        let text = fs::read_to_string(path).unwrap_or_default();
        let json: Json = serde_json::from_str(&text).unwrap_or_default();
        let entries = json.as_object().into_iter().flatten().filter_map(|(name, entry)| {
            let entry = Entry {
                file: entry["file"].as_u64()?,
                version: u32::try_from(entry["version"].as_u64()?).ok()?,
                outcome: entry["outcome"].as_str()?.to_owned(),
                points: u32::try_from(entry["points"].as_u64()?).ok()?,
                hints: usize::try_from(entry["hints"].as_u64()?).ok()?,
            };
            Some((name.clone(), entry))
        });
        Self { path: path.to_owned(), entries: entries.collect() }
    }

    /// How the exercise stands if this file of its, in these very bytes, was judged by this very exercise.
    pub(crate) fn standing(&self, exercise: &Exercise, file: &Path) -> Option<Standing> {
        let entry = self.entries.get(exercise.name)?;
        let current = entry.version == version(exercise) && entry.file == of_file(file)?;
        current.then(|| Standing { outcome: entry.outcome.clone(), points: entry.points })
    }

    /// Remembers a judgement of the exercise's own file.
    pub(crate) fn note(&mut self, exercise: &Exercise, file: &Path, judgement: &Judgement) {
        let Some(file) = of_file(file) else { return };
        // What went wrong with the grader may go right next time.
        if matches!(judgement.outcome, grader::Outcome::GraderError(_)) {
            return;
        }
        let entry = self.entries.entry(exercise.name.to_owned()).or_default();
        *entry = Entry {
            file,
            version: version(exercise),
            outcome: judgement.outcome.word().to_owned(),
            points: judgement.points,
            hints: entry.hints,
        };
    }

    /// How many hints of an exercise were read.
    pub(crate) fn hints(&self, exercise: &Exercise) -> usize {
        self.entries.get(exercise.name).map_or(0, |entry| entry.hints)
    }

    /// Remembers that so many hints were read.
    pub(crate) fn note_hints(&mut self, exercise: &Exercise, hints: usize) {
        self.entries.entry(exercise.name.to_owned()).or_default().hints = hints;
    }

    /// Writes it down. What cannot be written is judged again next time: slower, not wrong.
    pub(crate) fn write(&self) {
        let entries = self.entries.iter().map(|(name, entry)| {
            let entry = json!({
                "file": entry.file,
                "version": entry.version,
                "outcome": entry.outcome,
                "points": entry.points,
                "hints": entry.hints,
            });
            (name.clone(), entry)
        });
        let text = Json::Object(entries.collect()).to_string();
        if let Some(folder) = self.path.parent() {
            let _ = fs::create_dir_all(folder);
        }
        if let Ok(unfinished) = Unfinished::beside(&self.path) {
            let _ = unfinished.finish(text.as_bytes(), None, &self.path);
        }
    }
}

fn of_file(file: &Path) -> Option<u64> {
    bytes_of(file).map(fingerprint)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_damaged_memory_is_an_empty_one() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("board.json");
        for text in ["", "{", "[]", "7", r#"{"lambert": {"file": -1}}"#, r#"{"lambert": 3}"#] {
            fs::write(&path, text).unwrap();
            assert!(Memory::read(&path).entries.is_empty(), "{text}");
        }
        assert!(Memory::read(folder.path()).entries.is_empty());
    }

    #[test]
    fn what_was_written_is_read_again() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("deep/board.json");
        let exercise = course::find("rotate_about_point").unwrap();
        let mut memory = Memory::read(&path);
        memory.note_hints(exercise, 2);
        memory.write();
        assert_eq!(Memory::read(&path).entries, memory.entries);
        assert_eq!(Memory::read(&path).hints(exercise), 2);
    }
}
