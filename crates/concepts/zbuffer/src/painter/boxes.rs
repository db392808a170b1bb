//! Which polygons come into question at all? A tree of bounding boxes finds them; its memory is linear in their number.

use super::facet::Bounds;

/// A binary tree of boxes, in the order in which a walk meets them. Items can be taken out, after which no search finds
/// them and no search walks through what is empty.
pub(super) struct Boxes {
    nodes: Vec<Node>,
    /// The leaf of each item; items without box have none.
    leaves: Vec<usize>,
}

struct Node {
    bounds: Bounds,
    /// The node that follows on this one and all below it: where the walk goes on if there is nothing to find here.
    skip: usize,
    parent: usize,
    /// How many items below have not been taken out.
    left: usize,
    /// The item of a leaf.
    item: Option<usize>,
}

/// The parent of the root, and the leaf of an item without box.
const NONE: usize = usize::MAX;

impl Boxes {
    /// The tree over these boxes; item k has box k, and without box it is never found.
    pub(super) fn new(bounds: &[Option<Bounds>]) -> Self {
        let mut items: Vec<(usize, Bounds)> =
            bounds.iter().enumerate().filter_map(|(item, bounds)| Some((item, (*bounds)?))).collect();
        let mut boxes = Self { nodes: Vec::with_capacity(2 * items.len()), leaves: vec![NONE; bounds.len()] };
        if !items.is_empty() {
            boxes.grow(&mut items, NONE);
        }
        boxes
    }

    fn grow(&mut self, items: &mut [(usize, Bounds)], parent: usize) {
        let node = self.nodes.len();
        let bounds = items.iter().map(|(_, bounds)| *bounds).reduce(|a, b| a.union(&b));
        let bounds = bounds.expect("a node holds at least one item");
        let item = (items.len() == 1).then(|| items[0].0);
        self.nodes.push(Node { bounds, skip: 0, parent, left: items.len(), item });
        if let Some(item) = item {
            self.leaves[item] = node;
        } else {
            let axis = axis_to_divide(items);
            let key = |(item, bounds): &(usize, Bounds)| (bounds.min[axis] + bounds.max[axis], *item);
            let middle = items.len() / 2;
            items.select_nth_unstable_by(middle, |a, b| {
                let ((a, i), (b, k)) = (key(a), key(b));
                a.total_cmp(&b).then(i.cmp(&k))
            });
            let (low, high) = items.split_at_mut(middle);
            self.grow(low, node);
            self.grow(high, node);
        }
        self.nodes[node].skip = self.nodes.len();
    }

    /// The next item, from `cursor` on, whose box can hold something hidden by something in `front`. Moves `cursor`
    /// past it; a search begins with 0.
    pub(super) fn next_behind(&self, front: &Bounds, cursor: &mut usize) -> Option<usize> {
        while let Some(node) = self.nodes.get(*cursor) {
            if node.left == 0 || !node.bounds.can_be_behind(front) {
                *cursor = node.skip;
                continue;
            }
            *cursor += 1;
            if node.item.is_some() {
                return node.item;
            }
        }
        None
    }

    /// Takes an item out. One without box was never in.
    pub(super) fn remove(&mut self, item: usize) {
        let mut node = self.leaves[item];
        while node != NONE {
            self.nodes[node].left -= 1;
            node = self.nodes[node].parent;
        }
    }
}

/// The axis along which the boxes lie apart the most, measured in boxes: their depth only if they lie on top of each
/// other on the screen, as flat polygons would otherwise be divided by depth alone.
fn axis_to_divide(items: &[(usize, Bounds)]) -> usize {
    let spread = |axis: usize| {
        let (mut low, mut high, mut sizes) = (f64::INFINITY, f64::NEG_INFINITY, 0.0);
        for (_, bounds) in items {
            let centre = 0.5 * (bounds.min[axis] + bounds.max[axis]);
            (low, high) = (low.min(centre), high.max(centre));
            sizes += bounds.max[axis] - bounds.min[axis];
        }
        (high - low) * items.len() as f64 / sizes
    };
    let (x, y) = (spread(0), spread(1));
    if x.max(y) < 1.0 {
        2
    } else if x < y {
        1
    } else {
        0
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::dvec3;

    fn column(k: usize) -> Option<Bounds> {
        let x = 3.0 * k as f64;
        // Boxes 5 wide, so each overlaps its neighbours; deeper and deeper.
        Some(Bounds { min: dvec3(x, 0.0, -x), max: dvec3(x + 5.0, 7.0, -x + 0.5) })
    }

    fn found(boxes: &Boxes, front: &Bounds) -> Vec<usize> {
        let mut cursor = 0;
        let mut found: Vec<_> = std::iter::from_fn(|| boxes.next_behind(front, &mut cursor)).collect();
        found.sort_unstable();
        found
    }

    /// Two boxes of 2 × 2 × 2 whose centers are (5, 7, 0) and that plus the vector.
    fn two_apart_by(x: f64, y: f64, z: f64) -> [(usize, Bounds); 2] {
        [dvec3(5.0, 7.0, 0.0), dvec3(5.0 + x, 7.0 + y, z)].map(|p| (0, Bounds { min: p - 1.0, max: p + 1.0 }))
    }

    #[test]
    fn boxes_are_divided_along_the_axis_on_which_they_lie_apart() {
        assert_eq!(axis_to_divide(&two_apart_by(10.0, 1.0, 50.0)), 0);
        assert_eq!(axis_to_divide(&two_apart_by(1.0, 10.0, 50.0)), 1);
        assert_eq!(axis_to_divide(&two_apart_by(1.0, 1.5, 50.0)), 2, "they lie on top of each other");
        // The borders: boxes that touch lie beside each other, and of two equal axes x is taken.
        assert_eq!(axis_to_divide(&two_apart_by(2.0, 1.0, 50.0)), 0);
        assert_eq!(axis_to_divide(&two_apart_by(6.0, 6.0, 50.0)), 0);
    }

    #[test]
    fn a_search_finds_what_overlaps_and_reaches_behind_until_it_is_taken_out() {
        let bounds: Vec<_> = (0..20).map(|k| if k == 9 { None } else { column(k) }).collect();
        let mut boxes = Boxes::new(&bounds);
        // 10 touches nothing of 8 but its neighbours 9 (no box) and 11; 11 lies deeper, and 10 meets itself.
        assert_eq!(found(&boxes, &column(10).unwrap()), [10, 11]);
        assert_eq!(found(&boxes, &column(9).unwrap()), [10]);
        boxes.remove(10);
        boxes.remove(9);
        assert_eq!(found(&boxes, &column(9).unwrap()), []);
        assert_eq!(found(&boxes, &column(11).unwrap()), [11, 12]);
    }
}
