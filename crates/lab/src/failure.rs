//! What went wrong, and what helps?

use std::io;
use std::path::Path;

use canvas::CodecError;
use scene::{RenderError, SceneError};

/// The end of a command without a result, as the user reads it.
#[derive(Debug, PartialEq, Eq)]
pub(crate) struct Failure {
    /// What is wrong, with the file and the value that was found.
    pub(crate) problem: String,
    /// What to do about it.
    pub(crate) remedy: String,
}

impl Failure {
    pub(crate) fn new(problem: impl Into<String>, remedy: impl Into<String>) -> Self {
        Self { problem: problem.into(), remedy: remedy.into() }
    }

    /// A file or folder that the system refuses to give or take.
    pub(crate) fn io(doing: &str, path: &Path, error: &io::Error, remedy: impl Into<String>) -> Self {
        Self::new(format!("cannot {doing} {}: {}", path.display(), reason(error)), remedy)
    }

    /// A picture file that cannot be decoded.
    pub(crate) fn unreadable(path: &Path, error: &CodecError) -> Self {
        let problem = match error {
            // Some reasons are the insides of a library, which tell a user nothing.
            CodecError::Unreadable { reason } if reason.contains('{') => "its bytes are damaged".to_owned(),
            other => other.to_string(),
        };
        Self::new(
            format!("cannot read {}: {problem}", path.display()),
            "give a PNG or OpenEXR file, such as `cargo lab render` writes",
        )
    }
}

impl From<SceneError> for Failure {
    fn from(error: SceneError) -> Self {
        let number = |n: Option<usize>| n.map(|n| format!(":{n}")).unwrap_or_default();
        Self::new(
            format!(
                "{}{}{}: {}",
                error.file,
                number(error.line),
                number(error.column),
                without_number(&error.problem)
            ),
            error.remedy,
        )
    }
}

impl From<RenderError> for Failure {
    fn from(error: RenderError) -> Self {
        let remedy = match &error {
            RenderError::Scene(fault) => return fault.clone().into(),
            RenderError::Setting { .. } | RenderError::TooManyPixels { .. } => {
                "change it with --size, --samples or --max-depth, or in the scene file"
            }
            RenderError::TooManyToPaint { .. } | RenderError::TooEntangled => {
                "choose another renderer: --renderer zbuffer, say"
            }
            _ => "change the scene file",
        };
        Self::new(error.to_string(), remedy)
    }
}

/// The system's own words, without the number that it adds to them.
pub(crate) fn reason(error: &io::Error) -> String {
    without_number(&error.to_string()).to_owned()
}

fn without_number(words: &str) -> &str {
    words.find(" (os error").map_or(words, |end| &words[..end])
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_number_of_a_system_error_is_left_out() {
        let error = io::Error::from_raw_os_error(2);
        assert!(error.to_string().contains("os error 2"));
        assert!(!reason(&error).contains("os error"));
        assert_eq!(reason(&io::Error::other("no room")), "no room");
    }

    #[test]
    fn a_fault_of_a_scene_file_is_named_by_its_place() {
        let error = SceneError {
            file: "a/b.toml".to_owned(),
            line: Some(7),
            column: Some(3),
            problem: "unknown key `colour`".to_owned(),
            remedy: "write `color`".to_owned(),
        };
        assert_eq!(Failure::from(error), Failure::new("a/b.toml:7:3: unknown key `colour`", "write `color`"));
    }
}
