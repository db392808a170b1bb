//! Which scenes are there without any file?

use std::path::Path;

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
        Loaded::from_toml(self.text, &format!("{}.toml", self.name), Path::new(""))
    }
}

/// A built-in scene whose text is the file of its name.
macro_rules! builtin {
    ($name:literal, $summary:literal) => {
        Builtin { name: $name, summary: $summary, text: include_str!(concat!("../scenes/", $name, ".toml")) }
    };
}

const ALL: [Builtin; 7] = [
    builtin!("teapot", "the Utah teapot on a plate, with three lights"),
    builtin!("cornell-box", "the Cornell box as it was measured, by local lighting (L23)"),
    builtin!(
        "two-spheres",
        "two balls, the nearer one first in the file: without depth the farther one wins (L15)"
    ),
    builtin!("exponent-strip", "six balls with exponents from 1 to 1000: the highlight shrinks (L31)"),
    builtin!("cycle", "three triangles, each partly before the next: no drawing order is right (L14)"),
    builtin!("floating-bin", "two bins that look alike: only the shadows tell which one floats (L45)"),
    builtin!("glass-and-mirror", "a ball of glass and one of silver on a chequered floor (L58)"),
];

/// All of them; the first is the default.
#[must_use]
pub fn all() -> &'static [Builtin] {
    &ALL
}

/// The one of this name.
#[must_use]
pub fn find(name: &str) -> Option<&'static Builtin> {
    all().iter().find(|scene| scene.name == name)
}
