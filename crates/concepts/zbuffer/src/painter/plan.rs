//! What if there is no order? Cut polygons until there is one, after Newell, Newell and Sancha.

use std::sync::Arc;

use super::budget::Budget;
use super::cycle::OcclusionCycle;
use super::facet::Facet;
use super::graph::Graph;
use super::order::order_within;
use super::outlined_piece::{OutlinedPiece, Position};
use super::piece::Piece;
use crate::screen::ScreenTriangle;

/// What to draw over what, so that each pixel shows the nearest triangle. Made by [`plan`].
#[derive(Clone, Debug, PartialEq)]
pub struct Plan {
    /// Triangles and parts of triangles, from back to front. Together they have each pixel of each triangle once.
    pub pieces: Vec<Piece>,
    /// What made cuts necessary: every pair of triangles that pass through each other, then a shortest cycle for each
    /// group of other triangles that hide each other in cycles (L14). Empty if [`order`](super::order()) finds an order. If there are
    /// too many overlaps to keep (four million), only the first cycle that was found.
    pub cycles: Vec<OcclusionCycle>,
    /// How many times a triangle or a part of one was cut in two.
    pub splits: usize,
}

/// A drawing order that always exists: where [`order`](super::order()) meets a cycle or triangles that pass through each other, polygons
/// are cut along the planes of others (Newell).
///
/// Without cycles the pieces are the whole triangles, in the order of [`order`](super::order()). Only triangles on cycles are cut, and
/// only if they reach through the plane that cuts. Triangles that all pass through each other still give a number of
/// pieces that grows with the square of theirs, as the picture itself can.
///
/// # Panics
/// As [`order`](super::order()).
#[must_use]
pub fn plan(triangles: &[ScreenTriangle]) -> Plan {
    plan_within(triangles, u64::MAX).expect("nobody lives to see 2^64 comparisons")
}

/// The same plan as [`plan`] gives, or `None` if it takes more than so many comparisons of two polygons: many that lie in
/// one place, or that all pass through each other.
///
/// # Panics
/// As [`order`](super::order()).
#[must_use]
pub fn plan_within(triangles: &[ScreenTriangle], most_comparisons: u64) -> Option<Plan> {
    let budget = Budget::new(most_comparisons);
    let order = order_within(triangles, &budget);
    if budget.is_spent() {
        return None;
    }
    let plan = match order {
        Ok(order) => {
            Plan { pieces: order.into_iter().map(Piece::whole).collect(), cycles: Vec::new(), splits: 0 }
        }
        Err(cycle) => plan_with_cuts(triangles, cycle, &budget),
    };
    (!budget.is_spent()).then_some(plan)
}

fn plan_with_cuts(triangles: &[ScreenTriangle], first_cycle: OcclusionCycle, budget: &Budget) -> Plan {
    let mut untangling = Untangling { pieces: Vec::new(), splits: 0, budget };
    let mut parts = Vec::new();
    for (k, triangle) in triangles.iter().enumerate() {
        match Facet::new(triangle) {
            Some(facet) => parts.push(OutlinedPiece::whole(k, Arc::new(facet))),
            // Without area it hides nothing and draws nothing.
            None => untangling.pieces.push(Piece::whole(k)),
        }
    }
    let graph = graph_of(&parts, budget);
    let cycles = graph.as_ref().map_or_else(|| vec![first_cycle], |graph| cycles(&parts, graph));
    untangling.draw(untangled(parts, graph));
    Plan { pieces: untangling.pieces, cycles, splits: untangling.splits }
}

/// What stands in the way of an order: pairs that pass through each other, and a cycle for each group of others.
fn cycles(parts: &[OutlinedPiece], graph: &Graph) -> Vec<OcclusionCycle> {
    let pairs = graph.piercing_pairs().into_iter().map(|(a, b)| OcclusionCycle { polygons: vec![a, b] });
    let rest = graph.without_piercing_pairs();
    let groups: Vec<_> = rest.components().into_iter().filter(|group| group.len() > 1).collect();
    let mut group_of = vec![usize::MAX; parts.len()];
    for (k, group) in groups.iter().enumerate() {
        group.iter().for_each(|member| group_of[*member] = k);
    }
    let shortest = |(k, group): (usize, &Vec<usize>)| {
        // A cycle never leaves its group: no need to look at the rest of the scene for each of them.
        let within = |front| rest.behind(front).filter(|back| group_of[*back] == k);
        OcclusionCycle::shortest_through(group[0], within)
    };
    let others: Vec<_> = groups.iter().enumerate().filter_map(shortest).collect();
    // The graph counts parts; triangles without area are not among them.
    let name = |k: usize| parts[k].triangle();
    let named =
        |cycle: OcclusionCycle| OcclusionCycle { polygons: cycle.polygons.into_iter().map(name).collect() };
    pairs.chain(others).map(named).collect()
}

/// What comparing two parts, which are polygons, costs in comparisons of two triangles.
const PRICE_OF_PARTS: usize = 4;

/// Who hides whom; `None` if it is too large to keep, or if the budget does not reach.
fn graph_of(parts: &[OutlinedPiece], budget: &Budget) -> Option<Graph> {
    let bounds: Vec<_> = parts.iter().map(OutlinedPiece::bounds).collect();
    Graph::new(&bounds, |a, b| budget.pay(PRICE_OF_PARTS).then(|| parts[a].relation(&parts[b])))
}

/// What remains to be done, the next at the end.
enum Task {
    /// Draw these in a right order. At most one of them is a part of each triangle.
    Untangle(Vec<OutlinedPiece>),
    /// Draw these, which form cycles.
    Divide(Vec<OutlinedPiece>),
    /// Draw this.
    Draw(OutlinedPiece),
}

/// The pieces so far.
struct Untangling<'a> {
    pieces: Vec<Piece>,
    splits: usize,
    budget: &'a Budget,
}

impl Untangling<'_> {
    /// Does all tasks. Where parts form a cycle, the plane of one of them divides the others.
    ///
    /// It ends: no two parts in a task belong to the same triangle, as a cut puts one half before the plane and one
    /// behind it; and each division takes out a triangle, so that on the way from the first task to any other there
    /// are at most n divisions.
    fn draw(&mut self, mut tasks: Vec<Task>) {
        while let Some(task) = tasks.pop() {
            if self.budget.is_spent() {
                return;
            }
            match task {
                Task::Untangle(parts) => {
                    let graph = graph_of(&parts, self.budget);
                    tasks.extend(untangled(parts, graph));
                }
                Task::Divide(parts) => tasks.extend(self.divided(parts)),
                Task::Draw(part) => self.pieces.push(part.into_piece()),
            }
        }
    }

    /// What lies behind the plane of one of the parts, this part, and what lies before it; in reverse, as the last is
    /// done first. Nothing behind a plane hides anything before it.
    fn divided(&mut self, mut parts: Vec<OutlinedPiece>) -> [Task; 3] {
        // Each part is held against every candidate and then against the root.
        self.budget.pay((CANDIDATES + 1) * parts.len());
        let root = parts.remove(best_root(&parts));
        let (mut behind, mut before) = (Vec::new(), Vec::new());
        for part in parts {
            match part.position(&root) {
                Position::Behind => behind.push(part),
                Position::Before => before.push(part),
                Position::Through => {
                    let (nearer, farther) = part.split(&root);
                    before.push(nearer);
                    behind.push(farther);
                    self.splits += 1;
                }
            }
        }
        [Task::Untangle(before), Task::Draw(root), Task::Untangle(behind)]
    }
}

/// Single parts and groups that form cycles, from front to back, as the last is done first.
/// Without a graph, all parts count as one group.
fn untangled(parts: Vec<OutlinedPiece>, graph: Option<Graph>) -> Vec<Task> {
    let Some(graph) = graph else {
        return vec![Task::Divide(parts)];
    };
    let mut parts: Vec<_> = parts.into_iter().map(Some).collect();
    let task = |component: Vec<usize>| {
        let mut members: Vec<_> = component.into_iter().filter_map(|k| parts[k].take()).collect();
        if members.len() == 1 { Task::Draw(members.remove(0)) } else { Task::Divide(members) }
    };
    let mut tasks: Vec<_> = graph.components().into_iter().map(task).collect();
    tasks.reverse();
    tasks
}

/// How many parts are tried as the one whose plane divides the others.
const CANDIDATES: usize = 8;

/// The part whose plane cuts the fewest others, among the largest triangles: the slope of a large one is known best.
fn best_root(parts: &[OutlinedPiece]) -> usize {
    let mut candidates: Vec<usize> = (0..parts.len()).collect();
    candidates.sort_by_key(|k| std::cmp::Reverse(parts[*k].area_of_triangle()));
    candidates.truncate(CANDIDATES);
    let cuts = |k: usize| parts.iter().filter(|part| part.position(&parts[k]) == Position::Through).count();
    candidates.into_iter().min_by_key(|k| cuts(*k)).unwrap_or(0)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::painter::example::{three_polygon_cycle, triangle};

    #[test]
    fn without_cycles_the_plan_is_the_order() {
        let flat = |z: f32| triangle([[0.0, 1.0, z], [9.0, 2.0, z], [3.0, 7.0, z]]);
        let plan = plan(&[flat(0.3), flat(-0.2), flat(0.1)]);
        assert_eq!(plan.pieces.iter().map(|piece| piece.triangle).collect::<Vec<_>>(), [1, 2, 0]);
        assert!(plan.cycles.is_empty() && plan.splits == 0);
    }

    #[test]
    fn too_much_work_is_declined_and_enough_is_done() {
        let fan: Vec<_> = (0..40)
            .map(|k| {
                let x = k as f32;
                triangle([[0.0, x, 0.75], [40.0, 40.0 - x, -0.5], [x, 40.0, 0.1 * (x / 40.0)]])
            })
            .collect();
        assert!(plan_within(&fan, 10).is_none());
        assert!(plan_within(&fan, 2_000).is_none(), "the order fails soon, but the cuts take more");
        assert_eq!(plan_within(&fan, 100_000_000), Some(plan(&fan)));
    }

    #[test]
    fn the_cycle_of_three_is_named_and_opened() {
        let plan = plan(&three_polygon_cycle());
        assert_eq!(plan.cycles, [OcclusionCycle { polygons: vec![0, 2, 1] }]);
        // The plane of one runs through both others.
        assert_eq!((plan.splits, plan.pieces.len()), (2, 5));
    }

    #[test]
    fn a_division_pays_for_eight_candidates_and_the_root() {
        // 9 comparisons for each of three parts: 27.
        for (comparisons, is_spent) in [(27, true), (28, false)] {
            let budget = Budget::new(comparisons);
            let facet = |triangle| Arc::new(Facet::new(triangle).unwrap());
            let cycle = three_polygon_cycle();
            let parts = cycle.iter().enumerate().map(|(k, it)| OutlinedPiece::whole(k, facet(it))).collect();
            Untangling { pieces: Vec::new(), splits: 0, budget: &budget }.divided(parts);
            assert_eq!(budget.is_spent(), is_spent, "{comparisons}");
        }
    }

    #[test]
    fn of_two_that_pierce_one_is_cut() {
        let ramp = triangle([[0.0, 0.0, 0.75], [12.0, 1.0, -0.5], [0.0, 9.0, 0.75]]);
        let flat = triangle([[-5.0, 3.0, 0.0], [12.0, 2.0, 0.0], [2.0, 5.0, 0.0]]);
        let line = triangle([[0.0, 0.0, 0.9], [8.0, 8.0, -0.9], [4.0, 4.0, 0.3]]);
        let plan = plan(&[ramp, line, flat]);
        assert_eq!(plan.cycles, [OcclusionCycle { polygons: vec![0, 2] }]);
        assert_eq!((plan.splits, plan.pieces.len()), (1, 4));
        assert_eq!(plan.pieces[0], Piece::whole(1));
    }
}
