//! Do the arrows point down? The table in `crates/README.md` says which layer a crate has; the manifests say what it needs,
//! and the sources what it uses of the standard library.

mod manifest;
mod source;

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};

use self::manifest::{Manifest, manifests};
use self::source::{offences, sources};

/// The package that these tests are in.
const THESE_TESTS: &str = "lightlab-tests";

/// Outside the layers: what tests are made of and where they stand.
const BESIDE_THE_LAYERS: [&str; 2] = ["testkit", THESE_TESTS];

fn workspace() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).parent().expect("the package lies in the workspace").to_owned()
}

fn read(path: &Path) -> String {
    fs::read_to_string(path).unwrap_or_else(|e| panic!("{}: {e}", path.display()))
}

/// Folder and layer of each crate, from the headings "### `concepts/`" and the rows "| `name` | 2 | …" of the map.
fn map() -> BTreeMap<String, (String, u32)> {
    let text = read(&workspace().join("crates/README.md"));
    let mut folder = String::new();
    let mut rows = BTreeMap::new();
    for line in text.lines() {
        if let Some(heading) = line.strip_prefix("### `") {
            heading.trim_end_matches('`').trim_end_matches('/').clone_into(&mut folder);
        }
        let mut cells = line.split('|').map(str::trim).skip(1);
        let name = cells.next().and_then(|cell| cell.strip_prefix('`')?.strip_suffix('`'));
        let layer = cells.next().and_then(|cell| cell.parse().ok());
        if let (Some(name), Some(layer)) = (name, layer) {
            rows.insert(name.to_owned(), (folder.clone(), layer));
        }
    }
    rows
}

/// Layer of each crate.
fn layers() -> BTreeMap<String, u32> {
    map().into_iter().map(|(name, (_, layer))| (name, layer)).collect()
}

#[test]
fn a_crate_lies_in_the_folder_that_the_map_lists_it_under() {
    let map = map();
    for Manifest { name, folder, .. } in manifests() {
        let Some((expected, _)) = map.get(&name) else { continue };
        assert!(
            folder == workspace().join("crates").join(expected).join(&name),
            "crates/README.md lists {name} under `{expected}/`, but it lies in {}",
            folder.display()
        );
    }
}

#[test]
fn every_crate_is_on_the_map() {
    let layers = layers();
    let manifests = manifests();
    for manifest in &manifests {
        assert!(
            BESIDE_THE_LAYERS.contains(&manifest.name.as_str()) || layers.contains_key(&manifest.name),
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
    for Manifest { name, dependencies, .. } in manifests().iter().filter(|m| layers.contains_key(&m.name)) {
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
fn only_tests_and_exercises_depend_on_the_testkit_which_knows_layer_0_only() {
    let layers = layers();
    for Manifest { name, dependencies, .. } in &manifests() {
        let may = name == "course";
        assert!(
            may || !dependencies.iter().any(|d| d == "testkit"),
            "{name} needs testkit outside its tests"
        );
        if name == "testkit" {
            for dependency in dependencies.iter().filter(|d| layers.contains_key(*d)) {
                assert_eq!(layers[dependency], 0, "testkit depends on {dependency}");
            }
        }
    }
}

#[test]
fn nothing_depends_on_these_tests_and_they_have_no_code_of_their_own() {
    for Manifest { name, dependencies, dev_dependencies, .. } in &manifests() {
        let mut all = dependencies.iter().chain(dev_dependencies);
        assert!(!all.any(|d| d == THESE_TESTS), "{name} depends on {THESE_TESTS}");
        assert!(
            name != THESE_TESTS || dependencies.is_empty(),
            "{dependencies:?} belong to the dev-dependencies"
        );
    }
    let list = read(&workspace().join("tests/src/lib.rs"));
    assert!(
        source::without_tests_and_comments(&list)
            .iter()
            .all(|line| line.trim().is_empty() || line.starts_with("#!"))
    );
    for entry in fs::read_dir(workspace().join("tests/tests/it")).expect("the folder of these tests") {
        let path = entry.expect("an entry").path();
        let name = path.file_stem().expect("a name").to_string_lossy();
        if name == "main" {
            continue;
        }
        assert!(list.contains(&format!("- `{name}`:")), "tests/src/lib.rs does not say what {name} is about");
    }
}

#[test]
fn no_crate_needs_the_renderers_that_ours_is_compared_with() {
    let text = read(&workspace().join("tests/peers/Cargo.toml"));
    // What the comparison needs and the workspace's table does not name.
    let table = read(&workspace().join("Cargo.toml"));
    let peers: Vec<String> = manifest::dependencies(&text)
        .into_iter()
        .filter(|name| !table.lines().any(|line| line.starts_with(&format!("{name} = "))))
        .collect();
    assert!(["euc", "obvhs"].iter().all(|name| peers.contains(&(*name).to_owned())), "{peers:?}");
    for Manifest { name, dependencies, dev_dependencies, .. } in &manifests() {
        let mut all = dependencies.iter().chain(dev_dependencies);
        assert!(!all.any(|d| peers.contains(d) || d == "lightlab-peers"), "{name} depends on a peer");
    }
}

#[test]
fn no_crate_has_unsafe_code() {
    for Manifest { name, folder, .. } in &manifests() {
        let source = folder.join("src");
        let root = [source.join("lib.rs"), source.join("main.rs")].into_iter().find(|path| path.exists());
        let text = read(&root.unwrap_or_else(|| panic!("{name} has neither lib.rs nor main.rs")));
        assert!(text.contains("#![forbid(unsafe_code)]"), "{name} does not forbid unsafe code");
    }
}

#[test]
fn concept_crates_do_no_io_print_nothing_and_keep_no_global_state() {
    let layers = layers();
    let mut files = 0;
    for manifest in manifests().iter().filter(|m| layers.get(&m.name).is_some_and(|layer| *layer <= 2)) {
        for path in sources(&manifest.folder) {
            files += 1;
            let found = offences(&read(&path));
            assert!(found.is_empty(), "{}: {found:?}", path.display());
        }
    }
    assert!(files > 50, "only {files} source files found");
}

#[test]
fn every_crate_opens_its_readme_with_a_question() {
    for Manifest { name, folder, .. } in manifests().iter().filter(|m| m.name != THESE_TESTS) {
        let text = read(&folder.join("README.md"));
        let title = text.lines().next().unwrap_or_default();
        assert!(title.starts_with("# ") && title.contains('?'), "{name}: «{title}» is no question");
    }
}

#[test]
fn every_item_and_every_error_of_the_lecture_is_on_the_map() {
    let map = read(&workspace().join("crates/README.md"));
    let errata = read(&workspace().join("crates/errata.md"));
    let items: Vec<u32> = map
        .lines()
        .filter_map(|line| line.strip_prefix("| L"))
        .filter_map(|row| row.split('|').next())
        .flat_map(numbers)
        .collect();
    assert_eq!(items, (1..=58).collect::<Vec<_>>(), "L1…L58, each once");
    for error in 1..=18 {
        assert!(errata.contains(&format!("\n| E{error} |")), "E{error} is missing");
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

#[test]
fn exercises_see_glam_and_the_vocabulary_and_no_crate_sees_them() {
    let text = read(&workspace().join("exercises/Cargo.toml"));
    let mut seen = manifest::dependencies(&text);
    seen.sort();
    assert_eq!(seen, ["glam", "vocabulary"]);
    let vocabulary = manifests().into_iter().find(|m| m.name == "vocabulary").expect("the crate vocabulary");
    assert_eq!(vocabulary.dependencies, ["glam"]);
    for Manifest { name, dependencies, dev_dependencies, .. } in &manifests() {
        let mut all = dependencies.iter().chain(dev_dependencies);
        assert!(!all.any(|d| d == "exercises"), "{name} depends on the exercises");
    }
}
