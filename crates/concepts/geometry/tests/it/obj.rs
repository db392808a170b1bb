//! OBJ and MTL text as it comes: what is read, what is refused and in which words.

use geometry::obj::{Import, ObjError, ObjMaterial, parse};
use glam::{Vec3, vec2, vec3};
use testkit::damage::{self, Random};

/// A text that uses much of the format: groups, materials, polygons, all forms of corners, both ends of indices.
const KITCHEN: &str = "\
# A table with a pot's shadow on it
mtllib kitchen.mtl
o table
v 0 0 0
v 4 0 0
v 4 0 -3
v 0 0 -3
vt 0 0
vt 1 0
vt 1 1
vt 0 1
vn 0 1 0
usemtl wood
f 1/1/1 2/2/1 3/3/1 4/4/1
g shadow
v 1.5 0.01 -1
v 3 0.01 -1.25
v 2.25 0.01 -1.5
v 2 0.01 -2.5
v 1.75 0.01 -1.5
usemtl dark
f -5 -4 -3 -2 -1
usemtl wood
f 1//1 2//1 3//1
";

const KITCHEN_MTL: &str = "\
newmtl wood
Ka 0.1 0.1 0.1
Kd 0.6 0.4 0.2
Ks 0.5 0.25 0.125
Ns 96.5
d 0.75
Ni 1.45
illum 2
newmtl dark
Kd 0.05
Tr 0.25
";

fn import(text: &str) -> Result<Import, ObjError> {
    parse(text.as_bytes(), "kitchen.obj", &mut |name| match name {
        "kitchen.mtl" => Ok(KITCHEN_MTL.into()),
        _ => Err("there is no such file".to_owned()),
    })
}

fn with_mtl(mtl: &str) -> Result<Import, ObjError> {
    parse(KITCHEN.as_bytes(), "kitchen.obj", &mut |_| Ok(mtl.into()))
}

#[test]
fn groups_become_one_mesh_with_a_material_for_each_triangle() {
    let Import { mesh, materials, warnings, .. } = import(KITCHEN).unwrap();
    let names: Vec<_> = (0..mesh.len()).map(|k| materials[mesh.material(k) as usize].name.as_str()).collect();
    // A quad gives two triangles, the pentagon three.
    assert_eq!(names, ["wood", "wood", "dark", "dark", "dark", "wood"]);
    assert_eq!(materials[0], ObjMaterial::default());
    assert_eq!(mesh.positions().len(), 9, "points are shared across groups");
    assert_eq!(mesh.triangle(0).b, vec3(4.0, 0.0, 0.0));
    assert!(warnings.is_empty(), "{warnings:?}");
}

#[test]
fn mesh_far_away_keeps_its_shape_to_the_last_digit() {
    // Coordinates of a map in metres: f32 has steps of half a metre there.
    let far = "v 5432100.125 48000.5 -7654321.25\nv 5432101.375 48000.5 -7654321.25\nv 5432100.125 48002.75 -7654320.5\nf 1 2 3\n";
    let Import { mesh, origin, .. } = import(far).unwrap();
    let corners = mesh.triangle(0).corners();
    assert_eq!(
        (corners[1] - corners[0], corners[2] - corners[0]),
        (vec3(1.25, 0.0, 0.0), vec3(0.0, 2.25, 0.75))
    );
    assert_eq!(origin + corners[0].as_dvec3(), glam::dvec3(5432100.125, 48000.5, -7654321.25));
    // Where nothing is lost nothing is moved; and a vertex of no face has no say.
    let near = "v 10 20 30\nv 12 20 30\nv 10 25 30\nv 1e30 -1e30 0\nf 1 2 3\n";
    let import = import(near).unwrap();
    assert_eq!((import.origin, import.mesh.triangle(0).a), (glam::DVec3::ZERO, vec3(10.0, 20.0, 30.0)));
}

#[test]
fn materials_say_what_the_file_says_and_nothing_else() {
    let materials = import(KITCHEN).unwrap().materials;
    let wood = ObjMaterial {
        name: "wood".to_owned(),
        ambient: Some(Vec3::splat(0.1)),
        diffuse: Some(vec3(0.6, 0.4, 0.2)),
        specular: Some(vec3(0.5, 0.25, 0.125)),
        exponent: Some(96.5),
        dissolve: Some(0.75),
        refractive_index: Some(1.45),
        illumination_model: Some(2),
    };
    assert_eq!(materials[1], wood);
    let dark = ObjMaterial {
        name: "dark".to_owned(),
        diffuse: Some(Vec3::splat(0.05)),
        dissolve: Some(0.75),
        ..ObjMaterial::default()
    };
    assert_eq!(materials[2], dark);
}

#[test]
fn corners_without_normals_have_none_and_do_not_borrow_any() {
    let mesh = import(KITCHEN).unwrap().mesh;
    assert_eq!(mesh.corner_normals(0), Some([Vec3::Y; 3]));
    assert_eq!(mesh.corner_normals(2), None);
    assert_eq!(mesh.corner_normals(5), Some([Vec3::Y; 3]));
    assert_eq!(mesh.corner_texture_coordinates(1).unwrap()[2], vec2(0.0, 1.0));
    assert_eq!(mesh.corner_texture_coordinates(2).unwrap()[2], vec2(0.0, 0.0));

    let bare = import("v 0 0 0\nv 1 0 0\nv 0 2 0\nvn 0 0 1\nf 1 2 3\n").unwrap().mesh;
    assert!(bare.normals().is_none() && bare.texture_coordinates().is_none());
}

#[test]
fn concave_face_covers_itself_and_nothing_else() {
    // The shadow is a pentagon with dents at its third and last corner; seen from above (+y) it runs anticlockwise.
    let mesh = import(KITCHEN).unwrap().mesh;
    let areas: Vec<f32> = (2..5).map(|k| 0.5 * mesh.triangle(k).cross().y).collect();
    assert!(areas.iter().all(|area| *area > 0.0), "{areas:?}");
}

#[test]
fn line_ends_and_continued_lines_do_not_matter() {
    let plain = import(KITCHEN).unwrap();
    assert_eq!(import(&KITCHEN.replace('\n', "\r\n")).unwrap(), plain);
    assert_eq!(import(&KITCHEN.replace('\n', "\r")).unwrap(), plain);
    assert_eq!(import(&KITCHEN.replace("2//1", "\\\n 2//1")).unwrap(), plain);
    assert_eq!(import(&format!("\u{feff}{KITCHEN}")).unwrap(), plain);
    assert_eq!(import(&KITCHEN.replace("v 4 0 0", "  v\t4 0 0 # the right end")).unwrap(), plain);
    assert_eq!(import(&KITCHEN.replace("v 4 0 0", "v 8 0 0 2")).unwrap(), plain, "w divides");
    assert_eq!(
        import(&KITCHEN.replace("v 4 0 0", "v 4 0 0 1 0.5 0")).unwrap(),
        plain,
        "colours are left out"
    );
}

#[test]
fn missing_material_file_is_a_warning_and_gives_the_default() {
    let import = parse(KITCHEN.as_bytes(), "kitchen.obj", &mut |_| Err("no such file".to_owned())).unwrap();
    assert!((0..import.mesh.len()).all(|k| import.mesh.material(k) == 0));
    let words: Vec<_> = import.warnings.iter().map(ToString::to_string).collect();
    assert_eq!(
        words,
        [
            "kitchen.obj:2: material file 'kitchen.mtl' cannot be read (no such file); the default is used",
            "kitchen.obj:13: no material 'wood'; the default is used",
            "kitchen.obj:21: no material 'dark'; the default is used",
        ]
    );
}

#[test]
fn what_is_left_out_is_said_once_and_counted() {
    let text = format!("{KITCHEN}l 1 2\nl 2 3\np 1\ncurv 0 1 1 2\nbanana\n");
    let words: Vec<_> = import(&text).unwrap().warnings.iter().map(ToString::to_string).collect();
    assert_eq!(words[0], "kitchen.obj:25: 'l' is left out: lines are not drawn (2 times)");
    assert_eq!(words.len(), 4);
    // A hostile file cannot fill the memory with warnings.
    let many: String = (0..10_000).map(|k| format!("word{k}\n")).collect();
    assert_eq!(import(&format!("{KITCHEN}{many}")).unwrap().warnings.len(), 101);
}

#[test]
fn names_may_hold_spaces_and_number_signs() {
    let text =
        KITCHEN.replace("kitchen.mtl", "my kitchen.mtl").replace("usemtl dark", "usemtl Material #25 ");
    let mtl = KITCHEN_MTL.replace("newmtl dark", "newmtl Material #25");
    let mut asked = Vec::new();
    let import = parse(text.as_bytes(), "kitchen.obj", &mut |name| {
        asked.push(name.to_owned());
        Ok(mtl.clone().into())
    });
    assert_eq!(asked, ["my kitchen.mtl"]);
    assert_eq!(import.unwrap().materials[2].name, "Material #25");
}

#[test]
fn several_material_files_on_one_line_are_all_read() {
    let text = KITCHEN.replace("kitchen.mtl", "first.mtl second.mtl");
    let import = parse(text.as_bytes(), "kitchen.obj", &mut |name| match name {
        "first.mtl" => Ok(b"newmtl wood".to_vec()),
        "second.mtl" => Ok(b"newmtl dark".to_vec()),
        _ => Err("no such file".to_owned()),
    })
    .unwrap();
    assert_eq!((import.materials.len(), import.warnings.len()), (3, 0));
}

/// Replaces line `line` of the kitchen by `bad` and wants an error there that says `problem`.
#[track_caller]
fn refuses(line: usize, bad: &str, problem: &str) {
    let mut lines: Vec<_> = KITCHEN.lines().collect();
    lines[line - 1] = bad;
    let error = import(&lines.join("\n")).unwrap_err();
    assert_eq!((error.file.as_str(), error.line), ("kitchen.obj", Some(line)), "{error}");
    assert!(error.problem.contains(problem), "{error}");
    assert!(!error.remedy.is_empty());
}

#[test]
fn bad_numbers_are_refused_with_their_line() {
    refuses(4, "v 0 zero 0", "'zero' is not a number");
    refuses(4, "v 0 1e999 0", "'1e999' is out of range");
    refuses(4, "v 0 -inf 0", "'-inf' is out of range");
    refuses(4, "v 0 nan 0", "'nan' is not a number");
    refuses(4, "v 0 1,5 0", "'1,5' is not a number");
    refuses(4, "v 0 0", "'v' with 2 numbers");
    refuses(4, "v 0 0 0 0 0", "'v' with 5 numbers");
    refuses(4, "v 1 2 3 0", "w = 0");
    refuses(4, "v 1e30 2 3 1e-30", "out of range");
    refuses(8, "vt", "'vt' with 0 numbers");
    refuses(12, "vn 0 1", "'vn' with 2 numbers");
}

#[test]
fn bad_faces_are_refused_with_their_line() {
    refuses(14, "f 1 2 10", "vertex 10, but the file has only 9");
    refuses(14, "f 1/5 2/1 3/1", "texture coordinate 5, but the file has only 4");
    refuses(14, "f 1//2 2//1 3//1", "normal 2, but the file has only 1");
    refuses(14, "f 1 2 -5", "vertex -5, but only 4 came before");
    refuses(3, "f 1 2 -1", "vertex -1, but only 0 came before");
    refuses(14, "f 1 2 -9223372036854775808", "vertex -9223372036854775808");
    refuses(14, "f 1 2 9223372036854775807", "vertex 9223372036854775807");
    refuses(14, "f 1 2 9223372036854775808", "not a whole number");
    refuses(14, "f 0 1 2", "vertex 0");
    refuses(14, "f 1 2", "2 corners");
    refuses(14, "f", "0 corners");
    refuses(14, "f 1 2 3.5", "'3.5' is not a whole number");
    refuses(14, "f 1 2 /3", "no vertex");
    refuses(14, "f 1/1/1/1 2 3", "more than three");
    refuses(2, "mtllib  ", "without a file");
}

#[test]
fn bad_files_are_refused_as_a_whole() {
    for (text, problem) in [("", "no vertices and no faces"), ("v 1 2 3\n", "vertices, but no faces")] {
        let error = import(text).unwrap_err();
        assert_eq!((error.line, error.problem.as_str()), (None, problem));
    }
    let error = parse(b"v 0 0 0\nv \xf0\x28 0\n", "x.obj", &mut |_| Ok(Vec::new())).unwrap_err();
    assert_eq!(
        error.to_string(),
        "x.obj:2: byte 0xf0 is not UTF-8 text; save the file as UTF-8 (a binary format is not read)"
    );
}

#[test]
fn bad_materials_are_refused_with_the_line_of_their_file() {
    for (line, bad) in [
        (3, "newmtl wood\n\nKd 0.5 red 0"),
        (2, "newmtl wood\nKd 0.5 0.5"),
        (2, "newmtl wood\nKd"),
        (2, "newmtl wood\nNs 1e999"),
        (2, "newmtl wood\nd"),
        (2, "newmtl wood\nillum two"),
        (1, "newmtl"),
        (1, "Kd 1 1 1"),
    ] {
        let error = with_mtl(bad).unwrap_err();
        assert_eq!((error.file.as_str(), error.line), ("kitchen.mtl", Some(line)), "{bad}: {error}");
    }
}

#[test]
fn material_values_out_of_range_are_left_out_with_a_warning() {
    let mtl = "newmtl wood\nKd -1 0 0\nNs -5\nd 1.5\nNi 0\nillum 99\nmap_Kd wood.png\nnewmtl dark\nKs spectral x.rfl\n";
    let import = with_mtl(mtl).unwrap();
    assert_eq!(import.materials[1], ObjMaterial { name: "wood".to_owned(), ..ObjMaterial::default() });
    assert_eq!(import.warnings.len(), 7, "{:?}", import.warnings);
}

/// Words of both formats, and pieces of them, in places where nobody expects them.
const WORDS: &[&str] = &[
    "/",
    "//",
    "1/",
    "///",
    "1//",
    "\\",
    "\\\n",
    "\r",
    "\0",
    "#",
    "f",
    "v",
    "vn 0 0 0\n",
    "usemtl",
    "mtllib",
    "newmtl",
    "Kd",
    "illum 256",
    "é",
    "\u{2028}",
    "o",
    "f 1 1 1 1 1\n",
    "f 1 2 3 2 1 3\n",
    "\n\n",
    "l 1",
    "Tr",
    "d -halo",
];

const CASES: u32 = 1000;

/// Whether a mesh comes out; if not, the error must say something.
fn gives_a_mesh(obj: &[u8], mtl: &[u8]) -> bool {
    match parse(obj, "kitchen.obj", &mut |_| Ok(mtl.to_vec())) {
        Ok(import) => {
            let count = import.materials.len() as u32;
            assert!((0..import.mesh.len()).all(|k| import.mesh.material(k) < count));
            true
        }
        Err(error) => {
            assert!(!error.problem.is_empty() && !error.remedy.is_empty(), "{error:?}");
            assert!(!error.to_string().contains("reader refuses"), "the scan missed it: {error}");
            false
        }
    }
}

/// Neither errors nor meshes are so few that the test would not see one of them.
#[track_caller]
fn assert_both_occur(gave_meshes: &[bool]) {
    let meshes = gave_meshes.iter().filter(|mesh| **mesh).count();
    let errors = gave_meshes.len() - meshes;
    assert!(errors > CASES as usize / 5 && meshes > CASES as usize / 5, "{errors} errors, {meshes} meshes");
}

#[test]
fn a_thousand_mutilated_obj_files_end_in_an_error_or_a_mesh() {
    assert_both_occur(&damage::none_hangs(CASES, |case| {
        let obj = damage::text(KITCHEN.as_bytes(), WORDS, &mut Random::new(case.into()));
        gives_a_mesh(&obj, KITCHEN_MTL.as_bytes())
    }));
}

#[test]
fn a_thousand_mutilated_mtl_files_end_in_an_error_or_a_mesh() {
    assert_both_occur(&damage::none_hangs(CASES, |case| {
        let mtl = damage::text(KITCHEN_MTL.as_bytes(), WORDS, &mut Random::new(case.into()));
        gives_a_mesh(KITCHEN.as_bytes(), &mtl)
    }));
}
