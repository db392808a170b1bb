//! What did each student hand in? A class's folder, as a person or a learning platform fills it, becomes files of exercises.
//!
//! - [`Class::read`]: who is in the class. Folders, archives and loose files are put together by student; of several attempts the latest counts.
//! - [`Entry::take`]: one student's files. Only those with the name of an exercise are read, from wherever they lie; all else is ignored, and said so.
//!
//! Nothing in a submission is believed: links are not followed, archives are not unpacked onto the disk, and no more is read of a file than a
//! solution can be long.

mod archive;
mod candidates;
mod class;
mod folder;
mod names;

use std::collections::BTreeMap;
use std::path::PathBuf;

pub use class::{Class, ClassError};

use crate::results::Notice;

/// One student's submission, before it is read.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Entry {
    /// Unlike any other's, and fit for a file name.
    pub id: String,
    /// The student, as the names say.
    pub student: String,
    /// What the submission is read from, as it is named in the class's folder.
    pub source: String,
    /// What its names give rise to say: earlier attempts, lateness.
    pub notices: Vec<Notice>,
    /// Where it lies: one folder, one archive, or loose files.
    places: Vec<Place>,
}

/// Something in the class's folder that belongs to one student.
#[derive(Clone, Debug, PartialEq, Eq)]
struct Place {
    path: PathBuf,
    /// A loose file's own name, without what the platform put before it.
    own_name: Option<String>,
}

/// What was handed in, read.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Taken {
    /// The exercises' files, by the exercises' names; no more of each than shows that it is too long.
    pub files: BTreeMap<&'static str, Vec<u8>>,
    /// What there is to say about all else.
    pub notices: Vec<Notice>,
}
