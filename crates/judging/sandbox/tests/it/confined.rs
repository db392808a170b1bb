//! Does a program that was launched have only what it was granted, and does nothing of it survive its end?
#![cfg(target_os = "linux")]

use std::fs;
use std::io::Read;
use std::path::Path;
use std::process::{Child, Command, Stdio};
use std::time::{Duration, Instant};

use sandbox::{Calls, Confinement, Launcher, NOT_LAUNCHED, ResourceLimits};

const LAUNCHER: &str = env!("CARGO_BIN_EXE_sandbox-launcher");

/// Confines, if this system can; if not, says so loudly.
fn launcher() -> Option<Launcher> {
    let launcher = Launcher::at(Path::new(LAUNCHER))?;
    let status = launcher.command(&shell(Calls::Any), Path::new("/bin/true")).status().expect("it starts");
    if status.success() {
        return Some(launcher);
    }
    eprintln!("SKIPPED, NOTHING IS CONFINED HERE: {status}");
    None
}

/// What a shell and the programs that it starts need.
fn shell(calls: Calls) -> Confinement {
    let limits = ResourceLimits { open: 256, ..ResourceLimits::default() };
    let null = vec!["/dev/null".into()];
    Confinement {
        executable: sandbox::programs(),
        readable: null.clone(),
        writable: null,
        ..Confinement::new(calls, limits)
    }
}

/// What a shell prints, and whether it succeeds.
fn says(launcher: &Launcher, confinement: &Confinement, script: &str) -> (String, bool) {
    let output = launcher
        .command(confinement, Path::new("/bin/sh"))
        .args(["-c", script])
        .output()
        .expect("the launcher starts");
    (String::from_utf8_lossy(&output.stdout).into_owned(), output.status.success())
}

#[test]
fn arguments_environment_and_exit_code_pass_through() {
    let Some(launcher) = launcher() else { return };
    let mut command = launcher.command(&shell(Calls::Building), Path::new("/bin/sh"));
    command.args(["-c", "echo \"$1 $WORD\"; exit 7", "sh", "--launch-confined"]).env("WORD", "word");
    let output = command.output().expect("the launcher starts");
    assert_eq!(String::from_utf8_lossy(&output.stdout), "--launch-confined word\n");
    assert_eq!(output.status.code(), Some(7));
}

#[test]
fn a_launcher_that_cannot_confine_itself_starts_nothing() {
    let commands = [
        // Nobody waits for it: its starter is somebody else.
        ["1", "any", "1000000000", "1", "0", "64", "64", "--", "/bin/echo", "started"].to_vec(),
        // The line is torn.
        ["1", "any", "--", "/bin/echo", "started"].to_vec(),
        ["nobody"].to_vec(),
    ];
    for arguments in commands {
        let output =
            Command::new(LAUNCHER).arg("--launch-confined").args(&arguments).output().expect("it starts");
        assert_eq!(output.status.code(), Some(i32::from(NOT_LAUNCHED)), "{arguments:?}");
        assert!(output.stdout.is_empty() && output.stderr.starts_with(b"not launched: "), "{output:?}");
    }
}

#[test]
fn a_program_that_is_not_there_or_not_granted_is_not_launched() {
    let Some(launcher) = launcher() else { return };
    for program in ["/bin/there-is-none", LAUNCHER] {
        let output = launcher.command(&shell(Calls::Any), Path::new(program)).output().expect("it starts");
        assert_eq!(output.status.code(), Some(i32::from(NOT_LAUNCHED)), "{program}");
        assert!(String::from_utf8_lossy(&output.stderr).contains(program), "{output:?}");
    }
}

#[test]
fn an_inherited_descriptor_does_not_reach_the_program() {
    let Some(launcher) = launcher() else { return };
    let leak = |command: &Command| {
        let output = Command::new("/bin/sh")
            .args(["-c", "exec 9</etc/passwd; exec \"$@\"", "sh"])
            .arg(command.get_program())
            .args(command.get_args())
            .args(["-c", "cat <&9"])
            .output()
            .expect("a shell");
        String::from_utf8_lossy(&output.stdout).into_owned()
    };
    assert!(leak(&Command::new("/bin/sh")).contains("root"), "it leaks where nothing is confined");
    assert_eq!(leak(&launcher.command(&shell(Calls::Any), Path::new("/bin/sh"))), "");
}

#[test]
fn files_are_those_granted_each_as_it_was_granted() {
    let Some(launcher) = launcher() else { return };
    let folder = tempfile::tempdir().expect("a folder");
    let path = |name: &str| folder.path().join(name);
    for name in ["readable", "writable", "listable", "other"] {
        fs::create_dir(path(name)).expect("a folder");
        fs::write(path(name).join("file"), name).expect("a file");
    }
    let confinement = Confinement {
        readable: vec![path("readable")],
        listable: vec![path("listable")],
        writable: vec![path("writable"), "/dev/null".into()],
        ..shell(Calls::Building)
    };
    let confinement =
        Confinement { limits: ResourceLimits { file: 1 << 20, ..confinement.limits }, ..confinement };
    let says =
        |script: &str| says(&launcher, &confinement, &format!("cd {}; {script}", folder.path().display()));
    assert_eq!(says("cat readable/file"), ("readable".to_owned(), true));
    assert_eq!(says("cat writable/file"), ("writable".to_owned(), true));
    assert_eq!(says("ls listable"), ("file\n".to_owned(), true));
    for refused in [
        "cat listable/file",
        "cat other/file",
        "ls other",
        "ls .",
        "echo x >readable/file",
        "rm readable/file",
        "mv other/file writable/",
        "ln other/file writable/stolen",
        "cp /bin/true writable/true && writable/true",
        "cat /etc/passwd",
        "cat /proc/self/environ",
    ] {
        let (said, succeeded) = says(refused);
        assert!(said.is_empty() && !succeeded, "{refused}: {said}");
    }
    assert!(says("echo new >writable/new && mv writable/new writable/newer && rm writable/newer").1);
}

#[test]
fn a_program_that_builds_starts_others_but_reaches_nobody() {
    let Some(launcher) = launcher() else { return };
    let says = |script: &str| says(&launcher, &shell(Calls::Building), script);
    assert_eq!(says("echo one | cat"), ("one\n".to_owned(), true));
    let pid = std::process::id();
    for refused in [
        format!("kill -0 {pid}"),
        "setsid true".to_owned(),
        "unshare -U true".to_owned(),
        "ulimit -v unlimited".to_owned(),
        "ulimit -n 1000".to_owned(),
    ] {
        assert!(!says(&refused).1, "{refused}");
    }
}

#[test]
fn a_program_that_computes_starts_no_other() {
    let Some(launcher) = launcher() else { return };
    assert!(!says(&launcher, &shell(Calls::Computing), "echo one | cat").1);
}

#[test]
fn a_program_that_computes_does_not_learn_where_it_lies() {
    let Some(launcher) = launcher() else { return };
    assert_eq!(says(&launcher, &shell(Calls::Computing), "echo $0").0, "sh\n");
}

#[test]
fn what_a_program_started_ends_with_it() {
    let Some(launcher) = launcher() else { return };
    let start = |script: &str| {
        let mut command = launcher.command(&shell(Calls::Building), Path::new("/bin/sh"));
        let mut child = command.args(["-c", script]).stdout(Stdio::piped()).spawn().expect("it starts");
        let started = number_from(&mut child);
        assert!(Path::new(&format!("/proc/{started}")).exists());
        (child, started)
    };
    let (mut child, started) = start("sleep 100 >/dev/null 2>&1 & echo $!; wait");
    sandbox::end(&mut child).expect("it ends");
    assert_gone(started);
    let (mut child, started) = start("sleep 100 >&2 & echo $!");
    assert!(sandbox::finish(&mut child).expect("it ends").success());
    assert_gone(started);
}

#[test]
fn a_program_ends_with_the_one_that_started_it() {
    let Some(launcher) = launcher() else { return };
    let command = launcher.command(&shell(Calls::Any), Path::new("/bin/sleep"));
    // The shell takes the place of these tests as the starter.
    let arguments = command.get_args().skip(2);
    let mut starter = Command::new("/bin/sh")
        .args([
            "-c",
            "launcher=$1; shift; \"$launcher\" --launch-confined $$ \"$@\" 100 >&2 & echo $!; wait",
            "sh",
            LAUNCHER,
        ])
        .args(arguments)
        .stdout(Stdio::piped())
        .spawn()
        .expect("a shell");
    let started = number_from(&mut starter);
    let name = || fs::read_to_string(format!("/proc/{started}/comm")).expect("it is there");
    while name() != "sleep\n" {
        std::thread::sleep(Duration::from_millis(1));
    }
    starter.kill().expect("it is killed");
    starter.wait().expect("it ends");
    assert_gone(started);
}

/// The number that a child prints first.
fn number_from(child: &mut Child) -> u32 {
    let mut line = Vec::new();
    let mut output = child.stdout.take().expect("its output");
    let mut byte = [0];
    while output.read(&mut byte).expect("a byte") == 1 && byte != *b"\n" {
        line.extend(byte);
    }
    String::from_utf8_lossy(&line).parse().expect("a number")
}

/// Asserts that a process is no more, or only waits for somebody to ask for its exit code.
fn assert_gone(pid: u32) {
    let patience = Instant::now() + Duration::from_secs(20);
    loop {
        let status = fs::read_to_string(format!("/proc/{pid}/status")).unwrap_or_default();
        if status.is_empty() || status.contains("State:\tZ") || status.contains("State:\tX") {
            return;
        }
        assert!(Instant::now() < patience, "{status}");
        std::thread::sleep(Duration::from_millis(5));
    }
}
