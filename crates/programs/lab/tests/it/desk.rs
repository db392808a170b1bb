//! A folder of its own in which a test runs the program, and what the program said.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output, Stdio};

use canvas::{Image, codec};
use tempfile::TempDir;

/// The program under test.
pub(crate) const LAB: &str = env!("CARGO_BIN_EXE_lab");

/// A small mesh that nobody drew by hand: a tetrahedron without any symmetry.
pub(crate) const MESH: &str =
    "v 0 0 0\nv 3 0.2 0.1\nv 0.3 2 0\nv 0.5 0.4 1.7\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n";

/// The project's folder.
pub(crate) fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).ancestors().nth(3).expect("crates/programs/lab").to_owned()
}

/// An empty folder; it goes when the test ends.
pub(crate) struct Desk {
    folder: TempDir,
}

/// How a run ended.
#[derive(Debug)]
pub(crate) struct Said {
    /// The exit code; `None` if a signal ended the program.
    pub(crate) code: Option<i32>,
    pub(crate) out: String,
    pub(crate) err: String,
}

impl Desk {
    pub(crate) fn new() -> Self {
        Self { folder: tempfile::tempdir().unwrap() }
    }

    pub(crate) fn path(&self, name: &str) -> PathBuf {
        self.folder.path().join(name)
    }

    pub(crate) fn put(&self, name: &str, bytes: impl AsRef<[u8]>) {
        fs::write(self.path(name), bytes).unwrap();
    }

    pub(crate) fn bytes(&self, name: &str) -> Vec<u8> {
        fs::read(self.path(name)).unwrap_or_else(|error| panic!("{name}: {error}"))
    }

    pub(crate) fn picture(&self, name: &str) -> Image {
        codec::decode(&self.bytes(name)).unwrap()
    }

    /// The names of all files here, sorted.
    pub(crate) fn files(&self) -> Vec<String> {
        self.files_in("")
    }

    /// The names of all files in a folder here, sorted.
    pub(crate) fn files_in(&self, folder: &str) -> Vec<String> {
        let entries = fs::read_dir(self.path(folder)).unwrap();
        let mut names: Vec<String> =
            entries.map(|entry| entry.unwrap().file_name().into_string().unwrap()).collect();
        names.sort();
        names
    }

    /// The program, to be started in this folder with these words.
    pub(crate) fn command(&self, words: &[&str]) -> Command {
        let mut command = Command::new(LAB);
        command.args(words).current_dir(self.folder.path()).stdin(Stdio::null());
        command
    }

    /// Runs `cargo lab` with the words of `line`.
    pub(crate) fn lab(&self, line: &str) -> Said {
        self.words(&line.split_whitespace().collect::<Vec<_>>())
    }

    pub(crate) fn words(&self, words: &[&str]) -> Said {
        Said::from(self.command(words).output().unwrap())
    }

    /// Runs a line of shell, in which `$LAB` is the program.
    pub(crate) fn shell(&self, line: &str) -> Said {
        let mut shell = Command::new("sh");
        shell.args(["-c", line]).env("LAB", LAB).current_dir(self.folder.path()).stdin(Stdio::null());
        Said::from(shell.output().unwrap())
    }
}

impl From<Output> for Said {
    fn from(output: Output) -> Self {
        Self {
            code: output.status.code(),
            out: String::from_utf8(output.stdout).unwrap(),
            err: String::from_utf8(output.stderr).unwrap(),
        }
    }
}

impl Said {
    /// The run ended well and had nothing to complain about.
    #[track_caller]
    pub(crate) fn done(self) -> Self {
        assert_eq!((self.code, self.err.as_str()), (Some(0), ""), "{}", self.out);
        self
    }

    /// The run ended with one error, which has these parts, and a line that helps.
    #[track_caller]
    pub(crate) fn refused(self, parts: &[&str]) -> Self {
        assert_eq!(self.code, Some(2), "{self:?}");
        assert_eq!(self.err.matches("error: ").count(), 1, "{}", self.err);
        let helps = self.err.contains("\nhelp: ") || self.err.contains("try '--help'");
        assert!(helps, "{}", self.err);
        for part in parts {
            assert!(self.err.contains(part), "no {part:?} in: {}", self.err);
        }
        for noise in ["panicked", "os error", "Some(", "Err(", "{ "] {
            assert!(!self.err.contains(noise), "{noise:?} is nothing for a user: {}", self.err);
        }
        self
    }
}

/// Whether the file at `path` is there.
pub(crate) fn is_there(path: &Path) -> bool {
    fs::symlink_metadata(path).is_ok()
}
