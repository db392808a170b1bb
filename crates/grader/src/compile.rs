//! How does a student's file become a worker? By rustc alone, around a main file of a few lines.

use std::ffi::OsString;
use std::fs;
use std::io;
use std::path::{Path, PathBuf};

use course::Exercise;
use sandbox::Launcher;

use crate::kit::Kit;
use crate::rustc::{self, End, Said};

/// What rustc is asked for.
#[derive(Clone, Debug)]
pub struct Compiler {
    /// The libraries.
    pub kit: Kit,
    /// Names of files are shown relative to this folder.
    pub root: PathBuf,
    /// Whether rustc's messages are coloured.
    pub colour: bool,
}

/// A file and the exercise whose function is in it.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Part<'a> {
    pub(crate) exercise: &'a Exercise,
    pub(crate) file: &'a Path,
}

/// Why there is no worker.
#[derive(Debug)]
pub(crate) enum NotCompiled {
    /// The file is not right Rust, or lacks the function: what rustc prints, and what we add to it.
    Refused { message: String, note: Option<String> },
    /// The libraries are of another compiler than rustc is now.
    OldKit,
    /// Rustc does not start, or its files cannot be written.
    Failed(io::Error),
}

/// The name of the main file.
const MAIN: &str = "main.rs";

impl Compiler {
    /// Compiles students' files into one worker in `folder`; its functions are those of the parts, in their order. Rustc is confined if
    /// there is a launcher.
    pub(crate) fn worker(
        &self,
        parts: &[Part<'_>],
        folder: &Path,
        launcher: Option<&Launcher>,
    ) -> Result<PathBuf, NotCompiled> {
        let folder = std::path::absolute(folder).map_err(NotCompiled::Failed)?;
        let worker = folder.join(format!("worker{}", std::env::consts::EXE_SUFFIX));
        lay_out(parts, &folder).map_err(NotCompiled::Failed)?;
        let mut command = rustc::command(&self.kit, &folder, parts.len(), launcher);
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
            .args(if self.colour { &["--json", "diagnostic-rendered-ansi"][..] } else { &[] })
            .args(self.remapped(parts, &folder))
            .args(self.kit.arguments())
            .arg("-o")
            .arg(&worker)
            .arg(folder.join(MAIN));
        match rustc::run(command, parts.len()).map_err(NotCompiled::Failed)? {
            End::Made => Ok(worker),
            End::Refused(said) => Err(refused(said, parts)),
            End::TooLong(time) => Err(stopped(&format!("after {} s of computing", time.as_secs()))),
            End::TooMuch => Err(stopped("when it asked for more memory than any exercise needs")),
            End::Broken => {
                Err(stopped("by the system: something in the file is too deep or too large for it"))
            }
        }
    }

    /// How files are called in messages and panics: as the student knows them, from the project's folder on.
    fn remapped(&self, parts: &[Part<'_>], folder: &Path) -> Vec<OsString> {
        // What comes later counts more.
        let mut arguments = vec![remap(folder, Path::new(""))];
        arguments.extend(parts.iter().enumerate().map(|(at, part)| {
            let known = part.file.strip_prefix(&self.root).unwrap_or(part.file);
            let own = PathBuf::from(part.exercise.path());
            // The last `=` of the argument separates the two.
            let known = if known.as_os_str().as_encoded_bytes().contains(&b'=') { &own } else { known };
            remap(&folder.join(copy(at)), known)
        }));
        arguments
    }
}

fn remap(from: &Path, to: &Path) -> OsString {
    let mut argument = OsString::from("--remap-path-prefix=");
    argument.push(from);
    argument.push("=");
    argument.push(to);
    argument
}

/// Copies the files into the folder, and writes the main file: rustc needs nothing else.
fn lay_out(parts: &[Part<'_>], folder: &Path) -> io::Result<()> {
    for (at, part) in parts.iter().enumerate() {
        fs::write(folder.join(copy(at)), fs::read(part.file)?)?;
    }
    let texts: Vec<Vec<u8>> =
        (0..parts.len()).map(|at| fs::read(folder.join(copy(at)))).collect::<Result<_, _>>()?;
    fs::write(folder.join(MAIN), main_file(parts, course::fingerprint(texts.concat())))
}

/// The name of a student's file in the folder.
fn copy(at: usize) -> String {
    format!("student_{at}.rs")
}

fn refused(said: Said, parts: &[Part<'_>]) -> NotCompiled {
    if said.codes.iter().any(|code| code == "E0514" || code == "E0460") {
        return NotCompiled::OldKit;
    }
    let at_our_side = said.files.iter().any(|file| file == MAIN);
    let note = parts.first().filter(|_| at_our_side).map(|Part { exercise, .. }| {
        format!(
            "The exercise asks for `pub fn {}{}`: name, parameters and result must be these.",
            exercise.name,
            exercise.signature.text.replace(", )", ")")
        )
    });
    NotCompiled::Refused { message: said.text, note }
}

fn stopped(how: &str) -> NotCompiled {
    let message = format!("The compiler was stopped {how}.\n");
    let note = "Is there a constant, a macro or a type that grows without end?".to_owned();
    NotCompiled::Refused { message, note: Some(note) }
}

/// The main file: each student's file is a module of it. No file knows the name of another's module, or its own: a solution stands by itself.
fn main_file(parts: &[Part<'_>], secret: u64) -> String {
    let name = |at: usize| format!("student_{secret:016x}_{at}");
    let modules: String =
        (0..parts.len()).map(|at| format!("#[path = {:?}]\nmod {};\n", copy(at), name(at))).collect();
    let functions: String = parts
        .iter()
        .enumerate()
        .map(|(at, Part { exercise, .. })| {
            format!("worker::function!({}::{}, {}), ", name(at), exercise.name, exercise.signature.text)
        })
        .collect();
    format!(
        "#![allow(unused_imports)]\n{modules}use glam::*;\nuse vocabulary::*;\n\
         fn main() -> std::process::ExitCode {{\n    worker::serve(&[{functions}])\n}}\n"
    )
}
