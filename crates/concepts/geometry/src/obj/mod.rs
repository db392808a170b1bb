//! How does a mesh from elsewhere come in? As Wavefront OBJ text, its materials as MTL text.
//!
//! [`parse`] tells the story: read the text line by line, so that each defect is reported with its line and a remedy (`scan`); cut
//! polygons into triangles (`faces`); look the materials up (`mtl`).
//!
//! What is read: `v` (with w; vertex colours are left out), `vt`, `vn`, `f` with any number of corners, indices from
//! either end, `usemtl` (without a name: the default material), `mtllib`, `s`, comments, continued lines, the line ends of
//! every system. All objects and groups become one mesh. Normals are kept as the file has them; smoothing groups count for
//! faces without normals only. Lines, points, curves and textures are left out with a warning.
//!
//! Of several materials with one name the first is used, with a warning.

mod faces;
mod indices;
mod material;
mod message;
mod mtl;
mod mtl_scan;
mod scan;
mod text;

pub use material::ObjMaterial;
pub use message::{ObjError, ObjWarning};

use glam::DVec3;

use crate::{Indexed, Mesh};
use message::Warnings;
use mtl::Library;
use scan::{Attribute, Scan};

/// A mesh and its materials.
#[derive(Clone, Debug, PartialEq)]
pub struct Import {
    /// All triangles of the file, in its order, its positions less [`Self::origin`]. A corner without a normal has the zero normal, so that
    /// [`Mesh::corner_normals`] gives `None` there; a corner without texture coordinates has (0, 0).
    pub mesh: Mesh,
    /// Where the file has what the mesh has at (0, 0, 0). Not zero only if the file's mesh lies farther from its origin
    /// than 64 times its size, as maps and scans do: positions are f32, which there could not tell its vertices apart.
    /// Add it in f64.
    pub origin: DVec3,
    /// The materials that [`Mesh::material`] points to. Number 0 is always the default, for faces without a material.
    pub materials: Vec<ObjMaterial>,
    /// The smoothing group (`s`) of each triangle; empty if the file has no `s` line. Edges between two groups are hard.
    /// 0 is `s off`: such a triangle is smooth with no other. `None` for triangles before the first `s`.
    pub smoothing: Vec<Option<u32>>,
    /// What was left out or replaced, in the order of the file.
    pub warnings: Vec<ObjWarning>,
}

/// Reads OBJ text. `load_mtl` is asked for the bytes of each material file that the text names; if it fails (with a
/// reason), that is a warning and the faces get the default material.
///
/// - `source`: the name of the text in messages, usually its path.
///
/// # Errors
/// [`ObjError`] with file, line, problem and remedy: text that is not UTF-8; numbers that are none, not finite or out of
/// the range of f32; faces with fewer than three corners or with indices that point nowhere; no faces at all; an MTL
/// file with such defects.
///
/// ```
/// let text = "mtllib pot.mtl\nv 0 0 0\nv 4 0 0\nv 4 3 0\nv 0 3 0\nusemtl clay\nf 1 2 3 -1\n";
/// let import = geometry::obj::parse(text.as_bytes(), "pot.obj", &mut |name| match name {
///     "pot.mtl" => Ok(b"newmtl clay\nKd 0.8 0.4 0.2\n".to_vec()),
///     other => Err(format!("no file {other}")),
/// })?;
/// assert_eq!(import.mesh.len(), 2);
/// assert_eq!(import.materials[import.mesh.material(0) as usize].name, "clay");
///
/// let error = geometry::obj::parse(b"v 0 0 0\nf 1 2 3\n", "bad.obj", &mut |_| Ok(Vec::new())).unwrap_err();
/// assert_eq!((error.file.as_str(), error.line), ("bad.obj", Some(2)));
/// # Ok::<(), geometry::obj::ObjError>(())
/// ```
pub fn parse(
    bytes: &[u8],
    source: &str,
    load_mtl: &mut dyn FnMut(&str) -> Result<Vec<u8>, String>,
) -> Result<Import, ObjError> {
    let mut warnings = Warnings::default();
    let scan = Scan::of(bytes, source, &mut warnings)?;
    let polygons = faces::cut(&scan, &mut warnings)?;
    let library = Library::load(&scan, load_mtl, &mut warnings)?;
    let numbers = library.numbers_of(&scan, &mut warnings);
    let materials =
        polygons.faces.iter().map(|face| scan.faces[*face].material.map_or(0, |used| numbers[used]));
    let materials = materials.collect();
    let (origin, smoothing) = (scan.origin, smoothing_of(&scan, &polygons.faces));
    let mesh = mesh_of(scan, &polygons.corners, materials)?;
    Ok(Import { mesh, origin, materials: library.materials, smoothing, warnings: warnings.into_vec() })
}

/// The smoothing group of each triangle, if the file has any groups. `faces` has the face of each triangle.
fn smoothing_of(scan: &Scan, faces: &[usize]) -> Vec<Option<u32>> {
    if scan.faces.iter().all(|face| face.smoothing.is_none()) {
        return Vec::new();
    }
    faces.iter().map(|face| scan.faces[*face].smoothing).collect()
}

/// The mesh whose triangles have these corners, each a place in the scan's lists of indices.
fn mesh_of(scan: Scan, corners: &[[usize; 3]], materials: Vec<u32>) -> Result<Mesh, ObjError> {
    let Indexed { values, triangles } = indexed(scan.positions, corners);
    let mut mesh = Mesh::new(values, triangles);
    if scan.has_normals {
        mesh = mesh.and_then(|mesh| mesh.with_normals(indexed(scan.normals, corners)));
    }
    if scan.has_texture {
        mesh = mesh.and_then(|mesh| mesh.with_texture_coordinates(indexed(scan.texture, corners)));
    }
    mesh.and_then(|mesh| mesh.with_materials(materials))
        .map_err(|reason| ObjError::new(&scan.source, None, reason.to_string(), "export the mesh anew"))
}

/// The values with one index for each corner of each triangle.
fn indexed<T>(attribute: Attribute<T>, corners: &[[usize; 3]]) -> Indexed<T> {
    let triangles = corners.iter().map(|triangle| triangle.map(|corner| attribute.indices[corner]));
    Indexed { triangles: triangles.collect(), values: attribute.values }
}
