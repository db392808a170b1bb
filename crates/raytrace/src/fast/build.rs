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
        let mut items: Vec<Item> =
            boxes.iter().enumerate().filter(|(_, aabb)| !aabb.is_empty()).map(item).collect();
        if items.is_empty() {
            return Self::default();
        }
        let size = Part::new(&mut items).bounds.size().max_element();
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
            parts
                .par_iter_mut()
                .map(|part| (part.items.len() > LEAF).then(|| self.alone(part.items)))
                .collect()
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
        parts.push(Part::new(items));
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
        let Part { items, centers, .. } = part;
        let binning = Binning::new(&centers, items.len());
        let Some(split) = self.best_split(items, &binning) else {
            let (left, right) = items.split_at_mut(items.len() / 2);
            return [Part::new(left), Part::new(right)];
        };
        let (middle, centers) = partition(items, |item| binning.bin(item)[split.axis] < split.bin);
        let (left, right) = items.split_at_mut(middle);
        [
            Part { bounds: split.left, centers: centers[0], items: left },
            Part { bounds: split.right, centers: centers[1], items: right },
        ]
    }

    /// The split between two bins that promises the least work. `None` where all centres fall into one bin.
    fn best_split(self, items: &[Item], binning: &Binning) -> Option<Split> {
        let mut bins = [[(Bounds::EMPTY, 0_u32); BINS]; 3];
        for item in items {
            let places = binning.bin(item);
            for axis in 0..3 {
                let (bounds, count) = &mut bins[axis][places[axis] as usize];
                bounds.add(item.min, item.max);
                *count += 1;
            }
        }
        let mut best: Option<Split> = None;
        for (axis, bins) in bins.iter().enumerate() {
            let bins = &bins[..binning.count];
            let mut from_right = [(Bounds::EMPTY, 0); BINS];
            let mut right = (Bounds::EMPTY, 0);
            for k in (1..bins.len()).rev() {
                right = joined(right, bins[k]);
                from_right[k] = right;
            }
            let mut left = (Bounds::EMPTY, 0);
            for k in 1..bins.len() {
                left = joined(left, bins[k - 1]);
                let right = from_right[k];
                let cost = self.cost(left) + self.cost(right);
                if left.1 > 0 && right.1 > 0 && best.as_ref().is_none_or(|best| cost < best.cost) {
                    best = Some(Split { cost, axis, bin: k as u32, left: left.0, right: right.0 });
                }
            }
        }
        best
    }

    /// A leaf is tested as a whole, so started leaves count like full ones.
    fn cost(self, (bounds, count): (Bounds, u32)) -> f32 {
        self.area(&bounds) * count.div_ceil(LEAF as u32) as f32
    }

    /// Half of the surface of a box.
    fn area(self, bounds: &Bounds) -> f32 {
        let size = bounds.size() * self.scale;
        size.x * size.y + size.y * size.z + size.z * size.x
    }
}

struct Part<'a> {
    /// Around the items, and around their centres.
    bounds: Bounds,
    centers: Bounds,
    items: &'a mut [Item],
}

impl<'a> Part<'a> {
    fn new(items: &'a mut [Item]) -> Self {
        let (mut bounds, mut centers) = (Bounds::EMPTY, Bounds::EMPTY);
        for item in items.iter() {
            bounds.add(item.min, item.max);
            centers.add(item.center(), item.center());
        }
        Self { bounds, centers, items }
    }
}

/// Where to split: before `bin`, counted along `axis`.
struct Split {
    cost: f32,
    axis: usize,
    bin: u32,
    left: Bounds,
    right: Bounds,
}

impl Item {
    /// Halved before they are added: the sum may not overflow.
    #[inline(always)]
    fn center(&self) -> Vec3A {
        0.5 * self.min + 0.5 * self.max
    }
}

/// Which of equal parts of the centres' box holds a centre, on each axis.
struct Binning {
    origin: Vec3A,
    bins_per_length: Vec3A,
    /// How many parts: few for few items.
    count: usize,
}

impl Binning {
    fn new(centers: &Bounds, items: usize) -> Self {
        let count = items.clamp(4, BINS);
        let size = centers.size();
        let per_length = Vec3A::select(size.cmpgt(Vec3A::ZERO), (count - 1) as f32 / size, Vec3A::ZERO);
        Self { origin: centers.min, bins_per_length: per_length.min(Vec3A::splat(f32::MAX)), count }
    }

    /// The number of the bin along each axis, rounded to the nearest: 2²³ more, a number ends with that of the bin.
    #[inline(always)]
    fn bin(&self, item: &Item) -> [u32; 3] {
        const SHIFT: Vec3A = Vec3A::splat((1_u32 << 23) as f32);
        let place = (item.center() - self.origin) * self.bins_per_length + SHIFT;
        [place.x.to_bits() % BINS as u32, place.y.to_bits() % BINS as u32, place.z.to_bits() % BINS as u32]
    }
}

#[derive(Clone, Copy)]
struct Bounds {
    min: Vec3A,
    max: Vec3A,
}

impl Bounds {
    const EMPTY: Self = Self { min: Vec3A::INFINITY, max: Vec3A::NEG_INFINITY };

    #[inline(always)]
    fn add(&mut self, min: Vec3A, max: Vec3A) {
        self.min = self.min.min(min);
        self.max = self.max.max(max);
    }

    fn size(&self) -> Vec3A {
        self.max - self.min
    }
}

fn joined(mut a: (Bounds, u32), b: (Bounds, u32)) -> (Bounds, u32) {
    a.0.add(b.0.min, b.0.max);
    (a.0, a.1 + b.1)
}

/// Moves the items that are on the left to the front and counts them; and the boxes around the centres of either side.
#[inline(always)]
fn partition(items: &mut [Item], is_left: impl Fn(&Item) -> bool) -> (usize, [Bounds; 2]) {
    let (mut left, mut right) = (0, items.len());
    let mut centers = [Bounds::EMPTY; 2];
    while left < right {
        let item = &items[left];
        let center = item.center();
        if is_left(item) {
            centers[0].add(center, center);
            left += 1;
        } else {
            centers[1].add(center, center);
            right -= 1;
            items.swap(left, right);
        }
    }
    (left, centers)
}
