//! Which of a million things can a ray hit at all? Those in the boxes that it passes through.
//!
//! A bounding volume hierarchy: a tree of boxes, each around those below it. [`obvhs`] decides which things share a box
//! (PLOC with reinsertion); the walk is written out here, because three things must hold that pictures rarely notice:
//!
//! - **Nothing is lost.** A ray is tested against boxes in f32, and each test is made generous by more than its own
//!   rounding, after Ize, *Robust BVH Ray Traversal* (JCGT 2013). So a hit that brute force finds is found here too.
//! - **Ties are decided by the caller.** A box that begins exactly where the best hit lies is still opened.
//! - **The same input gives the same tree**, whatever the number of threads.

use std::ops::Range;

use geometry::Aabb;
use glam::Vec3A;
use obvhs::bvh2::leaf_collapser::collapse;
use obvhs::bvh2::reinsertion::ReinsertionOptimizer;
use obvhs::bvh2::{Bvh2, node::Bvh2Node};
use obvhs::ploc::{PlocBuilder, PlocSearchDistance, SortPrecision};

use crate::space::SpaceRay;

/// A tree of boxes over things that are known by number.
#[derive(Clone, Debug, Default)]
pub(crate) struct Hierarchy {
    nodes: Vec<Node>,
    root: Option<(Bounds, Child)>,
    /// The things in the order of the leaves: each leaf owns a range of them.
    order: Vec<u32>,
}

/// Two boxes and what is in them, side by side in memory because they are tested together.
#[derive(Clone, Copy, Debug)]
struct Node {
    bounds: [Bounds; 2],
    children: [Child; 2],
}

#[derive(Clone, Copy, Debug)]
struct Bounds {
    min: Vec3A,
    max: Vec3A,
}

/// A leaf with `count` things from `first` on, or, with count 0, the inner node `first`.
#[derive(Clone, Copy, Debug, Default)]
struct Child {
    first: u32,
    count: u32,
}

/// The most things in a leaf, and what a step down the tree costs in tests of things: measured, not critical.
const MOST_IN_LEAF: u32 = 4;
const STEP_COST: f32 = 2.0;

impl Hierarchy {
    /// The tree over `boxes`. Empty boxes are left out: no ray hits what is in them.
    pub(crate) fn new(boxes: &[Aabb]) -> Self {
        let order: Vec<u32> = (0..boxes.len() as u32).filter(|k| !boxes[*k as usize].is_empty()).collect();
        if order.is_empty() {
            return Self::default();
        }
        let tree = grouped(boxes, &order);
        let order: Vec<u32> = tree.primitive_indices.iter().map(|k| order[*k as usize]).collect();
        Self::flattened(&tree.nodes, order, boxes)
    }

    /// The things, in the order of the leaves; the ranges that [`Hierarchy::walk`] hands out index into it.
    pub(crate) fn order(&self) -> &[u32] {
        &self.order
    }

    /// Opens the leaves that the ray meets with t in [`t0`, `t1`], nearer boxes first, roughly.
    ///
    /// `open` gets a leaf's range of [`Hierarchy::order`] and returns where the search ends from now on; −∞ ends it at
    /// once.
    pub(crate) fn walk(&self, ray: &BoxRay, t0: f32, t1: f32, mut open: impl FnMut(Range<usize>) -> f32) {
        let mut t1 = t1;
        let mut waiting = Stack::default();
        if let Some((bounds, root)) = &self.root
            && let Some(entry) = ray.entry(bounds, t0, t1)
        {
            waiting.push((entry, *root));
        }
        while let Some((entry, child)) = waiting.pop() {
            // The search may have become shorter since the box was put aside.
            if entry > t1 {
                continue;
            }
            if child.count > 0 {
                t1 = open(child.first as usize..(child.first + child.count) as usize);
                continue;
            }
            let node = &self.nodes[child.first as usize];
            let left = ray.entry(&node.bounds[0], t0, t1).map(|entry| (entry, node.children[0]));
            let right = ray.entry(&node.bounds[1], t0, t1).map(|entry| (entry, node.children[1]));
            let (nearer, farther) = match (left, right) {
                (Some(l), Some(r)) if r.0 < l.0 => (right, left),
                _ => (left, right),
            };
            // The last one in is the first one out.
            farther.into_iter().chain(nearer).for_each(|item| waiting.push(item));
        }
    }

    /// The tree with true boxes, and without the parts that only building needs.
    fn flattened(nodes: &[Bvh2Node], order: Vec<u32>, boxes: &[Aabb]) -> Self {
        let from_root_down = from_root_down(nodes);
        let mut place = vec![0; nodes.len()];
        for (k, inner) in from_root_down.iter().filter(|k| !nodes[**k].is_leaf()).enumerate() {
            place[*inner] = k as u32;
        }
        let child = |k: usize| match nodes[k].prim_count {
            0 => Child { first: place[k], count: 0 },
            count => Child { first: nodes[k].first_index, count },
        };

        let mut bounds = vec![Aabb::EMPTY; nodes.len()];
        for &k in from_root_down.iter().rev() {
            let first = nodes[k].first_index as usize;
            bounds[k] = if nodes[k].is_leaf() {
                let things = &order[first..first + nodes[k].prim_count as usize];
                things.iter().fold(Aabb::EMPTY, |all, thing| all.union(boxes[*thing as usize]))
            } else {
                bounds[first].union(bounds[first + 1])
            };
        }
        let inner = from_root_down.iter().filter(|k| !nodes[**k].is_leaf()).map(|&k| {
            let pair = [nodes[k].first_index as usize, nodes[k].first_index as usize + 1];
            Node { bounds: pair.map(|k| Bounds::from(bounds[k])), children: pair.map(child) }
        });
        Self { nodes: inner.collect(), root: Some((bounds[0].into(), child(0))), order }
    }
}

/// Which things share a box: a binary tree by `obvhs`, over `order`.
fn grouped(boxes: &[Aabb], order: &[u32]) -> Bvh2 {
    // Moved into the unit cube, where no area overflows or vanishes; only the shape of the tree comes from these boxes.
    let whole = order.iter().fold(Aabb::EMPTY, |all, k| all.union(boxes[*k as usize]));
    let (origin, size) = (whole.min.as_dvec3(), (whole.max.as_dvec3() - whole.min.as_dvec3()).max_element());
    let scale = if size > 0.0 { size.recip() } else { 1.0 };
    let into_cube = |p: glam::Vec3| ((p.as_dvec3() - origin) * scale).as_vec3a();
    let scaled: Vec<obvhs::aabb::Aabb> = order
        .iter()
        .map(|k| &boxes[*k as usize])
        .map(|b| obvhs::aabb::Aabb::new(into_cube(b.min), into_cube(b.max)))
        .collect();

    let numbers = (0..scaled.len() as u32).collect();
    let mut tree = PlocBuilder::with_capacity(scaled.len()).build(
        PlocSearchDistance::Medium,
        &scaled,
        numbers,
        SortPrecision::U64,
        3,
    );
    // The settings of obvhs' `medium_build`.
    ReinsertionOptimizer::default().run(&mut tree, 0.05, None);
    collapse(&mut tree, MOST_IN_LEAF, STEP_COST);
    ReinsertionOptimizer::default().run(&mut tree, 0.1, None);
    tree
}

/// The numbers of all nodes, each after its parent.
fn from_root_down(nodes: &[Bvh2Node]) -> Vec<usize> {
    let mut sorted = vec![0];
    let mut next = 0;
    while let Some(&k) = sorted.get(next) {
        if !nodes[k].is_leaf() {
            let first = nodes[k].first_index as usize;
            sorted.extend([first, first + 1]);
        }
        next += 1;
    }
    sorted
}

impl From<Aabb> for Bounds {
    fn from(aabb: Aabb) -> Self {
        Self { min: aabb.min.into(), max: aabb.max.into() }
    }
}

/// A ray as boxes see it.
#[derive(Clone, Copy, Debug)]
pub(crate) struct BoxRay {
    /// The origin, moved towards the upper side by more than its own rounding: every lower side seems a bit lower.
    origin_for_min: Vec3A,
    /// The same for the upper sides.
    origin_for_max: Vec3A,
    inverse_direction: Vec3A,
}

/// What rounding the origin to f32 may lose, 2⁻²⁴ of it, four times over: so much that adding it never rounds to nothing.
const ORIGIN_SLACK: f32 = 2.0 * f32::EPSILON;

/// t of a side is computed with three roundings, and the t of a hit is rounded once: together 4 · 2⁻²⁴ of it at most
/// on either side of a comparison; this is twice that sum.
const T_SLACK: f32 = 8.0 * f32::EPSILON;

impl BoxRay {
    /// `None` for a ray with numbers so large or small that f32 would over- or underflow: test everything instead.
    pub(crate) fn new(ray: &SpaceRay) -> Option<Self> {
        let tame = |x: f64| x == 0.0 || (1e-30..1e30).contains(&x.abs());
        let (origin, direction) = (ray.origin.to_array(), ray.direction.to_array());
        if !origin.into_iter().chain(direction).all(tame) {
            return None;
        }
        let origin = ray.origin.as_vec3a();
        // Never 0, so that a ray that runs inside a side of a box meets 0/0 nowhere.
        let slack = ORIGIN_SLACK * origin.abs() + Vec3A::splat(f32::MIN_POSITIVE);
        Some(Self {
            origin_for_min: origin + slack,
            origin_for_max: origin - slack,
            // By a zero this is infinite: the ray is forever between two sides, or never.
            inverse_direction: ray.direction.recip().as_vec3a(),
        })
    }

    /// The t at which the ray enters the box, at most, if it is in the box anywhere in [`t0`, `t1`].
    #[inline]
    fn entry(&self, bounds: &Bounds, t0: f32, t1: f32) -> Option<f32> {
        let at_min = (bounds.min - self.origin_for_min) * self.inverse_direction;
        let at_max = (bounds.max - self.origin_for_max) * self.inverse_direction;
        let enter = at_min.min(at_max).max_element();
        let leave = at_min.max(at_max).min_element();
        let (enter, leave) = (enter - T_SLACK * enter.abs(), leave + T_SLACK * leave.abs());
        (enter <= leave && enter <= t1 && leave >= t0).then_some(enter)
    }
}

/// Boxes put aside. The first few need no memory of their own; more happen only in a badly balanced tree.
struct Stack {
    few: [(f32, Child); Stack::FEW],
    len: usize,
    more: Vec<(f32, Child)>,
}

impl Default for Stack {
    fn default() -> Self {
        Self { few: [(0.0, Child::default()); Self::FEW], len: 0, more: Vec::new() }
    }
}

impl Stack {
    const FEW: usize = 48;

    #[inline]
    fn push(&mut self, item: (f32, Child)) {
        if self.len < Self::FEW {
            self.few[self.len] = item;
            self.len += 1;
        } else {
            self.more.push(item);
        }
    }

    #[inline]
    fn pop(&mut self) -> Option<(f32, Child)> {
        self.more.pop().or_else(|| {
            self.len = self.len.checked_sub(1)?;
            Some(self.few[self.len])
        })
    }
}
