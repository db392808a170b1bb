//! The live page from the command line: it says where it is, answers, and ends with all that it has started.
#![cfg(unix)]

use std::io::{BufRead, BufReader, Read, Write};
use std::net::{TcpListener, TcpStream};
use std::process::{Child, Command, Stdio};
use std::time::{Duration, Instant};

use crate::desk::{Desk, root};

/// No step takes longer, however slow the computer.
const TOO_LONG: Duration = Duration::from_secs(120);

/// A server that is killed if the test fails.
struct Served {
    child: Child,
    address: String,
}

impl Drop for Served {
    fn drop(&mut self) {
        let _ = self.child.kill();
        let _ = self.child.wait();
    }
}

impl Served {
    fn start(desk: &Desk, words: &[&str]) -> Self {
        let mut command = desk.command(&[&["play", "--no-open"], words].concat());
        // In the project, with exercises of the test's own.
        let mut child = command
            .current_dir(root())
            .env("LIGHTLAB_EXERCISES", desk.path("exercises"))
            .stdout(Stdio::piped())
            .spawn()
            .unwrap();
        let mut address = String::new();
        BufReader::new(child.stdout.take().unwrap()).read_line(&mut address).unwrap();
        Self { child, address: address.trim_end().to_owned() }
    }

    fn port(&self) -> u16 {
        let after = self.address.strip_prefix("http://127.0.0.1:").unwrap();
        after.split('/').next().unwrap().parse().unwrap()
    }

    fn ask(&self, request: &str) -> String {
        let mut stream = TcpStream::connect(("127.0.0.1", self.port())).unwrap();
        stream.set_read_timeout(Some(TOO_LONG)).unwrap();
        stream.write_all(request.as_bytes()).unwrap();
        let mut answer = String::new();
        stream.read_to_string(&mut answer).unwrap();
        answer
    }

    fn interrupt(&mut self) -> Option<i32> {
        let sent = Command::new("kill").args(["-INT", &self.child.id().to_string()]).status().unwrap();
        assert!(sent.success());
        let begun = Instant::now();
        while begun.elapsed() < TOO_LONG {
            if let Some(status) = self.child.try_wait().unwrap() {
                return status.code();
            }
            std::thread::sleep(Duration::from_millis(10));
        }
        panic!("it does not end");
    }
}

fn desk() -> Desk {
    let desk = Desk::new();
    for exercise in course::all() {
        let path = desk.path("exercises").join(exercise.path());
        std::fs::create_dir_all(path.parent().unwrap()).unwrap();
        std::fs::write(path, exercise.stub).unwrap();
    }
    desk
}

#[test]
fn it_prints_its_address_answers_and_ends_with_ctrl_c() {
    let desk = desk();
    let mut served = Served::start(&desk, &["--port", "0", "L31?p=64"]);
    assert!(served.address.contains("/?key=") && served.address.ends_with("?p=64"), "{}", served.address);
    let host = format!("127.0.0.1:{}", served.port());
    let page = served.ask(&format!("GET / HTTP/1.1\r\nHost: {host}\r\nConnection: close\r\n\r\n"));
    assert!(page.starts_with("HTTP/1.1 200"), "{page}");
    assert_eq!(served.interrupt(), Some(130));
    assert!(TcpStream::connect(("127.0.0.1", served.port())).is_err(), "it still listens");
}

#[test]
fn a_taken_port_means_the_next_free_one() {
    let taken = TcpListener::bind("127.0.0.1:0").unwrap();
    let port = taken.local_addr().unwrap().port();
    let desk = desk();
    let mut served = Served::start(&desk, &["--port", &port.to_string()]);
    assert!(served.port() > port, "{}", served.address);
    assert_eq!(served.interrupt(), Some(130));
}

#[test]
fn what_is_no_figure_is_refused_before_anything_is_served() {
    let desk = Desk::new();
    desk.lab("play L99 --no-open").refused(&["L99", "L31"]);
    desk.words(&["play", "--no-open", "L31?p=<script>"]).refused(&["L31?p=64"]);
    desk.lab("play --port 70000").refused(&["70000"]);
}

#[test]
#[cfg(target_os = "linux")]
fn ctrl_c_ends_a_students_function_that_has_no_end() {
    let desk = desk();
    let exercise = course::find("lambert").unwrap();
    let endless = exercise.stub.replace("todo!()", "loop { std::hint::spin_loop() }");
    assert_ne!(endless, exercise.stub);
    desk.put("exercises/lighting/lambert.rs", endless);
    let mut served = Served::start(&desk, &["--port", "0"]);
    let key = served.address.split("key=").nth(1).unwrap().to_owned();
    let (host, port) = (format!("127.0.0.1:{}", served.port()), served.port());
    let question = r#"{"figure":"L26-lambert","exercise":"lambert"}"#;
    let mut stream = TcpStream::connect(("127.0.0.1", port)).unwrap();
    let head = format!(
        "POST /api/mine HTTP/1.1\r\nHost: {host}\r\nCookie: lightlab-{port}={key}\r\nContent-Type: application/json\r\nContent-Length: {}\r\n\r\n",
        question.len()
    );
    stream.write_all(format!("{head}{question}").as_bytes()).unwrap();
    // Its worker runs in a folder of its own, named after nothing else here.
    let parent = served.child.id().to_string();
    let children = || {
        let entries = std::fs::read_dir("/proc").unwrap().flatten();
        entries
            .filter_map(|entry| std::fs::read_to_string(entry.path().join("stat")).ok())
            .filter(|stat| {
                // After the name in parentheses: state, then the parent.
                let after = stat.rsplit_once(')').map_or("", |(_, after)| after);
                stat.contains("(worker") && after.split_whitespace().nth(1) == Some(&parent)
            })
            .filter_map(|stat| stat.split(' ').next().map(str::to_owned))
            .collect::<Vec<_>>()
    };
    let begun = Instant::now();
    let workers = loop {
        let workers = children();
        if !workers.is_empty() {
            break workers;
        }
        assert!(begun.elapsed() < TOO_LONG, "no worker begins");
        std::thread::sleep(Duration::from_millis(20));
    };
    assert_eq!(served.interrupt(), Some(130));
    let begun = Instant::now();
    while workers.iter().any(|pid| std::path::Path::new("/proc").join(pid).join("exe").exists()) {
        assert!(begun.elapsed() < TOO_LONG, "a worker lives on");
        std::thread::sleep(Duration::from_millis(20));
    }
}
