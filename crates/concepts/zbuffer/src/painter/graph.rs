//! Who hides whom, all at once, and which polygons stand in each other's way because of it?

use super::boxes::Boxes;
use super::facet::Bounds;
use super::relation::Relation;

/// The greatest number of constraints that are stored: 16 MB of them.
const GREATEST_GRAPH: usize = 1 << 22;

/// For each of n polygons those that it hides in part.
pub(super) struct Graph {
    /// Polygon k's begin at `starts[k]` and end at `starts[k + 1]`.
    starts: Vec<usize>,
    behind: Vec<u32>,
}

impl Graph {
    /// The graph of polygons with these boxes; `relation(a, b)` says what a is to b. `None` if it is too large to keep, or
    /// as soon as `relation` gives none: even to look at all pairs takes long where all overlap.
    pub(super) fn new(
        bounds: &[Bounds],
        relation: impl Fn(usize, usize) -> Option<Relation>,
    ) -> Option<Self> {
        let boxes = Boxes::new(&bounds.iter().copied().map(Some).collect::<Vec<_>>());
        let (mut starts, mut behind) = (vec![0], Vec::new());
        for (front, bounds) in bounds.iter().enumerate() {
            let mut cursor = 0;
            while let Some(back) = boxes.next_behind(bounds, &mut cursor) {
                if back != front && matches!(relation(back, front)?, Relation::Behind | Relation::Piercing) {
                    behind.push(back as u32);
                }
            }
            if GREATEST_GRAPH < behind.len() {
                return None;
            }
            behind[starts[front]..].sort_unstable();
            starts.push(behind.len());
        }
        Some(Self { starts, behind })
    }

    fn len(&self) -> usize {
        self.starts.len() - 1
    }

    /// What polygon `front` hides in part, by index.
    pub(super) fn behind(&self, front: usize) -> impl Iterator<Item = usize> + use<'_> {
        self.behind[self.starts[front]..self.starts[front + 1]].iter().map(|back| *back as usize)
    }

    /// All pairs that pass through each other, each once.
    pub(super) fn piercing_pairs(&self) -> Vec<(usize, usize)> {
        let pairs = (0..self.len()).flat_map(|a| self.behind(a).map(move |b| (a, b)));
        pairs.filter(|(a, b)| a < b && self.hides(*b, *a)).collect()
    }

    /// The graph without the pairs that pass through each other.
    pub(super) fn without_piercing_pairs(&self) -> Self {
        let (mut starts, mut behind) = (vec![0], Vec::new());
        for a in 0..self.len() {
            behind.extend(self.behind(a).filter(|b| !self.hides(*b, a)).map(|b| b as u32));
            starts.push(behind.len());
        }
        Self { starts, behind }
    }

    fn hides(&self, front: usize, back: usize) -> bool {
        self.behind[self.starts[front]..self.starts[front + 1]].binary_search(&(back as u32)).is_ok()
    }

    /// The strongly connected components, from back to front: one polygon each where an order exists, several where
    /// they form cycles. What a component hides lies in it or in an earlier one.
    ///
    /// Tarjan's algorithm, with a stack of its own instead of a recursion that could be n deep.
    pub(super) fn components(&self) -> Vec<Vec<usize>> {
        let mut walk = Walk::new(self);
        (0..self.len()).for_each(|polygon| walk.from(polygon));
        walk.components
    }
}

/// The state of Tarjan's walk.
struct Walk<'a> {
    graph: &'a Graph,
    /// When the walk came by, counted from 1; 0 for never.
    number: Vec<usize>,
    /// The earliest number that is known to be reachable; `DONE` once the component is complete.
    lowest: Vec<usize>,
    count: usize,
    /// What has been reached but belongs to no complete component.
    open: Vec<usize>,
    components: Vec<Vec<usize>>,
}

const DONE: usize = usize::MAX;

impl<'a> Walk<'a> {
    fn new(graph: &'a Graph) -> Self {
        let n = graph.len();
        Self {
            graph,
            number: vec![0; n],
            lowest: vec![0; n],
            count: 0,
            open: Vec::new(),
            components: Vec::new(),
        }
    }

    fn from(&mut self, first: usize) {
        let mut path = Vec::new();
        self.enter(first, &mut path);
        while let Some((polygon, next)) = path.last_mut() {
            let polygon = *polygon;
            if let Some(back) = self.graph.behind[..self.graph.starts[polygon + 1]].get(*next) {
                let back = *back as usize;
                *next += 1;
                if self.number[back] == 0 {
                    self.enter(back, &mut path);
                } else if self.lowest[back] != DONE {
                    self.lowest[polygon] = self.lowest[polygon].min(self.number[back]);
                }
            } else {
                path.pop();
                self.leave(polygon, path.last().map(|(front, _)| *front));
            }
        }
    }

    fn enter(&mut self, polygon: usize, path: &mut Vec<(usize, usize)>) {
        if self.number[polygon] == 0 {
            self.count += 1;
            (self.number[polygon], self.lowest[polygon]) = (self.count, self.count);
            self.open.push(polygon);
            path.push((polygon, self.graph.starts[polygon]));
        }
    }

    fn leave(&mut self, polygon: usize, front: Option<usize>) {
        if self.lowest[polygon] == self.number[polygon] {
            let start = self.open.iter().rposition(|open| *open == polygon).unwrap_or(0);
            let mut component = self.open.split_off(start);
            component.sort_unstable();
            component.iter().for_each(|member| self.lowest[*member] = DONE);
            self.components.push(component);
        } else if let Some(front) = front {
            self.lowest[front] = self.lowest[front].min(self.lowest[polygon]);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn graph(behind: &[&[u32]]) -> Graph {
        let mut starts = vec![0];
        for list in behind {
            starts.push(starts[starts.len() - 1] + list.len());
        }
        Graph { starts, behind: behind.concat() }
    }

    #[test]
    fn components_come_from_back_to_front() {
        // 3 hides 1, which is on a cycle with 4 and 2; the cycle hides 0; 5 is alone.
        let graph = graph(&[&[], &[0, 4], &[1], &[1], &[2], &[]]);
        assert_eq!(graph.components(), [vec![0], vec![1, 2, 4], vec![3], vec![5]]);
    }

    #[test]
    fn pairs_that_pierce_are_listed_once_and_can_be_left_out() {
        let graph = graph(&[&[1, 2], &[0], &[1]]);
        assert_eq!(graph.piercing_pairs(), [(0, 1)]);
        assert_eq!(graph.without_piercing_pairs().components(), [[1], [2], [0]]);
    }
}
