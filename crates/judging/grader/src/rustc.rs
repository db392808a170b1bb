//! How is rustc run so that no file, whatever is in it, keeps it busy or makes it reach for what is not the file's business?

use std::ffi::OsString;
use std::io::{self, Read};
use std::path::{Path, PathBuf};
use std::process::{Child, Command, ExitStatus, Stdio};
use std::sync::mpsc::{self, RecvTimeoutError};
use std::thread;
use std::time::Duration;

use sandbox::{Calls, Confinement, Launcher, NOT_LAUNCHED, ResourceLimits};
use serde_json::Value as Json;
use worker::system;

use crate::activity::activity;
use crate::libraries::Libraries;
use crate::running::KILLED;

/// Processor time for each further file that is compiled with the first.
const EACH_MORE: Duration = Duration::from_secs(1);

/// Time between two looks at what it has computed.
const LOOK: Duration = Duration::from_millis(100);

/// A compiler that has not computed its time away after so many looks waits for something that will not come: half an hour.
const PATIENCE: u32 = 18_000;

/// Address space, in bytes, for rustc and the linker each. All exercises together take a seventh of it on two processors; on many the linker has up to
/// sixteen threads, each of which sets some aside.
const MEMORY: u64 = 4 << 30;

/// The longest file that rustc or the linker may write, in bytes. A worker has five million.
const FILE: u64 = 256 << 20;

/// So much of what rustc says is read, in bytes.
const HEARD: usize = 4 << 20;

/// So much of it is passed on.
const TOLD: usize = 64 << 10;

/// What rustc may take of a processor for so many files, if it may take `first` for one.
pub(crate) fn time(first: Duration, files: usize) -> Duration {
    first + EACH_MORE * files.saturating_sub(1) as u32
}

/// How rustc ended.
#[derive(Debug)]
pub(crate) enum End {
    /// It made the program.
    Made,
    /// It refuses the files, or broke off; what it said.
    Refused(Said),
    /// It took longer than this.
    TooLong(Duration),
    /// It wanted more memory than it may have.
    TooMuch,
    /// It was ended by a signal.
    Broken,
    /// It failed for a reason that points into no file: no linker, no room on the disk, or a file that no linker can work with. What it said.
    Unexplained(String),
}

/// What rustc said.
#[derive(Debug, Default)]
pub(crate) struct Said {
    /// For a person, as rustc prints it.
    pub(crate) text: String,
    /// The codes of errors: "E0308".
    pub(crate) codes: Vec<String>,
    /// The files that errors point into.
    pub(crate) files: Vec<String>,
    /// Those of them in which an error lies.
    pub(crate) wrong: Vec<String>,
    /// The files that remarks on errors point into: where something is defined, say.
    pub(crate) mentioned: Vec<String>,
}

/// A command for rustc: confined to `folder`, and without the caller's environment, if there is a launcher.
pub(crate) fn command(
    libraries: &Libraries,
    folder: &Path,
    time: Duration,
    launcher: Option<&Launcher>,
) -> Command {
    let mut command = match launcher {
        Some(launcher) => {
            let mut command = launcher.command(&confinement(libraries, folder, time), &libraries.rustc);
            // What it is told a file can find out; so neither of the two says where anything of the caller's lies.
            command.env_clear().env("TMPDIR", ".").envs(path_of_the_system().map(|path| ("PATH", path)));
            command
        }
        None => Command::new(&libraries.rustc),
    };
    command.current_dir(folder);
    command
}

/// Where the linker is: those folders of the caller's `PATH` that hold the system's programs.
fn path_of_the_system() -> Option<OsString> {
    let allowed = sandbox::programs();
    let path = std::env::var_os("PATH")?;
    let of_the_system = std::env::split_paths(&path).filter(|folder| {
        let real = folder.canonicalize().unwrap_or_default();
        allowed.iter().any(|allowed| real.starts_with(allowed))
    });
    std::env::join_paths(of_the_system).ok()
}

/// Rustc reads the toolchain and the libraries, starts a linker, and writes where it is told to.
fn confinement(libraries: &Libraries, folder: &Path, time: Duration) -> Confinement {
    let limits =
        ResourceLimits { memory: MEMORY, cpu: time, file: FILE, open: 1024, ..ResourceLimits::default() };
    let mut executable = sandbox::programs();
    executable.push(libraries.sysroot.clone());
    executable.push(libraries.rustc.clone());
    Confinement {
        readable: libraries.files.clone(),
        listable: libraries.dependencies.iter().cloned().collect(),
        executable,
        writable: vec![folder.to_owned(), PathBuf::from("/dev/null")],
        ..Confinement::new(Calls::Building, limits)
    }
}

/// Runs rustc to its end, or to that of its time. Where the system does not say what it computes, the clock decides, with much patience.
pub(crate) fn run(mut command: Command, limit: Duration) -> io::Result<End> {
    let mut child = command.stdin(Stdio::null()).stdout(Stdio::null()).stderr(Stdio::piped()).spawn()?;
    let heard = listen(&mut child);
    for _ in 0..PATIENCE {
        match heard.recv_timeout(LOOK) {
            // The linker and all else that it started ends with it.
            Ok(words) => return judged(sandbox::finish(&mut child)?, &words, limit),
            Err(RecvTimeoutError::Disconnected) => {
                sandbox::end(&mut child)?;
                return Err(io::Error::other("what it says cannot be read"));
            }
            Err(RecvTimeoutError::Timeout) => {
                if activity(child.id()).is_some_and(|now| now.computed > limit) {
                    sandbox::end(&mut child)?;
                    return Ok(End::TooLong(limit));
                }
            }
        }
    }
    sandbox::end(&mut child)?;
    Err(io::Error::other("it neither computes nor ends"))
}

/// Reads what rustc says until the last of its processes has closed its output; keeps the beginning.
fn listen(child: &mut Child) -> mpsc::Receiver<Vec<u8>> {
    let (sender, receiver) = mpsc::channel();
    if let Some(mut pipe) = child.stderr.take() {
        thread::spawn(move || {
            let mut words = Vec::new();
            let _ = pipe.by_ref().take(HEARD as u64).read_to_end(&mut words);
            // So that it need not wait for a reader.
            let _ = io::copy(&mut pipe, &mut io::sink());
            let _ = sender.send(words);
        });
    }
    receiver
}

fn judged(status: ExitStatus, words: &[u8], limit: Duration) -> io::Result<End> {
    if status.success() {
        return Ok(End::Made);
    }
    let words = String::from_utf8_lossy(words);
    if status.code() == Some(i32::from(NOT_LAUNCHED)) {
        return Err(io::Error::other(words.trim().to_owned()));
    }
    // What the compiler itself says when it gets no memory; it comes from no message about a file, which would be JSON.
    let own = || words.lines().filter(|line| !line.starts_with('{'));
    if own().any(|line| MEMORY_WORDS.iter().any(|words| line.contains(words))) {
        return Ok(End::TooMuch);
    }
    Ok(match system::signal(status) {
        Some(signal) if system::is_out_of_time(signal) => End::TooLong(limit),
        // By whoever looks after the machine's memory, say.
        Some(KILLED) => return Err(io::Error::other("something on this machine ended it")),
        Some(_) => End::Broken,
        None => match said(&words) {
            // Nothing that a file says, whatever words it uses.
            said if said.files.is_empty() && said.codes.is_empty() => End::Unexplained(said.text),
            said => End::Refused(said),
        },
    })
}

const MEMORY_WORDS: [&str; 4] =
    ["memory allocation of", "out of memory", "Cannot allocate memory", "bad_alloc"];

/// Puts rustc's messages together.
fn said(words: &str) -> Said {
    let mut said = Said::default();
    for message in words.lines().filter_map(|line| serde_json::from_str::<Json>(line).ok()) {
        said.codes.extend(message["code"]["code"].as_str().map(str::to_owned));
        said.files.extend(files(&message, |_| true));
        said.wrong.extend(files(&message, |span| span["is_primary"] == true));
        let remarks = message["children"].as_array().into_iter().flatten();
        said.mentioned.extend(remarks.flat_map(|remark| files(remark, |_| true)));
        tell(&mut said.text, message["rendered"].as_str().unwrap_or_default());
    }
    if said.text.is_empty() {
        // It did not come to read a file.
        tell(&mut said.text, words);
    }
    said
}

/// The files that a message points into, by those of its spans that are `meant`.
fn files(message: &Json, meant: impl Fn(&Json) -> bool) -> Vec<String> {
    let spans = message["spans"].as_array().into_iter().flatten().filter(|span| meant(span));
    spans.filter_map(|span| Some(written_in(span)["file_name"].as_str()?.to_owned())).collect()
}

/// Where somebody wrote what an error points to: outside all macros.
fn written_in(mut span: &Json) -> &Json {
    while span["expansion"].is_object() {
        span = &span["expansion"]["span"];
    }
    span
}

/// Adds a message, as far as there is room; once there is none, says so and adds nothing more.
fn tell(text: &mut String, message: &str) {
    if text.ends_with(MORE) {
        return;
    }
    let room = TOLD.saturating_sub(text.len()).min(message.len());
    let end = (0..=room).rev().find(|end| message.is_char_boundary(*end)).unwrap_or_default();
    text.push_str(&message[..end]);
    if end < message.len() {
        text.push_str(MORE);
    }
}

/// Stands at the end of messages that are too long.
const MORE: &str = "\n…\nThe compiler says more; this is the beginning.\n";
