//! What is left of a mesh when some of its triangles are taken away?

use super::{Indexed, Mesh};

impl Mesh {
    /// Returns the mesh of those triangles for which `keep` holds, with their normals, texture coordinates and materials.
    /// Positions stay, also those that no triangle uses any more, so that indices keep their meaning.
    ///
    /// - `keep`: asked for each triangle by its index, in order.
    ///
    /// ```
    /// use geometry::shapes::cuboid;
    /// use glam::vec3;
    ///
    /// let crate_ = cuboid(vec3(1.0, 2.0, 3.0), 0)?;
    /// let open = crate_.filtered(|k| crate_.triangle(k).normal() != Some(vec3(0.0, 1.0, 0.0)));
    /// assert_eq!((crate_.len(), open.len()), (12, 10)); // without its lid
    /// # Ok::<(), geometry::shapes::ShapeError>(())
    /// ```
    #[must_use]
    pub fn filtered(&self, mut keep: impl FnMut(usize) -> bool) -> Self {
        let kept: Vec<usize> = (0..self.len()).filter(|k| keep(*k)).collect();
        let of = |triangles: &[[u32; 3]]| kept.iter().map(|k| triangles[*k]).collect::<Vec<_>>();
        Self {
            positions: self.positions.clone(),
            triangles: of(&self.triangles),
            normals: self
                .normals
                .as_ref()
                .map(|normals| Indexed { values: normals.values.clone(), triangles: of(&normals.triangles) }),
            normals_follow: self.normals_follow,
            texture_coordinates: self
                .texture_coordinates
                .as_ref()
                .map(|uv| Indexed { values: uv.values.clone(), triangles: of(&uv.triangles) }),
            materials: if self.has_materials() {
                kept.iter().map(|k| self.materials[*k]).collect()
            } else {
                Vec::new()
            },
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::tests::slope;

    #[test]
    fn all_attributes_of_a_kept_triangle_stay() {
        let mesh = slope();
        let second = mesh.filtered(|k| k == 1);
        assert_eq!((second.len(), second.triangle(0), second.material(0)), (1, mesh.triangle(1), 8));
        assert_eq!(second.corner_normals(0), mesh.corner_normals(1));
        assert_eq!(mesh.filtered(|_| true), mesh);
        let nothing = mesh.filtered(|_| false);
        assert!(nothing.is_empty() && !nothing.has_materials());
    }
}
