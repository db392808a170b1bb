//! What can be wrong with a scene or a picture, and what helps?

use std::path::Path;

use canvas::CodecError;
use scene::{RenderError, SceneError};

use crate::failure::{Failure, without_number};

impl Failure {
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

#[cfg(test)]
mod tests {
    use super::*;

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
