#![cfg(unix)]

use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

/// What a project is known by, and a program in it: these tests themselves, since the program under test has nothing to look for elsewhere.
fn checkout(root: &Path) -> PathBuf {
    for folder in ["exercises", "crates/judging/worker", "target/debug"] {
        fs::create_dir_all(root.join(folder)).unwrap();
    }
    fs::write(root.join("exercises/Cargo.toml"), "").unwrap();
    let program = root.join("target/debug/lab");
    let tests = std::env::current_exe().unwrap();
    // A link is at once there, where the file system has it.
    fs::hard_link(&tests, &program).or_else(|_| fs::copy(&tests, &program).map(drop)).unwrap();
    program
}

/// Stands for cargo, and prints what it is asked.
const CARGO: &str = "/bin/echo";

/// Runs the program in a folder, as somebody does who asks for a command that it does not have; gives what it said.
fn asked(program: &Path, here: &Path, package: Option<&Path>) -> String {
    let mut command = Command::new(program);
    command.args(["--exact", "elsewhere::tests::asks_cargo_for_pictures", "--ignored", "--nocapture"]);
    command.current_dir(here).env("CARGO", CARGO).env_remove("CARGO_MANIFEST_DIR");
    package.map(|package| command.env("CARGO_MANIFEST_DIR", package));
    let output = command.output().unwrap();
    format!("{}{}", String::from_utf8_lossy(&output.stdout), String::from_utf8_lossy(&output.stderr))
}

#[test]
#[ignore = "becomes cargo; the test below starts it"]
fn asks_cargo_for_pictures() {
    if std::env::var_os("CARGO").is_none_or(|cargo| cargo != CARGO) {
        return;
    }
    panic!("{:?}", super::run("pictures", "release"));
}

#[test]
fn a_copied_or_renamed_checkout_builds_its_own_program() {
    let place = tempfile::tempdir().unwrap();
    let place = fs::canonicalize(place.path()).unwrap();
    checkout(&place.join("first"));
    let copied = checkout(&place.join("copied"));
    fs::rename(place.join("first"), place.join("renamed")).unwrap();
    let renamed = place.join("renamed/target/debug/lab");
    let (in_renamed, in_copied) = (place.join("renamed"), place.join("copied"));
    let started = |root: &Path| {
        format!(
            "run --quiet --profile release --package lab --no-default-features --features pictures --manifest-path {}/Cargo.toml --",
            root.display()
        )
    };
    // Within the checkout, whichever program it is; elsewhere, by what cargo says of the program or where it lies.
    for (program, here, package, root) in [
        (&copied, in_copied.join("crates/judging/worker"), None, &in_copied),
        (&renamed, in_renamed.clone(), None, &in_renamed),
        (&renamed, in_copied.clone(), Some(in_renamed.join("crates/judging/worker")), &in_copied),
        (&renamed, place.clone(), Some(in_copied.join("crates/judging/worker")), &in_copied),
        (&renamed, place.clone(), Some(place.join("elsewhere")), &in_renamed),
        (&copied, place.clone(), None, &in_copied),
    ] {
        let said = asked(program, &here, package.as_deref());
        assert!(said.contains(&started(root)), "{} in {}: {said}", program.display(), here.display());
    }
}

#[test]
fn a_program_that_has_left_its_project_says_so() {
    let place = tempfile::tempdir().unwrap();
    let program = checkout(&place.path().join("project"));
    let alone = place.path().join("lab");
    fs::rename(program, &alone).unwrap();
    let said = asked(&alone, place.path(), None);
    assert!(said.contains("the project that this program was built in is not found"), "{said}");
}
