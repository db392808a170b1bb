//! Is the handout whole, does it work, and does it give nothing away?

use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

use super::files;

/// Lines shorter than this stand in any program.
const TELLING: usize = 16;

fn workspace() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).ancestors().nth(3).expect("crates/judging/class").to_owned()
}

/// The handout on the disk, some of its stubs replaced by the slide's solution.
fn written(solved: &[&str]) -> tempfile::TempDir {
    let folder = tempfile::tempdir().expect("a folder");
    let mut all = files(course::all(), false);
    // The very versions that are on this machine.
    all.push((
        "Cargo.lock".to_owned(),
        fs::read_to_string(workspace().join("Cargo.lock")).expect("the lock file"),
    ));
    for (path, text) in all {
        let path = folder.path().join(path);
        fs::create_dir_all(path.parent().expect("a folder")).expect("a folder");
        fs::write(path, text).expect("a file");
    }
    for name in solved {
        let exercise = course::find(name).expect("the exercise");
        let solution = exercise.submission(&exercise.reference).expect("its text");
        fs::write(folder.path().join("exercises").join(exercise.path()), solution).expect("a file");
    }
    folder
}

fn cargo_test(folder: &Path, target: &Path, filter: &str) -> Output {
    Command::new(env!("CARGO"))
        .current_dir(folder)
        .args(["test", "--offline", "--quiet", "--test", "examples", filter])
        .env("CARGO_TARGET_DIR", target)
        .env_remove("RUSTFLAGS")
        .output()
        .expect("cargo starts")
}

#[test]
fn examples_are_red_on_stubs_and_green_on_solutions() {
    let target = tempfile::tempdir().expect("a folder");
    let names: Vec<&str> = course::all().iter().map(|exercise| exercise.name).collect();
    let stubs = written(&[]);
    let red = cargo_test(stubs.path(), target.path(), "");
    let said = String::from_utf8_lossy(&red.stdout).into_owned();
    let complaint = String::from_utf8_lossy(&red.stderr).into_owned();
    assert!(!red.status.success() && said.contains("test result: FAILED. 0 passed"), "{said}\n{complaint}");
    let solved = written(&names);
    let green = cargo_test(solved.path(), target.path(), "");
    assert!(green.status.success(), "{}", String::from_utf8_lossy(&green.stdout));
    // A wrong solution is no green one.
    let lambert = course::find("lambert").expect("the exercise");
    let wrong = lambert.submission(&lambert.misconceptions[0].program).expect("its text");
    fs::write(solved.path().join("exercises").join(lambert.path()), wrong).expect("a file");
    let red = cargo_test(solved.path(), target.path(), "");
    assert!(!red.status.success(), "{}", String::from_utf8_lossy(&red.stdout));
}

/// The telling lines within the body of a function of an exercise's file.
fn body<'s>(source: &'s str, function: &str) -> Vec<&'s str> {
    let from = source.find(&format!("\nfn {function}(")).expect("the function");
    let end = from + source[from..].find("\n}\n").expect("its end");
    // Parameters may stand on lines of their own: the body begins behind the answer's type.
    let begin = from + source[from..end].find("{\n").expect("its body");
    source[begin..end].lines().skip(1).map(str::trim).filter(|line| line.len() >= TELLING).collect()
}

/// Whether it is the name of an exercise or a law, which students may know.
fn is_public(name: &str) -> bool {
    course::all().iter().any(|it| it.name == name || it.laws.iter().any(|law| law.name() == name))
}

/// Whether a text has this name in it, and not only within a longer one. A name of one word may be an ordinary one; as a function it is not.
fn names(text: &str, name: &str) -> bool {
    let longer = |letter: char| letter.is_alphanumeric() || letter == '_';
    let sought = if name.contains('_') { name.to_owned() } else { format!("fn {name}") };
    text.match_indices(&sought)
        .any(|(at, _)| !text[..at].ends_with(longer) && !text[at + sought.len()..].starts_with(longer))
}

#[test]
fn no_line_of_a_solution_and_no_misconception_is_given_away() {
    let handout = files(course::all(), false);
    for exercise in course::all() {
        let right = [exercise.reference.name].into_iter().chain(exercise.variants.iter().map(|it| it.name));
        let wrong = exercise.misconceptions.iter().map(|misconception| misconception.program.name);
        for line in right.chain(wrong.clone()).flat_map(|name| body(exercise.source, name)) {
            for (path, text) in &handout {
                assert!(
                    !text.lines().any(|given| given.trim() == line),
                    "{}: {path} holds: {line}",
                    exercise.name
                );
            }
        }
        // Exercises and laws are named in the handout; one may be called like a misconception of another exercise.
        for name in wrong.filter(|name| !is_public(name)) {
            for (path, text) in &handout {
                assert!(!names(text, name), "{path} names the misconception {name} of {}", exercise.name);
            }
        }
        let told = exercise.misconceptions.iter().map(|misconception| misconception.help);
        for sentence in told.chain(exercise.laws.iter().map(course::Law::help)).chain([exercise.explanation])
        {
            assert!(
                handout.iter().all(|(_, text)| !text.contains(sentence)),
                "{}: {sentence}",
                exercise.name
            );
        }
    }
    assert!(
        !handout.iter().any(|(_, text)| text.contains("course.workspace") || text.contains("use course"))
    );
}

#[test]
fn every_exercise_has_its_stub_its_laws_and_its_examples_and_hints_if_asked_for() {
    let (without, with) = (files(course::all(), false), files(course::all(), true));
    let text = |files: &[super::File], path: &str| {
        files.iter().find(|(it, _)| it == path).unwrap_or_else(|| panic!("no {path}")).1.clone()
    };
    for exercise in course::all() {
        assert_eq!(text(&without, &format!("exercises/{}", exercise.path())), exercise.stub);
        let page = format!("tasks/{}/{}.md", exercise.concept.name(), exercise.name);
        for law in &exercise.laws {
            assert!(text(&without, &page).contains(law.name()), "{page} lacks {}", law.name());
        }
        for hint in exercise.hints {
            assert!(
                !text(&without, &page).contains(hint) && text(&with, &page).contains(hint),
                "{page}: {hint}"
            );
        }
        let tests = text(&without, &format!("exercises/tests/examples/{}.rs", exercise.name));
        let decided = exercise.examples.iter().filter(|example| example.tolerance.is_some()).count();
        assert_eq!(tests.matches("#[test]").count(), decided, "{}", exercise.name);
    }
}

#[test]
fn what_was_copied_is_all_there_is_and_of_the_same_version() {
    let handout = files(course::all(), false);
    for entry in fs::read_dir(workspace().join("crates/judging/vocabulary/src")).expect("the vocabulary") {
        let path = format!("vocabulary/src/{}", entry.expect("an entry").file_name().to_string_lossy());
        assert!(handout.iter().any(|(it, _)| *it == path), "{path} is missing");
    }
    let ours = fs::read_to_string(workspace().join("Cargo.toml")).expect("our manifest");
    let version =
        ours.lines().find(|line| line.starts_with("glam = ")).and_then(|line| line.split('"').nth(1));
    let given = format!("glam = \"{}\"", version.expect("glam's version"));
    assert!(handout.iter().any(|(path, text)| path == "Cargo.toml" && text.contains(&given)), "{given}");
}
