//! What is in a zip archive? Names first; bytes only of the files that are wanted, and no more of them than a solution can be long.

use std::fs::File;
use std::io::{BufReader, Read};
use std::path::Path;

use grader::LONGEST_FILE;
use zip::ZipArchive;

use super::candidates::{is_stray, quoted};

/// A larger archive is not opened, in bytes: what is not a solution weighs something, too, but not this much. The names in it are all held in memory.
const LARGEST: u64 = 32 << 20;

/// An open archive.
pub(super) struct Archive(ZipArchive<BufReader<File>>);

/// What an archive holds.
pub(super) struct Listing {
    /// Files by their path, with their place in the archive.
    pub(super) files: Vec<(String, usize)>,
    /// What there is to say about what is left out.
    pub(super) remarks: Vec<String>,
}

impl Archive {
    /// Opens an archive; in the error stands why it cannot be read, as a sentence's end.
    pub(super) fn open(path: &Path) -> Result<Self, String> {
        let file = File::open(path).map_err(|e| e.to_string())?;
        let length = file.metadata().map_err(|e| e.to_string())?.len();
        if length > LARGEST {
            return Err(format!("it is larger than {} MiB", LARGEST >> 20));
        }
        ZipArchive::new(BufReader::new(file)).map(Self).map_err(|e| e.to_string())
    }

    /// Its files.
    pub(super) fn listing(&mut self) -> Listing {
        let mut listing = Listing { files: Vec::new(), remarks: Vec::new() };
        let mut outside = Vec::new();
        let mut links = Vec::new();
        for place in 0..self.0.len() {
            // The raw form: nothing is inflated, and a password is not asked for.
            let Ok(file) = self.0.by_index_raw(place) else { continue };
            // Some programs for Windows write their own separator.
            let Ok(name) = file.name() else { continue };
            let path = name.replace('\\', "/");
            if path.ends_with('/') || is_stray(&path) {
                continue;
            }
            if path.starts_with('/') || path.split('/').any(|part| part == "..") || path.contains(':') {
                outside.push(quoted(&path));
            } else if file.is_symlink() {
                links.push(quoted(&path));
            } else {
                listing.files.push((path, place));
            }
        }
        if !outside.is_empty() {
            let paths = super::candidates::listed(&outside);
            listing.remarks.push(format!("Paths in the archive that lead out of it are ignored: {paths}."));
        }
        if !links.is_empty() {
            let paths = super::candidates::listed(&links);
            listing.remarks.push(format!("Symbolic links are not followed: {paths}."));
        }
        listing
    }

    /// The bytes of the file at this place; no more than show that it is too long.
    pub(super) fn read(&mut self, place: usize) -> Result<Vec<u8>, String> {
        let file = self.0.by_index(place).map_err(|e| e.to_string())?;
        let mut bytes = Vec::new();
        file.take(LONGEST_FILE + 1).read_to_end(&mut bytes).map_err(|e| e.to_string())?;
        Ok(bytes)
    }
}
