//! Which things should share a box? Those that a ray meets together.
//!
//! From the root down: the boxes of a range of things are split in two where the *surface area heuristic* expects the
//! least work: a random ray meets a box with a chance in proportion to its area, and then has to test the things in it
//! (MacDonald and Booth, 1990). Sixteen places a axis are tried (Wald, *On fast Construction of SAH-based Bounding Volume
//! Hierarchies*, 2007). The part with the largest box is split again until a node has its eight children.
//!
//! The shape depends on the boxes alone; threads only share the work of building parts that are decided already.

use geometry::Aabb;
use glam::Vec3A;
use rayon::prelude::*;

use super::tree::{Child, LEAF, Node, Tree, WIDTH};

/// A thing by number and its box.
#[derive(Clone, Copy, Debug)]
struct Item {
    min: Vec3A,
    max: Vec3A,
    number: u32,
}

/// Ranges with more things than this are built by tasks of their own.
const TASK: usize = 8192;

/// Places to split at along each axis, and one more.
const BINS: usize = 16;

impl Tree {
    /// The tree over `boxes`. Empty boxes are left out: no ray hits what is in them.
    pub(crate) fn new(boxes: &[Aabb]) -> Self {
        let item = |(number, aabb): (usize, &Aabb)| Item {
            min: aabb.min.into(),
            max: aabb.max.into(),
            number: number as u32,
        };
        let mut items: Vec<Item> = boxes.iter().enumerate().filter(|(_, aabb)| !aabb.is_empty()).map(item).collect();
        if items.is_empty() {
            return Self::default();
        }
        let size = Bounds::around(&items).size().max_element();
        let scale = if size > 0.0 && size.is_finite() { size.recip() } else { 1.0 };
        let mut tree = Self::default();
        Builder { scale }.node(&mut items, &mut tree);
        tree.nodes.shrink_to_fit();
        tree.leaves.shrink_to_fit();
        tree
    }

    /// Takes over all of a part that was built by itself, and gives its root's number.
    fn append(&mut self, part: &Self) -> u32 {
        let (nodes, leaves) = (self.nodes.len() as u32, self.leaves.len() as u32);
        self.nodes.extend(part.nodes.iter().map(|node| node.renumbered(nodes, leaves)));
        self.leaves.extend_from_slice(&part.leaves);
        nodes
    }
}

#[derive(Clone, Copy)]
struct Builder {
    /// Brings lengths to at most 1, so that no area overflows or vanishes.
    scale: f32,
}

impl Builder {
    /// Appends the node over `items` and everything below it.
    fn node(self, items: &mut [Item], tree: &mut Tree) -> u32 {
        let parallel = items.len() > TASK;
        let mut parts = self.parts(items);
        let k = tree.nodes.len();
        tree.nodes.push(Node::EMPTY);
        let below: Vec<Option<Tree>> = if parallel {
            parts.par_iter_mut().map(|part| (part.items.len() > LEAF).then(|| self.alone(part.items))).collect()
        } else {
            Vec::new()
        };
        for (place, part) in parts.iter_mut().enumerate() {
            let child = if part.items.len() <= LEAF {
                let mut leaf = [u32::MAX; LEAF];
                leaf.iter_mut().zip(part.items.iter()).for_each(|(place, item)| *place = item.number);
                tree.leaves.push(leaf);
                Child::leaf(tree.leaves.len() - 1)
            } else if let Some(Some(below)) = below.get(place) {
                Child::node(tree.append(below))
            } else {
                Child::node(self.node(part.items, tree))
            };
            tree.nodes[k].put(place, part.bounds.min, part.bounds.max, child);
        }
        k as u32
    }

    fn alone(self, items: &mut [Item]) -> Tree {
        let mut tree = Tree::default();
        self.node(items, &mut tree);
        tree
    }

    /// Splits `items` into at most [`WIDTH`] parts: always the largest box that is not a leaf's.
    fn parts(self, items: &mut [Item]) -> Vec<Part<'_>> {
        let mut parts = Vec::with_capacity(WIDTH);
        parts.push(Part { bounds: Bounds::around(items), items });
        while parts.len() < WIDTH {
            let area = |k: &usize| self.area(&parts[*k].bounds);
            let splittable = (0..parts.len()).filter(|k| parts[*k].items.len() > LEAF);
            let Some(largest) = splittable.max_by(|k, l| area(k).total_cmp(&area(l))) else { break };
            let [left, right] = self.halves(parts.swap_remove(largest));
            parts.extend([left, right]);
        }
        parts
    }

    /// Splits a part in two where that promises the least work.
    fn halves(self, part: Part<'_>) -> [Part<'_>; 2] {
        let Part { items, .. } = part;
        let mut centers = Bounds::EMPTY;
        items.iter().for_each(|item| centers.add(item.center(), item.center()));
        let binning = Binning::new(&centers);
        let middle = match self.best_split(items, &binning) {
            Some((axis, bin)) => partition(items, |item| binning.bin(item)[axis] < bin),
            None => items.len() / 2,
        };
        let (left, right) = items.split_at_mut(middle);
        [left, right].map(|items| Part { bounds: Bounds::around(items), items })
    }

    /// The axis, and the first bin of the right half. `None` where all centres fall into one bin.
    fn best_split(self, items: &[Item], binning: &Binning) -> Option<(usize, usize)> {
        let mut bins = [[(Bounds::EMPTY, 0_usize); BINS]; 3];
        for item in items {
            let places = binning.bin(item);
            for axis in 0..3 {
                let (bounds, count) = &mut bins[axis][places[axis] % BINS];
                bounds.add(item.min, item.max);
                *count += 1;
            }
        }
        let mut best: Option<(f32, usize, usize)> = None;
        for (axis, bins) in bins.iter().enumerate() {
            let mut right_cost = [0.0; BINS];
            let mut right = (Bounds::EMPTY, 0);
            for k in (1..BINS).rev() {
                right = joined(right, bins[k]);
                right_cost[k] = self.cost(right);
            }
            let mut left = (Bounds::EMPTY, 0);
            for k in 1..BINS {
                left = joined(left, bins[k - 1]);
                let cost = self.cost(left) + right_cost[k];
                if 0 < left.1 && left.1 < items.len() && best.is_none_or(|(least, ..)| cost < least) {
                    best = Some((cost, axis, k));
                }
            }
        }
        best.map(|(_, axis, bin)| (axis, bin))
    }

    /// A leaf is tested as a whole, so started leaves count like full ones.
    fn cost(self, (bounds, count): (Bounds, usize)) -> f32 {
        if count == 0 { 0.0 } else { self.area(&bounds) * count.div_ceil(LEAF) as f32 }
    }

    /// Half of the surface of a box.
    fn area(self, bounds: &Bounds) -> f32 {
        let size = bounds.size() * self.scale;
        size.x * size.y + size.y * size.z + size.z * size.x
    }
}

struct Part<'a> {
    bounds: Bounds,
    items: &'a mut [Item],
}

impl Item {
    /// Halved before they are added: the sum may not overflow.
    fn center(&self) -> Vec3A {
        0.5 * self.min + 0.5 * self.max
    }
}

/// Which of [`BINS`] equal parts of the centres' box holds a centre, on each axis.
struct Binning {
    origin: Vec3A,
    bins_per_length: Vec3A,
}

impl Binning {
    fn new(centers: &Bounds) -> Self {
        let size = centers.size();
        let usable = size.cmpgt(Vec3A::ZERO);
        let per_length = Vec3A::select(usable, BINS as f32 / size, Vec3A::ZERO);
        Self { origin: centers.min, bins_per_length: per_length.min(Vec3A::splat(f32::MAX)) }
    }

    #[inline]
    fn bin(&self, item: &Item) -> [usize; 3] {
        let place = (item.center() - self.origin) * self.bins_per_length;
        place.to_array().map(|x| (x as usize).min(BINS - 1))
    }
}

#[derive(Clone, Copy)]
struct Bounds {
    min: Vec3A,
    max: Vec3A,
}

impl Bounds {
    const EMPTY: Self = Self { min: Vec3A::INFINITY, max: Vec3A::NEG_INFINITY };

    fn around(items: &[Item]) -> Self {
        let mut all = Self::EMPTY;
        items.iter().for_each(|item| all.add(item.min, item.max));
        all
    }

    #[inline]
    fn add(&mut self, min: Vec3A, max: Vec3A) {
        self.min = self.min.min(min);
        self.max = self.max.max(max);
    }

    fn size(&self) -> Vec3A {
        self.max - self.min
    }
}

fn joined(mut a: (Bounds, usize), b: (Bounds, usize)) -> (Bounds, usize) {
    a.0.add(b.0.min, b.0.max);
    (a.0, a.1 + b.1)
}

/// Moves the items that are on the left to the front, and counts them.
fn partition(items: &mut [Item], is_left: impl Fn(&Item) -> bool) -> usize {
    let (mut left, mut right) = (0, items.len());
    while left < right {
        if is_left(&items[left]) {
            left += 1;
        } else {
            right -= 1;
            items.swap(left, right);
        }
    }
    left
}
