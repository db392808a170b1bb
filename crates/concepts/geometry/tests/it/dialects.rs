//! OBJ and MTL text as programs write it: where readers differ, and what this one makes of it.

use geometry::obj::{Import, ObjError, parse};
use glam::{Vec3, vec3};

/// A quadrilateral of wood, a dark triangle and a wooden one.
const TABLE: &str = "\
mtllib table.mtl
v 0 0 0
v 4 0 0
v 4 0 -3
v 0 0 -3
usemtl wood
f 1 2 3 4
usemtl dark
f 1 2 3
usemtl wood
f 2 3 4
";

const TABLE_MTL: &str = "\
newmtl wood
Kd 0.6 0.4 0.2
d 0.75
newmtl dark
Kd 0.05
";

fn import(text: &str) -> Result<Import, ObjError> {
    parse(text.as_bytes(), "table.obj", &mut |name| match name {
        "table.mtl" => Ok(TABLE_MTL.into()),
        _ => Err("there is no such file".to_owned()),
    })
}

fn with_mtl(mtl: &str) -> Result<Import, ObjError> {
    parse(TABLE.as_bytes(), "table.obj", &mut |_| Ok(mtl.into()))
}

fn warnings_of(import: &Import) -> Vec<String> {
    import.warnings.iter().map(ToString::to_string).collect()
}

#[test]
fn path_in_a_comment_does_not_swallow_the_face_below() {
    let plain = import(TABLE).unwrap();
    let comment = TABLE.replace("f 1 2 3 4", "# D:\\models\\\nf 1 2 3 4");
    let read = import(&comment).unwrap();
    assert_eq!((read.mesh, read.warnings), (plain.mesh.clone(), plain.warnings.clone()));
    assert_eq!(import(&TABLE.replace("v 4 0 0", "v 4 0 0 # C:\\")).unwrap(), plain);
    // So in a material file.
    let mtl = TABLE_MTL.replace("Kd 0.6", "# C:\\wood\\\nKd 0.6");
    assert_eq!(with_mtl(&mtl).unwrap().materials, plain.materials);
}

#[test]
fn normals_are_kept_as_the_file_says_also_where_they_are_equal() {
    let text = "vn 0.6 0 0.8\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1//1 2//1 3//1 4//1\n";
    let mesh = import(text).unwrap().mesh;
    assert_eq!(mesh.corner_normals(1), Some([vec3(0.6, 0.0, 0.8); 3]));
}

#[test]
fn usemtl_without_a_name_is_the_default_material() {
    let import = import(&TABLE.replace("usemtl dark", "usemtl")).unwrap();
    let numbers: Vec<_> = (0..import.mesh.len()).map(|k| import.mesh.material(k)).collect();
    assert_eq!(numbers, [1, 1, 0, 1]);
    assert_eq!(import.warnings, []);
}

#[test]
fn smoothing_groups_come_with_the_triangles() {
    let text = TABLE.replace("f 1 2 3 4", "s 7\nf 1 2 3 4").replace("f 2 3 4", "s off\nf 2 3 4");
    assert_eq!(import(&text).unwrap().smoothing, [Some(7), Some(7), Some(7), Some(0)]);
    let late = TABLE.replace("f 2 3 4", "s 3\nf 2 3 4");
    assert_eq!(import(&late).unwrap().smoothing, [None, None, None, Some(3)]);
    assert_eq!(import(TABLE).unwrap().smoothing, []);
    let wrong = import(&TABLE.replace("f 2 3 4", "s smooth\nf 2 3 4")).unwrap();
    assert_eq!(
        warnings_of(&wrong),
        ["table.obj:11: smoothing group 'smooth' is left out: write a number, or off"]
    );
}

#[test]
fn first_of_two_materials_with_one_name_is_used_with_a_warning() {
    let again = format!("{TABLE_MTL}newmtl wood\nKd 0 0 1\n");
    let import = with_mtl(&again).unwrap();
    assert_eq!(import.materials[import.mesh.material(0) as usize].diffuse, Some(vec3(0.6, 0.4, 0.2)));
    let warning = "material 'wood' is defined again; its first definition is used";
    assert_eq!(warnings_of(&import), [format!("table.mtl:6: {warning}")]);

    for libraries in ["first.mtl second.mtl", "first.mtl\nmtllib second.mtl"] {
        let text = TABLE.replace("table.mtl", libraries);
        let import = parse(text.as_bytes(), "table.obj", &mut |name| match name {
            "first.mtl" => Ok(b"newmtl dark\nnewmtl wood\nKd 1 0 0\n".to_vec()),
            "second.mtl" => Ok(b"newmtl wood\nKd 0 0 1\n".to_vec()),
            _ => Err("no such file".to_owned()),
        })
        .unwrap();
        assert_eq!(import.materials[import.mesh.material(0) as usize].diffuse, Some(Vec3::X));
        assert_eq!(warnings_of(&import), [format!("second.mtl:1: {warning}")]);
    }
}

#[test]
fn material_file_that_is_named_twice_defines_nothing_again() {
    let text = TABLE.replace("table.mtl", "table.mtl table.mtl");
    assert_eq!(import(&text).unwrap().warnings, []);
}

/// The dissolve of the material with these lines, and the warnings.
fn dissolve_of(lines: &str) -> (Option<f32>, Vec<String>) {
    let import = with_mtl(&format!("newmtl wood\n{lines}\nnewmtl dark\n")).unwrap();
    (import.materials[1].dissolve, warnings_of(&import))
}

#[test]
fn d_decides_where_tr_contradicts_it() {
    let contradiction = "table.mtl:3: Tr 1 contradicts d 1; d is used, since Tr should be 1 - d";
    assert_eq!(dissolve_of("d 1\nTr 1"), (Some(1.0), vec![contradiction.to_owned()]));
    assert_eq!(dissolve_of("Tr 1\nd 1"), (Some(1.0), vec![contradiction.replace(":3", ":2")]));
    // What says the same, to the digits that files have, is no contradiction.
    assert_eq!(dissolve_of("d 0.333\nTr 0.67"), (Some(0.333), vec![]));
    assert_eq!(dissolve_of("Tr 0.25"), (Some(0.75), vec![]));
    // The last material of a file counts too.
    assert_eq!(with_mtl("newmtl wood\nnewmtl dark\nd 1\nTr 1\n").unwrap().warnings.len(), 1);
}

#[test]
fn value_that_is_given_twice_is_the_last_with_a_warning() {
    let import = with_mtl("newmtl wood\nKd 1 0 0\nKd 0 1 0\nnewmtl dark\nKd 0 0 1\n").unwrap();
    assert_eq!(import.materials[1].diffuse, Some(Vec3::Y));
    assert_eq!(warnings_of(&import), ["table.mtl:3: Kd occurs again in one material; the last one is used"]);
}
