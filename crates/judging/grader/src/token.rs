//! How is a verdict repeated, to the byte? By its token: which exercise, which seed, which version of the exercise.

use std::fmt;
use std::str::FromStr;

use course::{Exercise, fingerprint};

/// Exercise, seed and version: the same token and the same file give the same verdict.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Token {
    /// The exercise's name.
    pub exercise: String,
    /// The seed of its inputs.
    pub seed: u64,
    /// The version of the exercise that judged.
    pub version: u32,
}

impl Token {
    /// Of an exercise as it is now.
    pub fn new(exercise: &Exercise, seed: u64) -> Self {
        Self { exercise: exercise.name.to_owned(), seed, version: version(exercise) }
    }
}

/// A number that changes with the exercise's file and with the crate that tries it.
pub fn version(exercise: &Exercise) -> u32 {
    let text = env!("CARGO_PKG_VERSION").bytes().chain(exercise.source.bytes().filter(|byte| *byte != b'\r'));
    // Half of the fingerprint is enough to notice a change.
    fingerprint(text) as u32
}

impl fmt::Display for Token {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}.{:x}.{:08x}", self.exercise, self.seed, self.version)
    }
}

/// It is not a token.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
#[error("a token looks like rotate_about_point.1.0123abcd: exercise, seed and version")]
pub struct NoToken;

impl FromStr for Token {
    type Err = NoToken;

    fn from_str(text: &str) -> Result<Self, NoToken> {
        let mut parts = text.trim().split('.');
        let (Some(exercise), Some(seed), Some(version), None) =
            (parts.next(), parts.next(), parts.next(), parts.next())
        else {
            return Err(NoToken);
        };
        let seed = u64::from_str_radix(seed, 16).map_err(|_| NoToken)?;
        let version = u32::from_str_radix(version, 16).map_err(|_| NoToken)?;
        if exercise.is_empty() {
            return Err(NoToken);
        }
        Ok(Self { exercise: exercise.to_owned(), seed, version })
    }
}
