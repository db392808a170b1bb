//! What went wrong, and what helps?

use std::io;
use std::path::Path;

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
}

/// The system's own words, without the number that it adds to them.
pub(crate) fn reason(error: &io::Error) -> String {
    without_number(&error.to_string()).to_owned()
}

pub(crate) fn without_number(words: &str) -> &str {
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
}
