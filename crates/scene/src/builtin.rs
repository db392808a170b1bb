//! Which scenes are there without any file?

use crate::{Loaded, SceneError};

/// A scene that comes with the program.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Builtin {
    /// Its name on the command line.
    pub name: &'static str,
    /// What it shows, in one line.
    pub summary: &'static str,
    /// The scene file.
    pub text: &'static str,
}

impl Builtin {
    /// The scene, read.
    ///
    /// # Errors
    /// None for the scenes of [`all`]; a test sees to it.
    pub fn load(&self) -> Result<Loaded, SceneError> {
        Err(SceneError {
            file: self.name.to_owned(),
            line: None,
            column: None,
            problem: "not written yet".to_owned(),
            remedy: "wait".to_owned(),
        })
    }
}

/// All of them; the first is the default.
#[must_use]
pub fn all() -> &'static [Builtin] {
    &[]
}

/// The one of this name.
#[must_use]
pub fn find(name: &str) -> Option<&'static Builtin> {
    all().iter().find(|scene| scene.name == name)
}
