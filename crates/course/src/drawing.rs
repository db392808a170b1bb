//! How is a counterexample drawn? One function for each kind of answer.

use crate::exercise::{Picture, Seen};

/// Nothing to draw.
pub(crate) fn nothing(_: &Seen<'_>) -> Option<Picture> {
    None
}
