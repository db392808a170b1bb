//! How does a student's file become a worker? By rustc alone, around a main file of a few lines.

use std::ffi::OsStr;
use std::fs;
use std::io;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

use course::Exercise;

use crate::kit::Kit;

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

impl Compiler {
    /// Compiles students' files into one worker in `folder`; its functions are those of the parts, in their order.
    pub(crate) fn worker(&self, parts: &[Part<'_>], folder: &Path) -> Result<PathBuf, NotCompiled> {
        let main = folder.join("main.rs");
        let worker = folder.join(format!("worker{}", std::env::consts::EXE_SUFFIX));
        fs::write(&main, main_file(parts)).map_err(NotCompiled::Failed)?;
        let output = Command::new(&self.kit.rustc)
            .current_dir(&self.root)
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
            .args(["--color", if self.colour { "always" } else { "never" }])
            .arg(remapped(&self.root))
            .args(self.kit.arguments())
            .arg("-o")
            .arg(&worker)
            .arg(&main)
            .stdin(Stdio::null())
            .output()
            .map_err(NotCompiled::Failed)?;
        if output.status.success() {
            return Ok(worker);
        }
        let message = String::from_utf8_lossy(&output.stderr).into_owned();
        if message.contains("E0514") || message.contains("E0460") {
            return Err(NotCompiled::OldKit);
        }
        let at_our_side = message.contains("main.rs");
        let note = parts.first().filter(|_| at_our_side).map(|Part { exercise, .. }| {
            format!(
                "The exercise asks for `pub fn {}{}`: name, parameters and result must be these.",
                exercise.name,
                exercise.signature.text.replace(", )", ")")
            )
        });
        Err(NotCompiled::Refused { message, note })
    }
}

/// File names in messages and panics start at the project's folder.
fn remapped(root: &Path) -> std::ffi::OsString {
    let mut argument = std::ffi::OsString::from("--remap-path-prefix=");
    argument.push(root);
    argument.push(OsStr::new(std::path::MAIN_SEPARATOR_STR));
    argument.push("=");
    argument
}

/// The main file: each student's file is a module of it.
fn main_file(parts: &[Part<'_>]) -> String {
    let modules: String = parts
        .iter()
        .enumerate()
        .map(|(at, Part { file, .. })| format!("#[path = {file:?}]\nmod student_{at};\n"))
        .collect();
    let functions: String = parts
        .iter()
        .enumerate()
        .map(|(at, Part { exercise, .. })| {
            format!("worker::function!(student_{at}::{}, {}), ", exercise.name, exercise.signature.text)
        })
        .collect();
    format!(
        "#![allow(unused_imports)]\n{modules}use glam::*;\nuse vocabulary::*;\n\
         fn main() -> std::process::ExitCode {{\n    worker::serve(&[{functions}])\n}}\n"
    )
}
