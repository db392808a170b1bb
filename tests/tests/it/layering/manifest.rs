//! What does a crate need? Its manifest says it, in several tables.

use std::fs;
use std::path::{Path, PathBuf};

use toml::de::DeTable;

use crate::layering::{read, workspace};

pub(crate) struct Manifest {
    pub(crate) name: String,
    pub(crate) folder: PathBuf,
    /// What its code and its build script need, on any platform.
    pub(crate) dependencies: Vec<String>,
    /// What only its tests, benches and examples need.
    pub(crate) dev_dependencies: Vec<String>,
}

/// Returns the folders of all packages below `folder`: those that hold a manifest.
fn packages(folder: &Path) -> Vec<PathBuf> {
    let entries = fs::read_dir(folder).unwrap_or_else(|e| panic!("{}: {e}", folder.display()));
    let folders = entries.map(|entry| entry.expect("an entry").path()).filter(|path| path.is_dir());
    let found =
        folders.flat_map(|path| if path.join("Cargo.toml").is_file() { vec![path] } else { packages(&path) });
    found.collect()
}

/// Returns the manifests of all packages in `crates/`, and of these tests.
pub(crate) fn manifests() -> Vec<Manifest> {
    packages(&workspace().join("crates"))
        .into_iter()
        .chain([workspace().join("tests")])
        .map(|folder| {
            let text = read(&folder.join("Cargo.toml"));
            let table = DeTable::parse(&text).expect("a manifest").into_inner();
            let package = table.get("package").and_then(|package| package.get_ref().get("name"));
            Manifest {
                name: package.and_then(|name| name.get_ref().as_str()).expect("a name").to_owned(),
                folder,
                dependencies: names(&table, &["dependencies", "build-dependencies"]),
                dev_dependencies: names(&table, &["dev-dependencies"]),
            }
        })
        .collect()
}

/// What the code of a package needs, by the text of its manifest.
pub(crate) fn dependencies(text: &str) -> Vec<String> {
    let manifest = DeTable::parse(text).expect("a manifest").into_inner();
    names(&manifest, &["dependencies", "build-dependencies"])
}

/// The packages in these tables, and in those of single platforms: `[target.'cfg(unix)'.dependencies]`.
fn names(manifest: &DeTable, keys: &[&str]) -> Vec<String> {
    let platforms = manifest.get("target").and_then(|targets| targets.get_ref().as_table());
    let platforms =
        platforms.into_iter().flat_map(|table| table.values()).filter_map(|value| value.get_ref().as_table());
    let tables = [manifest].into_iter().chain(platforms);
    let dependencies =
        tables.flat_map(|table| keys.iter().filter_map(|key| table.get(*key)?.get_ref().as_table()));
    let mut names = Vec::new();
    for (name, value) in dependencies.flatten() {
        // `name = { package = "real-name" }` is another name for the same thing.
        let package = value.get_ref().get("package").and_then(|package| package.get_ref().as_str());
        names.push(package.unwrap_or(name.get_ref()).to_owned());
    }
    names
}

#[test]
fn every_table_of_a_manifest_is_read() {
    let text = "dependencies.a = '1'\ndependencies.alias = { package = 'b' }\nbuild-dependencies.c = '1'\n\
        target.'cfg(unix)'.dependencies.d = '1'\ntarget.x.build-dependencies.e = '1'\ndev-dependencies.f = '1'\n";
    let manifest = DeTable::parse(text).expect("a manifest").into_inner();
    let mut found = names(&manifest, &["dependencies", "build-dependencies"]);
    found.sort();
    assert_eq!(found, ["a", "b", "c", "d", "e"]);
}
