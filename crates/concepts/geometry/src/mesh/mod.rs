//! How do a thousand triangles share their vertices? By index.

mod part;
mod transform;

pub use transform::normal_matrix;

use glam::{Vec2, Vec3};

use crate::{Aabb, Triangle};

/// Triangles over shared positions, with optional normals and texture coordinates and a material for each triangle.
///
/// Every index is in range and every number finite: a mesh can only be made through checks, so nobody who holds one
/// has to check again. Triangles without area are allowed (files contain them); whoever needs a normal skips them.
#[derive(Clone, Debug, PartialEq, Default)]
pub struct Mesh {
    positions: Vec<Vec3>,
    triangles: Vec<[u32; 3]>,
    normals: Option<Indexed<Vec3>>,
    /// Whether the normals have the indices of the positions.
    normals_follow: bool,
    texture_coordinates: Option<Indexed<Vec2>>,
    materials: Vec<u32>,
}

/// An attribute with indices of its own: `triangles[k]` names the values at the corners of triangle k.
///
/// So two triangles can share a position and yet have different normals there: a hard edge.
#[derive(Clone, Debug, PartialEq)]
pub struct Indexed<T> {
    /// The values.
    pub values: Vec<T>,
    /// One index per corner, in the order of the mesh's triangles.
    pub triangles: Vec<[u32; 3]>,
}

/// Why data are not a mesh.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum MeshError {
    /// An index beyond the values it points into.
    #[error("triangle {triangle} asks for {what} {index}, but there are only {count} (counted from 0)")]
    IndexOutOfRange {
        /// What the index points to: position, normal, texture coordinate.
        what: &'static str,
        /// The triangle, counted from 0.
        triangle: usize,
        /// The index, counted from 0.
        index: u32,
        /// How many values there are.
        count: usize,
    },
    /// A NaN or an infinity.
    #[error("{what} {index} is not finite: {value} (counted from 0)")]
    NotFinite {
        /// What it is: position, normal, texture coordinate.
        what: &'static str,
        /// Its index, counted from 0.
        index: usize,
        /// The value as text.
        value: String,
    },
    /// An attribute that does not cover the triangles one to one.
    #[error("{what}: {got} entries for {triangles} triangles; there must be one for each triangle")]
    CountMismatch {
        /// What it is: normal, texture coordinate, material.
        what: &'static str,
        /// How many entries came.
        got: usize,
        /// How many triangles the mesh has.
        triangles: usize,
    },
}

impl Mesh {
    /// The mesh of `triangles`, each three indices into `positions`, anticlockwise seen from the front.
    ///
    /// # Errors
    /// [`MeshError`] if an index is out of range or a coordinate is not finite.
    ///
    /// ```
    /// use geometry::Mesh;
    /// use glam::vec3;
    ///
    /// let corners = vec![vec3(0.0, 0.0, 0.0), vec3(1.0, 0.0, 0.0), vec3(1.0, 2.0, 0.0), vec3(0.0, 2.0, 0.0)];
    /// let mesh = Mesh::new(corners.clone(), vec![[0, 1, 2], [0, 2, 3]])?;
    /// assert_eq!(mesh.len(), 2);
    /// assert!(Mesh::new(corners, vec![[0, 1, 4]]).is_err());
    /// # Ok::<(), geometry::MeshError>(())
    /// ```
    pub fn new(positions: Vec<Vec3>, triangles: Vec<[u32; 3]>) -> Result<Self, MeshError> {
        check_finite("position", &positions, |p| p.is_finite())?;
        check_indices("position", &triangles, positions.len())?;
        Ok(Self { positions, triangles, ..Self::default() })
    }

    /// The same triangles between other positions. Normals stay: the shape should be the same but for place and size.
    ///
    /// # Errors
    /// [`MeshError`] if there are fewer positions than the triangles use, or if one is not finite.
    pub fn with_positions(mut self, positions: Vec<Vec3>) -> Result<Self, MeshError> {
        check_finite("position", &positions, |p| p.is_finite())?;
        check_indices("position", &self.triangles, positions.len())?;
        self.positions = positions;
        Ok(self)
    }

    /// The same mesh with these normals, which it brings to unit length. A zero normal stays zero, which means: none
    /// given at this corner.
    ///
    /// # Errors
    /// [`MeshError`] if they do not fit the triangles or are not finite.
    pub fn with_normals(mut self, mut normals: Indexed<Vec3>) -> Result<Self, MeshError> {
        self.check_attribute("normal", &normals, |n| n.is_finite())?;
        for n in &mut normals.values {
            *n = n.as_dvec3().normalize_or_zero().as_vec3();
        }
        self.normals_follow = normals.triangles == self.triangles;
        self.normals = Some(normals);
        Ok(self)
    }

    /// The same mesh with these texture coordinates.
    ///
    /// # Errors
    /// [`MeshError`] if they do not fit the triangles or are not finite.
    pub fn with_texture_coordinates(mut self, coordinates: Indexed<Vec2>) -> Result<Self, MeshError> {
        self.check_attribute("texture coordinate", &coordinates, |t| t.is_finite())?;
        self.texture_coordinates = Some(coordinates);
        Ok(self)
    }

    /// The same mesh with a material index for each triangle (what it points into is the caller's list).
    ///
    /// # Errors
    /// [`MeshError::CountMismatch`] unless there is one for each triangle.
    pub fn with_materials(mut self, materials: Vec<u32>) -> Result<Self, MeshError> {
        if materials.len() != self.triangles.len() {
            return Err(MeshError::CountMismatch {
                what: "material",
                got: materials.len(),
                triangles: self.triangles.len(),
            });
        }
        self.materials = materials;
        Ok(self)
    }

    /// The same mesh without normals.
    #[must_use]
    pub fn without_normals(mut self) -> Self {
        self.normals = None;
        self.normals_follow = false;
        self
    }

    /// The shared positions.
    #[must_use]
    pub fn positions(&self) -> &[Vec3] {
        &self.positions
    }

    /// The triangles, as indices into [`Mesh::positions`].
    #[must_use]
    pub fn triangles(&self) -> &[[u32; 3]] {
        &self.triangles
    }

    /// The normals, if there are any.
    #[must_use]
    pub fn normals(&self) -> Option<&Indexed<Vec3>> {
        self.normals.as_ref()
    }

    /// Whether the normals have the indices of the positions: each vertex has one normal, and whatever depends on both can be worked
    /// out once a vertex.
    #[must_use]
    pub fn normals_follow_positions(&self) -> bool {
        self.normals_follow
    }

    /// Whether materials were given, one for each triangle.
    #[must_use]
    pub fn has_materials(&self) -> bool {
        !self.materials.is_empty()
    }

    /// The texture coordinates, if there are any.
    #[must_use]
    pub fn texture_coordinates(&self) -> Option<&Indexed<Vec2>> {
        self.texture_coordinates.as_ref()
    }

    /// How many triangles there are.
    #[must_use]
    pub fn len(&self) -> usize {
        self.triangles.len()
    }

    /// Whether there is no triangle.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.triangles.is_empty()
    }

    /// Triangle `k`.
    ///
    /// # Panics
    /// If `k` is not less than [`Mesh::len`].
    #[inline]
    #[must_use]
    pub fn triangle(&self, k: usize) -> Triangle {
        let [a, b, c] = self.triangles[k].map(|index| self.positions[index as usize]);
        Triangle { a, b, c }
    }

    /// The unit normals at the corners of triangle `k`, where the mesh has all three.
    ///
    /// # Panics
    /// If `k` is not less than [`Mesh::len`].
    #[inline]
    #[must_use]
    pub fn corner_normals(&self, k: usize) -> Option<[Vec3; 3]> {
        let normals = self.normals.as_ref()?;
        let corners = normals.triangles[k].map(|index| normals.values[index as usize]);
        corners.iter().all(|n| *n != Vec3::ZERO).then_some(corners)
    }

    /// The texture coordinates at the corners of triangle `k`, if the mesh has any.
    ///
    /// # Panics
    /// If `k` is not less than [`Mesh::len`].
    #[must_use]
    pub fn corner_texture_coordinates(&self, k: usize) -> Option<[Vec2; 3]> {
        let uv = self.texture_coordinates.as_ref()?;
        Some(uv.triangles[k].map(|index| uv.values[index as usize]))
    }

    /// The material index of triangle `k`; 0 where none was given.
    #[inline]
    #[must_use]
    pub fn material(&self, k: usize) -> u32 {
        self.materials.get(k).copied().unwrap_or(0)
    }

    /// The smallest box around the triangles; positions that no triangle uses do not count.
    #[must_use]
    pub fn aabb(&self) -> Aabb {
        Aabb::from_points(self.triangles.iter().flatten().map(|index| self.positions[*index as usize]))
    }

    fn check_attribute<T: std::fmt::Debug>(
        &self,
        what: &'static str,
        attribute: &Indexed<T>,
        is_finite: impl Fn(&T) -> bool,
    ) -> Result<(), MeshError> {
        if attribute.triangles.len() != self.triangles.len() {
            return Err(MeshError::CountMismatch {
                what,
                got: attribute.triangles.len(),
                triangles: self.triangles.len(),
            });
        }
        check_finite(what, &attribute.values, is_finite)?;
        check_indices(what, &attribute.triangles, attribute.values.len())
    }
}

fn check_finite<T: std::fmt::Debug>(
    what: &'static str,
    values: &[T],
    is_finite: impl Fn(&T) -> bool,
) -> Result<(), MeshError> {
    match values.iter().position(|v| !is_finite(v)) {
        None => Ok(()),
        Some(index) => Err(MeshError::NotFinite { what, index, value: format!("{:?}", values[index]) }),
    }
}

fn check_indices(what: &'static str, triangles: &[[u32; 3]], count: usize) -> Result<(), MeshError> {
    for (triangle, corners) in triangles.iter().enumerate() {
        if let Some(&index) = corners.iter().find(|index| **index as usize >= count) {
            return Err(MeshError::IndexOutOfRange { what, triangle, index, count });
        }
    }
    Ok(())
}

#[cfg(test)]
pub(super) mod tests {
    use glam::vec3;

    use super::*;

    /// A slope of two triangles with normals and materials.
    pub(super) fn slope() -> Mesh {
        let corners =
            vec![vec3(0.0, 0.0, 0.0), vec3(2.0, 0.0, 0.0), vec3(2.0, 3.0, 4.0), vec3(0.0, 3.0, 4.0)];
        let triangles = vec![[0, 1, 2], [0, 2, 3]];
        let n = vec3(0.0, -4.0, 3.0);
        let normals = Indexed { values: vec![n], triangles: vec![[0; 3]; 2] };
        Mesh::new(corners, triangles)
            .unwrap()
            .with_normals(normals)
            .unwrap()
            .with_materials(vec![5, 8])
            .unwrap()
    }

    #[test]
    fn normals_become_unit_and_stay_on_the_front() {
        let mesh = slope();
        assert_eq!(mesh.corner_normals(0), Some([vec3(0.0, -0.8, 0.6); 3]));
        assert_eq!(mesh.triangle(0).normal(), Some(vec3(0.0, -0.8, 0.6)));
    }

    #[test]
    fn attribute_that_does_not_fit_is_an_error_that_names_it() {
        let normals = |triangles| Indexed { values: vec![Vec3::X], triangles };
        let error = slope().with_normals(normals(vec![[0; 3]])).unwrap_err();
        assert_eq!(
            error.to_string(),
            "normal: 1 entries for 2 triangles; there must be one for each triangle"
        );
        let error = slope().with_normals(normals(vec![[0; 3], [0, 0, 7]])).unwrap_err();
        assert_eq!(error.to_string(), "triangle 1 asks for normal 7, but there are only 1 (counted from 0)");
        let error = Mesh::new(vec![Vec3::NAN], Vec::new()).unwrap_err();
        assert_eq!(error.to_string(), "position 0 is not finite: Vec3(NaN, NaN, NaN) (counted from 0)");
        assert!(slope().with_materials(vec![1]).is_err());
    }

    #[test]
    fn corner_without_a_normal_has_none() {
        let normals = Indexed { values: vec![Vec3::X, Vec3::ZERO], triangles: vec![[0; 3], [0, 1, 0]] };
        let mesh = slope().with_normals(normals).unwrap();
        assert!(mesh.corner_normals(0).is_some() && mesh.corner_normals(1).is_none());
    }
}
