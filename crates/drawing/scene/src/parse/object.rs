//! What stands in the scene, where, and how often? The `[[object]]` tables of a scene file.

use std::collections::BTreeMap;
use std::ops::Range;

use geometry::polygon::{MOST_TESTS, triangulate};
use geometry::shapes::GREATEST_LEVEL;
use glam::{DVec3, Vec3};
use raytrace::Surface;

use super::nearest::nearest;
use super::table::Table;
use super::value::{Value, plain};
use crate::SceneError;
use crate::limits::{LEAST_LENGTH, MOST_COPIES, MOST_TRIANGLES};
use crate::scene::{Object, Shape, Transform};

/// The subdivision level of a shape that says none: fine enough to look round in a small picture.
const LEVEL: u32 = 3;

/// Edges sharper than this stay hard where nothing else is said: `shading::CREASE_ANGLE` in degrees.
pub(crate) const CREASE_DEGREES: f32 = 60.0;

/// The names of the shapes, and the keys each has besides `level`.
const SHAPES: [(&str, &[&str]); 7] = [
    ("sphere", &["radius"]),
    ("uv-sphere", &["radius"]),
    ("icosphere", &["radius"]),
    ("box", &["size"]),
    ("torus", &["major", "minor"]),
    ("disc", &["radius"]),
    ("teapot", &[]),
];

/// The keys that every object has.
const COMMON: [&str; 4] = ["material", "transforms", "instances", "crease"];

/// What the objects so far take, and what is to be said about them.
pub(super) struct Objects {
    copies: u64,
    triangles: u64,
    /// The point-in-triangle tests that are left for cutting polygons.
    tests_left: u64,
    /// The OBJ files, and where they are named.
    pub(super) obj_paths: Vec<(String, Range<usize>)>,
    /// What is odd but can be drawn.
    pub(super) warnings: Vec<String>,
}

impl Default for Objects {
    fn default() -> Self {
        Self { copies: 0, triangles: 0, tests_left: MOST_TESTS, obj_paths: Vec::new(), warnings: Vec::new() }
    }
}

/// The object of one `[[object]]` table.
pub(super) fn object(
    value: &Value<'_>,
    materials: &BTreeMap<String, Surface>,
    so_far: &mut Objects,
) -> Result<Object, SceneError> {
    let table = value.any_table()?;
    let shape = shape(&table, so_far)?;
    let object = Object {
        shape,
        material: table.get("material").map(|name| material_name(&name, materials)).transpose()?,
        transforms: table.get("transforms").map_or(Ok(Vec::new()), |list| transforms(&list))?,
        instances: table.get("instances").map_or(Ok(Vec::new()), |list| instances(&list))?,
        crease_degrees: match table.get("crease") {
            Some(crease) => crease.number_where("from 0 to 180 degrees", |c| (0.0..=180.0).contains(&c))?,
            None => CREASE_DEGREES,
        },
    };
    so_far.spend(value, &object)?;
    Ok(object)
}

impl Objects {
    /// Counts one more object, before anything of it is built.
    fn spend(&mut self, value: &Value<'_>, object: &Object) -> Result<(), SceneError> {
        let copies = object.instances.len().max(1) as u64;
        self.copies += copies;
        self.triangles += copies * object.shape.triangle_count().unwrap_or(0);
        if self.copies > MOST_COPIES {
            let problem = format!("with this object there are {} copies", self.copies);
            return Err(value.fault(problem, format!("at most {MOST_COPIES} are drawn")));
        }
        if self.triangles > MOST_TRIANGLES {
            let problem = format!("with this object there are {} triangles", self.triangles);
            return Err(value.fault(
                problem,
                format!("at most {MOST_TRIANGLES} are drawn: lower `level` or leave out copies"),
            ));
        }
        Ok(())
    }
}

fn material_name(value: &Value<'_>, materials: &BTreeMap<String, Surface>) -> Result<String, SceneError> {
    let name = value.text()?;
    if materials.contains_key(name) {
        return Ok(name.to_owned());
    }
    let known: Vec<&str> = materials.keys().map(String::as_str).collect();
    let remedy = match nearest(name, &known) {
        Some(near) => format!("did you mean \"{}\"?", plain(near)),
        None => format!("define it: [material.{}], diffuse = [red, green, blue]", plain(name)),
    };
    Err(value.fault(format!("there is no material \"{}\"", plain(name)), remedy))
}

fn shape(table: &Table<'_>, so_far: &mut Objects) -> Result<Shape, SceneError> {
    let sources = ["shape", "polygons", "obj"].map(|key| table.get(key));
    let remedy =
        "an object has one of shape = \"teapot\", polygons = [[[x, y, z], …], …] and obj = \"file.obj\"";
    match sources {
        [Some(name), None, None] => built_in(table, &name),
        [None, Some(polygons), None] => {
            check_keys(table, &["polygons"])?;
            Ok(Shape::Polygons { polygons: self::polygons(&polygons, so_far)? })
        }
        [None, None, Some(path)] => {
            check_keys(table, &["obj", "fit"])?;
            let fit = table.get("fit").map_or(Ok(false), |fit| fit.truth())?;
            let name = obj_path(&path)?;
            so_far.obj_paths.push((name.clone(), path.span()));
            Ok(Shape::Obj { path: name, fit })
        }
        [None, None, None] => Err(table.fault("the object has no shape", remedy)),
        _ => Err(table.fault("the object has more than one shape", remedy)),
    }
}

/// A shape by name, with its sizes.
fn built_in(table: &Table<'_>, name: &Value<'_>) -> Result<Shape, SceneError> {
    let word = name.text()?;
    let Some((_, sizes)) = SHAPES.iter().find(|(known, _)| *known == word) else {
        let known = SHAPES.map(|(known, _)| known);
        let remedy = nearest(word, &known).map_or_else(
            || format!("the shapes are {}", known.join(", ")),
            |near| format!("did you mean \"{near}\"?"),
        );
        return Err(name.fault(format!("\"{}\" is no shape", plain(word)), remedy));
    };
    check_keys(table, &[&["shape", "level"], *sizes].concat())?;
    let level = table.get("level").map_or(Ok(LEVEL), |level| level.whole(0..=GREATEST_LEVEL))?;
    let radius = || table.get("radius").map_or(Ok(1.0), |radius| length(&radius));
    Ok(match word {
        "sphere" => Shape::Sphere { radius: radius()?, level },
        "uv-sphere" => Shape::UvSphere { radius: radius()?, level },
        "icosphere" => Shape::Icosphere { radius: radius()?, level },
        "box" => {
            Shape::Cuboid { size: table.get("size").map_or(Ok(Vec3::ONE), |size| lengths(&size))?, level }
        }
        "torus" => torus(table, level)?,
        "disc" => Shape::Disc { radius: radius()?, level },
        _ => Shape::Teapot { level },
    })
}

fn torus(table: &Table<'_>, level: u32) -> Result<Shape, SceneError> {
    let major = length(&table.need("major", "from the axis to the middle of the tube: major = 2")?)?;
    let minor_value = table.need("minor", "the radius of the tube: minor = 0.5")?;
    let minor = length(&minor_value)?;
    if minor >= major {
        return Err(
            minor_value.must_be(format!("less than major, {major}: a thicker tube would pierce itself"))
        );
    }
    Ok(Shape::Torus { major, minor, level })
}

fn check_keys(table: &Table<'_>, own: &[&str]) -> Result<(), SceneError> {
    table.check_keys(&[own, &COMMON].concat())
}

fn length(value: &Value<'_>) -> Result<f32, SceneError> {
    value.number_where(&format!("a length of at least {LEAST_LENGTH:e}"), |length| length >= LEAST_LENGTH)
}

fn lengths(value: &Value<'_>) -> Result<Vec3, SceneError> {
    let lengths = value.vector()?;
    if lengths.min_element() >= LEAST_LENGTH {
        Ok(lengths)
    } else {
        Err(value.must_be(format!("three lengths of at least {LEAST_LENGTH:e}")))
    }
}

fn polygons(value: &Value<'_>, so_far: &mut Objects) -> Result<Vec<Vec<Vec3>>, SceneError> {
    let polygons = value.items()?;
    if polygons.is_empty() {
        return Err(value.must_be("at least one polygon, [[x, y, z], [x, y, z], [x, y, z]]"));
    }
    polygons.iter().map(|polygon| self::polygon(polygon, so_far)).collect()
}

/// One polygon, of which it is clear that it can be cut into triangles.
fn polygon(value: &Value<'_>, so_far: &mut Objects) -> Result<Vec<Vec3>, SceneError> {
    let corners: Vec<Vec3> = value.items()?.iter().map(Value::vector).collect::<Result<_, _>>()?;
    if corners.len() < 3 {
        return Err(value.must_be("at least three corners, [[x, y, z], [x, y, z], [x, y, z]]"));
    }
    let points: Vec<DVec3> = corners.iter().map(|corner| corner.as_dvec3()).collect();
    let (_, outline) = triangulate(&points, &mut so_far.tests_left).ok_or_else(|| {
        value.fault(
            format!(
                "a re-entrant polygon with {} corners takes too long to cut into triangles",
                corners.len()
            ),
            "cut it into smaller polygons",
        )
    })?;
    so_far.warnings.extend(outline.warning().map(|warning| value.said(warning)));
    Ok(corners)
}

/// The path of an OBJ file; anything else, the scene file itself for one, is refused by its name.
fn obj_path(value: &Value<'_>) -> Result<String, SceneError> {
    let path = value.text()?;
    let is_obj =
        std::path::Path::new(path).extension().is_some_and(|extension| extension.eq_ignore_ascii_case("obj"));
    if is_obj && !path.contains('\0') {
        Ok(path.to_owned())
    } else {
        Err(value.must_be("the path of a Wavefront .obj file"))
    }
}

fn instances(value: &Value<'_>) -> Result<Vec<Vec<Transform>>, SceneError> {
    let copies = value.items()?;
    if copies.is_empty() {
        return Err(value.must_be("at least one list of transforms; leave the key out for a single copy"));
    }
    copies.iter().map(transforms).collect()
}

fn transforms(value: &Value<'_>) -> Result<Vec<Transform>, SceneError> {
    value.items()?.iter().map(transform).collect()
}

fn transform(value: &Value<'_>) -> Result<Transform, SceneError> {
    let table = value.table(&["translate", "scale", "rotate", "axis"])?;
    let parts = ["translate", "scale", "rotate"].map(|key| table.get(key));
    let remedy = "write { translate = [x, y, z] }, { scale = 2 } or { rotate = 30, axis = [0, 1, 0] }";
    if parts[2].is_none()
        && let Some(axis) = table.get("axis")
    {
        return Err(axis.fault("an axis without an angle", "write { rotate = 30, axis = [0, 1, 0] }"));
    }
    match parts {
        [Some(by), None, None] => Ok(Transform::Translate(by.vector()?)),
        [None, Some(by), None] => Ok(Transform::Scale(factors(&by)?)),
        [None, None, Some(angle)] => Ok(Transform::Rotate {
            degrees: angle.number()?,
            axis: table.need("axis", "say about which axis: axis = [0, 1, 0]")?.direction()?,
        }),
        _ => Err(value.fault("a transform does one thing at a time", remedy)),
    }
}

fn factors(value: &Value<'_>) -> Result<Vec3, SceneError> {
    let factors = if value.is_list() { value.vector()? } else { Vec3::splat(value.number()?) };
    if factors.abs().min_element() >= LEAST_LENGTH {
        Ok(factors)
    } else {
        Err(value.must_be(format!(
            "factors other than 0 (at least {LEAST_LENGTH:e}): nothing is seen of what is crushed"
        )))
    }
}
