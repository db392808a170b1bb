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
        self.materials
            .get(index)
            .or(self.materials.last())
            .copied()
            .unwrap_or_default()
    }
}

impl<'a> World<'a> {
    /// The light on this world as the camera's eye sees it.
    #[must_use]
    pub fn lighting(&self, pipeline: &Pipeline) -> Lighting<'a> {
        Lighting {
            lights: self.lights,
            highlight: self.highlight,
            eye: pipeline.camera().eye(),
        }
    }

    /// # Panics
    /// If an object's matrix is not finite.
    pub(crate) fn check(&self) {
        for (k, object) in self.objects.iter().enumerate() {
            let matrix = object.world_from_object;
            assert!(
                matrix.is_finite(),
                "object {k} has a matrix that is not finite: {matrix}"
            );
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
        let to_eye = (self.eye - p_world).normalize_or(n);
        lit(
            material,
            self.lights,
            self.highlight,
            &SurfacePoint { p_world, n, to_eye },
            |_| true,
        )
    }
}
