//! How can a hundred teapots cost no more memory than one? They share one mesh, made ready for rays once.

use geometry::{Aabb, Mesh, Triangle};
use rayon::prelude::*;

use crate::fast::mesh::Leaves;
use crate::query::Nearest;
use crate::space::SpaceRay;
use crate::triangle::TriangleHit;
use crate::triangle::watertight::ShearedRay;

/// A mesh with its own hierarchy of boxes, in its own space; put it in an `Arc` and use it in as many objects as you like.
///
/// Building takes less than a microsecond a triangle, shared among rayon's threads, and always gives the same tree.
#[derive(Clone, Debug)]
pub struct TracedMesh {
    mesh: Mesh,
    /// The box around the mesh: asked for whenever an object is made of it.
    aabb: Aabb,
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
        let is_first = are_first(&mesh);
        let box_of = |k: usize| {
            let triangle = mesh.triangle(k);
            if has_equal_corners(&triangle) || !is_first[k] { Aabb::EMPTY } else { triangle.aabb() }
        };
        let boxes: Vec<Aabb> = (0..mesh.len()).into_par_iter().map(box_of).collect();
        let leaves = Leaves::new(&mesh, &boxes);
        Self { aabb: mesh.aabb(), mesh, leaves }
    }

    /// The mesh.
    #[must_use]
    pub fn mesh(&self) -> &Mesh {
        &self.mesh
    }

    /// Offers every triangle that the ray hits, by the slide's loop over all of them (L43).
    pub(crate) fn nearest_brute(&self, ray: &SpaceRay, nearest: &mut Nearest) {
        for (k, hit) in self.hits(ray) {
            nearest.offer(k, hit);
        }
    }

    /// Every triangle that the ray's line hits, in the order of the mesh.
    pub(crate) fn hits(&self, ray: &SpaceRay) -> impl Iterator<Item = (u32, TriangleHit)> + '_ {
        let ray = ShearedRay::new(ray);
        (0..self.mesh.len()).filter_map(move |k| Some((k as u32, ray.hit(&self.mesh.triangle(k).corners())?)))
    }

    /// Whether the ray hits any triangle with t0 < t < t1, by the slide's loop.
    pub(crate) fn any_brute(&self, ray: &SpaceRay, t0: f32, t1: f32) -> bool {
        self.hits(ray).any(|(_, hit)| t0 < hit.t && hit.t < t1)
    }

    pub(crate) fn aabb(&self) -> Aabb {
        self.aabb
    }

    pub(crate) fn leaves(&self) -> &Leaves {
        &self.leaves
    }
}

fn has_equal_corners(triangle: &Triangle) -> bool {
    triangle.a == triangle.b || triangle.b == triangle.c || triangle.c == triangle.a
}

/// For each triangle, whether no earlier one has the same corners in the same order.
fn are_first(mesh: &Mesh) -> Vec<bool> {
    let mixed: Vec<u32> = (0..mesh.len()).into_par_iter().map(|k| mixed(&bits(mesh, k))).collect();
    // A table of triangles by what their corners mix to, half of it empty; each place holds that and the triangle's number.
    let mut table = vec![u64::MAX; (2 * mesh.len()).next_power_of_two()];
    let mut is_new = |(k, &mixed): (usize, &u32)| {
        let last = table.len() - 1;
        let mut place = mixed as usize & last;
        while table[place] != u64::MAX {
            let there = table[place];
            if (there >> 32) as u32 == mixed && bits(mesh, there as u32 as usize) == bits(mesh, k) {
                return false;
            }
            place = (place + 1) & last;
        }
        table[place] = u64::from(mixed) << 32 | k as u64;
        true
    };
    mixed.iter().enumerate().map(&mut is_new).collect()
}

fn bits(mesh: &Mesh, k: usize) -> [u32; 9] {
    let Triangle { a, b, c } = mesh.triangle(k);
    [a.x, a.y, a.z, b.x, b.y, b.z, c.x, c.y, c.z].map(f32::to_bits)
}

/// A number that hangs on every bit.
fn mixed(bits: &[u32; 9]) -> u32 {
    // An odd number without a pattern: multiplying carries each bit upwards, so the upper ones are the mixed ones.
    let mix =
        |hash: u64, bits: &u32| (hash.rotate_left(5) ^ u64::from(*bits)).wrapping_mul(0x517c_c1b7_2722_0a95);
    (bits.iter().fold(0, mix) >> 32) as u32
}
