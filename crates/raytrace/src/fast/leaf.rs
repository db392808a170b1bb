//! The triangles of a mesh, four to a leaf, side by side in memory as the tests want them.

use fearless_simd::{f32x4, f32x8, prelude::*};
use geometry::Mesh;
use glam::Vec3;

use super::crossing::{Crossing, LEAST_SIZE, Probe};
use super::tree::LEAF;

/// Up to four triangles, by corner, coordinate and triangle.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Leaf {
    corners: [[[f32; LEAF]; 3]; 3],
    /// L: no edge is longer.
    size: f32,
}

/// What a ray may hit in a leaf, one bit for each triangle, and between which two t if it does.
pub(crate) struct Candidates {
    pub(crate) possible: u32,
    pub(crate) sure: u32,
    pub(crate) at_least: [f32; LEAF],
    pub(crate) at_most: [f32; LEAF],
}

impl Leaf {
    /// The triangles with these numbers; places that are not used hold NaN, which nothing hits.
    pub(crate) fn new(mesh: &Mesh, numbers: &[u32; LEAF]) -> Self {
        let mut leaf = Self { corners: [[[f32::NAN; LEAF]; 3]; 3], size: 0.0 };
        for (place, &number) in numbers.iter().enumerate().filter(|(_, number)| **number != u32::MAX) {
            let triangle = mesh.triangle(number as usize);
            for (corner, p) in triangle.corners().into_iter().enumerate() {
                for axis in 0..3 {
                    leaf.corners[corner][axis][place] = p[axis];
                }
            }
            let [a, b, c] = triangle.corners().map(Vec3::as_dvec3);
            let longest = a.distance(b).max(b.distance(c)).max(c.distance(a));
            // Rounded up: the margins have room for that.
            leaf.size = leaf.size.max(longest as f32 * (1.0 + f32::EPSILON) + LEAST_SIZE);
        }
        leaf
    }

    /// The corners of one triangle.
    #[inline]
    pub(crate) fn triangle(&self, place: usize) -> [Vec3; 3] {
        self.corners.map(|corner| Vec3::from(corner.map(|coordinate| coordinate[place % LEAF])))
    }

    /// One ray against all triangles.
    #[inline(always)]
    pub(crate) fn candidates<S: Simd>(&self, simd: S, probe: &Probe) -> Option<Candidates> {
        let splat = |x: f32| f32x4::splat(simd, x);
        let corners = self.corners.map(|corner| corner.map(|x| f32x4::load_array(simd, x)));
        let crossing = Crossing::new(probe.origin.map(splat), probe.direction.map(splat), corners);
        let margin = splat(probe.margin * self.size);
        let possible = crossing.possible(margin);
        if possible == 0 {
            return None;
        }
        let (at_least, at_most) = crossing.t(simd, splat(probe.error * self.size * self.size));
        Some(Candidates {
            possible,
            sure: crossing.sure(margin).to_bitmask() as u32,
            at_least: at_least.to_array(),
            at_most: at_most.to_array(),
        })
    }

    /// Eight rays against one triangle.
    #[inline(always)]
    pub(crate) fn crossing<S: Simd>(
        &self,
        simd: S,
        place: usize,
        origins: [f32x8<S>; 3],
        directions: [f32x8<S>; 3],
    ) -> Crossing<f32x8<S>> {
        let corners = self.corners.map(|corner| corner.map(|x| f32x8::splat(simd, x[place % LEAF])));
        Crossing::new(origins, directions, corners)
    }

    /// L.
    #[inline(always)]
    pub(crate) fn size(&self) -> f32 {
        self.size
    }
}
