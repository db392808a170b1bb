//! What is there to see? Meshes with a place and materials, lights, and a background.

use canvas::Rgb;
use geometry::Mesh;
use glam::{Mat4, Vec3};
use lighting::{Highlight, Light, Material, SurfacePoint, lit};
use transforms::Pipeline;

/// A mesh at a place in the world. Several objects may share one mesh.
#[derive(Clone, Copy, Debug)]
pub struct Object<'a> {
    /// The triangles. Corners without a normal are shaded with the normal of their triangle;
    /// [`crate::with_vertex_normals`] gives them one.
    pub mesh: &'a Mesh,
    /// Affine and finite. A map that mirrors keeps fronts fronts, as in [`Mesh::transformed`].
    pub world_from_object: Mat4,
    /// What [`Mesh::material`] points into. An index beyond the end means the last; an empty list means
    /// [`Material::default`].
    pub materials: &'a [Material],
}

/// All that a picture shows.
#[derive(Clone, Copy, Debug)]
pub struct World<'a> {
    /// Drawn in this order; where two surfaces are equally near, the first drawn stays.
    pub objects: &'a [Object<'a>],
    /// What shines on them, world space. Nothing casts a shadow: the lighting is local (L35).
    pub lights: &'a [Light],
    /// The colour where no object is.
    pub background: Rgb,
    /// Which highlight the lighting model uses (E4).
    pub highlight: Highlight,
}

impl Object<'_> {
    /// The material of triangle `k`.
    ///
    /// # Panics
    /// If the mesh has no triangle `k`.
    #[must_use]
    pub fn material(&self, k: usize) -> Material {
        assert!(k < self.mesh.len(), "triangle {k} of {}", self.mesh.len());
        let index = self.mesh.material(k) as usize;
        self.materials.get(index).or(self.materials.last()).copied().unwrap_or_default()
    }
}

impl<'a> World<'a> {
    /// The light on this world as the camera's eye sees it.
    #[must_use]
    pub fn lighting(&self, pipeline: &Pipeline) -> Lighting<'a> {
        Lighting { lights: self.lights, highlight: self.highlight, eye: pipeline.camera().eye() }
    }

    /// # Panics
    /// If an object's matrix is not finite.
    pub(crate) fn check(&self) {
        for (k, object) in self.objects.iter().enumerate() {
            let matrix = object.world_from_object;
            assert!(matrix.is_finite(), "object {k} has a matrix that is not finite: {matrix}");
        }
    }
}

/// All that a lighting model needs beside the surface itself (L22).
#[derive(Clone, Copy, Debug)]
pub struct Lighting<'a> {
    /// What shines, world space.
    pub lights: &'a [Light],
    /// Which highlight to use (E4).
    pub highlight: Highlight,
    /// Where the eye is, world space.
    pub eye: Vec3,
}

impl Lighting<'_> {
    /// The colour of the point `p_world` of a surface with unit normal `n`, which should point to the side of the eye. Not
    /// clamped. Every light reaches the point: no shadows.
    ///
    /// At the eye itself, where the direction to it is undefined, the eye is taken to look along the normal.
    #[must_use]
    pub fn color(&self, material: &Material, p_world: Vec3, n: Vec3) -> Rgb {
        lit(material, self.lights, self.highlight, &self.surface_point(p_world, n), |_| true)
    }

    /// The point as the lighting model sees it: with the direction to the eye.
    #[must_use]
    pub fn surface_point(&self, p_world: Vec3, n: Vec3) -> SurfacePoint {
        SurfacePoint { p_world, n, to_eye: (self.eye - p_world).normalize_or(n) }
    }
}

#[cfg(test)]
mod tests {
    use glam::vec3;

    use super::*;

    fn two_triangles() -> Mesh {
        let positions = vec![Vec3::ZERO, vec3(2.0, 0.0, 0.0), vec3(0.0, 3.0, 0.0)];
        Mesh::new(positions, vec![[0, 1, 2]; 2]).and_then(|mesh| mesh.with_materials(vec![0, 7])).unwrap()
    }

    #[test]
    fn a_material_beyond_the_list_is_its_last_and_of_an_empty_list_the_default() {
        let mesh = two_triangles();
        let materials = [1.0, 2.0, 3.0].map(|exponent| Material::new(vec3(0.1, 0.2, 0.3), exponent));
        let object = |materials| Object { mesh: &mesh, world_from_object: Mat4::IDENTITY, materials };
        assert_eq!([0, 1].map(|k| object(&materials).material(k).exponent), [1.0, 3.0]);
        assert_eq!(object(&[]).material(1), Material::default());
    }

    #[test]
    fn a_surface_at_the_eye_has_a_color() {
        let lights = [Light::Directional { to_light: Vec3::Z, color: Vec3::ONE }];
        let eye = vec3(1.0, 2.0, 3.0);
        let color = |highlight| {
            let material = Material::new(vec3(0.5, 0.25, 0.0), 9.0);
            Lighting { lights: &lights, highlight, eye }.color(&material, eye, Vec3::Z)
        };
        assert_eq!([Highlight::Blinn, Highlight::Phong].map(color), [vec3(1.5, 1.25, 1.0); 2]);
    }

    #[test]
    #[should_panic(expected = "object 1 has a matrix that is not finite")]
    fn a_matrix_with_a_nan_is_the_callers_mistake() {
        let mesh = two_triangles();
        let object =
            |scale| Object { mesh: &mesh, world_from_object: Mat4::IDENTITY * scale, materials: &[] };
        let objects = [object(1.0), object(f32::NAN)];
        World { objects: &objects, lights: &[], background: Rgb::ZERO, highlight: Highlight::Blinn }.check();
    }
}
