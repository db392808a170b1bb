//! What does "from back to front" mean, word by word? Draw a polygon once nothing is left that it hides.

use super::clipping::relation_by_clipping;
use super::relation::Relation;
use crate::screen::ScreenTriangle;

/// An order as [`order`](super::order()) gives it, the slow way: of the polygons that are left, draw the first that hides no
/// other, until none is left (L13). `None` if each of those left hides another: there is a cycle (L14).
///
/// Up to n³ comparisons, each by [`relation_by_clipping`]: the yardstick for the fast one, not for use.
///
/// # Panics
/// As [`relation`](super::relation()).
#[must_use]
pub fn order_of_all_pairs(triangles: &[ScreenTriangle]) -> Option<Vec<usize>> {
    let hides = |front: usize, back: usize| {
        let relation = relation_by_clipping(&triangles[front], &triangles[back]);
        matches!(relation, Relation::InFront | Relation::Piercing)
    };
    let mut left: Vec<usize> = (0..triangles.len()).collect();
    let mut order = Vec::new();
    while !left.is_empty() {
        let hides_none = |k: &usize| left.iter().all(|other| other == k || !hides(*k, *other));
        let next = left.iter().position(hides_none)?;
        order.push(left.remove(next));
    }
    Some(order)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::painter::example::{three_polygon_cycle, triangle};

    #[test]
    fn what_hides_nothing_is_drawn_first() {
        let flat = |z: f32| triangle([[0.0, 1.0, z], [9.0, 2.0, z], [3.0, 7.0, z]]);
        assert_eq!(order_of_all_pairs(&[flat(0.3), flat(-0.2), flat(0.1)]), Some(vec![1, 2, 0]));
    }

    #[test]
    fn the_cycle_of_three_has_no_order() {
        assert_eq!(order_of_all_pairs(&three_polygon_cycle()), None);
    }
}
