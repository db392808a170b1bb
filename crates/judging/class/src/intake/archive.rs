//! What is in a zip archive? Names first; bytes only of the files that are wanted, and no more of them than a solution can be long.

use std::collections::BTreeMap;
use std::fs::File;
use std::io::{self, BufReader, Read, Seek, SeekFrom};
use std::path::Path;

use grader::LONGEST_FILE;
use zip::ZipArchive;

use super::candidates::{is_hidden, is_of_an_exercise, is_stray, listed};

/// A larger archive is not opened, in bytes: what is not a solution weighs something, too, but not this much. The names in it are all held in memory.
const LARGEST: u64 = 32 << 20;

/// An open archive.
pub(super) struct Archive {
    zip: ZipArchive<BufReader<File>>,
    /// Names that occur more than once, as they are written.
    repeated: Vec<String>,
}

/// What an archive holds.
#[derive(Default)]
pub(super) struct Listing {
    /// Files by their path, with their place in the archive.
    pub(super) files: Vec<(String, usize)>,
    /// What is left out, and why.
    remarks: BTreeMap<Odd, Vec<String>>,
}

/// Why a name in an archive is left out, or worth a word.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum Odd {
    Outside,
    Link,
    Hidden,
    Repeated,
    Unreadable,
}

impl Listing {
    fn note(&mut self, odd: Odd, path: &str) {
        self.remarks.entry(odd).or_default().push(path.to_owned());
    }

    /// What there is to say, in sentences.
    pub(super) fn remarks(&self) -> impl Iterator<Item = String> {
        self.remarks.iter().map(|(odd, paths)| {
            let paths = listed(paths);
            match odd {
                Odd::Outside => format!("Paths in the archive that lead out of it are ignored: {paths}."),
                Odd::Link => format!("Symbolic links are not followed: {paths}."),
                Odd::Hidden => format!("Hidden files are not judged: {paths}."),
                Odd::Repeated => {
                    format!("The archive holds a name more than once; the last of them counts: {paths}.")
                }
                Odd::Unreadable => {
                    format!("Entries of the archive that cannot be read are ignored: {paths}.")
                }
            }
        })
    }
}

impl Archive {
    /// Opens an archive; in the error stands why it cannot be read, as a sentence's end.
    pub(super) fn open(path: &Path) -> Result<Self, String> {
        let file = File::open(path).map_err(|e| e.to_string())?;
        let length = file.metadata().map_err(|e| e.to_string())?.len();
        if length > LARGEST {
            return Err(format!("it is larger than {} MiB", LARGEST >> 20));
        }
        let zip = ZipArchive::new(BufReader::new(file)).map_err(|e| e.to_string())?;
        let start = zip.central_directory_start();
        let repeated =
            if zip.has_duplicate_names() { repeated(path, start).unwrap_or_default() } else { Vec::new() };
        Ok(Self { zip, repeated })
    }

    /// Its files.
    pub(super) fn listing(&mut self) -> Listing {
        let mut listing = Listing::default();
        for place in 0..self.zip.len() {
            // What the directory at the archive's end says: nothing is inflated, and a password is not asked for.
            let entry = self.zip.by_index_data(place).ok();
            let named = entry.as_ref().and_then(|entry| Some((entry.name().ok()?, entry.is_symlink())));
            let Some((name, is_link)) = named else {
                listing.note(Odd::Unreadable, &format!("number {}", place + 1));
                continue;
            };
            // Some programs for Windows write their own separator.
            let path = name.replace('\\', "/");
            if path.ends_with('/') || is_stray(&path) {
                continue;
            }
            if path.starts_with('/') || path.split('/').any(|part| part == "..") || path.contains(':') {
                listing.note(Odd::Outside, &path);
            } else if is_link {
                listing.note(Odd::Link, &path);
            } else if is_hidden(&path) {
                if is_of_an_exercise(&path) {
                    listing.note(Odd::Hidden, &path);
                }
            } else {
                listing.files.push((path, place));
            }
        }
        for name in self.repeated.iter().filter(|name| !is_stray(name)) {
            listing.note(Odd::Repeated, name);
        }
        listing
    }

    /// The bytes of the file at this place; no more than show that it is too long.
    pub(super) fn read(&mut self, place: usize) -> Result<Vec<u8>, String> {
        let file = self.zip.by_index(place).map_err(|e| e.to_string())?;
        let mut bytes = Vec::new();
        file.take(LONGEST_FILE + 1).read_to_end(&mut bytes).map_err(|e| e.to_string())?;
        Ok(bytes)
    }
}

/// Returns the names that occur more than once in the directory that begins at `start`. The archive's reader keeps one entry a name, and does not
/// say of which there were more.
fn repeated(path: &Path, start: u64) -> io::Result<Vec<String>> {
    /// What each entry begins with, and how long the part before its name is.
    const SIGNATURE: &[u8] = b"PK\x01\x02";
    const BEFORE_THE_NAME: usize = 46;
    let mut directory = BufReader::new(File::open(path)?);
    directory.seek(SeekFrom::Start(start))?;
    let mut counts: BTreeMap<String, usize> = BTreeMap::new();
    let mut entry = [0; BEFORE_THE_NAME];
    while directory.read_exact(&mut entry).is_ok() && entry.starts_with(SIGNATURE) {
        let length = |at: usize| usize::from(u16::from_le_bytes([entry[at], entry[at + 1]]));
        let (name, extra, comment) = (length(28), length(30), length(32));
        let mut bytes = vec![0; name];
        directory.read_exact(&mut bytes)?;
        directory.seek_relative((extra + comment) as i64)?;
        *counts.entry(String::from_utf8_lossy(&bytes).into_owned()).or_default() += 1;
    }
    Ok(counts.into_iter().filter(|(_, count)| *count > 1).map(|(name, _)| name).collect())
}
