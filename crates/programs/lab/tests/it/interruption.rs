//! Ctrl-C and a request to terminate, while rendering and while writing.
#![cfg(unix)]

use std::fs;
use std::io::{BufRead, BufReader};
use std::os::unix::process::ExitStatusExt;
use std::process::{Child, Command, ExitStatus, Stdio};
use std::thread;
use std::time::{Duration, Instant};

use crate::desk::{Desk, MESH};

/// No step of these tests takes longer, however slow the computer; a test that waits for more has failed.
const TOO_LONG: Duration = Duration::from_secs(60);

fn send(signal: &str, to: &Child) {
    let sent = Command::new("kill").args([signal, &to.id().to_string()]).status().unwrap();
    assert!(sent.success());
}

/// How the program ends; it is killed, and the test fails, if it does not.
fn end(child: &mut Child) -> ExitStatus {
    let start = Instant::now();
    while start.elapsed() < TOO_LONG {
        if let Some(status) = child.try_wait().unwrap() {
            return status;
        }
        thread::sleep(Duration::from_millis(5));
    }
    child.kill().unwrap();
    panic!("the program did not end on the signal");
}

#[test]
fn a_signal_while_rendering_ends_the_program_and_leaves_the_old_picture() {
    for (signal, code) in [("-INT", 130), ("-TERM", 143)] {
        let desk = Desk::new();
        desk.put("stone.obj", format!("mtllib nowhere.mtl\n{MESH}"));
        desk.put("stone.png", "old");
        // Minutes of work, so that the signal comes in the middle of it.
        let line = "render stone.obj --renderer raytrace --size 8000x8000 --samples 16";
        let words: Vec<&str> = line.split(' ').collect();
        let mut child = desk.command(&words).stderr(Stdio::piped()).stdout(Stdio::null()).spawn().unwrap();
        // The warning about the missing MTL file tells that the program is at work.
        let mut warning = String::new();
        BufReader::new(child.stderr.take().unwrap()).read_line(&mut warning).unwrap();
        assert!(warning.starts_with("warning: "), "{warning}");
        send(signal, &child);
        let status = end(&mut child);
        assert_eq!((status.code(), status.signal()), (Some(code), None), "{signal}");
        assert_eq!(desk.files(), ["stone.obj", "stone.png"], "{signal}");
        assert_eq!(desk.bytes("stone.png"), b"old", "{signal}");
    }
}

#[test]
fn a_signal_while_writing_leaves_no_temporary_file() {
    let desk = Desk::new();
    let mut caught = 0;
    for _ in 0..5 {
        if caught == testkit::effort(1, 5) {
            break;
        }
        desk.put("out.exr", "old");
        // 12 MB: writing them takes long enough to be seen.
        let line = "render cycle --renderer zbuffer --samples 1 --size 1200x800 -o out.exr";
        let words: Vec<&str> = line.split(' ').collect();
        let mut child = desk.command(&words).stdout(Stdio::null()).spawn().unwrap();
        wait_for_bytes(&desk, &mut child);
        send("-INT", &child);
        match end(&mut child).code() {
            // It was too late or just in time: the picture is whole.
            Some(0) => assert_eq!(desk.picture("out.exr").width(), 1200),
            Some(130) => {
                caught += 1;
                let bytes = desk.bytes("out.exr");
                assert!(bytes == b"old" || desk.picture("out.exr").width() == 1200, "a torn file");
            }
            other => panic!("ended with {other:?}"),
        }
        assert_eq!(desk.files(), ["out.exr"]);
    }
    assert!(caught > 0, "no signal came while the file was written");
}

/// Waits until a temporary file has bytes in it, or the program has ended.
fn wait_for_bytes(desk: &Desk, child: &mut Child) {
    let start = Instant::now();
    while start.elapsed() < TOO_LONG && child.try_wait().unwrap().is_none() {
        let growing = desk.files().iter().any(|name| {
            name.starts_with(".lab-") && fs::metadata(desk.path(name)).is_ok_and(|file| file.len() > 0)
        });
        if growing {
            return;
        }
        thread::yield_now();
    }
}
