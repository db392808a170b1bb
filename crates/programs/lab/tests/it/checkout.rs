//! Does any program remember where it was built? A checkout that is copied or renamed brings its programs along.

use std::fs;
use std::path::{Path, PathBuf};

use crate::desk::root;

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
    for group in ["concepts", "drawing", "judging", "programs"] {
        for package in fs::read_dir(root().join("crates").join(group)).expect("the crates") {
            sources(&package.expect("an entry").path().join("src"), &mut found);
        }
    }
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
