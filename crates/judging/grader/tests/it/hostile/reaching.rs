//! Files, sockets, processes, signals.

use std::fs;

use crate::bench::{Bench, root};
use crate::hostile::assert_refused;

/// The path of something that is there, as Rust writes it.
fn quoted(path: &std::path::Path) -> String {
    assert!(path.exists(), "{}", path.display());
    format!("{path:?}")
}

#[test]
fn nothing_is_read_but_what_a_program_needs_to_start() {
    let other = tempfile::tempdir().expect("a folder");
    let submission = other.path().join("rotate_about_point.rs");
    fs::write(&submission, "// another's\n").expect("written");
    let references = root().join("crates/judging/course/src/transforms/rotate_about_point.rs");
    let folder = root().join("crates/judging/course");
    let mut paths = vec![quoted(&submission), quoted(other.path()), quoted(&references), quoted(&folder)];
    let system = [
        "/etc/passwd",
        "/proc/self/mem",
        "/proc/self/environ",
        "/proc/self/maps",
        "/proc/1/environ",
        "/proc",
    ];
    paths.extend(system.map(|path| format!("{path:?}")));
    paths.extend(
        ["\"/tmp\"", "\"/root\"", "\"/home\"", "\"/sys\"", "\"/dev/mem\"", "\".\""].map(str::to_owned),
    );
    let attacks: Vec<String> = paths
        .iter()
        .map(|path| {
            format!("std::fs::File::open({path}).is_ok() || std::fs::read_dir({path}).is_ok() || std::fs::metadata({path}).is_ok()")
        })
        .collect();
    assert_refused(&attacks);
}

#[test]
fn nothing_is_learned_of_a_file_that_may_not_be_read() {
    // Opened as a mere path (0o10000000), which the rules for files do not cover.
    let learned = |path: &str| {
        format!(
            "{{ use std::os::unix::fs::OpenOptionsExt; std::fs::OpenOptions::new().read(true).custom_flags(0o10000000).open({path:?}).is_ok_and(|file| file.metadata().is_ok()) }}"
        )
    };
    assert_refused(&["/etc/passwd", "/root", "/tmp", "/proc/1"].map(learned));
    assert_refused(&["std::env::args().next().is_none_or(|name| name.contains('/'))".to_owned()]);
}

#[test]
fn nothing_is_written_anywhere() {
    let other = tempfile::tempdir().expect("a folder");
    let victim = other.path().join("results.json");
    fs::write(&victim, "kept").expect("written");
    let (victim_path, folder) = (quoted(&victim), quoted(other.path()));
    let attacks = [
        format!("std::fs::write({victim_path}, \"forged\").is_ok()"),
        format!("std::fs::OpenOptions::new().append(true).open({victim_path}).is_ok()"),
        format!("std::fs::remove_file({victim_path}).is_ok()"),
        format!("std::fs::rename({victim_path}, \"/tmp/elsewhere\").is_ok()"),
        format!("std::fs::hard_link({victim_path}, \"here\").is_ok()"),
        format!("std::fs::create_dir(std::path::Path::new({folder}).join(\"new\")).is_ok()"),
        format!(
            "std::os::unix::fs::symlink(\"/etc/passwd\", std::path::Path::new({folder}).join(\"link\")).is_ok()"
        ),
        format!(
            "std::fs::set_permissions({victim_path}, std::os::unix::fs::PermissionsExt::from_mode(0o777)).is_ok()"
        ),
        format!("std::os::unix::fs::chown({victim_path}, Some(1), Some(1)).is_ok()"),
        "std::fs::write(\"/tmp/lightlab-hostile\", \"x\").is_ok()".to_owned(),
        "std::fs::write(\"/dev/shm/lightlab-hostile\", \"x\").is_ok()".to_owned(),
        "std::fs::write(\"here\", \"x\").is_ok()".to_owned(),
        "std::fs::write(\"/proc/self/oom_score_adj\", \"-1000\").is_ok()".to_owned(),
        "std::env::set_current_dir(\"/tmp\").is_ok()".to_owned(),
    ];
    assert_refused(&attacks);
    if Bench::confined().is_some() {
        assert_eq!(fs::read_to_string(&victim).expect("it is there"), "kept");
        assert_eq!(fs::read_dir(other.path()).expect("it is there").count(), 1);
    }
}

#[test]
fn no_socket_is_opened() {
    let attacks = [
        "std::net::TcpListener::bind(\"127.0.0.1:0\").is_ok()",
        "std::net::TcpStream::connect(\"1.1.1.1:80\").is_ok_and(|_| true)",
        "std::net::UdpSocket::bind(\"0.0.0.0:0\").is_ok()",
        "std::os::unix::net::UnixStream::pair().is_ok()",
        "std::os::unix::net::UnixDatagram::unbound().is_ok()",
        "std::os::unix::net::UnixListener::bind(\"socket\").is_ok()",
        "std::net::ToSocketAddrs::to_socket_addrs(\"example.org:80\").is_ok()",
    ];
    assert_refused(&attacks.map(str::to_owned));
}

#[test]
fn no_process_is_started_and_none_is_replaced_by_another_program() {
    let attacks = [
        "std::process::Command::new(\"sh\").spawn().is_ok()",
        "std::process::Command::new(\"/bin/sh\").arg(\"-c\").arg(\"kill -9 $PPID\").status().is_ok()",
        "std::process::Command::new(\"/usr/bin/env\").output().is_ok()",
        // Gives an error, or does not return.
        "{ use std::os::unix::process::CommandExt; std::process::Command::new(\"/bin/sh\").exec().raw_os_error() == None }",
        "std::os::unix::process::parent_id() < 1 << 30",
    ];
    assert_refused(&attacks.map(str::to_owned));
}

#[test]
fn the_environment_is_empty_and_the_command_line_says_nothing() {
    let attacks = [
        // What the worker itself is told, the same for everybody.
        "std::env::vars_os().any(|(name, _)| name != \"MALLOC_ARENA_MAX\" && name != \"RUST_MIN_STACK\")",
        "std::env::current_exe().is_ok()",
        "std::env::current_dir().is_ok()",
        "std::env::home_dir().is_some()",
    ];
    assert_refused(&attacks.map(str::to_owned));
}
