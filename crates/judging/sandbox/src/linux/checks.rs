//! Which tries show what a system enforces?

use std::fs;
use std::io;
use std::net::{Ipv4Addr, TcpListener};
use std::os::unix::process::ExitStatusExt;
use std::path::{Path, PathBuf};
use std::process::{Output, Stdio};
use std::time::Duration;

use tempfile::TempDir;

use crate::checkup::{Check, Finding, MARK, POSSIBLE, REFUSED};
use crate::confinement::{Calls, Confinement, ResourceLimits, libraries, loaders};
use crate::launcher::{Launcher, NOT_LAUNCHED};

const KERNEL: &str =
    "boot Linux 5.13 or later with `landlock` among its security modules (the kernel's parameter `lsm=`)";
const SECCOMP: &str = "boot a kernel with seccomp filters, and in a container do not forbid them";
const LIMITS: &str =
    "look at what starts this program: a container or a batch system may set limits of its own";

/// A try and what is expected of it.
struct Try {
    name: &'static str,
    tried: &'static str,
    needed: bool,
    remedy: &'static str,
    calls: Calls,
    what: &'static str,
    argument: String,
    /// The signal that ends it, where it is not refused but ended.
    signal: Option<i32>,
}

/// Tries everything.
pub(crate) fn checks(launcher: &Launcher) -> Vec<Check> {
    let place = match Place::new() {
        Ok(place) => place,
        Err(e) => {
            let why = format!("there is no place to try it: {e}");
            let finding = Finding::Missing { why, remedy: "make the folder for temporary files writable" };
            return vec![Check { name: "confinement", tried: "nothing", needed: true, finding }];
        }
    };
    let tries = tries(&place);
    tries
        .into_iter()
        .map(|attempt| Check {
            name: attempt.name,
            tried: attempt.tried,
            needed: attempt.needed,
            finding: place.finding(launcher, &attempt),
        })
        .collect()
}

/// A folder with something to read, and a socket to connect to.
struct Place {
    folder: TempDir,
    secret: PathBuf,
    scratch: PathBuf,
    listener: TcpListener,
}

impl Place {
    fn new() -> io::Result<Self> {
        let folder = tempfile::tempdir()?;
        let scratch = folder.path().join("scratch");
        fs::create_dir(&scratch)?;
        let secret = folder.path().join("secret");
        fs::write(&secret, "secret")?;
        Ok(Self { folder, secret, scratch, listener: TcpListener::bind((Ipv4Addr::LOCALHOST, 0))? })
    }

    /// Starts this program confined and lets it try.
    fn finding(&self, launcher: &Launcher, attempt: &Try) -> Finding {
        let missing = |why: String| Finding::Missing { why, remedy: attempt.remedy };
        // All but one need next to nothing; it must not be the limit of time that ends them on a slow system.
        let cpu = Duration::from_secs(if attempt.what == "loop" { 1 } else { 10 });
        let limits = ResourceLimits { cpu, file: 64 << 10, open: 32, ..ResourceLimits::default() };
        let limits = ResourceLimits {
            processes: if attempt.what == "processes" { 1 } else { limits.processes },
            ..limits
        };
        let program = launcher.program();
        let mut readable = libraries();
        readable.push("/dev/null".into());
        let mut executable = loaders();
        executable.push(program.to_owned());
        let confinement = Confinement {
            readable,
            executable,
            writable: vec![self.scratch.clone()],
            ..Confinement::new(attempt.calls, limits)
        };
        let mut command = launcher.command(&confinement, program);
        command.arg(MARK).arg(attempt.what).arg(&attempt.argument).stdin(Stdio::null());
        match command.output() {
            Err(e) => missing(format!("it did not start: {e}")),
            Ok(output) => judged(&output, attempt.signal).unwrap_or_else(|why| {
                missing(format!("{why} {}", String::from_utf8_lossy(&output.stderr).trim()).trim().to_owned())
            }),
        }
    }
}

fn judged(output: &Output, signal: Option<i32>) -> Result<Finding, &'static str> {
    match (output.status.code(), output.status.signal()) {
        // A program that tries nothing ends well too.
        (Some(0), _) if output.stdout == REFUSED.as_bytes() => Ok(Finding::Enforced),
        (None, ended) if ended.is_some() && ended == signal => Ok(Finding::Enforced),
        (Some(code), _) if code == i32::from(POSSIBLE) => Err("it was possible"),
        (Some(code), _) if code == i32::from(NOT_LAUNCHED) => Err("no program can be confined:"),
        _ => Err("the try ended otherwise:"),
    }
}

fn tries(place: &Place) -> Vec<Try> {
    let path = |path: &Path| path.display().to_string();
    let outside = path(&place.folder.path().join("outside"));
    let port = place.listener.local_addr().map(|address| address.port()).unwrap_or_default().to_string();
    let pid = std::process::id().to_string();
    let landlock = |name, tried, what, argument| Try {
        name,
        tried,
        needed: true,
        remedy: KERNEL,
        calls: Calls::Any,
        what,
        argument,
        signal: None,
    };
    let second = |attempt, remedy| Try { needed: false, remedy, ..attempt };
    let seccomp = |name, tried, calls, what| Try {
        calls,
        remedy: SECCOMP,
        ..landlock(name, tried, what, String::new())
    };
    let limit = |name, tried, what, argument| Try { remedy: LIMITS, ..landlock(name, tried, what, argument) };
    let ended = |attempt, signal| Try { signal: Some(signal), ..attempt };
    let threads = "to start two thousand threads";
    vec![
        landlock("Landlock: reading", "to read a file of another", "read", path(&place.secret)),
        landlock("Landlock: writing", "to write outside its folder", "write", outside),
        landlock("Landlock: running", "to run a program", "run", "/bin/true".to_owned()),
        second(landlock("Landlock: TCP", "to connect to a port of this machine", "connect", port), TCP),
        second(landlock("Landlock: signals", "to signal the one that started it", "signal", pid), SIGNALS),
        seccomp("seccomp: sockets of a worker", "to open a socket", Calls::Computing, "socket"),
        seccomp("seccomp: sockets of a compiler", "to open a socket", Calls::Building, "socket"),
        Try {
            argument: "/bin/true".to_owned(),
            ..seccomp("seccomp: processes", "to start a process", Calls::Computing, "run")
        },
        // Where the memory ends while a thread is beginning, that thread ends the program: it was refused too.
        ended(seccomp("seccomp and memory: threads", threads, Calls::Computing, "threads"), libc::SIGABRT),
        limit("limit: memory", "to reserve two GiB of one", "memory", (2_u64 << 30).to_string()),
        ended(limit("limit: time", "to compute without end", "loop", String::new()), libc::SIGXCPU),
        ended(
            limit("limit: files", "to write a longer file", "file", path(&place.scratch.join("long"))),
            libc::SIGXFSZ,
        ),
        limit("limit: open files", "to open more files", "open", String::new()),
        second(
            limit("limit: processes", "to start a thread too many", "processes", String::new()),
            PROCESSES,
        ),
    ]
}

const TCP: &str = "nothing: seccomp forbids sockets altogether; Linux 6.7 or later adds this";
const SIGNALS: &str = "nothing: seccomp forbids signals to others; Linux 6.12 or later adds this";
const PROCESSES: &str = "nothing: root's processes are not counted, and seccomp forbids new ones; run as another user to add this";

#[cfg(test)]
mod tests {
    use std::process::ExitStatus;

    use super::*;

    /// What comes of the try with threads where the program ends with this status.
    fn threads(status: i32) -> Result<Finding, &'static str> {
        let place = Place::new().expect("a place");
        let attempt = tries(&place).into_iter().find(|attempt| attempt.what == "threads").expect("a try");
        let output = Output { status: ExitStatus::from_raw(status), stdout: Vec::new(), stderr: Vec::new() };
        judged(&output, attempt.signal)
    }

    #[test]
    fn a_thread_whose_first_allocation_fails_is_refused_too() {
        assert_eq!(threads(libc::SIGABRT), Ok(Finding::Enforced));
        assert!(threads(libc::SIGSEGV).is_err());
        assert!(threads(i32::from(POSSIBLE) << 8).is_err());
    }
}
