//! Which normals have faces without any? Those of the smooth surface around, as far as the file's smoothing groups go.

use std::collections::{BTreeMap, HashMap};

use geometry::{Indexed, Mesh};
use glam::Vec3;

/// The mesh with a normal at every corner. The file's own stay; where there are none, triangles of one smoothing group are
/// smooth among themselves, but for edges sharper than the crease angle, and edges between groups are hard.
///
/// - `groups`: one for each triangle, as in [`geometry::obj::Import::smoothing`]; empty where nothing is said.
/// - `crease_angle`: radians, at least 0.
pub(super) fn smooth(mesh: Mesh, groups: &[Option<u32>], crease_angle: f32) -> Mesh {
    if groups.is_empty() || has_all_normals(&mesh) {
        return shading::with_vertex_normals(mesh, crease_angle);
    }
    let mut members: BTreeMap<Option<u32>, Vec<usize>> = BTreeMap::new();
    for (k, group) in groups.iter().enumerate() {
        members.entry(*group).or_default().push(k);
    }
    let mut normals = Indexed { values: Vec::new(), triangles: vec![[0; 3]; mesh.len()] };
    for (group, triangles) in &members {
        // In group 0 nothing is smooth: with a crease angle of 0 only what lies in one plane is.
        let crease_angle = if *group == Some(0) { 0.0 } else { crease_angle };
        let own = shading::vertex_normals(&submesh(&mesh, triangles), crease_angle);
        let first = normals.values.len() as u32;
        for (k, corners) in triangles.iter().zip(&own.triangles) {
            normals.triangles[*k] = corners.map(|corner| first + corner);
        }
        normals.values.extend(own.values);
    }
    with_missing(mesh, normals)
}

fn has_all_normals(mesh: &Mesh) -> bool {
    (0..mesh.len()).all(|k| mesh.corner_normals(k).is_some())
}

/// The given triangles over their own positions only, so that many small groups stay small.
fn submesh(mesh: &Mesh, triangles: &[usize]) -> Mesh {
    let (mut positions, mut places) = (Vec::new(), HashMap::new());
    let triangles = triangles.iter().map(|k| {
        mesh.triangles()[*k].map(|index| {
            *places.entry(index).or_insert_with(|| {
                positions.push(mesh.positions()[index as usize]);
                positions.len() as u32 - 1
            })
        })
    });
    let triangles = triangles.collect();
    Mesh::new(positions, triangles).expect("a part of a mesh is a mesh")
}

/// The mesh with its own normals, and the computed ones where its own are missing.
fn with_missing(mesh: Mesh, computed: Indexed<Vec3>) -> Mesh {
    let given = mesh
        .normals()
        .cloned()
        .unwrap_or_else(|| Indexed { values: vec![Vec3::ZERO], triangles: vec![[0; 3]; mesh.len()] });
    let first = given.values.len() as u32;
    let corner = |k: usize, at: usize| {
        let own = given.triangles[k][at];
        if given.values[own as usize] == Vec3::ZERO { first + computed.triangles[k][at] } else { own }
    };
    let triangles = (0..mesh.len()).map(|k| std::array::from_fn(|at| corner(k, at))).collect();
    let values = given.values.iter().chain(&computed.values).copied().collect();
    mesh.with_normals(Indexed { values, triangles }).expect("one finite normal for each corner")
}

#[cfg(test)]
mod tests {
    use glam::vec3;

    use super::*;

    /// A ridge of two slopes that meet along the z axis at 23°: smooth for a crease angle of 60°.
    fn ridge() -> Mesh {
        let corners =
            vec![vec3(-1.0, 0.0, 0.0), vec3(0.0, 0.2, 1.0), vec3(0.0, 0.2, -1.0), vec3(1.0, 0.0, 0.0)];
        Mesh::new(corners, vec![[0, 1, 2], [3, 2, 1]]).unwrap()
    }

    /// Whether both slopes have one normal where they meet.
    fn is_smooth(mesh: &Mesh) -> bool {
        mesh.corner_normals(0).unwrap()[1] == mesh.corner_normals(1).unwrap()[2]
    }

    #[test]
    fn edges_between_groups_are_hard_and_within_a_group_smooth() {
        let smoothed = |groups: &[Option<u32>]| is_smooth(&smooth(ridge(), groups, 1.0));
        assert!(smoothed(&[]) && smoothed(&[Some(1), Some(1)]) && smoothed(&[None, None]));
        assert!(!smoothed(&[Some(1), Some(2)]) && !smoothed(&[None, Some(2)]));
        assert!(!smoothed(&[Some(0), Some(0)]), "s off");
    }

    #[test]
    fn normals_of_the_file_count_more_than_groups() {
        let up = Indexed { values: vec![Vec3::Y, Vec3::ZERO], triangles: vec![[0; 3], [1, 0, 1]] };
        let mesh = smooth(ridge().with_normals(up).unwrap(), &[Some(1), Some(2)], 1.0);
        assert_eq!(mesh.corner_normals(0), Some([Vec3::Y; 3]));
        let face = ridge().triangle(1).normal().unwrap();
        let [a, b, c] = mesh.corner_normals(1).unwrap();
        assert_eq!(b, Vec3::Y);
        assert!(a.abs_diff_eq(face, 1e-6) && c.abs_diff_eq(face, 1e-6), "{a} {c}");
    }
}
