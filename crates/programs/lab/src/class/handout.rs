//! `cargo lab handout`: what students begin with.

use class::handout;

use super::args::HandoutArgs;
use super::report::{self, write};
use crate::cli::Outcome;
use crate::failure::Failure;
use crate::speech::say;

/// Writes the students' edition.
///
/// # Errors
/// [`Failure`] if the folder cannot be written.
pub(crate) fn run(asked: &HandoutArgs) -> Result<Outcome, Failure> {
    report::prepare(&asked.folder, false)?;
    for (name, text) in handout::files(course::all(), asked.hints) {
        let path = asked.folder.join(name);
        write(&path, text.as_bytes())
            .map_err(|e| Failure::io("write", &path, &e, "free some space, or see that it can be written"))?;
    }
    say(&format!("{} is what students read first", asked.folder.join("README.md").display()))?;
    Ok(Outcome::Done)
}
