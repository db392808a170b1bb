//! Does an exported autograder hold what its platform waits for, and nothing else?

#![cfg(unix)]

mod place;
mod scripts;
mod workflow;

use std::fs;
use std::io::{Cursor, Read};
use std::path::Path;
use std::process::Command;

use class::export::{File, Options, SourcesError, codegrade, github_classroom, gradescope};
use serde_json::Value;
use tempfile::TempDir;

/// A project in small.
fn project() -> TempDir {
    let folder = TempDir::new().expect("a folder");
    for (path, text) in [
        ("Cargo.toml", "[workspace.package]\nrust-version = \"1.88\"\n"),
        ("Cargo.lock", ""),
        (".cargo/config.toml", "[alias]\n"),
        ("crates/programs/lab/src/main.rs", "fn main() {}\n"),
        ("crates/programs/lab/target/debug/lab", "built"),
        ("crates/judging/course/proptest-regressions/a.txt", "cc"),
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
    "crates/programs/lab/src/main.rs",
    "exercises/lib.rs",
    "tests/Cargo.toml",
];

/// What is in an archive: paths in their order, with permissions and text.
fn unpacked(bytes: &[u8]) -> Vec<(String, u32, String)> {
    let text = |bytes| String::from_utf8(bytes).expect("text");
    entries(bytes).into_iter().map(|(path, mode, bytes)| (path, mode, text(bytes))).collect()
}

/// The same with bytes.
fn entries(bytes: &[u8]) -> Vec<(String, u32, Vec<u8>)> {
    let mut archive = zip::ZipArchive::new(Cursor::new(bytes)).expect("a zip");
    (0..archive.len())
        .map(|at| {
            let mut entry = archive.by_index(at).expect("an entry");
            assert_eq!(
                entry.last_modified(),
                Some(zip::DateTime::DEFAULT),
                "a date would differ from export to export"
            );
            let mut text = Vec::new();
            entry.read_to_end(&mut text).expect("bytes");
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
fn cargo_finds_every_package_of_this_project_in_its_export() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../..");
    let files = codegrade(&root, GUARDED).expect("an export");
    let folder = TempDir::new().expect("a folder");
    for (path, _, bytes) in entries(&file(&files, "lightlab.zip").bytes) {
        let path = folder.path().join(path);
        fs::create_dir_all(path.parent().expect("a parent")).expect("a folder");
        fs::write(path, bytes).expect("a file");
    }
    let members = |root: &Path| {
        // Reads the manifests and looks for every target's file; without dependencies it asks no network.
        let output = Command::new(env!("CARGO"))
            .args(["metadata", "--no-deps", "--offline", "--format-version", "1"])
            .current_dir(root)
            .output()
            .expect("cargo");
        assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
        let metadata: Value = serde_json::from_slice(&output.stdout).expect("JSON");
        let packages = metadata["packages"].as_array().expect("packages").clone();
        let targets = |it: &Value| it["targets"].as_array().map_or(0, Vec::len);
        packages.iter().map(|it| (it["name"].to_string(), targets(it))).collect::<Vec<_>>()
    };
    let (here, there) = (members(&root), members(folder.path()));
    assert!(here.len() > 15, "{here:?}");
    assert_eq!(here, there);
    assert!(folder.path().join(".cargo/config.toml").is_file());
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
