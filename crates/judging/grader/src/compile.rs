//! How does a student's file become a worker? By rustc alone, around a main file of a few lines.

use std::ffi::OsString;
use std::fs;
use std::io;
use std::path::{Path, PathBuf};
use std::time::Duration;

use course::Exercise;
use sandbox::Launcher;

use crate::forbidden::{self, Forbidden};
use crate::judgement::Outcome;
use crate::libraries::Libraries;
use crate::rustc::{self, End, Said};

/// What rustc is asked for.
#[derive(Clone, Debug)]
pub struct Compiler {
    /// The libraries.
    pub libraries: Libraries,
    /// Names of files are shown relative to this folder.
    pub root: PathBuf,
    /// Whether rustc's messages are colored.
    pub color: bool,
}

/// A file and the exercise whose function is in it.
#[derive(Clone, Copy, Debug)]
pub(crate) struct SourceFile<'a> {
    pub(crate) exercise: &'a Exercise,
    pub(crate) file: &'a Path,
}

/// Why there is no worker.
#[derive(Debug)]
pub(crate) enum NotCompiled {
    /// The file is not right Rust, or lacks the function: what rustc prints, and what we add to it.
    Refused {
        message: String,
        note: Option<String>,
        /// The places of the files that it says are wrong; none where it does not say.
        blamed: Vec<usize>,
    },
    /// The libraries are of another compiler than rustc is now.
    OldKit,
    /// Rustc fails and points into no file: what it says. If it compiles a worker without a student's file, this is the files' doing.
    Unexplained(String),
    /// Rustc does not start, or its files cannot be written: why.
    Failed(String),
}

impl NotCompiled {
    /// That rustc accepts the files and yet makes no program of them; with what it says, if that may be shown.
    pub(crate) fn unlinked(words: Option<String>) -> Self {
        let message = words
            .unwrap_or_else(|| "error: no program can be made of the file: linking it fails\n".to_owned());
        let note = "Is something in it very large, or defined nowhere?".to_owned();
        Self::Refused { message, note: Some(note), blamed: Vec::new() }
    }

    /// What it means for whoever wrote the files.
    pub(crate) fn outcome(self) -> Outcome {
        match self {
            Self::Refused { message, note, .. } => Outcome::DoesNotCompile { message, note },
            Self::OldKit => Outcome::GraderError("the libraries are of another version of Rust".to_owned()),
            Self::Failed(why) | Self::Unexplained(why) => Outcome::GraderError(why),
        }
    }
}

fn failed(error: io::Error) -> NotCompiled {
    NotCompiled::Failed(format!("rustc: {error}"))
}

/// The name of the main file.
const MAIN: &str = "main.rs";

impl Compiler {
    /// Compiles students' files into one worker in `folder`; its functions are those of the parts, in their order. Rustc is confined if
    /// there is a launcher, and may take `first` of a processor for the first file.
    pub(crate) fn worker(
        &self,
        parts: &[SourceFile<'_>],
        folder: &Path,
        first: Duration,
        launcher: Option<&Launcher>,
    ) -> Result<PathBuf, NotCompiled> {
        let limit = rustc::time(first, parts.len());
        let folder = std::path::absolute(folder).map_err(failed)?;
        let worker = folder.join(format!("worker{}", std::env::consts::EXE_SUFFIX));
        let texts =
            parts.iter().map(|part| fs::read(part.file)).collect::<io::Result<Vec<_>>>().map_err(failed)?;
        if let Some(refused) = self.forbidden(parts, &texts) {
            return Err(refused);
        }
        lay_out(&texts, &main_file(parts, course::fingerprint(texts.concat())), &folder).map_err(failed)?;
        let mut command = rustc::command(&self.libraries, &folder, limit, launcher);
        command
            .args(["--edition", "2024", "--crate-name", "worker_of_a_student", "--crate-type", "bin"])
            // Debug assertions catch the overflow of an index; optimization would cost more than it gives.
            .args([
                "-C",
                "opt-level=0",
                "-C",
                "debug-assertions=on",
                "-C",
                "debuginfo=0",
                "-C",
                "strip=debuginfo",
            ])
            // One piece: there is little to share among threads, and less to link.
            .args(["-C", "codegen-units=1"])
            .args(["-F", "unsafe_code", "-A", "warnings"])
            // A text in a file may look like a message of the compiler; in this form it cannot.
            .args(["--error-format", "json"])
            .args(if self.color { &["--json", "diagnostic-rendered-ansi"][..] } else { &[] })
            .args(self.remapped(parts, &folder))
            .args(self.libraries.arguments())
            .arg("-o")
            .arg(&worker)
            .arg(folder.join(MAIN));
        match rustc::run(command, limit).map_err(failed)? {
            End::Made => Ok(worker),
            End::Refused(said) => Err(self.refused(said, parts)),
            End::TooLong(time) => Err(stopped(&format!("after {} s of computing", time.as_secs()))),
            End::TooMuch => Err(stopped("when it asked for more memory than any exercise needs")),
            End::Unexplained(words) => Err(NotCompiled::Unexplained(words)),
            End::Broken => {
                Err(stopped("by the system: something in the file is too deep or too large for it"))
            }
        }
    }

    /// That some of the files hold words that no solution needs, said as rustc says what it refuses.
    fn forbidden(&self, parts: &[SourceFile<'_>], texts: &[Vec<u8>]) -> Option<NotCompiled> {
        let texts: Vec<_> = texts.iter().map(|text| String::from_utf8_lossy(text)).collect();
        let found = texts.iter().enumerate().filter_map(|(at, text)| Some((at, forbidden::first(text)?)));
        let (blamed, messages): (Vec<usize>, Vec<String>) = found
            .map(|(at, Forbidden { word, reaches, line, column })| {
                let path = self.known(&parts[at]).display().to_string();
                (at, format!("error: `{word}` reaches {reaches}, which no exercise needs\n --> {path}:{line}:{column}\n"))
            })
            .unzip();
        let note = "Compute the answer from the arguments alone; a name that happens to be this word can be changed.";
        let refused =
            NotCompiled::Refused { message: messages.concat(), note: Some(note.to_owned()), blamed };
        (!messages.is_empty()).then_some(refused)
    }

    /// How files are called in messages and panics: as the student knows them, from the project's folder on.
    fn remapped(&self, parts: &[SourceFile<'_>], folder: &Path) -> Vec<OsString> {
        // What comes later counts more.
        let mut arguments = vec![remap(folder, Path::new(""))];
        arguments.extend(
            parts.iter().enumerate().map(|(at, part)| remap(&folder.join(copy(at)), &self.known(part))),
        );
        arguments
    }

    /// How a file is called in messages.
    fn known(&self, part: &SourceFile<'_>) -> PathBuf {
        let known = part.file.strip_prefix(&self.root).unwrap_or(part.file);
        // The last `=` of rustc's argument separates the two.
        let separates = known.as_os_str().as_encoded_bytes().contains(&b'=');
        if separates { part.exercise.path().into() } else { known.to_owned() }
    }

    fn refused(&self, said: Said, parts: &[SourceFile<'_>]) -> NotCompiled {
        if said.codes.iter().any(|code| code == "E0514" || code == "E0460") {
            return NotCompiled::OldKit;
        }
        let at_our_side = said.files.iter().any(|file| file == MAIN);
        let note = parts.first().filter(|_| at_our_side).map(|SourceFile { exercise, .. }| {
            format!(
                "The exercise asks for `pub fn {}{}`: name, parameters and result must be these.",
                exercise.name,
                exercise.signature.text.replace(", )", ")")
            )
        });
        let known: Vec<String> =
            parts.iter().map(|part| self.known(part).to_string_lossy().into_owned()).collect();
        NotCompiled::Refused { note, blamed: blamed(&said, &known), message: said.text }
    }
}

fn remap(from: &Path, to: &Path) -> OsString {
    let mut argument = OsString::from("--remap-path-prefix=");
    argument.push(from);
    argument.push("=");
    argument.push(to);
    argument
}

/// Writes the files and the main file into the folder: rustc needs nothing else.
fn lay_out(texts: &[Vec<u8>], main: &str, folder: &Path) -> io::Result<()> {
    for (at, text) in texts.iter().enumerate() {
        fs::write(folder.join(copy(at)), text)?;
    }
    fs::write(folder.join(MAIN), main)
}

/// The name of a student's file in the folder.
fn copy(at: usize) -> String {
    format!("student_{at}.rs")
}

/// The places of the files in which errors lie. An error may lie in the main file, which calls them; then those that it speaks of.
fn blamed(said: &Said, known: &[String]) -> Vec<usize> {
    let among = |files: &[&[String]]| -> Vec<usize> {
        (0..known.len()).filter(|at| files.iter().any(|files| files.contains(&known[*at]))).collect()
    };
    let wrong = among(&[&said.wrong]);
    if wrong.is_empty() { among(&[&said.files, &said.mentioned]) } else { wrong }
}

fn stopped(how: &str) -> NotCompiled {
    let message = format!("The compiler was stopped {how}.\n");
    let note = "Is there a constant, a macro or a type that grows without end?".to_owned();
    NotCompiled::Refused { message, note: Some(note), blamed: Vec::new() }
}

/// The main file: each student's file is a module of it. No file knows the name of another's module, or its own: a solution stands by itself.
fn main_file(parts: &[SourceFile<'_>], secret: u64) -> String {
    let name = |at: usize| format!("student_{secret:016x}_{at}");
    let modules: String =
        (0..parts.len()).map(|at| format!("#[path = {:?}]\nmod {};\n", copy(at), name(at))).collect();
    let functions: String = parts
        .iter()
        .enumerate()
        .map(|(at, SourceFile { exercise, .. })| {
            format!("worker::function!({}::{}, {}), ", name(at), exercise.name, exercise.signature.text)
        })
        .collect();
    format!(
        "#![allow(unused_imports)]\n{modules}use glam::*;\nuse vocabulary::*;\n\
         fn main() -> std::process::ExitCode {{\n    worker::serve(&[{functions}])\n}}\n"
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    fn said(wrong: &[&str], files: &[&str], mentioned: &[&str]) -> Vec<usize> {
        let owned = |names: &[&str]| names.iter().map(|name| (*name).to_owned()).collect();
        let known: Vec<String> = owned(&["scratch/7.rs", "scratch/8.rs", "scratch/17.rs"]);
        let said =
            Said { wrong: owned(wrong), files: owned(files), mentioned: owned(mentioned), ..Said::default() };
        blamed(&said, &known)
    }

    #[test]
    fn an_error_is_that_of_the_file_in_which_it_lies() {
        assert_eq!(
            said(&["scratch/7.rs"], &["scratch/7.rs", "scratch/17.rs"], &["scratch/8.rs"]),
            [0],
            "a note is no error"
        );
        assert_eq!(said(&["main.rs"], &["main.rs"], &["scratch/8.rs"]), [1]);
        assert_eq!(said(&["main.rs"], &["main.rs"], &[]), [] as [usize; 0]);
    }
}
