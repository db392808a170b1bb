//! What is in a student's folder? Files, and archives of files.

use std::collections::BTreeMap;
use std::fs::{self, File};
use std::io::{self, Read};
use std::path::{Path, PathBuf};

use grader::LONGEST_FILE;

use super::archive::Archive;
use super::candidates::{Found, choose, is_stray, listed, quoted};
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
    remarks: Vec<String>,
    seen: usize,
}

impl Entry {
    /// Reads the submission.
    ///
    /// # Errors
    /// A folder of the class cannot be read. What is wrong with the submission itself is no error: it stands in the notices.
    pub fn take(&self) -> io::Result<Taken> {
        let mut search = Search::default();
        for place in &self.places {
            search.look_at(place)?;
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
            return self.walk(&place.path, "", 0);
        }
        self.file(&place.path, name, metadata.file_type());
        Ok(())
    }

    fn walk(&mut self, folder: &Path, prefix: &str, depth: usize) -> io::Result<()> {
        let mut entries: Vec<fs::DirEntry> = Vec::new();
        for entry in fs::read_dir(folder)? {
            self.seen += 1;
            if self.seen > MOST_ENTRIES {
                self.remark(format!(
                    "The submission holds more than {MOST_ENTRIES} files; the rest was not looked at."
                ));
                break;
            }
            entries.push(entry?);
        }
        entries.sort_by_key(fs::DirEntry::file_name);
        for entry in entries {
            let path = format!("{prefix}{}", entry.file_name().to_string_lossy());
            if is_stray(&path) {
                continue;
            }
            let kind = entry.file_type()?;
            if !kind.is_dir() {
                self.file(&entry.path(), path, kind);
            } else if depth < DEEPEST {
                self.walk(&entry.path(), &format!("{path}/"), depth + 1)?;
            } else {
                self.remark(format!("Folders deeper than {DEEPEST} were not looked at."));
            }
        }
        Ok(())
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
        self.remarks.extend(listing.remarks);
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
                Bytes::OnDisk(path) => beginning(path).map_err(|e| e.to_string()),
                Bytes::Zipped(number, place) => self.opened[*number].read(*place),
            };
            match read {
                Ok(bytes) => drop(files.insert(name, bytes)),
                Err(why) => self.remark(format!("{} cannot be read: {why}.", quoted(&file.path))),
            }
        }
        if !self.links.is_empty() {
            self.remark(format!("Symbolic links are not followed: {}.", listed(&self.links)));
        }
        if !self.strange.is_empty() {
            self.remark(format!("Neither files nor folders: {}.", listed(&self.strange)));
        }
        notices.extend(self.remarks.into_iter().map(|text| Notice { audience: Audience::Student, text }));
        Taken { files, notices }
    }
}

/// The bytes of a file; no more than show that it is too long.
fn beginning(path: &Path) -> io::Result<Vec<u8>> {
    let mut bytes = Vec::new();
    File::open(path)?.take(LONGEST_FILE + 1).read_to_end(&mut bytes)?;
    Ok(bytes)
}
