//! How does a report come onto the disk? File by file, each whole or not at all.

use std::fs::{self, Permissions};
use std::io;
use std::path::Path;
use std::sync::{Mutex, PoisonError};

use class::format::Format;
use class::results::Results;

use crate::failure::Failure;
use crate::unfinished::Unfinished;

/// Sees that the folder is there, and empty unless an earlier run is gone on with.
///
/// # Errors
/// [`Failure`] if it is no folder, or not empty.
pub(super) fn prepare(report: &Path, resume: bool) -> Result<(), Failure> {
    fs::create_dir_all(report)
        .map_err(|e| Failure::io("make the folder", report, &e, "name another one with --out"))?;
    let mut entries = fs::read_dir(report)
        .map_err(|e| Failure::io("read", report, &e, "name another folder with --out"))?;
    if !resume && entries.next().is_some() {
        return Err(Failure::new(
            format!("{} is not empty", report.display()),
            "name a new folder with --out, or go on with the run that began there with --resume",
        ));
    }
    Ok(())
}

/// Writes a file whole or not at all.
pub(super) fn write(path: &Path, bytes: &[u8]) -> io::Result<()> {
    write_with(path, bytes, None)
}

/// The same with permissions; without, they are those of any new file. One at a time: Ctrl-C knows of one unfinished file.
pub(super) fn write_with(path: &Path, bytes: &[u8], permissions: Option<&Permissions>) -> io::Result<()> {
    static TURN: Mutex<()> = Mutex::new(());
    let _turn = TURN.lock().unwrap_or_else(PoisonError::into_inner);
    if let Some(folder) = path.parent() {
        fs::create_dir_all(folder)?;
    }
    Unfinished::beside(path)?.finish(bytes, permissions, path)
}

/// Writes all files of a report.
///
/// # Errors
/// [`Failure`]: a file cannot be written.
pub(super) fn write_all(report: &Path, results: &Results, formats: &[Format]) -> Result<(), Failure> {
    for (name, bytes) in class::files(results, formats) {
        let path = report.join(name);
        write(&path, &bytes).map_err(|e| unwritten(&path, &e))?;
    }
    Ok(())
}

pub(super) fn unwritten(path: &Path, error: &io::Error) -> Failure {
    Failure::io(
        "write",
        path,
        error,
        "free some space, or see that it can be written; what was judged is kept: --resume",
    )
}
