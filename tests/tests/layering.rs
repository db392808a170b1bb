//! Do the arrows point down? The table in `crates/README.md` says which layer a crate has; the manifests say what it needs.

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};

fn workspace() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).parent().expect("the package lies in the workspace").to_owned()
}

fn read(path: &Path) -> String {
    fs::read_to_string(path).unwrap_or_else(|e| panic!("{}: {e}", path.display()))
}

/// Layer by crate, from the rows "| `name` | 2 | …" of the map.
fn layers() -> BTreeMap<String, u32> {
    let map = read(&workspace().join("crates/README.md"));
    let rows = map.lines().filter_map(|line| {
        let mut cells = line.split('|').map(str::trim).skip(1);
        let name = cells.next()?.strip_prefix('`')?.strip_suffix('`')?;
        Some((name.to_owned(), cells.next()?.parse().ok()?))
    });
    rows.collect()
}

struct Manifest {
    name: String,
    dependencies: Vec<String>,
    dev_dependencies: Vec<String>,
}

fn manifests() -> Vec<Manifest> {
    let folders = fs::read_dir(workspace().join("crates"))
        .expect("crates/")
        .map(|entry| entry.expect("an entry").path());
    let names = |table: &toml::Table, key: &str| -> Vec<String> {
        table.get(key).and_then(|t| t.as_table()).map(|t| t.keys().cloned().collect()).unwrap_or_default()
    };
    folders
        .filter(|folder| folder.is_dir())
        .map(|folder| {
            let table: toml::Table = read(&folder.join("Cargo.toml")).parse().expect("a manifest");
            Manifest {
                name: table["package"]["name"].as_str().expect("a name").to_owned(),
                dependencies: names(&table, "dependencies"),
                dev_dependencies: names(&table, "dev-dependencies"),
            }
        })
        .collect()
}

/// Every Rust file of a crate's library or program, without its tests and examples.
fn sources(name: &str) -> Vec<PathBuf> {
    let mut folders = vec![workspace().join("crates").join(name).join("src")];
    let mut files = Vec::new();
    while let Some(folder) = folders.pop() {
        for entry in fs::read_dir(&folder).expect("a source folder") {
            let path = entry.expect("an entry").path();
            if path.is_dir() {
                folders.push(path);
            } else if path.extension().is_some_and(|e| e == "rs") {
                files.push(path);
            }
        }
    }
    files
}

#[test]
fn every_crate_is_on_the_map() {
    let layers = layers();
    let manifests = manifests();
    for manifest in &manifests {
        assert!(
            manifest.name == "testkit" || layers.contains_key(&manifest.name),
            "{} has no row in crates/README.md",
            manifest.name
        );
    }
    for name in layers.keys() {
        assert!(
            manifests.iter().any(|m| m.name == *name),
            "crates/README.md lists {name}, which does not exist"
        );
    }
}

#[test]
fn a_crate_depends_only_on_lower_layers() {
    let layers = layers();
    let mut arrows = 0;
    for Manifest { name, dependencies, .. } in manifests().iter().filter(|m| m.name != "testkit") {
        for dependency in dependencies.iter().filter(|d| layers.contains_key(*d)) {
            arrows += 1;
            assert!(
                layers[dependency] < layers[name],
                "{name} (layer {}) depends on {dependency} (layer {})",
                layers[name],
                layers[dependency]
            );
        }
    }
    assert!(arrows > 10, "only {arrows} arrows found: the manifests were not understood");
}

#[test]
fn the_ray_tracer_knows_neither_the_z_buffer_nor_shading() {
    let manifests = manifests();
    let raytrace = manifests.iter().find(|m| m.name == "raytrace").expect("the crate raytrace");
    for stranger in ["zbuffer", "shading"] {
        assert!(!raytrace.dependencies.iter().any(|d| d == stranger), "raytrace depends on {stranger}");
        assert!(
            !raytrace.dev_dependencies.iter().any(|d| d == stranger),
            "raytrace's tests depend on {stranger}"
        );
    }
}

#[test]
fn only_tests_depend_on_the_testkit_which_knows_layer_0_only() {
    let layers = layers();
    for Manifest { name, dependencies, .. } in &manifests() {
        assert!(!dependencies.iter().any(|d| d == "testkit"), "{name} depends on testkit outside its tests");
        if name == "testkit" {
            for dependency in dependencies.iter().filter(|d| layers.contains_key(*d)) {
                assert_eq!(layers[dependency], 0, "testkit depends on {dependency}");
            }
        }
    }
}

#[test]
fn no_crate_has_unsafe_code() {
    for Manifest { name, .. } in &manifests() {
        let source = workspace().join("crates").join(name).join("src");
        let root = [source.join("lib.rs"), source.join("main.rs")].into_iter().find(|path| path.exists());
        let text = read(&root.unwrap_or_else(|| panic!("{name} has neither lib.rs nor main.rs")));
        assert!(text.contains("#![forbid(unsafe_code)]"), "{name} does not forbid unsafe code");
    }
}

#[test]
fn concept_crates_do_no_io_and_print_nothing() {
    let quiet = layers().into_iter().filter(|(_, layer)| *layer <= 2);
    for (name, _) in quiet {
        for path in sources(&name) {
            let text = read(&path);
            // Unit tests may print; the code before them may not. Doc comments show examples.
            let code = text.split("#[cfg(test)]").next().unwrap_or_default();
            let lines = code.lines().filter(|line| !line.trim_start().starts_with("//"));
            for line in lines {
                for word in
                    ["std::fs", "std::net", "std::thread", "println!", "eprintln!", "print!(", "static mut"]
                {
                    assert!(!line.contains(word), "{} has {word}: {line}", path.display());
                }
            }
        }
    }
}

#[test]
fn every_crate_opens_its_readme_with_a_question() {
    for Manifest { name, .. } in &manifests() {
        let text = read(&workspace().join("crates").join(name).join("README.md"));
        let title = text.lines().next().unwrap_or_default();
        assert!(title.starts_with("# ") && title.contains('?'), "{name}: «{title}» is no question");
    }
}

#[test]
fn every_item_and_every_error_of_the_lecture_is_on_the_map() {
    let map = read(&workspace().join("crates/README.md"));
    let items: Vec<u32> = map
        .lines()
        .filter_map(|line| line.strip_prefix("| L"))
        .filter_map(|row| row.split('|').next())
        .flat_map(numbers)
        .collect();
    assert_eq!(items, (1..=58).collect::<Vec<_>>(), "L1…L58, each once");
    for error in 1..=18 {
        assert!(map.contains(&format!("\n| E{error} |")), "E{error} is missing");
    }
}

/// The numbers of "1–5", "6, L7" or "21".
fn numbers(cell: &str) -> Vec<u32> {
    let number = |text: &str| text.trim().trim_start_matches('L').parse::<u32>().expect("a number");
    if let Some((first, last)) = cell.split_once('–') {
        return (number(first)..=number(last)).collect();
    }
    cell.split(',').map(number).collect()
}
