//! Which normals does a triangle have, as the eye sees it?

use geometry::Triangle;
use geometry::mesh::normal_matrix;
use glam::Vec3;
use lighting::Material;

use crate::Object;

/// One triangle of an object in world space, with its normals on the side of the eye: all that shading asks about it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Facet {
    /// The corners, in the order of the mesh.
    pub corners: Triangle,
    /// The normal of the triangle itself, a unit vector.
    pub face_normal: Vec3,
    /// n₀, n₁, n₂: the unit normals at the corners (L40); the face normal where the mesh has none.
    pub corner_normals: [Vec3; 3],
    /// Its optical properties.
    pub material: Material,
}

impl Facet {
    /// Triangle `k` of `object` as an eye at `eye` (world space) sees it.
    ///
    /// **One rule turns normals to the eye**, the ray tracer's too: if the triangle's front, the side from which its corners
    /// run anticlockwise, faces away from the eye, then all its normals are negated. So both sides of a surface are lit as
    /// they should be, and the three corners never disagree about the side.
    ///
    /// Normals move with [`normal_matrix`], positive multiples of the inverse transpose: they stay perpendicular under
    /// uneven scales, and fronts stay fronts when the map mirrors.
    ///
    /// A triangle without area has no normal of its own; it takes the mean of its corners' normals or, failing that,
    /// the direction to the eye.
    ///
    /// ```
    /// use geometry::Mesh;
    /// use glam::{Mat4, Vec3, vec3};
    /// use shading::{Facet, Object};
    ///
    /// let corners = vec![vec3(0.0, 0.0, 0.0), vec3(2.0, 0.0, 0.0), vec3(0.0, 3.0, 0.0)];
    /// let mesh = Mesh::new(corners, vec![[0, 1, 2]])?;
    /// let object = Object { mesh: &mesh, world_from_object: Mat4::IDENTITY, materials: &[] };
    /// assert_eq!(Facet::new(&object, 0, vec3(1.0, 2.0, 9.0)).face_normal, Vec3::Z);
    /// assert_eq!(Facet::new(&object, 0, vec3(1.0, 2.0, -9.0)).face_normal, Vec3::NEG_Z); // seen from behind
    /// # Ok::<(), geometry::MeshError>(())
    /// ```
    ///
    /// # Panics
    /// If the mesh has no triangle `k`.
    #[must_use]
    pub fn new(object: &Object, k: usize, eye: Vec3) -> Self {
        let to_world = |p: Vec3| object.world_from_object.transform_point3(p);
        let Triangle { a, b, c } = object.mesh.triangle(k);
        let corners = Triangle { a: to_world(a), b: to_world(b), c: to_world(c) };

        let normal_matrix = normal_matrix(&object.world_from_object);
        let turned = |n: Vec3| (normal_matrix * n).try_normalize();
        let given = object
            .mesh
            .corner_normals(k)
            .and_then(|[n0, n1, n2]| Some([turned(n0)?, turned(n1)?, turned(n2)?]));
        let to_eye = eye - corners.a;
        let front = object.mesh.triangle(k).normal().and_then(turned);
        let front = front.or_else(|| given?.into_iter().sum::<Vec3>().try_normalize());
        let front = front.unwrap_or_else(|| to_eye.normalize_or(Vec3::Z));

        let side = if front.dot(to_eye) < 0.0 { -1.0 } else { 1.0 };
        Self {
            corners,
            face_normal: side * front,
            corner_normals: given.unwrap_or([front; 3]).map(|n| side * n),
            material: object.material(k),
        }
    }
}

#[cfg(test)]
mod tests {
    use geometry::{Indexed, Mesh};
    use glam::{Mat4, vec3};

    use super::*;

    fn mesh() -> Mesh {
        let normals = vec![vec3(0.0, 0.0, 1.0), vec3(0.6, 0.0, 0.8), vec3(0.0, 0.6, 0.8)];
        Mesh::new(vec![Vec3::ZERO, vec3(2.0, 0.0, 0.0), vec3(0.0, 3.0, 0.0)], vec![[0, 1, 2]])
            .and_then(|mesh| mesh.with_normals(Indexed { values: normals, triangles: vec![[0, 1, 2]] }))
            .unwrap()
    }

    #[test]
    fn all_normals_turn_to_the_eye_together() {
        let mesh = mesh();
        let object = Object { mesh: &mesh, world_from_object: Mat4::IDENTITY, materials: &[] };
        let before = Facet::new(&object, 0, vec3(9.0, 1.0, 0.5));
        let behind = Facet::new(&object, 0, vec3(9.0, 1.0, -0.5));
        assert_eq!(before.corner_normals.map(|n| -n), behind.corner_normals);
        // From behind and far to the side, the second normal points away from the eye and yet stays with the others.
        assert!(behind.corner_normals[1].dot(vec3(9.0, 1.0, -0.5) - behind.corners.b) < 0.0);
    }

    #[test]
    fn a_mirror_keeps_fronts_fronts_and_an_uneven_scale_keeps_normals_perpendicular() {
        let mesh = mesh();
        let mirror = Mat4::from_scale(vec3(-2.0, 1.0, 5.0)) * Mat4::from_rotation_y(0.4);
        let object = Object { mesh: &mesh, world_from_object: mirror, materials: &[] };
        let moved = mesh.transformed(&mirror).unwrap();
        let moved_object = Object { mesh: &moved, world_from_object: Mat4::IDENTITY, materials: &[] };
        for eye in [vec3(1.0, 2.0, 9.0), vec3(1.0, 2.0, -9.0)] {
            let (ours, theirs) = (Facet::new(&object, 0, eye), Facet::new(&moved_object, 0, eye));
            assert!(ours.face_normal.abs_diff_eq(theirs.face_normal, 1e-6));
            assert!(ours.face_normal.dot(ours.corners.b - ours.corners.a).abs() < 1e-5);
            // The mirrored mesh runs round the other way: its second corner is our third.
            assert!(ours.corner_normals[1].abs_diff_eq(theirs.corner_normals[2], 1e-6));
        }
    }

    #[test]
    fn a_triangle_without_area_has_unit_normals_all_the_same() {
        let line = vec![Vec3::ZERO, vec3(1.0, 2.0, 3.0), vec3(2.0, 4.0, 6.0)];
        let mesh = Mesh::new(line, vec![[0, 1, 2]]).unwrap();
        let object = Object { mesh: &mesh, world_from_object: Mat4::IDENTITY, materials: &[] };
        for eye in [Vec3::ZERO, vec3(3.0, 0.0, 4.0)] {
            let facet = Facet::new(&object, 0, eye);
            assert!((facet.face_normal.length() - 1.0).abs() < 1e-6, "{facet:?}");
        }
    }
}
