//! Which triangle of a mesh does a ray meet first? The quick test finds out, the exact one has the last word.

use fearless_simd::Simd;
use geometry::{Aabb, Mesh};
use rayon::prelude::*;

use super::bundle::Bundle;
use super::crossing::Probe;
use super::leaf::{Candidates, Leaf};
use super::tree::Tree;
use crate::query::Nearest;
use crate::space::SpaceRay;
use crate::triangle::watertight::ShearedRay;

/// The triangles of a mesh in the leaves of a tree.
#[derive(Clone, Debug, Default)]
pub(crate) struct Leaves {
    pub(super) tree: Tree,
    pub(super) leaves: Vec<Leaf>,
    /// The greatest distance of a corner from the origin.
    pub(super) reach: f32,
}

/// A triangle by its leaf and its place there.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Place {
    pub(crate) leaf: usize,
    pub(crate) place: usize,
}

impl Leaves {
    /// `boxes`: around the mesh's triangles; a triangle with an empty box is left out.
    pub(crate) fn new(mesh: &Mesh, boxes: &[Aabb]) -> Self {
        let mut tree = Tree::new(boxes);
        let leaves = tree.take_leaves().par_iter().map(|numbers| Leaf::new(mesh, numbers)).collect();
        // The sum of coordinates is greater than the length, by more than rounding unless it lies on an axis.
        let far = mesh.positions().iter().map(|p| p.abs().element_sum()).fold(0.0, f32::max);
        let reach = far * (1.0 + 4.0 * f32::EPSILON);
        Self { tree, leaves, reach }
    }

    /// Offers the nearest triangle that the ray hits, by the exact test. `false` if the ray's numbers are beyond the
    /// range of f32: then nothing was searched.
    #[inline(always)]
    pub(crate) fn nearest<S: Simd>(&self, simd: S, ray: &SpaceRay, nearest: &mut Nearest) -> bool {
        let (t0, t1) = nearest.interval();
        let (Some(bundle), Some(probe)) = (Bundle::of_one(ray, t0), Probe::new(ray, self.reach)) else {
            return false;
        };
        let mut best = Best::new(t1);
        self.tree.walk(
            simd,
            &bundle,
            t1,
            #[inline(always)]
            |leaf| {
                self.take(ray, leaf, &self.leaves[leaf].candidates(simd, &probe), &mut best, nearest);
                best.at_most
            },
        );
        self.offer_exact(ray, best.place, nearest);
        true
    }

    /// Whether the ray hits any triangle with t0 < t < t1, if its numbers are in the range of f32.
    #[inline(always)]
    pub(crate) fn any<S: Simd>(&self, simd: S, ray: &SpaceRay, t0: f32, t1: f32) -> Option<bool> {
        let (bundle, probe) = (Bundle::of_one(ray, t0)?, Probe::new(ray, self.reach)?);
        let mut found = false;
        self.tree.walk(
            simd,
            &bundle,
            t1,
            #[inline(always)]
            |leaf| {
                found = self.any_of(ray, leaf, &self.leaves[leaf].candidates(simd, &probe), t0, t1);
                if found { f32::NEG_INFINITY } else { t1 }
            },
        );
        Some(found)
    }

    /// Takes the candidates that are surely the nearest so far; where rounding decides, the exact test does.
    #[inline(always)]
    fn take(
        &self,
        ray: &SpaceRay,
        leaf: usize,
        candidates: &Candidates,
        best: &mut Best,
        nearest: &mut Nearest,
    ) {
        let t0 = nearest.interval().0;
        let mut possible = candidates.possible;
        while possible != 0 {
            let place = possible.trailing_zeros() as usize & 3;
            possible &= possible - 1;
            let (at_least, at_most) = (candidates.at_least[place], candidates.at_most[place]);
            let place = Place { leaf, place };
            if candidates.sure >> place.place & 1 == 1 {
                if at_least > best.at_most || at_most <= t0 {
                    continue;
                }
                if at_most < best.at_least && at_least > t0 {
                    *best = Best { at_least, at_most, place: Some(place) };
                    continue;
                }
            }
            self.decide(ray, place, best, nearest);
        }
    }

    /// Lets the exact test decide between the best so far and another.
    #[cold]
    #[inline(never)]
    fn decide(&self, ray: &SpaceRay, place: Place, best: &mut Best, nearest: &mut Nearest) {
        self.offer_exact(ray, best.place, nearest);
        self.offer_exact(ray, Some(place), nearest);
        *best = Best::new(nearest.interval().1);
    }

    #[inline(always)]
    pub(super) fn offer_exact(&self, ray: &SpaceRay, place: Option<Place>, nearest: &mut Nearest) {
        let Some(Place { leaf, place }) = place else { return };
        if let Some(hit) = ShearedRay::new(ray).hit(&self.leaves[leaf].triangle(place)) {
            nearest.offer(self.leaves[leaf].number(place), hit);
        }
    }

    #[inline(always)]
    fn any_of(&self, ray: &SpaceRay, leaf: usize, candidates: &Candidates, t0: f32, t1: f32) -> bool {
        let mut possible = candidates.possible;
        while possible != 0 {
            let place = possible.trailing_zeros() as usize & 3;
            possible &= possible - 1;
            let (at_least, at_most) = (candidates.at_least[place], candidates.at_most[place]);
            if candidates.sure >> place & 1 == 1 {
                if t0 < at_least && at_most < t1 {
                    return true;
                }
                if at_least >= t1 || at_most <= t0 {
                    continue;
                }
            }
            if self.is_exactly_hit(ray, Place { leaf, place }, t0, t1) {
                return true;
            }
        }
        false
    }

    #[cold]
    #[inline(never)]
    pub(super) fn is_exactly_hit(
        &self,
        ray: &SpaceRay,
        Place { leaf, place }: Place,
        t0: f32,
        t1: f32,
    ) -> bool {
        let hit = ShearedRay::new(ray).hit(&self.leaves[leaf].triangle(place));
        hit.is_some_and(|hit| t0 < hit.t && hit.t < t1)
    }
}

/// The nearest sure hit so far, and between which t it lies; without one, where the search ends.
#[derive(Clone, Copy)]
struct Best {
    at_least: f32,
    at_most: f32,
    place: Option<Place>,
}

impl Best {
    fn new(t1: f32) -> Self {
        Self { at_least: t1, at_most: t1, place: None }
    }
}

#[cfg(test)]
mod tests {
    use geometry::shapes;

    use super::*;

    #[test]
    fn a_triangle_of_a_smooth_mesh_takes_at_most_64_bytes() {
        let mesh = shapes::icosphere(6).unwrap();
        let boxes: Vec<Aabb> = (0..mesh.len()).map(|k| mesh.triangle(k).aabb()).collect();
        let leaves = Leaves::new(&mesh, &boxes);
        let bytes = size_of_val(leaves.leaves.as_slice()) + leaves.tree.bytes();
        assert!(bytes <= 64 * mesh.len(), "{} bytes a triangle", bytes as f64 / mesh.len() as f64);
    }
}
