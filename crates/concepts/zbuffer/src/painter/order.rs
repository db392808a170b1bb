//! In which order do polygons draw the right picture? From back to front, where "back" is decided pair by pair.

use super::boxes::Boxes;
use super::budget::Budget;
use super::cycle::OcclusionCycle;
use super::facet::{Bounds, Facet};
use super::relation::{Relation, relation_of_facets};
use crate::screen::ScreenTriangle;

/// The painter's algorithm as the slide has it, "from back to front" (L13): sorted by each polygon's farthest vertex.
///
/// Short, and wrong: a long polygon begins far away and can still lie over others that begin nearer. [`order`] asks
/// what really hides what.
///
/// - Result: indices, in the order of drawing. Polygons that begin equally far away keep their order.
#[must_use]
pub fn order_by_depth(triangles: &[ScreenTriangle]) -> Vec<usize> {
    let farthest =
        |k: &usize| triangles[*k].vertices.map(|v| v.position.z).into_iter().fold(f64::INFINITY, f64::min);
    let mut order: Vec<usize> = (0..triangles.len()).collect();
    order.sort_by(|a, b| farthest(a).total_cmp(&farthest(b)));
    order
}

/// The order in which to draw triangles over each other, so that each pixel shows the nearest (L13).
///
/// Every triangle stands after all that it hides in part, as [`relation`](super::relation()) has it. Among the orders
/// that do so it stays close to [`order_by_depth`], and it is the same in every run. Triangles without area are listed
/// too.
///
/// All pairs that overlap are compared, and few that do not: about n log n steps for a mesh whose triangles overlap a
/// few others each, n² at worst. Memory is linear in n in any case, as no comparison is stored.
///
/// # Errors
/// An [`OcclusionCycle`] if there is no such order (L14). [`plan`](super::plan()) then cuts polygons.
///
/// # Panics
/// If a coordinate is not finite or a position lies beyond [`GREATEST_PIXEL`](crate::screen::GREATEST_PIXEL).
///
/// ```
/// use glam::{Vec3, vec3};
/// use zbuffer::painter;
/// # use geometry::Barycentric;
/// # use zbuffer::{ScreenTriangle, ScreenVertex};
/// # let triangle = |corners: [Vec3; 3]| ScreenTriangle {
/// #     vertices: corners.map(|position| ScreenVertex { position: position.as_dvec3(), inv_w: -1.0, weights: Barycentric::A }),
/// # };
/// // Under the near end of a long floor, but nearer than its far end.
/// let below = triangle([vec3(3.0, 1.0, 0.1), vec3(6.0, 1.0, 0.1), vec3(5.0, 2.0, 0.2)]);
/// let floor = triangle([vec3(0.0, 0.0, 0.8), vec3(9.0, 0.0, 0.8), vec3(5.0, 7.0, -0.9)]);
/// assert_eq!(painter::order_by_depth(&[below, floor]), [1, 0]); // the floor first: wrong
/// assert_eq!(painter::order(&[below, floor])?, [0, 1]);
/// # Ok::<(), painter::OcclusionCycle>(())
/// ```
pub fn order(triangles: &[ScreenTriangle]) -> Result<Vec<usize>, OcclusionCycle> {
    order_within(triangles, &Budget::unlimited())
}

/// [`order`], or anything at all once the budget is spent.
pub(super) fn order_within(
    triangles: &[ScreenTriangle],
    budget: &Budget,
) -> Result<Vec<usize>, OcclusionCycle> {
    let facets: Vec<_> = triangles.iter().map(Facet::new).collect();
    let mut canvas = Canvas::new(&facets, budget);
    for first in order_by_depth(triangles) {
        canvas.draw_after_all_behind(first)?;
    }
    Ok(canvas.drawn)
}

/// What has been drawn, and what has not.
struct Canvas<'a> {
    facets: &'a [Option<Facet>],
    budget: &'a Budget,
    /// The boxes of what is not drawn yet.
    boxes: Boxes,
    drawn: Vec<usize>,
    is_drawn: Vec<bool>,
    /// Whether the polygon waits for those behind it to be drawn.
    waits: Vec<bool>,
}

/// A polygon that waits for those behind it, and how far the search for them has come.
struct Waiting {
    polygon: usize,
    bounds: Bounds,
    cursor: usize,
}

impl<'a> Canvas<'a> {
    fn new(facets: &'a [Option<Facet>], budget: &'a Budget) -> Self {
        let bounds: Vec<_> = facets.iter().map(|facet| Some(facet.as_ref()?.bounds())).collect();
        Self {
            facets,
            budget,
            boxes: Boxes::new(&bounds),
            drawn: Vec::with_capacity(facets.len()),
            is_drawn: vec![false; facets.len()],
            waits: vec![false; facets.len()],
        }
    }

    /// Draws a polygon, but before it all that it hides in part, and before those all that they hide.
    ///
    /// A polygon that must wait for itself is on a cycle. The stack stands for a recursion, which could be n deep.
    fn draw_after_all_behind(&mut self, first: usize) -> Result<(), OcclusionCycle> {
        let mut stack = Vec::new();
        self.begin(first, &mut stack);
        while let Some(top) = stack.last_mut() {
            match self.next_behind(top) {
                Some(behind) if self.waits[behind] => return Err(self.cycle_through(behind)),
                Some(behind) => self.begin(behind, &mut stack),
                None => {
                    self.draw(top.polygon);
                    stack.pop();
                }
            }
        }
        Ok(())
    }

    fn begin(&mut self, polygon: usize, stack: &mut Vec<Waiting>) {
        if self.is_drawn[polygon] {
            return;
        }
        match &self.facets[polygon] {
            Some(facet) => {
                self.waits[polygon] = true;
                stack.push(Waiting { polygon, bounds: facet.bounds(), cursor: 0 });
            }
            None => self.draw(polygon),
        }
    }

    fn draw(&mut self, polygon: usize) {
        self.waits[polygon] = false;
        self.is_drawn[polygon] = true;
        self.boxes.remove(polygon);
        self.drawn.push(polygon);
    }

    /// The next polygon that is not drawn yet and that this one hides in part.
    fn next_behind(&self, waiting: &mut Waiting) -> Option<usize> {
        let front = self.facets[waiting.polygon].as_ref()?;
        loop {
            let candidate = self.boxes.next_behind(&waiting.bounds, &mut waiting.cursor)?;
            if !self.budget.pay(1) {
                return None;
            }
            let back = self.facets[candidate].as_ref()?;
            let hides = || matches!(relation_of_facets(back, front), Relation::Behind | Relation::Piercing);
            if candidate != waiting.polygon && hides() {
                return Some(candidate);
            }
        }
    }

    /// A shortest cycle through a polygon that is known to be on one, or two of its members that pass through each other.
    /// None of its polygons is drawn yet.
    fn cycle_through(&self, polygon: usize) -> OcclusionCycle {
        let all_behind = |front: usize| {
            let bounds = self.facets[front].as_ref().map(Facet::bounds);
            let mut search = bounds.map(|bounds| Waiting { polygon: front, bounds, cursor: 0 });
            std::iter::from_fn(move || self.next_behind(search.as_mut()?))
        };
        let cycle = // Only a spent budget can hide the way back; then nobody looks at the answer.
        OcclusionCycle::shortest_through(polygon, all_behind)
            .unwrap_or_else(|| OcclusionCycle { polygons: vec![polygon] });
        cycle.piercing_pair(|a, b| self.pierce(a, b)).unwrap_or(cycle)
    }

    fn pierce(&self, a: usize, b: usize) -> bool {
        let (Some(a), Some(b)) = (&self.facets[a], &self.facets[b]) else {
            return false;
        };
        relation_of_facets(a, b) == Relation::Piercing
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::painter::example::{three_polygon_cycle, triangle};

    /// A floor from near to far, and a tile under its near end.
    fn floor_and_tile() -> [ScreenTriangle; 2] {
        let floor = triangle([[0.0, 0.0, 0.75], [30.0, 1.0, 0.75], [14.0, 20.0, -0.9]]);
        let tile = triangle([[10.0, 2.0, 0.25], [18.0, 3.0, 0.25], [15.0, 7.0, -0.5]]);
        [tile, floor]
    }

    #[test]
    fn the_slides_sort_by_depth_paints_the_floor_over_by_what_lies_under_it() {
        assert_eq!(order_by_depth(&floor_and_tile()), [1, 0]);
        assert_eq!(order(&floor_and_tile()), Ok(vec![0, 1]));
    }

    #[test]
    fn the_cycle_of_three_is_found_and_named_in_any_input_order() {
        let cycle = three_polygon_cycle();
        for [a, b, c] in [[0, 1, 2], [0, 2, 1], [1, 0, 2], [1, 2, 0], [2, 0, 1], [2, 1, 0]] {
            // A tile that has nothing to do with it stands in front of the list.
            let triangles = [floor_and_tile()[0], cycle[a], cycle[b], cycle[c]];
            let found = order(&triangles).unwrap_err();
            let place = |k: usize| 1 + [a, b, c].iter().position(|x| *x == k).unwrap();
            // Each lies over the next, so each is hidden by the one before.
            let from_first = [1, 2, 3].map(|p| [a, b, c][p - 1]);
            let hidden_by = |k: usize| place((from_first[k - 1] + 2) % 3);
            assert_eq!(found.polygons, [1, hidden_by(1), hidden_by(hidden_by(1))]);
            assert!(!found.is_piercing());
        }
    }

    #[test]
    fn two_polygons_that_pass_through_each_other_are_a_cycle_of_two() {
        let ramp = triangle([[0.0, 0.0, 0.75], [12.0, 1.0, -0.5], [0.0, 9.0, 0.75]]);
        let flat = triangle([[-5.0, 3.0, 0.0], [12.0, 2.0, 0.0], [2.0, 5.0, 0.0]]);
        let far = triangle([[-5.0, 3.0, -0.9], [12.0, 2.0, -0.9], [2.0, 5.0, -0.9]]);
        let found = order(&[ramp, far, flat]).unwrap_err();
        assert_eq!(found.polygons, [0, 2]);
        assert!(found.is_piercing());
    }

    #[test]
    fn triangles_without_area_are_listed_and_in_nobodys_way() {
        let [tile, floor] = floor_and_tile();
        let line = triangle([[0.0, 0.0, 0.9], [8.0, 8.0, -0.9], [4.0, 4.0, 0.3]]);
        assert_eq!(order(&[line, tile, line, floor]).unwrap().len(), 4);
        assert_eq!(order(&[]), Ok(vec![]));
    }
}
