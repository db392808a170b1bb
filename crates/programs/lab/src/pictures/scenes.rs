//! `cargo lab scenes`: what is there to draw without any file?

use scene::builtin;

use super::args::ScenesArgs;
use crate::cli::Outcome;
use crate::failure::Failure;
use crate::speech::say;

/// Lists the built-in scenes, or prints the one asked for.
///
/// # Errors
/// [`Failure`] if standard output takes nothing.
pub(crate) fn run(asked: &ScenesArgs) -> Result<Outcome, Failure> {
    match asked.name.as_deref().and_then(builtin::find) {
        Some(scene) => say(scene.text.trim_end())?,
        None => list()?,
    }
    Ok(Outcome::Done)
}

/// The names in one column, what they show in the next.
fn list() -> Result<(), Failure> {
    let longest = builtin::all().iter().map(|scene| scene.name.len()).max().unwrap_or(0);
    for (place, scene) in builtin::all().iter().enumerate() {
        let default = if place == 0 { " (the default)" } else { "" };
        say(&format!("{:longest$}  {}{default}", scene.name, scene.summary))?;
    }
    Ok(())
}
