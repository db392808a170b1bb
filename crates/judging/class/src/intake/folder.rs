//! What is in a student's folder? Files, and archives of files.

use std::collections::BTreeMap;
use std::fs::{self, File};
use std::io::{self, Read};
use std::path::{Path, PathBuf};

use grader::LONGEST_FILE;

use super::archive::Archive;
use super::candidates::{Found, choose, is_hidden, is_of_an_exercise, is_stray, listed, quoted};
use super::{Entry, Place, Taken};
use crate::results::{Audience, Notice};

/// So many entries of a submission are looked at.
const MOST_ENTRIES: usize = 20_000;

/// So many folders stand in one another at most.
const DEEPEST: usize = 12;

/// So many archives in a folder are opened.
const MOST_ARCHIVES: usize = 4;

/// Archives that are not read, by their endings.
const OTHER_ARCHIVES: [&str; 8] = [".7z", ".rar", ".tar", ".gz", ".tgz", ".xz", ".bz2", ".zst"];

/// Where the bytes of a file are.
#[derive(Clone, Debug, PartialEq, Eq)]
enum Bytes {
    OnDisk(PathBuf),
    /// In the archive of this number, at this place.
    Zipped(usize, usize),
}

/// What has been found so far.
#[derive(Default)]
struct Search {
    files: Vec<Found<Bytes>>,
    archives: Vec<(PathBuf, String)>,
    opened: Vec<Archive>,
    links: Vec<String>,
    strange: Vec<String>,
    hidden: Vec<String>,
    unreadable: Vec<String>,
    /// Folders that are looked at last: however much is in them, it crowds nothing out.
    hidden_folders: Vec<Folder>,
    remarks: Vec<String>,
    seen: usize,
}

/// A folder within the submission.
struct Folder {
    path: PathBuf,
    /// Its path in the submission, with `/` at the end; empty for the submission itself.
    prefix: String,
    depth: usize,
}

impl Entry {
    /// Reads the submission.
    ///
    /// # Errors
    /// The submission as a whole cannot be read. What is wrong with the submission itself is no error: it stands in the notices.
    pub fn take(&self) -> io::Result<Taken> {
        let mut search = Search::default();
        for place in &self.places {
            search.look_at(place)?;
        }
        while let Some(folder) = search.hidden_folders.pop() {
            search.walk(&folder);
        }
        search.open_archives();
        Ok(search.taken())
    }
}

impl Search {
    fn look_at(&mut self, place: &Place) -> io::Result<()> {
        let metadata = fs::symlink_metadata(&place.path)?;
        let name = match &place.own_name {
            Some(name) => name.clone(),
            None => place.path.file_name().unwrap_or_default().to_string_lossy().into_owned(),
        };
        if metadata.is_dir() {
            // Of a submission that cannot be read at all somebody has to hear more than that its files are missing.
            fs::read_dir(&place.path)?;
            self.walk(&Folder { path: place.path.clone(), prefix: String::new(), depth: 0 });
        } else {
            self.file(&place.path, name, metadata.file_type());
        }
        Ok(())
    }

    fn walk(&mut self, folder: &Folder) {
        for (entry, kind) in self.entries(folder) {
            let path = format!("{}{}", folder.prefix, entry.file_name().to_string_lossy());
            if is_stray(&path) {
                continue;
            }
            if !kind.is_dir() {
                if !is_hidden(&path) {
                    self.file(&entry.path(), path, kind);
                } else if is_of_an_exercise(&path) {
                    self.hidden.push(path);
                }
            } else if folder.depth >= DEEPEST {
                self.remark(format!("Folders deeper than {DEEPEST} were not looked at."));
            } else {
                let is_new = is_hidden(&path) && !is_hidden(&folder.prefix);
                let inner =
                    Folder { path: entry.path(), prefix: format!("{path}/"), depth: folder.depth + 1 };
                if is_new { self.hidden_folders.push(inner) } else { self.walk(&inner) }
            }
        }
    }

    /// What is in a folder, sorted by name. What cannot be read is noted, and hinders nothing else.
    fn entries(&mut self, folder: &Folder) -> Vec<(fs::DirEntry, fs::FileType)> {
        let mut entries = Vec::new();
        let mut failure = None;
        match fs::read_dir(&folder.path) {
            Err(error) => failure = Some(error),
            Ok(found) => {
                for entry in found {
                    self.seen += 1;
                    if self.seen > MOST_ENTRIES {
                        self.remark(format!(
                            "The submission holds more than {MOST_ENTRIES} files; the rest was not looked at."
                        ));
                        break;
                    }
                    match entry.and_then(|entry| entry.file_type().map(|kind| (entry, kind))) {
                        Ok(entry) => entries.push(entry),
                        Err(error) => failure = Some(error),
                    }
                }
            }
        }
        if let Some(error) = failure {
            self.unreadable.push(format!("{} ({})", folder.prefix, reason(&error)));
        }
        entries.sort_by_key(|(entry, _)| entry.file_name());
        entries
    }

    fn file(&mut self, path: &Path, name: String, kind: fs::FileType) {
        let lower = name.to_lowercase();
        if kind.is_symlink() {
            self.links.push(name);
        } else if !kind.is_file() {
            self.strange.push(name);
        } else if lower.ends_with(".zip") {
            self.archives.push((path.to_owned(), name));
        } else if OTHER_ARCHIVES.iter().any(|ending| lower.ends_with(ending)) {
            self.remark(format!(
                "{} cannot be read: hand in the files themselves, or a zip archive.",
                quoted(&name)
            ));
        } else {
            self.files.push(Found {
                path: name,
                attempt: String::new(),
                place: Bytes::OnDisk(path.to_owned()),
            });
        }
    }

    /// What is in archives counts like what lies beside them.
    fn open_archives(&mut self) {
        for (at, (path, name)) in std::mem::take(&mut self.archives).into_iter().enumerate() {
            if at >= MOST_ARCHIVES {
                self.files.push(Found { path: name, attempt: String::new(), place: Bytes::OnDisk(path) });
                continue;
            }
            match Archive::open(&path) {
                Ok(archive) => self.list(archive),
                Err(why) => self.remark(format!("The archive {} cannot be read: {why}.", quoted(&name))),
            }
        }
    }

    fn list(&mut self, mut archive: Archive) {
        let listing = archive.listing();
        listing.remarks().for_each(|text| self.remark(text));
        let number = self.opened.len();
        self.opened.push(archive);
        self.files.extend(listing.files.into_iter().map(|(path, place)| Found {
            path,
            attempt: String::new(),
            place: Bytes::Zipped(number, place),
        }));
    }

    fn remark(&mut self, text: String) {
        if !self.remarks.contains(&text) {
            self.remarks.push(text);
        }
    }

    fn taken(mut self) -> Taken {
        let (chosen, mut notices) = choose(std::mem::take(&mut self.files));
        let mut files = BTreeMap::new();
        for (name, file) in chosen {
            let read = match &file.place {
                Bytes::OnDisk(path) => beginning(path).map_err(|e| reason(&e)),
                Bytes::Zipped(number, place) => self.opened[*number].read(*place),
            };
            match read {
                Ok(bytes) => drop(files.insert(name, bytes)),
                Err(why) => self.remark(format!("{} cannot be read: {why}.", quoted(&file.path))),
            }
        }
        self.list_oddities();
        notices.extend(self.remarks.into_iter().map(|text| Notice { audience: Audience::Student, text }));
        Taken { files, notices }
    }

    fn list_oddities(&mut self) {
        if !self.unreadable.is_empty() {
            self.remark(format!(
                "Folders that cannot be read, so that nothing in them was judged: {}.",
                listed(&self.unreadable)
            ));
        }
        if !self.hidden.is_empty() {
            self.hidden.sort();
            self.remark(format!("Hidden files are not judged: {}.", listed(&self.hidden)));
        }
        if !self.links.is_empty() {
            self.remark(format!("Symbolic links are not followed: {}.", listed(&self.links)));
        }
        if !self.strange.is_empty() {
            self.remark(format!("Neither files nor folders: {}.", listed(&self.strange)));
        }
    }
}

/// The system's own words, without the number that it adds to them.
fn reason(error: &io::Error) -> String {
    let words = error.to_string();
    words.split(" (os error").next().unwrap_or_default().to_owned()
}

/// The bytes of a file; no more than show that it is too long.
fn beginning(path: &Path) -> io::Result<Vec<u8>> {
    let mut bytes = Vec::new();
    File::open(path)?.take(LONGEST_FILE + 1).read_to_end(&mut bytes)?;
    Ok(bytes)
}
