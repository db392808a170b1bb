//! How does the program speak? Results on standard output, complaints on standard error; a closed pipe silences it.

use std::io::{self, Write};

use crate::failure::{Failure, reason};

/// Says a result on standard output, with a line break at the end.
///
/// A reader who has left (`cargo lab scenes | head -1`) is no error: the rest is not said.
///
/// # Errors
/// [`Failure`] if standard output takes nothing for another reason: it is a file on a full disk, say.
pub(crate) fn say(text: &str) -> Result<(), Failure> {
    let mut out = io::stdout().lock();
    match writeln!(out, "{text}").and_then(|()| out.flush()) {
        Err(error) if error.kind() != io::ErrorKind::BrokenPipe => Err(Failure::new(
            format!("cannot write to standard output: {}", reason(&error)),
            "free some space, or send the output elsewhere",
        )),
        _ => Ok(()),
    }
}

/// Says on standard error what can be borne. Nobody is left to tell if that fails.
pub(crate) fn warn(text: &str) {
    let _ = writeln!(io::stderr(), "warning: {text}");
}

/// Says on standard error how far it is.
#[cfg(feature = "class")]
pub(crate) fn tell(text: &str) {
    let _ = writeln!(io::stderr(), "{text}");
}

/// Says on standard error why the command ends.
pub(crate) fn complain(failure: &Failure) {
    // One call, so that two programs that write to one terminal do not mix their lines.
    let text = format!("error: {}\nhelp: {}\n", failure.problem, failure.remedy);
    let _ = io::stderr().write_all(text.as_bytes());
}
