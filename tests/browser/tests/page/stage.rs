//! What stands before a person sits down? A server with exercises of its own, and a browser that reaches nothing but this machine.

use std::io::{BufRead, BufReader};
use std::path::{Path, PathBuf};
use std::process::{Child, Command, Stdio};
use std::sync::LazyLock;

use serde_json::Value as Json;
use tempfile::TempDir;

/// The project.
fn root() -> &'static Path {
    Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/../.."))
}

/// The program that serves the page, as `cargo lab play` builds it; built once.
fn program() -> &'static Path {
    static PROGRAM: LazyLock<PathBuf> = LazyLock::new(|| {
        let output = Command::new(env!("CARGO"))
            .current_dir(root())
            .args(["build", "--release", "--package", "lab", "--no-default-features", "--features", "live"])
            .args(["--message-format", "json-render-diagnostics"])
            .stderr(Stdio::inherit())
            .output()
            .expect("cargo starts");
        assert!(output.status.success(), "the program is not built");
        let messages = String::from_utf8_lossy(&output.stdout).into_owned();
        let executable = messages
            .lines()
            .filter_map(|line| serde_json::from_str::<Json>(line).ok())
            .filter_map(|message| message["executable"].as_str().map(PathBuf::from))
            .next_back();
        executable.expect("cargo names what it built")
    });
    &PROGRAM
}

/// A program that ends with the test.
#[derive(Debug)]
pub(crate) struct Running(Child);

impl Drop for Running {
    fn drop(&mut self) {
        let _ = self.0.kill();
        let _ = self.0.wait();
    }
}

impl Running {
    /// Starts a program, and waits for the line of its output from which `find` reads something.
    fn start<T>(mut command: Command, find: impl Fn(&str) -> Option<T>) -> (Self, T) {
        let spawned = command.stdout(Stdio::piped()).spawn();
        let mut child = spawned.unwrap_or_else(|error| panic!("{command:?} does not start: {error}"));
        let output = child.stdout.take().expect("its output is taken");
        let running = Self(child);
        let mut lines = BufReader::new(output).lines();
        let found = loop {
            let line = lines.next().unwrap_or_else(|| panic!("{command:?} ended")).expect("text");
            if let Some(found) = find(&line) {
                break found;
            }
        };
        // Read on, so that the program never writes into a closed pipe.
        std::thread::spawn(move || lines.for_each(drop));
        (running, found)
    }
}

/// A server, and a folder of exercises that it draws with.
#[derive(Debug)]
pub(crate) struct Stage {
    exercises: TempDir,
    /// `http://127.0.0.1:4711/?key=…`.
    pub(crate) address: String,
    _server: Running,
}

impl Stage {
    /// Starts the server on a free port, with the exercises as they are handed out.
    pub(crate) fn new() -> Self {
        let exercises = tempfile::tempdir().expect("a folder");
        let concepts =
            std::fs::read_dir(root().join("exercises")).expect("the project's exercises").flatten();
        for concept in concepts.filter(|entry| entry.path().is_dir()) {
            let copy = exercises.path().join(concept.file_name());
            std::fs::create_dir(&copy).expect("made");
            for file in std::fs::read_dir(concept.path()).expect("a folder").flatten() {
                std::fs::copy(file.path(), copy.join(file.file_name())).expect("copied");
            }
        }
        let mut command = Command::new(program());
        command.current_dir(root()).env("LIGHTLAB_EXERCISES", exercises.path()).args([
            "play",
            "--no-open",
            "--port",
            "0",
        ]);
        let (server, address) =
            Running::start(command, |line| line.starts_with("http://").then(|| line.to_owned()));
        Self { exercises, address, _server: server }
    }

    /// Without the key: `http://127.0.0.1:4711/`.
    pub(crate) fn base(&self) -> &str {
        self.address.split('?').next().expect("an address")
    }

    /// Saves a student's file: `lighting/lambert.rs`.
    pub(crate) fn save(&self, path: &str, text: &str) {
        std::fs::write(self.exercises.path().join(path), text).expect("written");
    }
}

/// Starts the browser's driver; gives its address too.
pub(crate) fn driver() -> (Running, String) {
    let mut command = Command::new("chromedriver");
    command.arg("--port=0").stderr(Stdio::null());
    Running::start(command, |line| {
        let port = line.split_once("started successfully on port ")?.1.trim_end_matches('.');
        Some(format!("http://127.0.0.1:{port}"))
    })
}
