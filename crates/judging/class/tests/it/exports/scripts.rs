//! Do the exported scripts do what the platforms wait for? They run here, in a tree like the platform's.

use std::fs;
use std::process::{Command, Output};

use class::export::{File, codegrade, gradescope};
use serde_json::Value;
use tempfile::TempDir;

use crate::exports::place::Place;
use crate::exports::{GUARDED, SOURCES, file, project, put, unpacked};

fn gradescopes() -> Place {
    let files = gradescope(project().path(), GUARDED).expect("an export");
    // As the platform unpacks it.
    let inside: Vec<File> = files
        .into_iter()
        .filter_map(|it| {
            Some(File { path: format!("source/{}", it.path.strip_prefix("autograder/")?), ..it })
        })
        .collect();
    let place = Place::new(&inside, "autograder");
    put(&place.path("autograder/submission/lambert.rs"), "");
    put(&place.path("autograder/submission_metadata.json"), "{}");
    place
}

fn run_autograder(place: &Place, gives: &str, exit: &str) -> Output {
    let root = place.path("autograder");
    let root = root.to_str().expect("UTF-8");
    place.run(
        "\"$AUTOGRADER\"/source/run_autograder",
        &[("AUTOGRADER", root), ("GIVES", gives), ("EXTENSION", "json"), ("EXIT", exit)],
    )
}

#[test]
fn gradescopes_setup_builds_the_grader() {
    let place = gradescopes();
    let root = place.path("autograder");
    let output =
        place.run("\"$AUTOGRADER\"/source/setup.sh", &[("AUTOGRADER", root.to_str().expect("UTF-8"))]);
    assert!(output.status.success(), "{output:?}");
    let calls = place.read("calls");
    assert!(calls.contains("source/lightlab: lab grade --help"), "{calls}");
}

#[test]
fn gradescopes_run_grades_the_submission_and_leaves_the_result() {
    let place = gradescopes();
    let output = run_autograder(&place, "{\"score\":3}", "0");
    assert!(output.status.success(), "{output:?}");
    assert_eq!(place.read("autograder/results/results.json"), "{\"score\":3}");
    let root = place.path("autograder").display().to_string();
    assert_eq!(
        place.read("calls"),
        format!(
            "{root}/source/lightlab: lab grade {root}/submission --single --out {root}/report/graded --format gradescope\n"
        )
    );
    assert_eq!(place.read("autograder/report/submission_metadata.json"), "{}");
    assert!(place.read("environment").contains("CARGO_NET_OFFLINE=true"));
    // Again, over what the first run left.
    assert!(run_autograder(&place, "{\"score\":4}", "1").status.success());
    assert_eq!(place.read("autograder/results/results.json"), "{\"score\":4}");
}

#[test]
fn gradescope_gets_a_valid_result_if_the_grader_fails() {
    for gives in ["nothing", "twice"] {
        let place = gradescopes();
        let output = run_autograder(&place, gives, "0");
        assert!(output.status.success(), "{output:?}");
        let result: Value =
            serde_json::from_str(&place.read("autograder/results/results.json")).expect("JSON");
        assert_eq!(result["score"], 0);
        assert!(
            result["output"]
                .as_str()
                .is_some_and(|it| it.contains("The grader itself failed, not your submission"))
        );
        assert_eq!(result["stdout_visibility"], "hidden");
    }
}

fn codegrades() -> Place {
    let files = codegrade(project().path(), GUARDED).expect("an export");
    let place = Place::new(&files, "fixtures");
    fs::create_dir_all(place.path("home/lightlab")).expect("a folder");
    fs::create_dir_all(place.path("student")).expect("a folder");
    place
}

#[test]
fn codegrades_setup_unpacks_the_project_and_builds_the_grader() {
    let place = codegrades();
    // Nothing else is pretended, so that what is in the archive is really there.
    place.pretend("unzip", "mkdir -p \"$4\" && echo \"$2\" >\"$4/unpacked\"");
    let output = place.run("fixtures/cg-setup", &[]);
    assert!(output.status.success(), "{output:?}");
    assert!(place.read("home/lightlab/unpacked").contains("fixtures/lightlab.zip"));
    assert!(place.read("calls").contains("home/lightlab: lab grade --help"));
    let files = codegrade(project().path(), GUARDED).expect("an export");
    let entries = unpacked(&file(&files, "lightlab.zip").bytes);
    assert_eq!(entries.iter().map(|(path, ..)| path.as_str()).collect::<Vec<_>>(), SOURCES);
}

#[test]
fn codegrade_v1_gets_its_file_and_nobody_else_knows_where() {
    let place = codegrades();
    let (xml, student) = (place.path("place.xml"), place.path("student"));
    let variables = [
        ("CG_JUNIT_XML_LOCATION", xml.to_str().expect("UTF-8")),
        ("STUDENT", student.to_str().expect("UTF-8")),
        ("GIVES", "<testsuites/>"),
        ("EXTENSION", "xml"),
    ];
    let output = place.run("fixtures/cg-run-v1", &variables);
    assert!(output.status.success(), "{output:?}");
    assert_eq!(place.read("place.xml"), "<testsuites/>");
    let environment = place.read("environment");
    assert!(!environment.contains("CG_JUNIT") && !environment.contains("place.xml"), "{environment}");
    let call = place.read("calls");
    assert!(call.contains(&format!("lab grade {} --single --out ", student.display())), "{call}");
    assert!(call.contains(" --format codegrade-v1"), "{call}");
}

#[test]
fn codegrade_v2_gets_its_messages_when_the_students_code_is_over() {
    let place = codegrades();
    let messages = "{\"tag\":\"points\",\"points\":\"3/5\"}\n";
    let output = place.run(
        "cd student && ../fixtures/cg-run-v2 3>../messages",
        &[("GIVES", messages), ("EXTENSION", "jsonl")],
    );
    assert!(output.status.success(), "{output:?}");
    assert_eq!(place.read("messages"), messages);
    assert!(!place.path("descriptor-3").exists(), "the grader could write to descriptor 3");
    assert!(place.read("calls").contains("/student --single --out "));
}

#[test]
fn codegrades_step_fails_if_the_grader_does() {
    for gives in ["nothing", "twice"] {
        let place = codegrades();
        let xml = place.path("place.xml");
        let variables =
            [("CG_JUNIT_XML_LOCATION", xml.to_str().expect("UTF-8")), ("GIVES", gives), ("EXTENSION", "xml")];
        for command in ["fixtures/cg-run-v1", "EXTENSION=jsonl fixtures/cg-run-v2 3>messages"] {
            let output = place.run(command, &variables);
            assert!(!output.status.success(), "{command}");
            assert!(
                String::from_utf8_lossy(&output.stderr)
                    .contains("The grader itself failed, not your submission")
            );
        }
        assert!(!xml.exists() && place.read("messages").is_empty());
    }
}

#[test]
fn scripts_are_clean_where_shellcheck_is_installed() {
    if Command::new("shellcheck").arg("--version").output().is_err() {
        return;
    }
    let project = project();
    for export in [gradescope, codegrade] {
        for script in export(project.path(), GUARDED).expect("an export").iter().filter(|it| it.executable) {
            let folder = TempDir::new().expect("a folder");
            let path = folder.path().join("script");
            fs::write(&path, &script.bytes).expect("a file");
            let output =
                Command::new("shellcheck").args(["--shell", "bash"]).arg(&path).output().expect("shellcheck");
            assert!(output.status.success(), "{}: {}", script.path, String::from_utf8_lossy(&output.stdout));
            assert!(
                String::from_utf8_lossy(&script.bytes).contains("\nset -euo pipefail\n"),
                "{}",
                script.path
            );
        }
    }
}
