//! Why parts do not make a class, and what to do about it.

use std::io;
use std::path::PathBuf;

/// Parts that do not make a class.
#[derive(Debug, thiserror::Error)]
pub enum MergeError {
    /// A file cannot be read.
    #[error("cannot read {path}: {error}")]
    Io {
        /// The file.
        path: PathBuf,
        /// What the system says.
        error: io::Error,
    },
    /// A file is not what its name says.
    #[error("{path}: {what}")]
    Torn {
        /// The file.
        path: PathBuf,
        /// What is wrong, with line and column.
        what: String,
    },
    /// A report that is not a part.
    #[error("{path} is not a part of a class: it does not list the whole class")]
    NotAPart {
        /// Its `results.json`.
        path: PathBuf,
    },
    /// A file that is not as it was written.
    #[error("{path} was changed after it was written: its digest does not match")]
    Changed {
        /// The file.
        path: PathBuf,
    },
    /// Parts that were judged differently.
    #[error("{one} and {other} were not judged alike: {what} differs")]
    Unlike {
        /// A part.
        one: PathBuf,
        /// Another one.
        other: PathBuf,
        /// What differs.
        what: &'static str,
    },
    /// Parts of two classes, or of a class that changed in between.
    #[error("{one} and {other} were made from different submissions: {what}")]
    OtherClass {
        /// A part.
        one: PathBuf,
        /// Another one.
        other: PathBuf,
        /// The first submission that differs, and how.
        what: String,
    },
    /// A submission that changed between the beginning and the end of a run.
    #[error("the submission {id} changed while {part} was made")]
    ChangedMeanwhile {
        /// The part.
        part: PathBuf,
        /// The student.
        id: String,
    },
    /// A student in two parts.
    #[error("{one} and {other} both hold {id}")]
    Twice {
        /// A part.
        one: PathBuf,
        /// Another one.
        other: PathBuf,
        /// The student.
        id: String,
    },
    /// Not all parts are there.
    #[error("of {of} parts, these are missing: {missing}")]
    Missing {
        /// How many parts there are.
        of: usize,
        /// Their numbers.
        missing: String,
    },
    /// A student of the class who is in no part, although all parts are there.
    #[error("{id} is in the class, but in none of the parts")]
    Nowhere {
        /// The student.
        id: String,
    },
}

impl MergeError {
    /// Says what to do about it.
    pub fn remedy(&self) -> &'static str {
        match self {
            Self::Io { .. } | Self::Torn { .. } => {
                "name the folders that `cargo lab grade --partition` wrote, each with all its files"
            }
            Self::NotAPart { .. } => {
                "make every part with `cargo lab grade --partition K/N` of this version of the project"
            }
            Self::Changed { .. } => {
                "grade that part again, into a new folder; correct points by hand in the merged report, where it can be seen"
            }
            Self::Unlike { .. } => {
                "grade all parts with the same version of the project, the same --seed, --seeds and way of --partition, on systems with the same sandbox"
            }
            Self::OtherClass { .. } | Self::Nowhere { .. } => {
                "give every machine the same submissions, and make each part again with the same command and --resume: what has not changed is not judged again"
            }
            Self::ChangedMeanwhile { .. } => {
                "make that part again with the same command and --resume: what has not changed is not judged again"
            }
            Self::Twice { .. } => "name each part once",
            Self::Missing { .. } => "make these parts, or name their folders too",
        }
    }
}
