//! Eight boxes side by side: which of them does the ray meet, and which first?
//!
//! A node holds the boxes of its eight children by coordinate, so that one subtraction serves all eight. The tree is then
//! a third as deep as one with two children, and its children are put in order once they are known to be met. Three things
//! must hold that pictures rarely notice:
//!
//! - **Nothing is lost**: the boxes are tested by a [`Bundle`], generous by more than its own rounding.
//! - **Ties are decided by the caller.** A box that begins exactly where the best hit lies is still opened.
//! - **The same input gives the same tree**, whatever the number of threads.

use fearless_simd::{f32x8, prelude::*};
use glam::Vec3A;

use super::bundle::{Bundle, Slab};
use super::walk::Walk;

/// Children of a node.
pub(crate) const WIDTH: usize = 8;

/// The most things in a leaf.
pub(crate) const LEAF: usize = 4;

/// A tree of boxes over things that are known by number.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct Tree {
    /// The root first; empty where there is nothing.
    pub(super) nodes: Vec<Node>,
    /// The things in each leaf; places that are not used hold [`u32::MAX`].
    pub(super) leaves: Vec<[u32; LEAF]>,
}

/// The boxes of up to eight children: lower and upper sides on each axis.
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(align(32))]
pub(super) struct Node {
    sides: [[[f32; WIDTH]; 2]; 3],
    pub(super) children: [Child; WIDTH],
}

/// The number of a node, or, with the highest bit set, of a leaf.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct Child(pub(super) u32);

impl Child {
    const LEAF_BIT: u32 = 1 << 31;

    pub(super) fn node(k: u32) -> Self {
        Self(k)
    }

    pub(super) fn leaf(k: usize) -> Self {
        Self(k as u32 | Self::LEAF_BIT)
    }

    /// The number of the leaf, if it is one.
    #[inline(always)]
    pub(super) fn as_leaf(self) -> Option<usize> {
        (self.0 & Self::LEAF_BIT != 0).then_some((self.0 & !Self::LEAF_BIT) as usize)
    }

    fn renumbered(self, nodes: u32, leaves: u32) -> Self {
        Self(self.0 + if self.0 & Self::LEAF_BIT == 0 { nodes } else { leaves })
    }
}

impl Node {
    /// Boxes that no ray meets.
    pub(super) const EMPTY: Self = Self {
        sides: [[[f32::INFINITY; WIDTH], [f32::NEG_INFINITY; WIDTH]]; 3],
        children: [Child(0); WIDTH],
    };

    pub(super) fn put(&mut self, place: usize, min: Vec3A, max: Vec3A, child: Child) {
        for axis in 0..3 {
            self.sides[axis][0][place] = min[axis];
            self.sides[axis][1][place] = max[axis];
        }
        self.children[place] = child;
    }

    pub(super) fn renumbered(&self, nodes: u32, leaves: u32) -> Self {
        Self { children: self.children.map(|child| child.renumbered(nodes, leaves)), ..*self }
    }

    /// Where the bundle enters each box, and which boxes it meets between t0 and `t1`, ends included, one bit each.
    #[inline(always)]
    fn entries<S: Simd>(&self, simd: S, bundle: &Bundle, t1: f32) -> (f32x8<S>, u32) {
        let x = along(simd, &self.sides[0], &bundle.slabs[0]);
        let y = along(simd, &self.sides[1], &bundle.slabs[1]);
        let z = along(simd, &self.sides[2], &bundle.slabs[2]);
        let enter = x.0.max(y.0).max(z.0.max(f32x8::splat(simd, bundle.t0)));
        let leave = x.1.min(y.1).min(z.1.min(f32x8::splat(simd, t1)));
        (enter, enter.simd_le(leave).to_bitmask() as u32)
    }
}

/// Where the bundle enters and leaves eight boxes along one axis.
#[inline(always)]
fn along<S: Simd>(simd: S, sides: &[[f32; WIDTH]; 2], slab: &Slab) -> (f32x8<S>, f32x8<S>) {
    let near = f32x8::load_array_ref(simd, &sides[slab.side & 1]);
    let far = f32x8::load_array_ref(simd, &sides[slab.side & 1 ^ 1]);
    ((near - slab.enter.0) * slab.enter.1, (far - slab.leave.0) * slab.leave.1)
}

impl Tree {
    /// How much memory it takes.
    #[cfg(test)]
    pub(super) fn bytes(&self) -> usize {
        size_of_val(self.nodes.as_slice()) + size_of_val(self.leaves.as_slice())
    }

    /// Takes the leaves out, for somebody who keeps more of each thing than its number.
    pub(super) fn take_leaves(&mut self) -> Vec<[u32; LEAF]> {
        std::mem::take(&mut self.leaves)
    }

    /// The things in one leaf.
    #[inline(always)]
    pub(crate) fn things(&self, leaf: usize) -> impl Iterator<Item = u32> {
        self.leaves[leaf].iter().copied().filter(|thing| *thing != u32::MAX)
    }

    /// Whether there is so little that no box is worth a test: a leaf, or nothing.
    pub(crate) fn is_one_leaf(&self) -> bool {
        self.leaves.len() <= 1
    }

    /// Opens the leaves that the bundle meets with t up to `t1`, nearer boxes first, roughly.
    ///
    /// `open` gets a leaf's number and returns where the search ends from now on; −∞ ends it at once.
    #[inline(always)]
    pub(crate) fn walk<S: Simd>(
        &self,
        simd: S,
        bundle: &Bundle,
        t1: f32,
        mut open: impl FnMut(usize) -> f32,
    ) {
        let mut t1 = t1;
        let mut walk = Walk::from((!self.nodes.is_empty()).then(|| Child::node(0)));
        while let Some(k) = walk.next_node(&mut t1, &mut open) {
            let node = &self.nodes[k];
            let (enter, met) = node.entries(simd, bundle, t1);
            walk.choose(node, &enter.to_array(), met);
        }
    }
}
