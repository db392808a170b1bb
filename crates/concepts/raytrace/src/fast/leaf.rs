//! How do four triangles lie in memory so that one instruction reads the same coordinate of all? By corner, then coordinate.

use fearless_simd::{f32x4, f32x8, prelude::*};
use geometry::{Mesh, Triangle};
use glam::{Vec3, vec3};

use super::crossing::{Crossing, LEAST_SIZE, Probe};
use super::tree::LEAF;

/// Up to four triangles, by corner, coordinate and triangle.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Leaf {
    corners: [[[f32; LEAF]; 3]; 3],
    /// L: no edge is longer.
    size: f32,
    len: u32,
    numbers: [u32; LEAF],
}

/// What a ray may hit in a leaf, one bit for each triangle, and between which two t if it does.
#[derive(Clone, Copy, Default)]
pub(crate) struct Candidates {
    pub(crate) possible: u32,
    pub(crate) sure: u32,
    pub(crate) at_least: [f32; LEAF],
    pub(crate) at_most: [f32; LEAF],
}

impl Leaf {
    /// The triangles with these numbers; places that are not used hold NaN, which nothing hits.
    pub(crate) fn new(mesh: &Mesh, numbers: &[u32; LEAF]) -> Self {
        let mut leaf = Self { corners: [[[f32::NAN; LEAF]; 3]; 3], size: 0.0, len: 0, numbers: *numbers };
        for (place, &number) in numbers.iter().enumerate().filter(|(_, number)| **number != u32::MAX) {
            let triangle = mesh.triangle(number as usize);
            leaf.len += 1;
            for (corner, p) in [triangle.a, triangle.b, triangle.c].into_iter().enumerate() {
                for axis in 0..3 {
                    leaf.corners[corner][axis][place] = p[axis];
                }
            }
            let Triangle { a, b, c } = triangle;
            let longest = a.distance(b).max(b.distance(c)).max(c.distance(a));
            // Rounded by a millionth at most; the margins have more room than that.
            leaf.size = leaf.size.max(longest + LEAST_SIZE);
        }
        leaf
    }

    /// The corners of one triangle.
    #[inline]
    pub(crate) fn triangle(&self, place: usize) -> [Vec3; 3] {
        let k = place % LEAF;
        let corner = |c: usize| vec3(self.corners[c][0][k], self.corners[c][1][k], self.corners[c][2][k]);
        [corner(0), corner(1), corner(2)]
    }

    /// One ray against all triangles.
    #[inline(always)]
    pub(crate) fn candidates<S: Simd>(&self, simd: S, probe: &Probe) -> Candidates {
        let [a, b, c] = &self.corners;
        let corners = [four(simd, a), four(simd, b), four(simd, c)];
        let crossing = Crossing::new(spread4(simd, probe.origin), spread4(simd, probe.direction), corners);
        let margin = f32x4::splat(simd, probe.margin * self.size);
        let possible = crossing.possible(margin);
        if possible == 0 {
            return Candidates::default();
        }
        let (at_least, at_most) = crossing.t(simd, f32x4::splat(simd, probe.error * self.size * self.size));
        Candidates {
            possible,
            sure: crossing.sure(margin).to_bitmask() as u32,
            at_least: at_least.to_array(),
            at_most: at_most.to_array(),
        }
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
        let [a, b, c] = &self.corners;
        let corners = [one(simd, a, place), one(simd, b, place), one(simd, c, place)];
        Crossing::new(origins, directions, corners)
    }

    /// The triangle's number in the mesh.
    #[inline(always)]
    pub(crate) fn number(&self, place: usize) -> u32 {
        self.numbers[place % LEAF]
    }

    /// How many triangles there are.
    #[inline(always)]
    pub(crate) fn len(&self) -> usize {
        self.len as usize
    }

    /// L.
    #[inline(always)]
    pub(crate) fn size(&self) -> f32 {
        self.size
    }
}

/// A corner of all four triangles.
#[inline(always)]
fn four<S: Simd>(simd: S, [x, y, z]: &[[f32; LEAF]; 3]) -> [f32x4<S>; 3] {
    [f32x4::load_array_ref(simd, x), f32x4::load_array_ref(simd, y), f32x4::load_array_ref(simd, z)]
}

/// A corner of one triangle, for eight rays.
#[inline(always)]
fn one<S: Simd>(simd: S, [x, y, z]: &[[f32; LEAF]; 3], place: usize) -> [f32x8<S>; 3] {
    let k = place % LEAF;
    [f32x8::splat(simd, x[k]), f32x8::splat(simd, y[k]), f32x8::splat(simd, z[k])]
}

/// A vector of one ray, for four triangles.
#[inline(always)]
fn spread4<S: Simd>(simd: S, [x, y, z]: [f32; 3]) -> [f32x4<S>; 3] {
    [f32x4::splat(simd, x), f32x4::splat(simd, y), f32x4::splat(simd, z)]
}
