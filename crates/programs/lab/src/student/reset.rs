//! `cargo lab reset`: back to the beginning, without losing anything.

use std::fs;
use std::io;
use std::path::{Path, PathBuf};

use serde_json::json;

use super::which::{self, Meant};
use super::workbench::{Workbench, is_untouched};
use crate::cli::{Outcome, ResetArgs};
use crate::failure::Failure;
use crate::speech::say;
use crate::unfinished::Unfinished;

/// Puts the handed-out file in its place; what stood there gets another name beside it.
///
/// # Errors
/// [`Failure`] if there is no such exercise, or a file cannot be written.
pub(crate) fn run(asked: &ResetArgs) -> Result<Outcome, Failure> {
    let bench = Workbench::find()?;
    let mut done = Vec::new();
    for Meant { exercise, .. } in which::meant(&bench, &asked.names)? {
        let file = bench.file(exercise);
        let backup = if is_untouched(exercise, &file) { None } else { keep(&file)? };
        write(&file, exercise.stub)?;
        done.push((exercise.name, file, backup));
    }
    if asked.json {
        let records: Vec<serde_json::Value> = done
            .iter()
            .map(|(name, file, backup)| {
                json!({ "exercise": name, "file": file.display().to_string(), "backup": backup.as_ref().map(|path| path.display().to_string()) })
            })
            .collect();
        say(&format!("{:#}", json!({ "reset": records })))?;
    } else {
        for (name, file, backup) in &done {
            let kept = backup.as_ref().map_or_else(
                || "; there was nothing to keep".to_owned(),
                |path| format!("; what stood there is now {}", bench.shown(path)),
            );
            say(&format!("{name}: {} is as it was handed out{kept}", bench.shown(file)))?;
        }
    }
    Ok(Outcome::Done)
}

/// Copies the file to a name beside it that is free; `None` if there is no file.
fn keep(file: &Path) -> Result<Option<PathBuf>, Failure> {
    let name = file.file_name().unwrap_or_default().to_string_lossy().into_owned();
    for number in 1.. {
        let backup = file.with_file_name(format!("{name}.{number}.bak"));
        let copied =
            fs::OpenOptions::new().write(true).create_new(true).open(&backup).and_then(|mut copy| {
                let mut original = fs::File::open(file)?;
                io::copy(&mut original, &mut copy).and_then(|_| copy.sync_all())
            });
        match copied {
            Ok(()) => return Ok(Some(backup)),
            Err(e) if e.kind() == io::ErrorKind::AlreadyExists => {}
            Err(e) => {
                let gone = !file.exists();
                // An unfinished copy is no backup.
                let _ = fs::remove_file(&backup);
                if gone {
                    return Ok(None);
                }
                return Err(Failure::io("keep", file, &e, "free some space; the file was left as it is"));
            }
        }
    }
    Ok(None)
}

fn write(file: &Path, text: &str) -> Result<(), Failure> {
    let refused =
        |e: io::Error| Failure::io("write", file, &e, "free some space, or make the folder writable");
    if let Some(folder) = file.parent() {
        fs::create_dir_all(folder).map_err(refused)?;
    }
    Unfinished::beside(file)
        .and_then(|unfinished| unfinished.finish(text.as_bytes(), None, file))
        .map_err(refused)
}
