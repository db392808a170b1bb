//! Files: scenes with meshes beside them, and bare meshes of any size, at any place.

use std::fs;

use scene::{Loaded, Renderer, Settings, Shape, Show, builtin, load, prepare, render};
use tempfile::TempDir;

const SCENE: &str = "[camera]\neye = [0.5, 1, 4]\ntarget = [0, 0, 0]\nfov = 40\n[[object]]\nobj = \"pot.obj\"\n[[light]]\nkind = \"ambient\"\n";
const POT: &str =
    "mtllib pot.mtl\nusemtl clay\nv 0 0 0\nv 1 0 0.5\nv 0.3 1.2 0\nv -1 0.1 0.2\nf 1 2 3\nf 1 3 4\n";

fn folder(files: &[(&str, &str)]) -> TempDir {
    let folder = tempfile::tempdir().unwrap();
    for (name, text) in files {
        fs::write(folder.path().join(name), text).unwrap();
    }
    folder
}

fn picture(loaded: &Loaded, renderer: Renderer) -> canvas::Image {
    let settings = Settings { renderer, size: (32, 24), ..loaded.scene.settings };
    render(&prepare(loaded).unwrap(), &settings, &|_| ()).unwrap().image
}

/// How many pixels show something other than the background.
fn covered(loaded: &Loaded, renderer: Renderer) -> usize {
    picture(loaded, renderer).pixels().iter().filter(|pixel| **pixel != loaded.scene.background).count()
}

#[test]
fn a_mesh_is_found_beside_its_scene_with_its_material() {
    let folder = folder(&[("a.toml", SCENE), ("pot.obj", POT), ("pot.mtl", "newmtl clay\nKd 0.8 0.4 0.2\n")]);
    let loaded = load(&folder.path().join("a.toml")).unwrap();
    assert_eq!(loaded.warnings, Vec::<String>::new());
    assert!(covered(&loaded, Renderer::ZBuffer) > 50);
}

#[test]
fn a_missing_mtl_file_is_a_warning() {
    let folder = folder(&[("a.toml", SCENE), ("pot.obj", POT)]);
    let loaded = load(&folder.path().join("a.toml")).unwrap();
    assert!(loaded.warnings.iter().any(|warning| warning.contains("pot.mtl")), "{:?}", loaded.warnings);
    assert!(covered(&loaded, Renderer::Raytrace) > 50);
}

#[test]
fn a_missing_mesh_is_an_error_at_the_line_that_names_it() {
    let folder = folder(&[("a.toml", SCENE)]);
    let error = load(&folder.path().join("a.toml")).unwrap_err();
    assert_eq!((error.line, error.column), (Some(6), Some(7)), "{error}");
    assert!(error.problem.contains("pot.obj"), "{error}");
}

#[test]
fn a_fault_in_a_mesh_has_the_line_of_the_mesh() {
    let folder = folder(&[("a.toml", SCENE), ("pot.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 9\n")]);
    let error = load(&folder.path().join("a.toml")).unwrap_err();
    assert!(error.file.ends_with("pot.obj") && error.line == Some(4), "{error}");
}

#[test]
fn a_scene_that_names_itself_as_its_mesh_is_refused() {
    let folder = folder(&[("a.toml", &SCENE.replace("pot.obj", "a.toml"))]);
    let error = load(&folder.path().join("a.toml")).unwrap_err();
    assert_eq!((error.line, error.column), (Some(6), Some(7)), "{error}");
    assert!(error.remedy.contains(".obj"), "{error}");
}

#[test]
fn folders_devices_and_other_kinds_of_file_are_refused() {
    let folder = folder(&[("a.txt", SCENE)]);
    fs::create_dir(folder.path().join("b.toml")).unwrap();
    for path in [folder.path().join("a.txt"), folder.path().join("b.toml"), folder.path().join("none.obj")] {
        assert!(load(&path).is_err(), "{}", path.display());
    }
}

#[cfg(unix)]
#[test]
fn a_file_that_never_ends_is_refused() {
    let folder = folder(&[("a.toml", SCENE)]);
    std::os::unix::fs::symlink("/dev/zero", folder.path().join("pot.obj")).unwrap();
    let error = load(&folder.path().join("a.toml")).unwrap_err();
    assert!(error.problem.contains("not a file"), "{error}");
}

#[test]
fn text_that_is_not_utf8_is_an_error_at_its_line() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("a.toml");
    fs::write(&path, [SCENE.as_bytes(), b"# \xff\n"].concat()).unwrap();
    let error = load(&path).unwrap_err();
    assert_eq!((error.line, error.column), (Some(9), Some(3)), "{error}");
}

/// A lopsided box as a bare mesh, its corners scaled and then moved.
fn box_text(scale: f64, offset: f64) -> String {
    let corner = |k: u32| {
        let [x, y, z] = [k & 1, k >> 1 & 1, k >> 2 & 1].map(f64::from);
        format!(
            "v {:e} {:e} {:e}\n",
            scale * 3.0 * x + offset,
            scale * 2.0 * y - 2.0 * offset,
            scale * z + offset
        )
    };
    let corners: String = (0..8).map(corner).collect();
    corners + "f 1 3 4 2\nf 5 6 8 7\nf 1 2 6 5\nf 3 7 8 4\nf 1 5 7 3\nf 2 4 8 6\n"
}

#[test]
fn a_bare_mesh_fills_the_picture_whatever_its_size_and_place() {
    let mut counts = Vec::new();
    // The last ones lie so far away that f32 could not tell their corners apart.
    for (scale, offset) in
        [(1.0, 0.0), (1e-20, 0.0), (1e20, 0.0), (1.0, 300.0), (1.0, 1e9), (1e-20, 1e-12), (1e20, 1e29)]
    {
        let folder = folder(&[("box.obj", &box_text(scale, offset))]);
        let loaded = load(&folder.path().join("box.obj")).unwrap();
        for renderer in [Renderer::ZBuffer, Renderer::Painter, Renderer::Raytrace] {
            counts.push(covered(&loaded, renderer));
        }
    }
    // 32 × 24 pixels; 86 % of a side are filled, and a box fills about half of the rectangle around it.
    let (least, most) = (*counts.iter().min().unwrap(), *counts.iter().max().unwrap());
    assert!(least > 200 && most < 600, "{counts:?}");
    // The shape is the same to the last digits of f32; only a pixel centre on an outline could change sides.
    assert!(most - least <= 3, "{counts:?}");
}

#[test]
fn a_picture_of_another_shape_loses_nothing_at_its_sides() {
    let loaded = builtin::find("exponent-strip").unwrap().load().unwrap();
    let (width, height) = loaded.scene.settings.size;
    let balls = |size| {
        let settings = Settings { renderer: Renderer::ZBuffer, size, samples: 1, ..loaded.scene.settings };
        let image = render(&prepare(&loaded).unwrap(), &settings, &|_| ()).unwrap().image;
        // Along the middle row, so many times a ball begins.
        let row: Vec<bool> =
            (0..size.0).map(|i| image.get(i, size.1 / 2) != loaded.scene.background).collect();
        (!row[0] && !row[row.len() - 1], row.windows(2).filter(|pair| !pair[0] && pair[1]).count())
    };
    for size in [(width, height), (160, 120), (300, 300), (100, 400), (800, 60)] {
        assert_eq!(balls(size), (true, 6), "{size:?}");
    }
}

#[test]
fn flat_meshes_are_seen_from_where_they_are_not_a_line() {
    // Planes whose normals are x, y, z, and one that holds the first viewing direction (0.55, 0.4, 1).
    for corners in [
        "v 5 0 0\nv 5 3 0\nv 5 0 2\n",
        "v 0 5 0\nv 3 5 0\nv 0 5 2\n",
        "v 0 0 5\nv 3 0 5\nv 0 2 5\n",
        "v 0 0 0\nv 0.55 0.4 1\nv 1.1 -0.4 0\n",
    ] {
        let folder = folder(&[("flat.obj", &format!("{corners}f 1 2 3\n"))]);
        let loaded = load(&folder.path().join("flat.obj")).unwrap();
        for renderer in [Renderer::ZBuffer, Renderer::Painter, Renderer::Raytrace] {
            assert!(covered(&loaded, renderer) > 40, "{corners} {renderer}: {}", covered(&loaded, renderer));
        }
    }
}

#[test]
fn a_mesh_in_one_point_is_an_error() {
    let folder = folder(&[("point.obj", "v 3 1 2\nv 3 1 2\nv 3 1 2\nf 1 2 3\n")]);
    let error = load(&folder.path().join("point.obj")).unwrap_err();
    assert!(error.problem.contains("one point"), "{error}");
}

#[test]
fn a_line_of_triangles_is_drawn_as_nothing_and_said_to_be() {
    let folder = folder(&[("line.obj", "v 0 0 0\nv 1 2 3\nv 2 4 6\nf 1 2 3\n")]);
    let loaded = load(&folder.path().join("line.obj")).unwrap();
    for renderer in [Renderer::ZBuffer, Renderer::Painter, Renderer::Raytrace] {
        assert_eq!(covered(&loaded, renderer), 0);
        let settings = Settings { renderer, size: (16, 12), ..loaded.scene.settings };
        let notes = render(&prepare(&loaded).unwrap(), &settings, &|_| ()).unwrap().notes;
        assert!(notes.iter().any(|note| note.contains("every pixel is background")), "{notes:?}");
    }
}

#[test]
fn the_scene_around_a_bare_mesh_can_be_written_beside_it_and_read_again() {
    let folder = folder(&[("box.obj", &box_text(1e3, 7e3))]);
    let loaded = load(&folder.path().join("box.obj")).unwrap();
    fs::write(folder.path().join("box.toml"), loaded.scene.to_toml()).unwrap();
    let again = load(&folder.path().join("box.toml")).unwrap();
    assert_eq!(again.scene, loaded.scene);
    assert_eq!(picture(&again, Renderer::Raytrace), picture(&loaded, Renderer::Raytrace));
}

#[test]
fn every_built_in_scene_is_read_and_drawn_by_every_renderer() {
    for built_in in builtin::all() {
        let loaded = built_in.load().unwrap_or_else(|error| panic!("{error}"));
        assert_eq!(loaded.warnings, Vec::<String>::new());
        for renderer in [Renderer::ZBuffer, Renderer::Painter, Renderer::Raytrace] {
            let count = covered(&loaded, renderer);
            assert!(count > 100, "{} by {renderer}: {count} of 768 pixels", built_in.name);
        }
    }
}

#[test]
fn the_closed_cornell_box_loses_not_one_ray() {
    let mut loaded = builtin::find("cornell-box").unwrap().load().unwrap();
    // The sixth wall, with the corners of the other five. The floor's right edge and the ceiling's differ by 3.2 mm in the
    // measurement, so the left wall is not a rectangle and neither is this one.
    let front = [[552.8, 0.0, 0.0], [556.0, 548.8, 0.0], [0.0, 548.8, 0.0], [0.0, 0.0, 0.0]];
    let mut wall = loaded.scene.objects[0].clone();
    wall.shape = Shape::Polygons { polygons: vec![front.map(glam::Vec3::from).to_vec()] };
    loaded.scene.objects.push(wall);
    let camera = &mut loaded.scene.camera;
    camera.lens = scene::Lens::FieldOfView { degrees: 100.0, near: Some(-1.0), far: Some(-2000.0) };
    for (eye, target) in
        [([278.0, 273.0, 100.0], [278.0, 273.0, 559.0]), ([100.0, 400.0, 200.0], [300.0, 0.0, -100.0])]
    {
        (loaded.scene.camera.eye, loaded.scene.camera.target) = (eye.into(), target.into());
        let prepared = prepare(&loaded).unwrap();
        for renderer in [Renderer::Raytrace, Renderer::ZBuffer] {
            let settings =
                Settings { renderer, size: (1024, 1024), show: Show::Depth, ..loaded.scene.settings };
            let image = render(&prepared, &settings, &|_| ()).unwrap().image;
            let lost = image.pixels().iter().filter(|pixel| **pixel == canvas::Rgb::ZERO).count();
            assert_eq!(lost, 0, "{renderer} from {eye:?}");
        }
    }
}
