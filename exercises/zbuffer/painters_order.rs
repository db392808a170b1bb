//! The painter's order, from back to front (L13, L14).
//!
//! The painter's algorithm draws polygons one over the other, so a polygon must be drawn after all those that it hides. Given is
//! which polygon hides a part of which; give an order in which they can be drawn, the first one drawn first.
//!
//! - `count`: how many polygons there are; they have the numbers 0 … count − 1.
//! - `occlusions`: pairs of polygons, the one `behind` partly hidden by the one `in_front`. In any order; a pair may be there
//!   twice. No polygon hides itself. Polygons without a pair may be drawn at any time, but they are drawn too.
//! - The answer holds every polygon once. Where several orders are possible, each is right.
//! - `None` if no order is possible: there is an occlusion cycle, as in Fig 8.9.

use vocabulary::Occlusion;

pub fn painters_order(count: usize, occlusions: &[Occlusion]) -> Option<Vec<usize>> {
    todo!()
}
