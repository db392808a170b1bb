//! Is what is handed out what the exercises say? A solution in progress is no mistake: only the task and the signature are looked at.

use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};

use course::Concept;

fn exercises() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../../exercises")
}

/// The task: the comment on top.
fn task(text: &str) -> Vec<&str> {
    text.trim_start_matches('\u{feff}').lines().take_while(|line| line.starts_with("//!")).collect()
}

#[test]
fn every_exercise_has_a_file_with_its_task_and_its_signature() {
    let list = fs::read_to_string(exercises().join("lib.rs")).expect("exercises/lib.rs");
    for exercise in course::all() {
        let path = exercises().join(exercise.path());
        let text = fs::read_to_string(&path).unwrap_or_else(|e| {
            panic!("{}: {e}; `cargo lab reset {}` writes it", path.display(), exercise.name)
        });
        assert_eq!(task(&text), task(exercise.stub), "{}: another task", path.display());
        let begin = exercise.stub.find("pub fn ").expect("a function");
        let signature = exercise.stub[begin..].split('{').next().unwrap_or_default();
        let flat = |text: &str| text.split_whitespace().collect::<String>();
        assert!(flat(&text).contains(&flat(signature)), "{}: another signature", path.display());
        assert!(
            list.contains(&format!("pub mod {};", exercise.name)),
            "exercises/lib.rs lacks {}",
            exercise.name
        );
    }
}

#[test]
fn every_file_belongs_to_an_exercise() {
    let known: BTreeSet<String> = course::all().iter().map(course::Exercise::path).collect();
    for concept in Concept::ALL {
        for entry in fs::read_dir(exercises().join(concept.name())).expect("a concept's folder") {
            let path = entry.expect("an entry").path();
            let name = format!("{}/{}", concept.name(), path.file_name().expect("a name").to_string_lossy());
            // Backups of `cargo lab reset` may lie beside them.
            assert!(known.contains(&name) || !name.ends_with(".rs"), "{name} is no exercise");
        }
    }
}

#[test]
fn the_signature_of_the_stub_is_the_one_that_is_asked() {
    for exercise in course::all() {
        let flat = |text: &str| text.split_whitespace().collect::<String>().replace(",)", ")");
        let begin = exercise.stub.find("pub fn ").expect("a function");
        let stub = exercise.stub[begin..].split('{').next().unwrap_or_default();
        let asked = format!("pub fn {}{}", exercise.name, exercise.signature.text);
        assert_eq!(flat(stub), flat(&asked), "{}", exercise.name);
    }
}

#[test]
fn the_list_of_the_lecture_is_covered() {
    // Names that courses build on; new ones may be added.
    let wanted = [
        "rotate_about_point",
        "change_of_basis",
        "change_of_basis_inverse",
        "camera_frame",
        "camera_from_world",
        "perspective",
        "canonical_from_camera",
        "screen_from_canonical",
        "window_from_pixel",
        "barycentric",
        "covers",
        "depth_at",
        "rasterize",
        "zbuffer",
        "painters_order",
        "lambert",
        "ambient_and_diffuse",
        "reflection",
        "phong_highlight",
        "halfway",
        "blinn_phong",
        "light_all",
        "face_normal",
        "vertex_normals",
        "gouraud",
        "phong_shading",
        "viewing_ray",
        "ray_triangle_system",
        "ray_triangle",
        "ray_sphere",
        "nearest_hit",
        "in_shadow",
        "ray_color",
        "refract",
        "ray_color_recursive",
    ];
    let missing: Vec<&str> = wanted.into_iter().filter(|name| course::find(name).is_none()).collect();
    assert!(missing.is_empty(), "missing: {missing:?}");
}
