//! How can a hundred teapots cost no more memory than one? They share one mesh, made ready for rays once.

use std::collections::HashSet;

use geometry::{Aabb, Mesh, Triangle};
use glam::Vec3;

use crate::hierarchy::{BoxRay, Hierarchy};
use crate::query::Nearest;
use crate::space::SpaceRay;
use crate::triangle::TriangleHit;
use crate::triangle::watertight::ShearedRay;

/// A mesh with its own hierarchy of boxes, in its own space; put it in an `Arc` and use it in as many objects as you like.
///
/// Building takes about a microsecond a triangle and always gives the same tree.
#[derive(Clone, Debug)]
pub struct TracedMesh {
    mesh: Mesh,
    hierarchy: Hierarchy,
    /// The corners of the triangles in the order of the leaves, so that a leaf's triangles lie side by side.
    corners: Vec<[Vec3; 3]>,
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
        let mut seen = HashSet::new();
        let mut box_of = |k: usize| {
            let triangle = mesh.triangle(k);
            // No ray hits a triangle with two equal corners; and of equal triangles the first one wins every tie.
            // Files have either by the thousand, and a tree of equal boxes has no good shape.
            let key = triangle.corners().map(|corner| corner.to_array().map(f32::to_bits));
            if has_equal_corners(&triangle) || !seen.insert(key) { Aabb::EMPTY } else { triangle.aabb() }
        };
        let boxes: Vec<Aabb> = (0..mesh.len()).map(&mut box_of).collect();
        let hierarchy = Hierarchy::new(&boxes);
        let corners = hierarchy.order().iter().map(|k| mesh.triangle(*k as usize).corners()).collect();
        Self { mesh, hierarchy, corners }
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

    /// The same through the hierarchy.
    pub(crate) fn nearest(&self, ray: &SpaceRay, nearest: &mut Nearest) {
        let Some(box_ray) = BoxRay::new(ray) else {
            return self.nearest_brute(ray, nearest);
        };
        let sheared = ShearedRay::new(ray);
        let (t0, t1) = nearest.interval();
        self.hierarchy.walk(&box_ray, t0, t1, |leaf| {
            for (k, corners) in self.hierarchy.order()[leaf.clone()].iter().zip(&self.corners[leaf]) {
                if let Some(hit) = sheared.hit(corners) {
                    nearest.offer(*k, hit);
                }
            }
            nearest.interval().1
        });
    }

    /// Whether the ray hits any triangle with t0 < t < t1.
    pub(crate) fn any(&self, ray: &SpaceRay, t0: f32, t1: f32) -> bool {
        let between = |hit: &TriangleHit| t0 < hit.t && hit.t < t1;
        let sheared = ShearedRay::new(ray);
        let Some(box_ray) = BoxRay::new(ray) else {
            return self.corners.iter().filter_map(|corners| sheared.hit(corners)).any(|hit| between(&hit));
        };
        let mut found = false;
        self.hierarchy.walk(&box_ray, t0, t1, |leaf| {
            found =
                self.corners[leaf].iter().filter_map(|corners| sheared.hit(corners)).any(|hit| between(&hit));
            if found { f32::NEG_INFINITY } else { t1 }
        });
        found
    }
}

fn has_equal_corners(triangle: &Triangle) -> bool {
    triangle.a == triangle.b || triangle.b == triangle.c || triangle.c == triangle.a
}
