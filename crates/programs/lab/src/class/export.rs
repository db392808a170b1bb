//! `cargo lab export`: a folder that a platform takes as its autograder.

use std::fs::Permissions;
#[cfg(unix)]
use std::os::unix::fs::PermissionsExt;

use class::export::{self, File, Options};

use super::args::{ExportArgs, Platform};
use super::report::{self, write_with};
use crate::cli::Outcome;
use crate::failure::Failure;
use crate::speech::say;
use crate::student::workbench::Workbench;

/// Writes the autograder.
///
/// # Errors
/// [`Failure`] if the project cannot be read, or the folder not be written.
pub(crate) fn run(asked: &ExportArgs) -> Result<Outcome, Failure> {
    let root = Workbench::find()?.root;
    let options = Options { unsafe_no_sandbox: asked.unsafe_no_sandbox };
    let make = match asked.platform {
        Platform::Gradescope => export::gradescope,
        Platform::GithubClassroom => export::github_classroom,
        Platform::Codegrade => export::codegrade,
    };
    let files = make(&root, options)
        .map_err(|e| Failure::new(e.to_string(), "run it in a complete copy of the project"))?;
    report::prepare(&asked.folder, false)?;
    for file in &files {
        let path = asked.folder.join(&file.path);
        write_with(&path, &file.bytes, permissions(file).as_ref())
            .map_err(|e| Failure::io("write", &path, &e, "free some space, or see that it can be written"))?;
    }
    say(&format!("{} says what to do next", asked.folder.join("README.md").display()))?;
    Ok(Outcome::Done)
}

/// Scripts may be run, whatever the umask is; on a system that knows of such a thing.
#[cfg(unix)]
fn permissions(file: &File) -> Option<Permissions> {
    Some(PermissionsExt::from_mode(if file.executable { 0o755 } else { 0o644 }))
}

#[cfg(not(unix))]
fn permissions(_: &File) -> Option<Permissions> {
    None
}
