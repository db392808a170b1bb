//! How does each face of the file become triangles? It is cut by [`crate::polygon`].

use std::ops::Range;

use glam::DVec3;

use super::message::{ObjError, Warnings};
use super::scan::Scan;
use crate::polygon::{MOST_TESTS, triangulate};

/// The triangles of all faces.
pub(super) struct Polygons {
    /// The corners of each triangle, as places in the scan's lists of indices.
    pub(super) corners: Vec<[usize; 3]>,
    /// The face of each triangle.
    pub(super) faces: Vec<usize>,
}

/// Cuts every face into triangles.
///
/// # Errors
/// If concave faces are so large that it would take too long.
pub(super) fn cut(scan: &Scan, warnings: &mut Warnings) -> Result<Polygons, ObjError> {
    let mut polygons = Polygons { corners: Vec::new(), faces: Vec::new() };
    let mut tests_left = MOST_TESTS;
    for (face, about) in scan.faces.iter().enumerate() {
        let outline = outline(scan, about.corners.clone());
        let points: Vec<DVec3> = outline.iter().map(|corner| position(scan, *corner)).collect();
        let (triangles, shape) = triangulate(&points, &mut tests_left).ok_or_else(|| {
            let count = about.corners.len();
            let problem = format!("a concave face with {count} corners takes too long to cut into triangles");
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
    }
    Ok(polygons)
}

/// The corners of a face without those that repeat the corner before. A triangle stays as the file has it.
fn outline(scan: &Scan, corners: Range<usize>) -> Vec<usize> {
    if corners.len() == 3 {
        return corners.collect();
    }
    let (start, end) = (corners.start, corners.end);
    let before = |corner: usize| {
        if corner == start { end - 1 } else { corner - 1 }
    };
    let vertices = &scan.positions.indices;
    corners.filter(|corner| vertices[*corner] != vertices[before(*corner)]).collect()
}

fn position(scan: &Scan, corner: usize) -> DVec3 {
    scan.positions.values[scan.positions.indices[corner] as usize].as_dvec3()
}
