//! Each fault of a scene file is found where it is, and said so that it can be mended.

use scene::Scene;

/// A scene without a fault; line 2 is that of the eye.
const GOOD: &str = "[camera]
eye = [1, 2, 8]
target = [0, 0.5, 0]
fov = 40
[material.red]
diffuse = [0.7, 0.1, 0.05]
[[light]]
kind = \"point\"
position = [3, 9, 4]
[[object]]
shape = \"torus\"
major = 2
minor = 0.5
material = \"red\"
";

/// Line 2 of [`GOOD`] without a fault becomes `line`, and so on: what is replaced, by what, and what must be said where.
type Fault = (&'static str, &'static str, (usize, usize), &'static str, &'static str);

const FAULTS: &[Fault] = &[
    // Keys.
    ("eye =", "eey =", (2, 1), "unknown key `camera.eey`", "did you mean `eye`?"),
    ("[[light]]", "[[lights]]", (7, 3), "unknown key `lights`", "did you mean `light`?"),
    ("major = 2", "mayor = 2", (12, 1), "unknown key `object[0].mayor`", "did you mean `major`?"),
    (
        "major = 2",
        "colour = 2",
        (12, 1),
        "unknown key `object[0].colour`",
        "the keys here are shape, level, major",
    ),
    ("target = [0, 0.5, 0]", "", (1, 1), "`camera.target` is missing", "target = [x, y, z]"),
    ("fov = 40", "", (1, 1), "`camera.fov` is missing", "fov = 40"),
    ("major = 2", "", (10, 1), "`object[0].major` is missing", "major = 2"),
    ("eye = [1, 2, 8]", "eye = [1, 2, 8]\neye = [1, 2, 9]", (3, 1), "duplicate key", "TOML"),
    // Types and numbers.
    ("[1, 2, 8]", "\"here\"", (2, 7), "`camera.eye` is \"here\"", "three numbers"),
    ("[1, 2, 8]", "[1, 2]", (2, 7), "`camera.eye` is [1, 2]", "three numbers"),
    ("[1, 2, 8]", "[1, nan, 8]", (2, 11), "`camera.eye[1]` is nan", "a finite number"),
    ("[1, 2, 8]", "[1, 2, -inf]", (2, 14), "`camera.eye[2]` is -inf", "a finite number"),
    ("[1, 2, 8]", "[1, 2, 1e400]", (2, 14), "`camera.eye[2]` is 1e400", "a finite number"),
    ("[1, 2, 8]", "[1, 2, 1e12]", (2, 14), "`camera.eye[2]` is 1e12", "at most 1e9"),
    ("[1, 2, 8]", "[1, 2, true]", (2, 14), "`camera.eye[2]` is true", "a number"),
    ("[1, 2, 8]", "[1, 2, 8", (3, 1), "missing comma", "TOML"),
    // Camera.
    ("fov = 40", "fov = 0", (4, 7), "`camera.fov` is 0", "between 0 and 180"),
    ("fov = 40", "fov = 180", (4, 7), "`camera.fov` is 180", "between 0 and 180"),
    ("fov = 40", "fov = 40\nnear = 0.1", (5, 8), "near = 0.1 must be negative", "write near = -0.1"),
    (
        "fov = 40",
        "fov = 40\nnear = -2\nfar = -1",
        (6, 7),
        "far = -1 must be less than near = -2",
        "far < near < 0",
    ),
    ("fov = 40", "fov = 40\nup = [-1, -1.5, -8]", (5, 6), "is parallel to the gaze", "up = [0, 1, 0]"),
    ("fov = 40", "fov = 40\nup = [0, 0, 0]", (5, 6), "the up vector is zero", "up = [0, 1, 0]"),
    ("[0, 0.5, 0]", "[1, 2, 8]", (3, 10), "the gaze direction is zero", "span a frame"),
    ("fov = 40", "fov = 40\nwindow = {}", (5, 10), "both `fov` and `window`", "choose one"),
    (
        "fov = 40",
        "window = { left = 1, right = 1, bottom = -1, top = 1 }\nnear = -1\nfar = -9",
        (4, 10),
        "left = 1 must be less than right = 1",
        "left < right",
    ),
    (
        "fov = 40",
        "window = { left = -1, right = 1, bottom = -1, top = 1 }\nnear = -1",
        (1, 1),
        "`camera.far` is missing",
        "both negative",
    ),
    // Materials and lights.
    ("0.05]", "-0.05]", (6, 11), "`material.red.diffuse` is [0.7, 0.1, -0.05]", "cannot be negative"),
    ("0.05]", "1.05]", (6, 11), "`material.red.diffuse` is [0.7, 0.1, 1.05]", "at most 1"),
    ("0.05]", "0.05]\nexponent = -3", (7, 12), "`material.red.exponent` is -3", "from 0 to"),
    ("0.05]", "0.05]\nexponent = nan", (7, 12), "`material.red.exponent` is nan", "a finite number"),
    (
        "0.05]",
        "0.05]\nexponent = 1e6",
        (7, 12),
        "`material.red.exponent` is 1e6",
        "from 0 to 4096: above that the highlight, computed in f32, is off by half a step",
    ),
    ("0.05]", "0.05]\nopacity = 1.5", (7, 11), "`material.red.opacity` is 1.5", "from 0, invisible, to 1"),
    ("0.05]", "0.05]\nmirror = 1\nopacity = 0.5", (8, 11), "`opacity` stands beside", "choose one"),
    ("0.05]", "0.05]\nmirror = 1.5", (7, 10), "`material.red.mirror` is 1.5", "at most 1"),
    ("0.05]", "0.05]\nglass = { index = 0.5 }", (7, 19), "`material.red.glass.index` is 0.5", "from 1 to"),
    (
        "0.05]",
        "0.05]\nmirror = 1\nglass = { index = 1.5 }",
        (8, 9),
        "both `mirror` and `glass`",
        "choose one",
    ),
    ("0.05]", "0.05]\n[material.red]\ndiffuse = 0.5", (7, 11), "duplicate key", "TOML"),
    ("\"red\"", "\"rad\"", (14, 12), "there is no material \"rad\"", "did you mean \"red\"?"),
    ("\"red\"", "\"marble\"", (14, 12), "there is no material \"marble\"", "define it"),
    ("\"point\"", "\"spot\"", (8, 8), "\"spot\" is no kind of light", "kind = \"point\""),
    (
        "kind = \"point\"\nposition",
        "kind = \"directional\"\nto-light = [0, 0, 0]\n# ",
        (9, 12),
        "`light[0].to-light` is [0, 0, 0]",
        "must not be 0",
    ),
    // Objects.
    ("\"torus\"", "\"tourus\"", (11, 9), "\"tourus\" is no shape", "did you mean \"torus\"?"),
    ("minor = 0.5", "minor = 2.5", (13, 9), "`object[0].minor` is 2.5", "less than major"),
    ("minor = 0.5", "minor = 0.5\nlevel = 8", (14, 9), "`object[0].level` is 8", "from 0 to 7"),
    ("minor = 0.5", "minor = 0.5\nlevel = 1.5", (14, 9), "`object[0].level` is 1.5", "a whole number"),
    ("minor = 0.5", "minor = 0.5\nobj = \"a.obj\"", (10, 1), "more than one shape", "one of"),
    ("minor = 0.5", "minor = 0.5\ntransforms = [{ scale = 0 }]", (14, 25), "is 0", "factors other than 0"),
    (
        "minor = 0.5",
        "minor = 0.5\ntransforms = [{ rotate = 30 }]",
        (14, 15),
        "`object[0].transforms[0].axis` is missing",
        "axis = [0, 1, 0]",
    ),
    (
        "minor = 0.5",
        "minor = 0.5\ntransforms = [{ rotate = 3, axis = [0, 1, 0], scale = 2 }]",
        (14, 15),
        "one thing at a time",
        "{ scale = 2 }",
    ),
    (
        "minor = 0.5",
        "minor = 0.5\ninstances = []",
        (14, 13),
        "`object[0].instances` is []",
        "leave the key out",
    ),
    // Settings.
    (
        "[camera]",
        "render = { size = [0, 480] }\n[camera]",
        (1, 20),
        "`render.size[0]` is 0",
        "from 1 to 16384",
    ),
    (
        "[camera]",
        "render = { size = [640, 20000] }\n[camera]",
        (1, 25),
        "`render.size[1]` is 20000",
        "from 1 to 16384",
    ),
    (
        "[camera]",
        "render = { size = [16384, 16384] }\n[camera]",
        (1, 19),
        "`render.size` is [16384, 16384]",
        "at most 67108864",
    ),
    ("[camera]", "render = { samples = 17 }\n[camera]", (1, 22), "`render.samples` is 17", "from 1 to 16"),
    (
        "[camera]",
        "render = { max-depth = 65 }\n[camera]",
        (1, 24),
        "`render.max-depth` is 65",
        "from 0 to 64",
    ),
    (
        "[camera]",
        "render = { shading = \"gourand\" }\n[camera]",
        (1, 22),
        "is no shading",
        "did you mean \"gouraud\"?",
    ),
    (
        "[camera]",
        "render = { depth-bits = 20 }\n[camera]",
        (1, 25),
        "`render.depth-bits` is 20",
        "16, 24 or 32",
    ),
];

#[test]
fn the_scene_without_a_fault_is_read() {
    assert_eq!(Scene::from_toml(GOOD, "good.toml").map(|scene| scene.objects.len()), Ok(1));
}

#[test]
fn every_fault_is_found_at_its_line_and_column_with_a_remedy() {
    for (good, bad, place, problem, remedy) in FAULTS {
        assert!(GOOD.contains(good), "the good scene has no {good:?} that could go wrong");
        let text = GOOD.replacen(good, bad, 1);
        let error = Scene::from_toml(&text, "bad.toml").expect_err(bad);
        assert_eq!((error.line, error.column), (Some(place.0), Some(place.1)), "{bad:?}: {error}");
        assert!(error.problem.contains(problem), "{bad:?}: {error}");
        assert!(error.remedy.contains(remedy), "{bad:?}: {error}");
    }
}

#[test]
fn columns_count_characters_and_not_bytes() {
    let text = GOOD.replace("fov = 40", "\"é\" = 1");
    let error = Scene::from_toml(&text, "é.toml").unwrap_err();
    assert_eq!((error.line, error.column), (Some(4), Some(1)));
    let text = GOOD.replace("eye = [1, 2, 8]", "eye = [\"éé\", nan, 8]");
    let error = Scene::from_toml(&text, "é.toml").unwrap_err();
    assert_eq!((error.line, error.column), (Some(2), Some(8)), "{error}");
}

#[test]
fn more_triangles_than_memory_holds_are_refused_before_they_are_built() {
    // A torus of level 7 has 64 · 2^14 = 1,048,576 triangles; 48 copies of it are more than 50 million.
    let copies = "[{ translate = [0, 1, 0] }],".repeat(48);
    let text = GOOD.replace("minor = 0.5", &format!("minor = 0.5\nlevel = 7\ninstances = [{copies}]"));
    let error = Scene::from_toml(&text, "many.toml").unwrap_err();
    assert!(error.problem.contains("50331648 triangles"), "{error}");
    assert_eq!(error.line, Some(10));
}

#[test]
fn deep_nesting_is_an_error_and_not_an_overflow_of_the_stack() {
    let text = format!("background = {}", "[".repeat(100_000));
    assert!(Scene::from_toml(&text, "deep.toml").is_err());
}
