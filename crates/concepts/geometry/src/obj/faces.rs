//! How does each face of the file become triangles? Cut as [`crate::polygon`] does it.

use glam::DVec3;

use super::message::{ObjError, Warnings};
use super::scan::Scan;
use crate::polygon::{MOST_TESTS, triangulate};

/// The triangles of all faces.
pub(super) struct Polygons {
    /// The corners of each triangle, as places in the model's lists of indices.
    pub(super) corners: Vec<[usize; 3]>,
    /// The face of each triangle.
    pub(super) faces: Vec<usize>,
}

/// Cuts every face of `model` into triangles.
///
/// # Errors
/// If concave faces are so large that it would take too long.
pub(super) fn cut(model: &tobj::Mesh, scan: &Scan, warnings: &mut Warnings) -> Result<Polygons, ObjError> {
    let mut polygons = Polygons { corners: Vec::new(), faces: Vec::new() };
    let mut tests_left = MOST_TESTS;
    let mut start = 0;
    for (face, about) in scan.faces.iter().enumerate() {
        // tobj lists the numbers of corners only if they are not all three.
        let arity = model.face_arities.get(face).map_or(3, |arity| *arity as usize);
        let outline = outline(model, start, arity);
        let points: Vec<DVec3> = outline.iter().map(|corner| position(model, *corner)).collect();
        let (triangles, shape) = triangulate(&points, &mut tests_left).ok_or_else(|| {
            let problem = format!("a concave face with {arity} corners takes too long to cut into triangles");
            ObjError::new(
                &scan.source,
                Some(about.line),
                problem,
                "cut it into smaller faces where it was made",
            )
        })?;
        if let Some(message) = shape.warning() {
            warnings.add(&scan.source, Some(about.line), message);
        }
        polygons.corners.extend(triangles.iter().map(|t| t.map(|k| outline[k])));
        polygons.faces.resize(polygons.corners.len(), face);
        start += arity;
    }
    Ok(polygons)
}

/// The corners of a face as places in the model's lists, without repetitions of the corner before. A triangle stays as
/// the file has it.
fn outline(model: &tobj::Mesh, start: usize, arity: usize) -> Vec<usize> {
    let corners = start..start + arity;
    if arity == 3 {
        return corners.collect();
    }
    let before = |corner: usize| {
        if corner == start { start + arity - 1 } else { corner - 1 }
    };
    corners.filter(|corner| model.indices[*corner] != model.indices[before(*corner)]).collect()
}

fn position(model: &tobj::Mesh, corner: usize) -> DVec3 {
    let first = 3 * model.indices[corner] as usize;
    DVec3::from_array(std::array::from_fn(|axis| f64::from(model.positions[first + axis])))
}
