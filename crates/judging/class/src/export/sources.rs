//! Which files of the project does a grader need? Those that cargo builds from; not what it built, nor what somebody left there.

use std::fs;
use std::io;
use std::path::{Path, PathBuf};

use super::File;

/// What lies at the project's root and belongs to it.
const ROOTS: [&str; 8] =
    ["Cargo.toml", "Cargo.lock", ".cargo", "crates", "exercises", "tests", "LICENSE-APACHE", "LICENSE-MIT"];

/// Why the project's sources cannot be exported.
#[derive(Debug, thiserror::Error)]
pub enum SourcesError {
    /// Something cannot be read.
    #[error("{path}: {error}")]
    Io {
        /// What.
        path: PathBuf,
        /// Why.
        error: io::Error,
    },
    /// Something is neither a file nor a folder.
    #[error(
        "{0} is neither a file nor a folder: an export holds nothing else, so remove it or copy what it points to"
    )]
    Strange(PathBuf),
    /// The project does not say which Rust it needs.
    #[error("{0} has no line like `rust-version = \"1.88\"`: an export asks for that version of Rust")]
    NoVersion(PathBuf),
}

/// The project's files, sorted by path.
pub(super) fn sources(root: &Path) -> Result<Vec<File>, SourcesError> {
    let mut files = Vec::new();
    for name in ROOTS {
        add(root, name, &mut files)?;
    }
    files.sort_by(|a, b| a.path.cmp(&b.path));
    Ok(files)
}

fn add(root: &Path, path: &str, files: &mut Vec<File>) -> Result<(), SourcesError> {
    let whole = root.join(path);
    let io = |error| SourcesError::Io { path: whole.clone(), error };
    let kind = fs::symlink_metadata(&whole).map_err(io)?.file_type();
    if kind.is_file() {
        let bytes = fs::read(&whole).map_err(io)?;
        files.push(File { path: path.to_owned(), bytes, executable: false });
        return Ok(());
    }
    if !kind.is_dir() {
        return Err(SourcesError::Strange(whole));
    }
    for entry in fs::read_dir(&whole).map_err(io)? {
        let name = entry.map_err(io)?.file_name().to_string_lossy().into_owned();
        if !is_left_behind(&name) {
            add(root, &format!("{path}/{name}"), files)?;
        }
    }
    Ok(())
}

/// What cargo, an editor or `cargo lab` leaves among the sources.
fn is_left_behind(name: &str) -> bool {
    matches!(name, "target" | "proptest-regressions")
        || name.starts_with('.')
        || name.ends_with(".bak")
        || name.ends_with('~')
}

/// The version of Rust that the project asks for.
pub(super) fn toolchain(root: &Path) -> Result<String, SourcesError> {
    let path = root.join("Cargo.toml");
    let text = fs::read_to_string(&path).map_err(|error| SourcesError::Io { path: path.clone(), error })?;
    let version = text.lines().find_map(|line| line.trim().strip_prefix("rust-version")?.split('"').nth(1));
    // It goes into scripts as it is.
    version
        .filter(|it| !it.is_empty() && it.bytes().all(|byte| byte.is_ascii_digit() || byte == b'.'))
        .map(str::to_owned)
        .ok_or(SourcesError::NoVersion(path))
}
