//! Meshes and materials from other programs: what a picture shows of them.

use std::fs;

use canvas::{Image, Rgb};
use glam::vec3;
use scene::{Loaded, Renderer, Settings, load, prepare, render, render_slide};
use tempfile::TempDir;

/// Seen along −z: a window of 4 × 3 around the origin.
const VIEW: &str = "background = [0, 0.25, 1]\n[camera]\neye = [0, 0, 5]\ntarget = [0, 0, 0]\n\
    window = { left = -2, right = 2, bottom = -1.5, top = 1.5 }\nnear = -4\nfar = -9\n\
    [[light]]\nkind = \"ambient\"\n";

/// A square of 2 × 2 in z = 0 with material `m`.
const SQUARE: &str = "mtllib a.mtl\nusemtl m\nv -1 -1 0\nv 1 -1 0\nv 1 1 0\nv -1 1 0\nf 1 2 3 4\n";

const RENDERERS: [Renderer; 3] = [Renderer::Painter, Renderer::ZBuffer, Renderer::Raytrace];

fn folder(files: &[(&str, &str)]) -> TempDir {
    let folder = tempfile::tempdir().unwrap();
    for (name, text) in files {
        fs::write(folder.path().join(name), text).unwrap();
    }
    folder
}

/// The scene of [`VIEW`] and these further tables.
fn scene(tables: &str) -> Loaded {
    Loaded::from_toml(&format!("{VIEW}{tables}"), "a.toml", "".as_ref()).unwrap()
}

fn with_material(mtl: &str) -> Loaded {
    let scene = format!("{VIEW}[[object]]\nobj = \"a.obj\"\n");
    let folder = folder(&[("a.toml", &scene), ("a.obj", SQUARE), ("a.mtl", mtl)]);
    load(&folder.path().join("a.toml")).unwrap()
}

fn drawn(loaded: &Loaded, renderer: Renderer) -> (Image, Vec<String>) {
    let settings = Settings { renderer, size: (16, 12), ..loaded.scene.settings };
    let prepared = prepare(loaded).unwrap();
    let rendered = render(&prepared, &settings, &|_| ()).unwrap();
    assert_eq!(render_slide(&prepared, &settings, &|_| ()).unwrap().notes, rendered.notes);
    (rendered.image, rendered.notes)
}

fn middle(loaded: &Loaded, renderer: Renderer) -> Rgb {
    drawn(loaded, renderer).0.get(8, 6)
}

#[test]
fn d_mixes_own_light_and_what_is_behind() {
    let own = vec3(0.8, 0.4, 0.2);
    let (background, eps) = (vec3(0.0, 0.25, 1.0), 1e-6);
    for index in ["", "Ni 1.45\n"] {
        let half = with_material(&format!("newmtl m\nKd 0.8 0.4 0.2\nillum 2\n{index}d 0.5\n"));
        let seen = middle(&half, Renderer::Raytrace);
        assert!(seen.abs_diff_eq(0.5 * own + 0.5 * background, eps), "{seen}");
        assert!(middle(&half, Renderer::ZBuffer).abs_diff_eq(own, eps), "a rasterizer draws it opaque");
    }
}

#[test]
fn d_0_is_invisible_in_every_renderer() {
    for index in ["", "Ni 1.45\n"] {
        let clear = with_material(&format!("newmtl m\nKd 0.8 0.4 0.2\n{index}d 0\n"));
        for renderer in RENDERERS {
            let (image, notes) = drawn(&clear, renderer);
            assert!(image.pixels().iter().all(|pixel| *pixel == clear.scene.background), "{renderer}");
            assert!(notes.iter().any(|note| note.contains("every pixel is background")), "{notes:?}");
        }
    }
    // So is an exact ball.
    let ball =
        scene("[material.m]\ndiffuse = 0.5\nopacity = 0\n[[object]]\nshape = \"sphere\"\nmaterial = \"m\"\n");
    for renderer in RENDERERS {
        assert_eq!(middle(&ball, renderer), ball.scene.background, "{renderer}");
    }
}

#[test]
fn reentrant_polygon_of_a_scene_is_that_of_a_mesh() {
    // An arrowhead that points right; its dent is the third corner, so that a fan around the first covers the outside.
    let polygon = "[[object]]\npolygons = [[[1.5, 0, 0], [-1, 1, 0], [0.8, 0, 0], [-1, -1, 0]]]\n";
    let mesh = "v 1.5 0 0\nv -1 1 0\nv 0.8 0 0\nv -1 -1 0\nf 1 2 3 4\n";
    for start in 0..4 {
        let mut corners = ["[1.5, 0, 0]", "[-1, 1, 0]", "[0.8, 0, 0]", "[-1, -1, 0]"];
        corners.rotate_left(start);
        let polygon = format!("[[object]]\npolygons = [[{}]]\n", corners.join(", "));
        let folder = folder(&[("a.toml", &format!("{VIEW}[[object]]\nobj = \"a.obj\"\n")), ("a.obj", mesh)]);
        let from_mesh = load(&folder.path().join("a.toml")).unwrap();
        for renderer in RENDERERS {
            assert_eq!(
                drawn(&scene(&polygon), renderer).0,
                drawn(&from_mesh, renderer).0,
                "{renderer} {start}"
            );
        }
    }
    // Left of the dent is nothing.
    let loaded = scene(polygon);
    assert_eq!(middle(&loaded, Renderer::Raytrace), loaded.scene.background);
    assert_eq!(loaded.warnings, Vec::<String>::new());
}

#[test]
fn polygon_that_crosses_itself_is_drawn_with_a_warning_at_its_line() {
    let star = "[[object]]\npolygons = [\n[[0, 1, 0], [-0.6, -0.8, 0], [0.9, 0.3, 0], [-0.9, 0.3, 0], [0.6, -0.8, 0]]]\n";
    assert_eq!(
        scene(star).warnings,
        ["a.toml:12: a face crosses itself; it is cut into triangles as well as may be"]
    );
}

/// The picture of a ridge along y of two slopes, lit from the right, by Phong shading.
fn ridge(faces: &str) -> Image {
    let mesh = format!("v -1 -1 0\nv -1 1 0\nv 0 -1 0.3\nv 0 1 0.3\nv 1 -1 0\nv 1 1 0\n{faces}");
    let toml = format!(
        "{VIEW}[[light]]\nkind = \"directional\"\nto-light = [1, 0, 1]\n[[object]]\nobj = \"a.obj\"\n"
    );
    let folder = folder(&[("a.toml", &toml), ("a.obj", &mesh)]);
    drawn(&load(&folder.path().join("a.toml")).unwrap(), Renderer::ZBuffer).0
}

#[test]
fn edges_between_smoothing_groups_are_hard() {
    let ([left, right], flat) = (["f 1 3 4 2\n", "f 3 5 6 4\n"], ridge("s off\nf 1 3 4 2\nf 3 5 6 4\n"));
    let smooth = ridge(&format!("{left}{right}"));
    assert_ne!(smooth, flat);
    assert_eq!(ridge(&format!("s 1\n{left}{right}")), smooth);
    assert_eq!(ridge(&format!("s 1\n{left}s 2\n{right}")), flat);
}

#[test]
fn normals_that_are_equal_on_all_corners_are_kept() {
    // A square in z = 0 whose normals lean to the right, and the light comes along z.
    let text = |normal: &str| {
        let faces = if normal.is_empty() { "f 1 2 3 4\n" } else { "f 1//1 2//1 3//1 4//1\n" };
        format!("v -1 -1 0\nv 1 -1 0\nv 1 1 0\nv -1 1 0\n{normal}{faces}")
    };
    let lamp =
        "[material.m]\ndiffuse = 1\nspecular = 0\n[[light]]\nkind = \"directional\"\nto-light = [0, 0, 1]\n";
    let toml = VIEW.replace("kind = \"ambient\"", "kind = \"ambient\"\ncolor = 0")
        + lamp
        + "[[object]]\nobj = \"a.obj\"\nmaterial = \"m\"\n";
    let seen = |normal: &str, renderer| {
        let folder = folder(&[("a.toml", &toml), ("a.obj", &text(normal))]);
        let loaded = load(&folder.path().join("a.toml")).unwrap();
        assert_eq!(loaded.warnings, Vec::<String>::new());
        middle(&loaded, renderer).x
    };
    for renderer in RENDERERS {
        assert!((seen("vn 0.6 0 0.8\n", renderer) - 0.8).abs() < 1e-6, "{renderer}");
        assert!((seen("", renderer) - 1.0).abs() < 1e-6, "{renderer}");
    }
}

#[test]
fn only_a_picture_that_shows_no_object_is_said_to_be_background() {
    let ball = |color: &str| {
        scene(&format!(
            "[material.m]\ndiffuse = {color}\n[[object]]\nshape = \"sphere\"\nmaterial = \"m\"\ntransforms = [{{ translate = [0.1, 0.2, 0] }}]\n"
        ))
    };
    let same_color = ball("[0, 0.25, 1]");
    let away = scene("[[object]]\nshape = \"sphere\"\ntransforms = [{ translate = [50, 0, 0] }]\n");
    for renderer in RENDERERS {
        for samples in [1, 2] {
            let notes = |loaded: &Loaded| {
                let mut loaded = loaded.clone();
                loaded.scene.settings.samples = samples;
                drawn(&loaded, renderer).1.join("\n")
            };
            let covered = notes(&same_color);
            assert!(!covered.contains("every pixel is background"), "{covered}");
            assert!(covered.contains("all have the color of the background"), "{covered}");
            assert!(notes(&away).contains("every pixel is background"));
            assert_eq!(notes(&ball("[1, 0, 0]")), "");
        }
    }
}

#[test]
fn object_far_from_the_origin_for_its_size_is_a_warning() {
    let warnings = |radius: f32, x: f32| {
        let scene = scene(&format!(
            "[[object]]\nshape = \"sphere\"\nradius = {radius:?}\ntransforms = [{{ translate = [{x:?}, 0, 0] }}]\n"
        ));
        prepare(&scene).unwrap().warnings().to_vec()
    };
    assert_eq!(warnings(0.5, 3000.0), Vec::<String>::new());
    assert_eq!(warnings(50.0, 1e4), Vec::<String>::new(), "large for its distance");
    let [warning] = &warnings(0.5, 1e4)[..] else { panic!("one warning") };
    assert!(warning.contains("object 0") && warning.contains("10000.5 from the origin"), "{warning}");
}

#[test]
fn exponent_of_a_material_file_that_f32_cannot_compute_is_lowered_with_a_warning() {
    let warnings = with_material("newmtl m\nNs 1000000\n").warnings;
    assert!(warnings.len() == 1 && warnings[0].contains("\"m\" has Ns 1e6"), "{warnings:?}");
    assert_eq!(with_material("newmtl m\nNs 1000\n").warnings, Vec::<String>::new());
}
