//! Which things should share a box? Those that a ray meets together.
//!
//! From the root down: the boxes of a range of things are split in two where the *surface area heuristic* expects the
//! least work: a random ray meets a box with a chance in proportion to its area, and then has to test the things in it
//! (MacDonald and Booth, 1990). At most fifteen places along each axis are tried (Wald, *On fast Construction of SAH-based Bounding Volume
//! Hierarchies*, 2007). The part with the largest box is split again until a node has its eight children.
//!
//! The shape depends on the boxes alone; threads only share the work of building parts that are decided already.

use geometry::Aabb;
use rayon::prelude::*;

use super::bins::{BINS, Binning, Bounds, Item, joined, partition};
use super::tree::{Child, LEAF, Node, Tree, WIDTH};

/// Ranges with more things than this are built by tasks of their own.
const TASK: usize = 8192;

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
        let size = ItemRange::new(&mut items).bounds.size().max_element();
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
    fn parts(self, items: &mut [Item]) -> Vec<ItemRange<'_>> {
        let mut parts = Vec::with_capacity(WIDTH);
        parts.push(ItemRange::new(items));
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
    fn halves(self, part: ItemRange<'_>) -> [ItemRange<'_>; 2] {
        let ItemRange { items, centers, .. } = part;
        let binning = Binning::new(&centers, items.len());
        let Some(split) = self.best_split(items, &binning) else {
            let (left, right) = items.split_at_mut(items.len() / 2);
            return [ItemRange::new(left), ItemRange::new(right)];
        };
        let (middle, centers) = partition(items, |item| binning.bin(item)[split.axis] < split.bin);
        let (left, right) = items.split_at_mut(middle);
        [
            ItemRange { bounds: split.left, centers: centers[0], items: left },
            ItemRange { bounds: split.right, centers: centers[1], items: right },
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

struct ItemRange<'a> {
    /// Around the items, and around their centres.
    bounds: Bounds,
    centers: Bounds,
    items: &'a mut [Item],
}

impl<'a> ItemRange<'a> {
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

#[cfg(test)]
mod tests {
    use geometry::shapes;

    use super::*;

    /// More boxes than one task builds.
    fn boxes() -> Vec<Aabb> {
        let mesh = shapes::icosphere(5).unwrap();
        (0..mesh.len()).map(|k| mesh.triangle(k).aabb()).collect()
    }

    #[test]
    fn any_number_of_threads_builds_the_same_tree() {
        let boxes = boxes();
        assert!(boxes.len() > 2 * TASK);
        let built = |threads: usize| {
            let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
            pool.install(|| Tree::new(&boxes))
        };
        let one = built(1);
        assert!(one == built(2) && one == built(5));
    }

    #[test]
    fn each_thing_is_in_one_leaf_and_empty_ones_in_none() {
        let mut boxes = boxes();
        boxes[7] = Aabb::EMPTY;
        let tree = Tree::new(&boxes);
        let mut things: Vec<u32> = (0..tree.leaves.len()).flat_map(|leaf| tree.things(leaf)).collect();
        things.sort_unstable();
        assert!(things.iter().copied().eq((0..boxes.len() as u32).filter(|k| *k != 7)));
        // Not merely correct: leaves are mostly full.
        assert!(tree.leaves.len() * LEAF < 3 * things.len() / 2, "{} leaves", tree.leaves.len());
    }

    #[test]
    fn a_thousand_equal_boxes_and_boxes_at_the_ends_of_the_range_make_a_tree() {
        let unit = Aabb { min: glam::Vec3::ZERO, max: glam::Vec3::ONE };
        let huge = Aabb { min: glam::Vec3::splat(f32::MIN), max: glam::Vec3::splat(f32::MAX) };
        let mut boxes = vec![unit; 1000];
        boxes.extend([huge; 9]);
        let tree = Tree::new(&boxes);
        assert_eq!((0..tree.leaves.len()).flat_map(|leaf| tree.things(leaf)).count(), 1009);
    }
}
