//! Many files of one exercise, of which some may not compile: which do, and what do they answer? One worker for all of them.

use std::path::Path;

use course::{Answerer, Exercise};

use crate::compile::Part;
use crate::judge::{Judge, Worker};
use crate::judgement::Outcome;
use crate::process::Process;

/// Files compiled into one worker, but for those that do not compile.
pub struct Crowd<'a> {
    judge: &'a Judge,
    exercise: &'a Exercise,
    worker: Option<Worker>,
    /// The place of each file's function in the worker.
    places: Vec<Option<u32>>,
}

impl Judge {
    /// Compiles many files of one exercise together. Rustc names the files that it refuses; the others are compiled again without them, which
    /// takes a few rounds, since a compiler that gives up early does not name all. Each file's name must be its own.
    ///
    /// # Errors
    /// An [`Outcome`] that is no file's doing: no compiler, no room, or a refusal that names none of the files.
    pub fn crowd<'a>(&'a self, exercise: &'a Exercise, files: &[&Path]) -> Result<Crowd<'a>, Outcome> {
        let mut left: Vec<usize> = (0..files.len()).collect();
        while !left.is_empty() {
            let parts: Vec<Part<'_>> = left.iter().map(|at| Part { exercise, file: files[*at] }).collect();
            match self.worker(&parts) {
                Ok(worker) => {
                    let place = |at| left.iter().position(|it| *it == at).map(|place| place as u32);
                    let places = (0..files.len()).map(place).collect();
                    return Ok(Crowd { judge: self, exercise, worker: Some(worker), places });
                }
                Err(Outcome::DoesNotCompile { message, note }) => {
                    let before = left.len();
                    left.retain(|at| !refuses(&message, files[*at]));
                    if left.len() == before {
                        return Err(Outcome::DoesNotCompile { message, note });
                    }
                }
                Err(other) => return Err(other),
            }
        }
        Ok(Crowd { judge: self, exercise, worker: None, places: vec![None; files.len()] })
    }
}

impl Crowd<'_> {
    /// One who answers for a file's function, in a process of its own; `None` if the file does not compile.
    pub fn answerer(&self, file: usize) -> Option<impl Answerer + use<>> {
        let worker = self.worker.as_ref()?;
        let place = (*self.places.get(file)?)?;
        let launcher = self.judge.sandbox.as_ref();
        Some(Process::new(&worker.program, place, self.exercise, self.judge.limits, launcher))
    }
}

/// Whether rustc's message has an error in this file: the arrow beneath an error's first line points at it.
fn refuses(message: &str, file: &Path) -> bool {
    let Some(name) = file.file_name().and_then(|name| name.to_str()) else { return false };
    let mut in_error = false;
    message.lines().any(|line| {
        if line.starts_with("error") {
            in_error = true;
        }
        let Some(place) = line.trim_start().strip_prefix("--> ").filter(|_| in_error) else { return false };
        in_error = false;
        let path = place.rsplitn(3, ':').last().unwrap_or(place);
        Path::new(path).file_name().is_some_and(|it| it == name)
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    const MESSAGE: &str = "error[E0308]: mismatched types\n --> target/scratch/7.rs:3:5\n  |\n3 |     1\n  |     ^\n\
                           note: defined here\n --> target/scratch/8.rs:1:4\n\nerror: aborting due to 1 previous error\n";

    #[test]
    fn an_error_is_that_of_the_file_that_its_first_arrow_points_at() {
        assert!(refuses(MESSAGE, Path::new("/elsewhere/7.rs")));
        assert!(!refuses(MESSAGE, Path::new("/elsewhere/8.rs")), "a note is no error");
        assert!(!refuses(MESSAGE, Path::new("/elsewhere/17.rs")));
    }
}
