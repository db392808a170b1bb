//! Wrong words after `cargo lab render`: each is refused with what would be right, and nothing is written.

use crate::desk::Desk;

#[track_caller]
fn refused(line: &str, parts: &[&str]) {
    let desk = Desk::new();
    desk.lab(line).refused(parts);
    assert!(desk.files().is_empty(), "{line} left {:?}", desk.files());
}

#[test]
fn sizes() {
    for wrong in ["12", "axb", "640x", "x", "-3x4", "3.5x4"] {
        refused(&format!("render --size={wrong}"), &[wrong, "--size", "640x480"]);
    }
    refused("render --size 0x0", &["0x0", "at least 1"]);
    refused("render --size 7x0", &["7x0", "at least 1"]);
    refused("render --size 1000000x1000000", &["at most 16384"]);
    refused("render --size 99999999999999999999x1", &["at most 16384"]);
    refused("render --size 8000x8000", &["3 pictures of 8000 × 8000", "67108864", "--renderer"]);
    let said = Desk::new().lab("render --size 16384x16384 --renderer raytrace");
    let said = said.refused(&["16384 × 16384", "67108864", "--size"]);
    assert!(!said.err.contains("--renderer"), "one is chosen already: {}", said.err);
    refused("render --size 8192x8192 --renderer zbuffer --samples 16", &["--samples"]);
}

#[test]
fn numbers() {
    for wrong in ["0", "-1", "x", "1.5", "99999999999", ""] {
        refused(&format!("render --threads={wrong}"), &["--threads"]);
        refused(&format!("render --samples={wrong}"), &["--samples"]);
    }
    refused("render --threads 0", &["from 1 to 1024"]);
    refused("render --threads -2", &["from 1 to 1024"]);
    refused("render --samples 17", &["from 1 to 16"]);
    refused("render --max-depth 65", &["from 0 to 64"]);
    refused("render --max-depth -1", &["from 0 to 64"]);
}

#[test]
fn names() {
    refused("render --renderer zbufer", &["zbuffer, painter, raytrace", "similar value exists: 'zbuffer'"]);
    refused("render --shading gourand", &["flat, gouraud, phong", "'gouraud'"]);
    refused("render --show colour", &["color, depth, normals, barycentric, overdraw", "'color'"]);
    refused("render --colour", &["--colour"]);
    refused("rendr", &["'rendr'", "'render'"]);
}

#[test]
fn scenes() {
    refused("render teepot", &["teepot", "teapot", "cornell-box", ".toml", ".obj"]);
    refused("render nowhere.toml", &["nowhere.toml"]);
    refused("render nowhere/mesh.obj", &["nowhere/mesh.obj"]);
    refused("render picture.png", &["picture.png"]);
}

#[test]
fn a_scene_that_is_a_folder_or_no_scene() {
    let desk = Desk::new();
    std::fs::create_dir(desk.path("folder.toml")).unwrap();
    desk.put("notes.txt", "not a scene");
    desk.put("empty.obj", "");
    for name in ["folder.toml", "notes.txt", "empty.obj", "."] {
        desk.lab(&format!("render {name} -o out.png")).refused(&[name]);
    }
    for folder in ["folder.toml", "."] {
        let is_said = format!("{folder} is a folder, not a scene");
        desk.lab(&format!("render {folder}")).refused(&[&is_said]);
    }
    assert_eq!(desk.files(), ["empty.obj", "folder.toml", "notes.txt"]);
}

#[test]
fn a_fault_in_a_scene_is_named_with_its_line() {
    let desk = Desk::new();
    let scene = desk.lab("scenes teapot").done().out;
    let lines = scene.lines().count();
    desk.put("mine.toml", format!("{scene}\n[cammera]\nfov = 3\n"));
    desk.lab("render mine.toml").refused(&[&format!("mine.toml:{}:", lines + 2), "cammera"]);
}

#[test]
fn the_last_of_two_equal_flags_counts() {
    let desk = Desk::new();
    desk.lab("render --size 999x999 --renderer painter --size 20x10 --renderer zbuffer").done();
    assert_eq!(desk.picture("teapot.png").width(), 20);
}
