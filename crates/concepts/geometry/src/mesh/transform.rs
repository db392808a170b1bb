//! Where does a mesh go under an affine map, and where do its normals point then?

use glam::{Mat3, Mat4};

use super::{Indexed, Mesh, MeshError};

impl Mesh {
    /// The mesh moved by an affine map. Normals turn with the inverse transpose; a map that mirrors also turns each
    /// triangle's order round, so that fronts stay fronts.
    ///
    /// # Errors
    /// [`MeshError::NotFinite`] if a coordinate overflows.
    pub fn transformed(&self, target_from_source: &Mat4) -> Result<Self, MeshError> {
        let mirrored = scaled_linear_part(target_from_source).determinant() < 0.0;
        let turn = |t: &[u32; 3]| if mirrored { [t[0], t[2], t[1]] } else { *t };
        let turn_all = |triangles: &[[u32; 3]]| triangles.iter().map(turn).collect::<Vec<_>>();

        let positions = self.positions.iter().map(|p| target_from_source.transform_point3(*p)).collect();
        let mut mesh = Self::new(positions, turn_all(&self.triangles))?;
        if let Some(normals) = &self.normals {
            let normal_matrix = normal_matrix(target_from_source);
            let values = normals.values.iter().map(|n| (normal_matrix * *n).normalize_or_zero()).collect();
            mesh = mesh.with_normals(Indexed { values, triangles: turn_all(&normals.triangles) })?;
        }
        if let Some(uv) = &self.texture_coordinates {
            mesh = mesh.with_texture_coordinates(Indexed {
                values: uv.values.clone(),
                triangles: turn_all(&uv.triangles),
            })?;
        }
        mesh.materials.clone_from(&self.materials);
        Ok(mesh)
    }
}

/// The matrix that turns normals when `target_from_source` moves points: a positive multiple of its inverse transpose.
///
/// The cofactor matrix is that multiple (times the sign of the determinant) and exists for singular maps too. Results
/// have no unit length: normalize them.
#[must_use]
pub fn normal_matrix(target_from_source: &Mat4) -> Mat3 {
    let m = scaled_linear_part(target_from_source);
    let cofactors =
        Mat3::from_cols(m.y_axis.cross(m.z_axis), m.z_axis.cross(m.x_axis), m.x_axis.cross(m.y_axis));
    if m.determinant() < 0.0 { -cofactors } else { cofactors }
}

/// What the map does to directions, divided by its largest entry: products of three entries of a map that shrinks to
/// a trillionth would underflow.
fn scaled_linear_part(target_from_source: &Mat4) -> Mat3 {
    let m = Mat3::from_mat4(*target_from_source);
    let largest = m.to_cols_array().iter().fold(0.0_f32, |largest, entry| largest.max(entry.abs()));
    if largest > 0.0 && largest.is_finite() {
        // Not times the reciprocal: that of a subnormal number overflows.
        Mat3::from_cols(m.x_axis / largest, m.y_axis / largest, m.z_axis / largest)
    } else {
        m
    }
}

#[cfg(test)]
mod tests {
    use glam::vec3;

    use super::*;
    use crate::mesh::tests::slope;

    #[test]
    fn mirror_keeps_fronts_in_front_however_small_the_result() {
        for scale in [1.0, 1e-15, 1e-30, 1e15] {
            let mirror = Mat4::from_scale(scale * vec3(-1.0, 2.0, 0.5));
            let mesh = slope().transformed(&mirror).unwrap();
            for k in 0..2 {
                let face = mesh.triangle(k).normal().unwrap();
                let [n, ..] = mesh.corner_normals(k).unwrap();
                // Both are unit vectors, each rounded a few times.
                assert!((face - n).length() < 1e-6, "scale {scale}, triangle {k}: {face} and {n}");
            }
            assert_eq!((mesh.material(0), mesh.material(1)), (5, 8));
        }
    }
}
