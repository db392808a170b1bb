//! How can a hundred teapots cost no more memory than one? They share one mesh, made ready for rays once.

use geometry::{Aabb, Mesh, Triangle};

use crate::fast::mesh::Leaves;
use crate::query::Nearest;
use crate::space::SpaceRay;
use crate::triangle::watertight::ShearedRay;

/// A mesh with its own hierarchy of boxes, in its own space; put it in an `Arc` and use it in as many objects as you like.
///
/// Building takes about a microsecond a triangle and always gives the same tree.
#[derive(Clone, Debug)]
pub struct TracedMesh {
    mesh: Mesh,
    leaves: Leaves,
}

impl TracedMesh {
    /// Makes a mesh ready for rays.
    ///
    /// ```
    /// use geometry::Mesh;
    /// use glam::vec3;
    /// use raytrace::TracedMesh;
    ///
    /// let corners = vec![vec3(0.0, 0.0, 0.0), vec3(3.0, 0.0, 0.0), vec3(0.0, 2.0, 1.0)];
    /// let traced = TracedMesh::new(Mesh::new(corners, vec![[0, 1, 2]])?);
    /// assert_eq!(traced.mesh().len(), 1);
    /// # Ok::<(), geometry::MeshError>(())
    /// ```
    #[must_use]
    pub fn new(mesh: Mesh) -> Self {
        // No ray hits a triangle with two equal corners; and of equal triangles the first one wins every tie.
        // Files have either by the thousand, and a tree of equal boxes has no good shape.
        let mut seen = Seen::new(mesh.len());
        let box_of = |k: usize| {
            let triangle = mesh.triangle(k);
            if has_equal_corners(&triangle) || !seen.insert(&mesh, k) { Aabb::EMPTY } else { triangle.aabb() }
        };
        let boxes: Vec<Aabb> = (0..mesh.len()).map(box_of).collect();
        let leaves = Leaves::new(&mesh, &boxes);
        Self { mesh, leaves }
    }

    /// The mesh.
    #[must_use]
    pub fn mesh(&self) -> &Mesh {
        &self.mesh
    }

    /// Offers every triangle that the ray hits, by the slide's loop over all of them (L43).
    pub(crate) fn nearest_brute(&self, ray: &SpaceRay, nearest: &mut Nearest) {
        let ray = ShearedRay::new(ray);
        for k in 0..self.mesh.len() {
            if let Some(hit) = ray.hit(&self.mesh.triangle(k).corners()) {
                nearest.offer(k as u32, hit);
            }
        }
    }

    /// Whether the ray hits any triangle with t0 < t < t1, by the slide's loop.
    pub(crate) fn any_brute(&self, ray: &SpaceRay, t0: f32, t1: f32) -> bool {
        let ray = ShearedRay::new(ray);
        let hits = (0..self.mesh.len()).filter_map(|k| ray.hit(&self.mesh.triangle(k).corners()));
        hits.into_iter().any(|hit| t0 < hit.t && hit.t < t1)
    }

    pub(crate) fn leaves(&self) -> &Leaves {
        &self.leaves
    }
}

fn has_equal_corners(triangle: &Triangle) -> bool {
    triangle.a == triangle.b || triangle.b == triangle.c || triangle.c == triangle.a
}

/// Triangles that were there already: a table of numbers, by what is mixed of the bits of the corners.
struct Seen {
    table: Vec<u32>,
}

impl Seen {
    /// Room for twice as many as may come.
    fn new(triangles: usize) -> Self {
        Self { table: vec![u32::MAX; (2 * triangles).next_power_of_two()] }
    }

    /// Whether triangle `k` is the first of its kind.
    fn insert(&mut self, mesh: &Mesh, k: usize) -> bool {
        let key = |k: usize| mesh.triangle(k).corners().map(|corner| corner.to_array().map(f32::to_bits));
        let wanted = key(k);
        // An odd number with well-mixed bits; multiplying carries each bit upwards, so the upper ones are taken.
        let mix = |h: u64, bits: &u32| (h.rotate_left(5) ^ u64::from(*bits)).wrapping_mul(0x517c_c1b7_2722_0a95);
        let hash = wanted.as_flattened().iter().fold(0, mix);
        let mut place = (hash >> 32) as usize & (self.table.len() - 1);
        loop {
            match self.table[place] {
                u32::MAX => {
                    self.table[place] = k as u32;
                    return true;
                }
                there if key(there as usize) == wanted => return false,
                _ => place = (place + 1) & (self.table.len() - 1),
            }
        }
    }
}
