//! Does any program remember where it was built? A checkout that is copied or renamed brings its programs along.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

use crate::desk::{LAB, Said, root};

const NAME: &str = "rotate_about_point";

/// Makes a checkout with the program in it and all that the commands below need of the rest.
fn check_out(place: &Path) {
    for folder in ["exercises", "crates/judging/worker", "target/debug"] {
        fs::create_dir_all(place.join(folder)).expect("made");
    }
    fs::write(place.join("exercises/Cargo.toml"), "").expect("written");
    fs::write(place.join("crates/judging/worker/Cargo.toml"), "").expect("written");
    fs::copy(LAB, program(place)).expect("copied");
    in_checkout(place, &["reset", NAME]);
}

/// The program that was built in a checkout.
fn program(place: &Path) -> PathBuf {
    place.join(format!("target/debug/lab{}", std::env::consts::EXE_SUFFIX))
}

/// Runs the program of a checkout in that checkout, as cargo does not start it.
fn in_checkout(place: &Path, words: &[&str]) -> Said {
    let mut command = Command::new(program(place));
    command.args(words).current_dir(place).stdin(Stdio::null());
    for name in ["CARGO_MANIFEST_DIR", "LIGHTLAB_EXERCISES"] {
        command.env_remove(name);
    }
    Said::from(command.output().expect("it runs")).done()
}

#[test]
fn a_checkout_that_was_copied_or_renamed_works_on_its_own_files() {
    let exercise = course::find(NAME).expect("an exercise");
    let desk = tempfile::tempdir().expect("a folder");
    let place = |name: &str| desk.path().join(name);
    let [built, copied, renamed] = ["built", "copied", "renamed here"].map(place);
    check_out(&built);
    check_out(&copied);
    fs::rename(&built, &renamed).expect("renamed");
    for place in [&copied, &renamed] {
        let file = place.join("exercises").join(exercise.path());
        fs::write(&file, "// something else\n").expect("written");
        in_checkout(place, &["reset", NAME]);
        assert_eq!(fs::read_to_string(&file).expect("there"), exercise.stub, "{}", place.display());
        in_checkout(place, &["render", "cycle", "--size", "8x8", "-o", "picture.png"]);
        assert!(place.join("picture.png").is_file());
    }
    assert!(!built.exists(), "something was written where the checkout no longer is");
}

/// Sources of programs: not of tests, which are built where they run.
fn sources(folder: &Path, found: &mut Vec<PathBuf>) {
    for entry in fs::read_dir(folder).expect("a folder") {
        let path = entry.expect("an entry").path();
        if path.is_dir() {
            sources(&path, found);
        } else if path.extension().is_some_and(|kind| kind == "rs") && !path.ends_with("tests.rs") {
            found.push(path);
        }
    }
}

#[test]
fn no_program_asks_at_build_time_where_it_lies() {
    let mut found = Vec::new();
    let crates = root().join("crates");
    sources(&crates, &mut found);
    // Not those of tests, benches and examples.
    found.retain(|path| path.strip_prefix(&crates).is_ok_and(|path| path.iter().any(|part| part == "src")));
    assert!(found.len() > 100, "only {} files", found.len());
    for path in found {
        let text = fs::read_to_string(&path).expect("read");
        let program = text.split("#[cfg(test)]\nmod tests {").next().unwrap_or_default();
        for baked in
            ["CARGO_MANIFEST_DIR", "CARGO_MANIFEST_PATH", "CARGO_BIN_EXE_", "CARGO_TARGET_TMPDIR", "OUT_DIR"]
        {
            let asked = format!("env!(\"{baked}");
            assert!(
                !program.contains(&asked),
                "{}: {asked}…; ask with std::env when it runs",
                path.display()
            );
        }
    }
}
