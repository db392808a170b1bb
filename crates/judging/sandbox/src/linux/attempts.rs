//! What does a confined process try that it should not be able to do?

use std::ffi::OsString;
use std::fs::File;
use std::io::{ErrorKind, Write};
use std::net::{Ipv4Addr, TcpStream, UdpSocket};
use std::process::Command;
use std::thread;
use std::time::Duration;

use rustix::process::Pid;

use crate::checkup::text;

/// Tries something; whether it was refused. `None`: there is no such attempt.
pub(crate) fn attempt(what: &str, arguments: &[OsString]) -> Option<bool> {
    let argument = arguments.first();
    let denied = |error: std::io::Error| error.kind() == ErrorKind::PermissionDenied;
    Some(match what {
        "read" => File::open(argument?).is_err_and(denied),
        "write" => File::create(argument?).is_err_and(denied),
        "run" => Command::new(argument?).spawn().is_err_and(denied),
        "connect" => {
            let port = text(argument)?.parse().ok()?;
            TcpStream::connect((Ipv4Addr::LOCALHOST, port)).is_err_and(denied)
        }
        "signal" => {
            let pid = Pid::from_raw(text(argument)?.parse().ok()?)?;
            rustix::process::test_kill_process(pid).is_err_and(|e| denied(e.into()))
        }
        "socket" => UdpSocket::bind((Ipv4Addr::LOCALHOST, 0)).is_err_and(denied),
        "processes" => thread::Builder::new().spawn(|| ()).is_err(),
        "threads" => too_many_threads(),
        "memory" => Vec::<u8>::new().try_reserve(text(argument)?.parse().ok()?).is_err(),
        "open" => {
            let files: Vec<_> = (0..64).map(|_| File::open("/dev/null")).collect();
            files.iter().any(Result::is_err)
        }
        // The limit ends these.
        "file" => {
            let mut file = File::create(argument?).ok()?;
            (0..64).any(|_| file.write_all(&[0; 4096]).is_err())
        }
        "loop" => loop {
            std::hint::spin_loop();
        },
        _ => return None,
    })
}

/// Whether a thread with a small stack is refused, one with the usual one is not, and many of those are.
fn too_many_threads() -> bool {
    let start = |stack: usize| {
        // On a busy system starting them takes a while, in which none may end; they end with the process.
        let pause = || thread::sleep(Duration::from_secs(600));
        thread::Builder::new().stack_size(stack).spawn(pause)
    };
    start(64 << 10).is_err() && start(2 << 20).is_ok() && (0..2048).any(|_| start(2 << 20).is_err())
}
