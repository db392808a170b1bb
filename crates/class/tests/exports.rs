//! Does an exported autograder do what its platform waits for? Its scripts run here, in a tree like the platform's, with a `cargo` that only
//! pretends.

#![cfg(unix)]

use std::collections::BTreeMap;
use std::fs;
use std::io::{Cursor, Read};
use std::os::unix::fs::PermissionsExt;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

use class::export::{File, Options, SourcesError, codegrade, github_classroom, gradescope, write};
use serde_json::Value;
use tempfile::TempDir;

/// A project in small.
fn project() -> TempDir {
    let folder = TempDir::new().expect("a folder");
    for (path, text) in [
        ("Cargo.toml", "[workspace.package]\nrust-version = \"1.88\"\n"),
        ("Cargo.lock", ""),
        (".cargo/config.toml", "[alias]\n"),
        ("crates/lab/src/main.rs", "fn main() {}\n"),
        ("crates/lab/target/debug/lab", "built"),
        ("crates/course/proptest-regressions/a.txt", "cc"),
        ("exercises/lib.rs", ""),
        ("exercises/lighting/lambert.rs.bak", "mine"),
        ("exercises/.lightlab/memory", "mine"),
        ("tests/Cargo.toml", ""),
        ("LICENSE-APACHE", "A"),
        ("LICENSE-MIT", "M"),
        ("target/release/lab", "built"),
        ("private-notes.txt", "mine"),
    ] {
        put(&folder.path().join(path), text);
    }
    folder
}

fn put(path: &Path, text: &str) {
    fs::create_dir_all(path.parent().expect("a parent")).expect("a folder");
    fs::write(path, text).expect("a file");
}

const SOURCES: [&str; 8] = [
    ".cargo/config.toml",
    "Cargo.lock",
    "Cargo.toml",
    "LICENSE-APACHE",
    "LICENSE-MIT",
    "crates/lab/src/main.rs",
    "exercises/lib.rs",
    "tests/Cargo.toml",
];

/// What is in an archive: paths in their order, with permissions and text.
fn unpacked(bytes: &[u8]) -> Vec<(String, u32, String)> {
    let mut archive = zip::ZipArchive::new(Cursor::new(bytes)).expect("a zip");
    (0..archive.len())
        .map(|at| {
            let mut entry = archive.by_index(at).expect("an entry");
            assert_eq!(
                entry.last_modified(),
                Some(zip::DateTime::DEFAULT),
                "a date would differ from export to export"
            );
            let mut text = String::new();
            entry.read_to_string(&mut text).expect("text");
            (entry.name().expect("UTF-8").into_owned(), entry.unix_mode().expect("permissions") & 0o777, text)
        })
        .collect()
}

fn file<'a>(files: &'a [File], path: &str) -> &'a File {
    files.iter().find(|it| it.path == path).unwrap_or_else(|| panic!("no {path}"))
}

const GUARDED: Options = Options { unsafe_no_sandbox: false };

#[test]
fn gradescopes_zip_has_its_two_scripts_at_the_root_and_the_sources_alone() {
    let files = gradescope(project().path(), GUARDED).expect("an export");
    let entries = unpacked(&file(&files, "autograder.zip").bytes);
    let paths: Vec<&str> = entries.iter().map(|(path, ..)| path.as_str()).collect();
    let mut wanted: Vec<String> = SOURCES.iter().map(|path| format!("lightlab/{path}")).collect();
    wanted.extend(["run_autograder".to_owned(), "setup.sh".to_owned()]);
    assert_eq!(paths, wanted);
    for (path, mode, text) in &entries {
        let is_script = text.starts_with("#!");
        assert_eq!(*mode, if is_script { 0o755 } else { 0o644 }, "{path}");
        // The same lies beside the zip, to be read.
        let beside = file(&files, &format!("autograder/{path}"));
        assert_eq!((beside.bytes.as_slice(), beside.executable), (text.as_bytes(), is_script));
    }
}

#[test]
fn the_same_project_gives_the_same_export() {
    let (one, other) = (project(), project());
    for export in [gradescope, github_classroom, codegrade] {
        assert_eq!(
            export(one.path(), GUARDED).expect("one"),
            export(other.path(), GUARDED).expect("the other")
        );
    }
}

#[test]
fn the_sandbox_is_left_out_only_if_that_was_asked_for() {
    let project = project();
    for export in [gradescope, github_classroom, codegrade] {
        let text = |options| -> String {
            let files = export(project.path(), options).expect("an export");
            let scripts = files.iter().filter(|it| !it.path.ends_with(".zip") && !it.path.contains("README"));
            scripts.map(|it| String::from_utf8_lossy(&it.bytes).into_owned()).collect()
        };
        assert!(!text(GUARDED).contains("unsafe-no-sandbox"));
        assert!(text(Options { unsafe_no_sandbox: true }).contains(" --unsafe-no-sandbox "));
    }
}

#[test]
fn every_export_explains_itself_and_leaves_no_gap() {
    let project = project();
    for export in [gradescope, github_classroom, codegrade] {
        let files = export(project.path(), GUARDED).expect("an export");
        let readme = String::from_utf8_lossy(&file(&files, "README.md").bytes).into_owned();
        assert!(readme.contains("## The sandbox") && readme.contains("`--unsafe-no-sandbox`"));
        for it in files.iter().filter(|it| !it.path.ends_with(".zip")) {
            let text = String::from_utf8_lossy(&it.bytes);
            assert!(
                !["@FLAGS@", "@TOOLCHAIN@", "@SANDBOX@", "\r"].iter().any(|gap| text.contains(gap)),
                "{}",
                it.path
            );
        }
    }
}

#[test]
fn what_cannot_be_exported_is_named() {
    let linked = project();
    std::os::unix::fs::symlink("/etc/passwd", linked.path().join("crates/passwd")).expect("a link");
    let error = gradescope(linked.path(), GUARDED).expect_err("a link leads out");
    assert!(matches!(&error, SourcesError::Strange(path) if path.ends_with("crates/passwd")), "{error}");
    let empty = TempDir::new().expect("a folder");
    let error = codegrade(empty.path(), GUARDED).expect_err("there is no project").to_string();
    assert!(error.contains("Cargo.toml"), "{error}");
    let versionless = project();
    put(&versionless.path().join("Cargo.toml"), "rust-version = \"1.88; rm -rf /\"\n");
    assert!(matches!(github_classroom(versionless.path(), GUARDED), Err(SourcesError::NoVersion(_))));
}

/// A place like the platform's: the export written out, and programs that only pretend.
struct Place {
    folder: TempDir,
}

impl Place {
    fn new(files: &[File], under: &str) -> Self {
        let folder = TempDir::new().expect("a folder");
        write(files, &folder.path().join(under)).expect("the export is written");
        let place = Self { folder };
        for program in ["apt-get", "curl", "sudo", "rustup"] {
            place.pretend(program, "cat >/dev/null </dev/null; exit 0");
        }
        place.pretend("cargo", CARGO);
        place
    }

    fn path(&self, path: &str) -> PathBuf {
        self.folder.path().join(path)
    }

    fn pretend(&self, program: &str, script: &str) {
        let path = self.path("bin").join(program);
        put(&path, &format!("#!/bin/sh\n{script}\n"));
        fs::set_permissions(&path, fs::Permissions::from_mode(0o755)).expect("permissions");
    }

    fn run(&self, command: &str, variables: &[(&str, &str)]) -> Output {
        let path = format!("{}:/usr/bin:/bin", self.path("bin").display());
        let mut bash = Command::new("bash");
        bash.args(["-c", command]).current_dir(self.folder.path()).env_clear().env("PATH", path);
        bash.env("HOME", self.path("home")).env("PLACE", self.folder.path());
        bash.envs(variables.iter().copied()).output().expect("bash")
    }

    fn read(&self, path: &str) -> String {
        fs::read_to_string(self.path(path)).unwrap_or_else(|e| panic!("{path}: {e}"))
    }
}

/// Writes down how it was called, with its environment, and what it can write to; then gives what $GIVES says.
const CARGO: &str = r#"
echo "$PWD: $*" >>"$PLACE/calls"
env >"$PLACE/environment"
if (echo forged >&3) 2>/dev/null; then echo open >"$PLACE/descriptor-3"; fi
case "$*" in
  *--help*|fetch*) exit 0 ;;
esac
out=; format=
while [ $# -gt 0 ]; do
  case "$1" in
    --out) out=$2 ;;
    --format) format=$2 ;;
  esac
  shift
done
[ "$GIVES" = nothing ] && exit 101
mkdir -p "$out/$format"
printf '%s' "$GIVES" >"$out/$format/submission.$EXTENSION"
[ "$GIVES" = twice ] && printf 'forged' >"$out/$format/other.$EXTENSION"
exit "${EXIT:-0}"
"#;

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

/// The workflow's steps with their names: each begins with "      - ".
fn steps(workflow: &str) -> BTreeMap<String, String> {
    let steps = workflow.split("\n      - ").skip(1);
    steps
        .filter_map(|step| Some((step.lines().next()?.strip_prefix("name: ")?.to_owned(), step.to_owned())))
        .collect()
}

#[test]
fn the_workflow_has_the_names_that_github_classroom_looks_for() {
    let files = github_classroom(project().path(), GUARDED).expect("an export");
    let workflow =
        String::from_utf8(file(&files, ".github/workflows/classroom.yml").bytes.clone()).expect("UTF-8");
    assert!(workflow.contains("\nname: Autograding Tests\n"));
    let jobs = workflow.split_once("\njobs:\n").expect("jobs").1;
    let names: Vec<&str> =
        jobs.lines().filter(|line| line.starts_with("  ") && !line.starts_with("   ")).collect();
    assert_eq!(names, ["  run-autograding-tests:"]);
    let steps = steps(&workflow);
    assert!(steps["Grade"].contains("id: lightlab\n"));
    assert!(steps["Report"].contains("LIGHTLAB_RESULTS: ${{ steps.lightlab.outputs.result }}"));
    assert!(steps["Report"].contains("runners: lightlab"));
    assert!(!workflow.contains('\t'));
}

#[test]
fn the_workflows_step_sets_the_result_and_hides_where_it_goes() {
    let files = github_classroom(project().path(), GUARDED).expect("an export");
    let workflow =
        String::from_utf8(file(&files, ".github/workflows/classroom.yml").bytes.clone()).expect("UTF-8");
    let step = steps(&workflow)["Grade"].clone();
    let script: Vec<&str> = step
        .split_once("run: |\n")
        .expect("a script")
        .1
        .lines()
        .map_while(|line| line.strip_prefix("          "))
        .collect();
    let place = Place::new(&[], "empty");
    let (output, temporary) = (place.path("output"), place.path("temporary"));
    put(&output, "");
    let ran = place.run(
        &script.join("\n"),
        &[
            ("GITHUB_WORKSPACE", "/w"),
            ("GITHUB_OUTPUT", output.to_str().expect("UTF-8")),
            ("GITHUB_ENV", "/env"),
            ("RUNNER_TEMP", temporary.to_str().expect("UTF-8")),
            ("GIVES", "eyJ9"),
            ("EXTENSION", "txt"),
        ],
    );
    assert!(ran.status.success(), "{ran:?}");
    assert_eq!(place.read("output"), "result=eyJ9\n");
    let environment = place.read("environment");
    assert!(!environment.contains("GITHUB_OUTPUT") && !environment.contains("GITHUB_ENV"), "{environment}");
    assert!(place.read("calls").contains("lab grade /w/submission --single --out "));
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
