//! Which polygons stand in each other's way?

use std::collections::{HashMap, VecDeque};
use std::fmt;

/// Polygons that no order can draw: each is hidden in part by the next, and the last by the first (L14, Fig 8.9).
///
/// Two polygons form a cycle if they pass through each other; flat polygons that do not need at least three.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct OcclusionCycle {
    /// Indices of the triangles, the smallest first.
    pub polygons: Vec<usize>,
}

impl OcclusionCycle {
    /// Whether it is two polygons that pass through each other.
    #[must_use]
    pub fn is_piercing(&self) -> bool {
        self.polygons.len() == 2
    }

    /// A cycle in which each polygon hides a part of the next.
    fn from_front_to_back(mut polygons: Vec<usize>) -> Self {
        polygons.reverse();
        let smallest = polygons.iter().enumerate().min_by_key(|(_, polygon)| **polygon).map_or(0, |(k, _)| k);
        polygons.rotate_left(smallest);
        Self { polygons }
    }

    /// The cycle of two neighbours on this one that pierce each other, if any do.
    pub(super) fn piercing_pair(&self, pierce: impl Fn(usize, usize) -> bool) -> Option<Self> {
        let next = self.polygons.iter().cycle().skip(1);
        let (a, b) = self.polygons.iter().zip(next).find(|(a, b)| pierce(**a, **b))?;
        Some(Self { polygons: vec![*a.min(b), *a.max(b)] })
    }

    /// A shortest cycle through `start`, where `behind(p)` names the polygons that p hides in part. `None` if there is
    /// no cycle through `start`.
    pub(super) fn shortest_through<I: IntoIterator<Item = usize>>(
        start: usize,
        mut behind: impl FnMut(usize) -> I,
    ) -> Option<Self> {
        // Breadth first, so the first way back to the start is a shortest one.
        let mut reached_from = HashMap::new();
        let mut queue = VecDeque::from([start]);
        while let Some(front) = queue.pop_front() {
            for back in behind(front) {
                if back == start {
                    return Some(Self::from_front_to_back(way(start, front, &reached_from)));
                }
                reached_from.entry(back).or_insert_with(|| {
                    queue.push_back(back);
                    front
                });
            }
        }
        None
    }
}

/// The way from `start` to `end`, both included.
fn way(start: usize, end: usize, reached_from: &HashMap<usize, usize>) -> Vec<usize> {
    let mut way = vec![end];
    while way[way.len() - 1] != start {
        way.push(reached_from[&way[way.len() - 1]]);
    }
    way.reverse();
    way
}

impl fmt::Display for OcclusionCycle {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if let [a, b] = self.polygons[..] {
            return write!(f, "polygons {a} and {b} pass through each other: no order draws them right");
        }
        let names: Vec<_> = self.polygons.iter().map(ToString::to_string).collect();
        write!(
            f,
            "polygons {} hide each other in a cycle, each hidden in part by the next: no order draws them right",
            names.join(", ")
        )
    }
}

impl std::error::Error for OcclusionCycle {}

#[cfg(test)]
mod tests {
    use super::*;

    /// 4 hides 7 hides 2 hides 4, and there is a longer way round through 9.
    fn behind(polygon: usize) -> Vec<usize> {
        match polygon {
            4 => vec![9, 7],
            9 => vec![7],
            7 => vec![2],
            2 => vec![4, 5],
            _ => vec![],
        }
    }

    #[test]
    fn the_shortest_cycle_runs_from_hidden_to_hiding_and_begins_with_the_smallest() {
        for start in [2, 4, 7] {
            let cycle = OcclusionCycle::shortest_through(start, behind).unwrap();
            assert_eq!(cycle.polygons, [2, 7, 4]);
        }
        assert_eq!(OcclusionCycle::shortest_through(9, behind).unwrap().polygons, [2, 7, 9, 4]);
        assert_eq!(OcclusionCycle::shortest_through(5, behind), None);
    }

    #[test]
    fn the_message_names_the_polygons() {
        let cycle = OcclusionCycle { polygons: vec![2, 7, 4] };
        assert!(cycle.to_string().starts_with("polygons 2, 7, 4 hide each other in a cycle"));
    }
}
