//! `cargo lab render`: scenes and meshes become pictures.

use canvas::{Image, Rgb};

use crate::desk::{Desk, MESH, is_there};

/// The part of a picture that is `width` pixels wide and begins at column `left`.
fn cut(picture: &Image, left: u32, width: u32) -> Image {
    Image::from_fn(width, picture.height(), |i, j| picture.get(left + i, j))
}

#[test]
fn without_a_scene_the_teapot_is_drawn_by_all_three() {
    let desk = Desk::new();
    let said = desk.lab("render --size 40x30").done();
    assert_eq!(desk.files(), ["teapot.png"]);
    let picture = desk.picture("teapot.png");
    assert_eq!((picture.width(), picture.height()), (3 * 40 + 2 * 8, 30));
    for words in
        ["painter ", "zbuffer ", "raytrace ", "40 × 30", "teapot.png: 136 × 30", "painter, zbuffer, raytrace"]
    {
        assert!(said.out.contains(words), "no {words:?} in {}", said.out);
    }
}

#[test]
fn painter_zbuffer_and_raytrace_stand_from_left_to_right() {
    let desk = Desk::new();
    desk.lab("render two-spheres --size 40x30 -o all.png").done();
    let all = desk.picture("all.png");
    for (place, renderer) in ["painter", "zbuffer", "raytrace"].into_iter().enumerate() {
        desk.lab(&format!("render two-spheres --size 40x30 --renderer {renderer} -o one.png")).done();
        assert_eq!(cut(&all, 48 * place as u32, 40), desk.picture("one.png"), "{renderer}");
    }
    let gap = cut(&all, 40, 8);
    assert!(gap.pixels().iter().all(|color| *color == gap.get(0, 0)), "the gap has one colour");
}

#[test]
fn renderers_can_be_told_apart_side_by_side() {
    // What only one of them does shows where it stands: shadows are the ray tracer's.
    let desk = Desk::new();
    desk.lab("render floating-bin --size 60x45 -o lit.png --no-shadows").done();
    desk.lab("render floating-bin --size 60x45 -o shadow.png").done();
    let (lit, shadow) = (desk.picture("lit.png"), desk.picture("shadow.png"));
    assert_eq!(cut(&lit, 0, 128), cut(&shadow, 0, 128), "painter and zbuffer draw no shadows");
    assert_ne!(cut(&lit, 136, 60), cut(&shadow, 136, 60), "raytrace does");
}

#[test]
fn a_bare_mesh_is_drawn_wherever_it_lies() {
    let desk = Desk::new();
    std::fs::create_dir(desk.path("meshes")).unwrap();
    desk.put("meshes/stone.obj", MESH);
    desk.lab("render meshes/stone.obj --size 40x30 --shading flat").done();
    assert_eq!(desk.files(), ["meshes", "stone.png"], "the picture comes to the current folder");
    let picture = desk.picture("stone.png");
    for left in [0, 48, 96] {
        let one = cut(&picture, left, 40);
        let covered = one.pixels().iter().filter(|color| **color != one.get(0, 29)).count();
        assert!(covered > 40 * 30 / 10, "{covered} pixels of the mesh in the picture at {left}");
    }
}

#[test]
fn what_can_be_borne_is_a_warning_on_standard_error() {
    let desk = Desk::new();
    desk.put("stone.obj", format!("mtllib nowhere.mtl\n{MESH}"));
    let said = desk.lab("render stone.obj --size 40x30 --renderer zbuffer");
    assert_eq!(said.code, Some(0));
    assert!(said.err.starts_with("warning: ") && said.err.contains("nowhere.mtl"), "{}", said.err);
    assert!(is_there(&desk.path("stone.png")));
}

#[test]
fn settings_come_from_the_scene_unless_given() {
    let desk = Desk::new();
    desk.put("mine.toml", desk.lab("scenes teapot").done().out);
    desk.lab("render mine.toml --renderer zbuffer -o own.png").done();
    desk.lab("render teapot --renderer zbuffer -o built-in.png").done();
    assert_eq!(desk.bytes("own.png"), desk.bytes("built-in.png"));
    assert!(desk.picture("own.png").width() > 100, "the scene's own size");
    desk.lab("render mine.toml --renderer zbuffer --size 17x13 -o own.png").done();
    let picture = desk.picture("own.png");
    assert_eq!((picture.width(), picture.height()), (17, 13));
}

#[test]
fn every_flag_changes_the_picture() {
    let desk = Desk::new();
    let base = "render glass-and-mirror --renderer raytrace --size 48x36 -o";
    desk.lab(&format!("{base} base.png")).done();
    for flag in [
        "--max-depth 0",
        "--samples 3",
        "--show depth",
        "--show normals",
        "--show barycentric",
        "--show overdraw",
        "--no-shadows",
        "--renderer zbuffer",
    ] {
        desk.lab(&format!("{base} other.png {flag}")).done();
        assert_ne!(desk.bytes("base.png"), desk.bytes("other.png"), "{flag}");
    }
    for renderer in ["zbuffer", "raytrace"] {
        let base = format!("render teapot --renderer {renderer} --size 48x36 -o");
        let pictures = ["flat", "gouraud", "phong"].map(|shading| {
            desk.lab(&format!("{base} {shading}.png --shading {shading}")).done();
            desk.bytes(&format!("{shading}.png"))
        });
        let [flat, gouraud, phong] = pictures;
        assert!(flat != gouraud && gouraud != phong && phong != flat, "{renderer}");
    }
}

#[test]
fn every_renderer_shows_every_property() {
    let desk = Desk::new();
    for show in ["color", "depth", "normals", "barycentric", "overdraw"] {
        desk.lab(&format!("render teapot --size 24x18 --show {show} -o {show}.png")).done();
        let picture = desk.picture(&format!("{show}.png"));
        for left in [0, 32, 64] {
            let one = cut(&picture, left, 24);
            assert!(
                one.pixels().iter().any(|color| *color != one.get(0, 17)),
                "{show} at {left} shows something"
            );
        }
    }
}

#[test]
fn the_number_of_threads_changes_no_byte() {
    let desk = Desk::new();
    for scene in ["teapot", "glass-and-mirror"] {
        let bytes = [1, 2, 5].map(|threads| {
            desk.lab(&format!(
                "render {scene} --size 61x47 --samples 2 --threads {threads} -o {threads}.exr"
            ))
            .done();
            desk.bytes(&format!("{threads}.exr"))
        });
        assert!(bytes[0] == bytes[1] && bytes[1] == bytes[2], "{scene}");
    }
}

#[test]
fn the_loops_of_the_slides_draw_the_same_picture() {
    let desk = Desk::new();
    // The slide's ray tracer asks every triangle of the teapot for every pixel.
    for (scene, size) in [("teapot", "12x9"), ("two-spheres", "40x30")] {
        for (r, renderer) in ["zbuffer", "painter", "raytrace"].into_iter().enumerate() {
            for (s, shading) in ["flat", "gouraud", "phong"].into_iter().enumerate() {
                // By day each renderer and each shading once, at night every pair.
                if r != s && testkit::effort(true, false) {
                    continue;
                }
                let render =
                    format!("render {scene} --renderer {renderer} --shading {shading} --size {size}");
                desk.lab(&format!("{render} -o fast.png")).done();
                desk.lab(&format!("{render} --slide -o slide.png")).done();
                // Colours differ by rounding only; that can carry one over the border between two steps of a file.
                desk.lab("compare fast.png slide.png --tolerance 1/255").done();
            }
        }
    }
}

#[test]
fn the_extension_chooses_the_format() {
    let desk = Desk::new();
    for name in ["a.png", "a.16.png", "a.exr", "B.PNG"] {
        desk.lab(&format!("render two-spheres --renderer zbuffer --size 40x30 -o {name}")).done();
    }
    let (exr, deep, shallow) = (desk.picture("a.exr"), desk.picture("a.16.png"), desk.picture("a.png"));
    let furthest = |other: &Image| {
        let apart = |(a, b): (&Rgb, &Rgb)| (a.clamp(Rgb::ZERO, Rgb::ONE) - *b).abs().max_element();
        exr.pixels().iter().zip(other.pixels()).map(apart).fold(0.0, f32::max)
    };
    // Half a step of the file, in light: the sRGB curve is nowhere steeper than 2.4 for the inverse, at white.
    assert!(furthest(&deep) <= 2.4 * 0.5 / 65535.0 + 1e-6);
    assert!(furthest(&shallow) <= 2.4 * 0.5 / 255.0 + 1e-6);
    assert!(furthest(&shallow) > furthest(&deep));
    assert_eq!(desk.bytes("a.png"), desk.bytes("B.PNG"));
}

#[test]
fn damaged_scenes_and_meshes_end_in_an_error_or_a_picture() {
    let desk = Desk::new();
    let scene = desk.lab("scenes teapot").done().out;
    let inputs = [("scene.toml", scene.as_str()), ("mesh.obj", MESH)];
    for (name, text) in inputs {
        for seed in 1_usize..=8 {
            let mut bytes = text.as_bytes().to_vec();
            let place = seed * 7919 % bytes.len();
            match seed % 3 {
                0 => bytes.truncate(place),
                1 => bytes[place] ^= 1 << (seed % 8),
                _ => drop(bytes.splice(place..place, *b" 99999999999999999999 ")),
            }
            desk.put(name, &bytes);
            let said = desk.lab(&format!("render {name} --size 16x12 -o out.png"));
            match said.code {
                Some(0) => assert!(is_there(&desk.path("out.png")), "{name} {seed}"),
                _ => drop(said.refused(&[name])),
            }
        }
    }
}
