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

/// Children of a node.
pub(crate) const WIDTH: usize = 8;

/// The most things in a leaf.
pub(crate) const LEAF: usize = 4;

/// A tree of boxes over things that are known by number.
#[derive(Clone, Debug, Default)]
pub(crate) struct Tree {
    /// The root first; empty where there is nothing.
    pub(super) nodes: Vec<Node>,
    /// The things in each leaf; places that are not used hold [`u32::MAX`].
    pub(super) leaves: Vec<[u32; LEAF]>,
}

/// The boxes of up to eight children: lower and upper sides on each axis.
#[derive(Clone, Copy, Debug)]
#[repr(align(32))]
pub(super) struct Node {
    sides: [[[f32; WIDTH]; 2]; 3],
    children: [Child; WIDTH],
}

/// The number of a node, or, with the highest bit set, of a leaf.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Child(u32);

impl Child {
    const LEAF_BIT: u32 = 1 << 31;

    pub(super) fn node(k: u32) -> Self {
        Self(k)
    }

    pub(super) fn leaf(k: usize) -> Self {
        Self(k as u32 | Self::LEAF_BIT)
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
    /// The things in each leaf; places that are not used hold [`u32::MAX`].
    pub(crate) fn leaves(&self) -> &[[u32; LEAF]] {
        &self.leaves
    }

    /// Whether there is so little that no box is worth a test: a leaf, or nothing.
    pub(crate) fn is_one_leaf(&self) -> bool {
        self.leaves.len() <= 1
    }

    /// Opens the leaves that the bundle meets with t up to `t1`, nearer boxes first, roughly.
    ///
    /// `open` gets 0 (see [`Tree::walk_each`]) and a leaf's number, and returns where the search ends from now on; −∞ ends
    /// it at once.
    #[inline(always)]
    pub(crate) fn walk<S: Simd>(
        &self,
        simd: S,
        bundle: &Bundle,
        t1: f32,
        mut open: impl FnMut(usize, usize) -> f32,
    ) {
        let mut t1 = t1;
        let mut walk = self.start();
        while let Some(k) = walk.next_node(&mut t1, 0, &mut open) {
            let node = &self.nodes[k];
            let (enter, met) = node.entries(simd, bundle, t1);
            walk.choose(node, &enter.to_array(), met);
        }
    }

    /// The way down for each of several bundles that have nothing to do with each other, a step of each in turn: while one
    /// waits for its node to arrive from memory, the others go on.
    ///
    /// `open` gets the bundle's number, too.
    #[inline(always)]
    pub(crate) fn walk_each<S: Simd, const N: usize>(
        &self,
        simd: S,
        bundles: &[Bundle; N],
        t1: [f32; N],
        mut open: impl FnMut(usize, usize) -> f32,
    ) {
        let mut t1 = t1;
        let mut walks: [Walk; N] = std::array::from_fn(|_| self.start());
        let mut steps = [(0_u32, [0.0_f32; WIDTH]); N];
        let mut at = [Some(0_usize); N];
        let mut walking = 0;
        for lane in 0..N {
            at[lane] = walks[lane].next_node(&mut t1[lane], lane, &mut open);
            walking += usize::from(at[lane].is_some());
        }
        while walking > 0 {
            // First all tests, which wait for memory but for no decision; then all decisions.
            for lane in 0..N {
                if let Some(k) = at[lane] {
                    let (enter, met) = self.nodes[k].entries(simd, &bundles[lane], t1[lane]);
                    steps[lane] = (met, enter.to_array());
                }
            }
            for lane in 0..N {
                if let Some(k) = at[lane] {
                    let (met, enter) = &steps[lane];
                    walks[lane].choose(&self.nodes[k], enter, *met);
                    at[lane] = walks[lane].next_node(&mut t1[lane], lane, &mut open);
                    walking -= usize::from(at[lane].is_none());
                }
            }
        }
    }

    #[inline(always)]
    fn start(&self) -> Walk {
        let next = if self.nodes.is_empty() { None } else { Some(Child(0)) };
        Walk { next, waiting: Stack::default() }
    }
}

/// Where one bundle is on its way through the tree.
struct Walk {
    /// The next child, where that is decided.
    next: Option<Child>,
    waiting: Stack,
}

impl Walk {
    /// Opens leaves until the next one is a node. `None` at the end of the way.
    ///
    /// `open` gets `lane`, too.
    #[inline(always)]
    fn next_node(
        &mut self,
        t1: &mut f32,
        lane: usize,
        open: &mut impl FnMut(usize, usize) -> f32,
    ) -> Option<usize> {
        loop {
            let child = match self.next.take() {
                Some(child) => child,
                None => {
                    let waiting = self.waiting.pop()?;
                    // The search may have become shorter since the box was put aside.
                    if !(waiting.enter() <= *t1) {
                        continue;
                    }
                    waiting.child()
                }
            };
            if child.0 & Child::LEAF_BIT == 0 {
                return Some(child.0 as usize);
            }
            *t1 = open(lane, (child.0 ^ Child::LEAF_BIT) as usize);
        }
    }

    /// Goes on to the nearest child that is met, and puts the others aside.
    #[inline(always)]
    fn choose(&mut self, node: &Node, enter: &[f32; WIDTH], met: u32) {
        let waiting = |met: u32| {
            let k = met.trailing_zeros() as usize % WIDTH;
            Waiting::new(enter[k], node.children[k])
        };
        let rest = met & met.wrapping_sub(1);
        if met == 0 {
        } else if rest == 0 {
            self.next = Some(waiting(met).child());
        } else if rest & (rest - 1) == 0 {
            let (a, b) = (waiting(met), waiting(rest));
            self.waiting.push(Waiting(a.0.max(b.0)));
            self.next = Some(Waiting(a.0.min(b.0)).child());
        } else {
            let first = self.waiting.len;
            let mut met = met;
            while met != 0 {
                self.waiting.push_sorted(first, waiting(met));
                met &= met - 1;
            }
        }
    }
}

/// A child put aside, with where the bundle enters it: the bits of that number, then the child, so that they are ordered by
/// one comparison. (Where it is negative the order is another one; nothing depends on it.)
#[derive(Clone, Copy, Default, PartialEq, PartialOrd)]
struct Waiting(u64);

impl Waiting {
    #[inline(always)]
    fn new(enter: f32, child: Child) -> Self {
        Self(u64::from(enter.to_bits()) << 32 | u64::from(child.0))
    }

    #[inline(always)]
    fn enter(self) -> f32 {
        f32::from_bits((self.0 >> 32) as u32)
    }

    #[inline(always)]
    fn child(self) -> Child {
        Child(self.0 as u32)
    }
}

/// Children put aside. The first few need no memory of their own; more happen only in a badly balanced tree.
struct Stack {
    few: [Waiting; Stack::FEW],
    len: usize,
    more: Vec<Waiting>,
}

impl Default for Stack {
    #[inline(always)]
    fn default() -> Self {
        Self { few: [Waiting::default(); Self::FEW], len: 0, more: Vec::new() }
    }
}

impl Stack {
    const FEW: usize = 32;

    #[inline(always)]
    fn push(&mut self, item: Waiting) {
        match self.few.get_mut(self.len) {
            Some(place) => {
                *place = item;
                self.len += 1;
            }
            None => self.more.push(item),
        }
    }

    /// Pushes the item below those from `first` on that are nearer.
    #[inline(always)]
    fn push_sorted(&mut self, first: usize, item: Waiting) {
        if self.len == Self::FEW {
            return self.more.push(item);
        }
        let mut place = self.len;
        while place > first && self.few[place - 1] < item {
            self.few[place] = self.few[place - 1];
            place -= 1;
        }
        self.few[place] = item;
        self.len += 1;
    }

    #[inline(always)]
    fn pop(&mut self) -> Option<Waiting> {
        if self.len == Self::FEW
            && let Some(item) = self.more.pop()
        {
            return Some(item);
        }
        self.len = self.len.checked_sub(1)?;
        self.few.get(self.len).copied()
    }
}
