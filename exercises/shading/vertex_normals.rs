//! Vertex normals (L39, Fig 10.4).
//!
//! Give one unit normal for each position of a mesh: the mean direction of the normals of all triangles that meet there. It
//! stands for the normal of the curved surface that the mesh approximates.
//!
//! - `positions`: the vertices of the mesh.
//! - `triangles`: three indices into `positions` each; from the front the corners run anticlockwise, and there are the normals.
//! - You may count each triangle once, or larger ones more (their area, their angle at the vertex), as long as each counts.
//! - A triangle without area has no normal: it counts for nothing.
//! - The answer has as many normals as there are positions. Where no triangle with an area meets, it is `Vec3::ZERO`.
//!
//! glam: `u.cross(v)`, `v.normalize_or_zero()`. The cross product of two edges is the normal, longer for larger triangles.

use glam::Vec3;

pub fn vertex_normals(positions: &[Vec3], triangles: &[[usize; 3]]) -> Vec<Vec3> {
    todo!()
}
