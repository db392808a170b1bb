//! Which file is it? A scene or a bare mesh comes in from the disk.

use std::path::Path;

use crate::{Scene, SceneError};

/// A scene with all files it names.
#[derive(Clone, Debug)]
pub struct Loaded {
    /// What the file says. Change it before [`crate::prepare`] if you like; the settings are in it.
    pub scene: Scene,
    /// What was wrong but could be borne: a missing MTL file, say. One sentence each.
    pub warnings: Vec<String>,
}

/// Reads a `.toml` scene or a `.obj` mesh, which is framed by itself.
///
/// # Errors
/// [`SceneError`] with file, line and column, and what would be right.
pub fn load(path: &Path) -> Result<Loaded, SceneError> {
    Err(SceneError {
        file: path.display().to_string(),
        line: None,
        column: None,
        problem: "not written yet".to_owned(),
        remedy: "wait".to_owned(),
    })
}
