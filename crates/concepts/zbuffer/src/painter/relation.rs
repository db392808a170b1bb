//! Does one triangle hide a part of another? Where both are on the screen at once, their depths decide.

use super::facet::Facet;
use crate::screen::ScreenTriangle;

/// How far apart two depths must lie before one counts as nearer: 2 · 2^−23.
///
/// Each of the two depths is a mean of its triangle's three, with weights from 0 to 1, so it is off by no more than a
/// vertex is, however steep the triangle. A vertex's depth, a quotient of f32 sums of size 1, counts as known to one
/// unit in the last place of 1: 2^−23. The comparison itself, in f64, adds less than 2^−48.
pub const DEPTH_TOLERANCE: f64 = 2.0 * f32::EPSILON as f64;

/// What one triangle is to another.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Relation {
    /// Neither hides the other: apart on the screen, or equally deep wherever they overlap.
    Free,
    /// It is hidden in part by the other, so it must be drawn first.
    Behind,
    /// It hides a part of the other, so it must be drawn later.
    InFront,
    /// Each hides a part of the other: they pass through each other.
    Piercing,
}

/// What `a` is to `b`.
///
/// - On the screen: exact, by separating edges on the 1/256-pixel grid. Triangles that share an edge or only touch do
///   not overlap; one without area overlaps nothing.
/// - In depth: the difference of the two depths is affine where they overlap, so its extremes lie at the corners of the
///   overlap. Differences up to [`DEPTH_TOLERANCE`] count as none.
///
/// [`relation_by_clipping`](super::relation_by_clipping) is the plain twin.
///
/// # Panics
/// If a coordinate is not finite or a position lies beyond [`GREATEST_PIXEL`](crate::screen::GREATEST_PIXEL).
///
/// ```
/// use glam::{Vec3, vec3};
/// use zbuffer::painter::{Relation, relation};
/// # use geometry::Barycentric;
/// # use zbuffer::{ScreenTriangle, ScreenVertex};
/// # let triangle = |corners: [Vec3; 3]| ScreenTriangle {
/// #     vertices: corners.map(|position| ScreenVertex { position: position.as_dvec3(), inv_w: -1.0, weights: Barycentric::A }),
/// # };
/// let floor = triangle([vec3(0.0, 0.0, 0.8), vec3(9.0, 0.0, 0.8), vec3(5.0, 7.0, -0.9)]);
/// let below = triangle([vec3(3.0, 1.0, 0.1), vec3(6.0, 1.0, 0.1), vec3(5.0, 2.0, 0.2)]);
/// assert_eq!(relation(&below, &floor), Relation::Behind);
/// ```
#[must_use]
pub fn relation(a: &ScreenTriangle, b: &ScreenTriangle) -> Relation {
    match (Facet::new(a), Facet::new(b)) {
        (Some(a), Some(b)) => relation_of_facets(&a, &b),
        _ => Relation::Free,
    }
}

/// [`relation`], once the triangles are known to have an area.
pub(super) fn relation_of_facets(a: &Facet, b: &Facet) -> Relation {
    // sides[k][v]: on which side of edge k lies the other's corner v?
    let sides_of_a = [0, 1, 2].map(|k| a.corners.map(|corner| b.side(k, corner)));
    if has_separating_edge(&sides_of_a) {
        return Relation::Free;
    }
    let sides_of_b = [0, 1, 2].map(|k| b.corners.map(|corner| a.side(k, corner)));
    if has_separating_edge(&sides_of_b) {
        return Relation::Free;
    }
    let mut differences = DepthDifferences::default();
    for v in 0..3 {
        if let Some(depth) = depth_if_inside(b, sides_of_a.map(|edge| edge[v])) {
            differences.add(a.depths[v] - depth);
        }
        if let Some(depth) = depth_if_inside(a, sides_of_b.map(|edge| edge[v])) {
            differences.add(depth - b.depths[v]);
        }
    }
    for (e, f) in EDGE_PAIRS {
        let crossing_on_a = crossing(sides_of_a[f], e);
        let crossing_on_b = crossing(sides_of_b[e], f);
        if let (Some(s), Some(t)) = (crossing_on_a, crossing_on_b) {
            differences.add(depth_on_edge(a, e, s) - depth_on_edge(b, f, t));
        }
    }
    differences.relation()
}

const EDGE_PAIRS: [(usize, usize); 9] =
    [(0, 0), (0, 1), (0, 2), (1, 0), (1, 1), (1, 2), (2, 0), (2, 1), (2, 2)];

/// Whether all corners lie outside one edge or on its line. In the plane, convex polygons without a common inner point
/// are separated by the line of an edge.
fn has_separating_edge(sides: &[[i64; 3]; 3]) -> bool {
    sides.iter().any(|edge| edge.iter().all(|side| *side <= 0))
}

fn depth_if_inside(facet: &Facet, sides: [i64; 3]) -> Option<f64> {
    sides.iter().all(|side| 0 <= *side).then(|| facet.depth_from_sides(sides))
}

/// Where on its edge from corner v to v+1 a triangle crosses the line with these sides, 0 to 1, if it really crosses.
fn crossing(sides: [i64; 3], v: usize) -> Option<f64> {
    let (from, to) = (sides[v], sides[(v + 1) % 3]);
    (from.signum() * to.signum() < 0).then(|| from as f64 / (from - to) as f64)
}

fn depth_on_edge(facet: &Facet, v: usize, t: f64) -> f64 {
    let (from, to) = (facet.depths[v], facet.depths[(v + 1) % 3]);
    from + t * (to - from)
}

/// The range of the depth differences a − b at the corners of an overlap. Larger is nearer.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct DepthDifferences {
    least: f64,
    greatest: f64,
}

impl DepthDifferences {
    pub(super) fn add(&mut self, difference: f64) {
        self.least = self.least.min(difference);
        self.greatest = self.greatest.max(difference);
    }

    pub(super) fn relation(&self) -> Relation {
        match (self.least < -DEPTH_TOLERANCE, DEPTH_TOLERANCE < self.greatest) {
            (false, false) => Relation::Free,
            (true, false) => Relation::Behind,
            (false, true) => Relation::InFront,
            (true, true) => Relation::Piercing,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::painter::example::{three_polygon_cycle, triangle};

    const WALL: [[f32; 3]; 3] = [[1.0, 1.0, 0.25], [9.0, 2.0, 0.5], [3.0, 8.0, -0.25]];

    #[test]
    fn neighbours_on_a_common_edge_are_free_even_if_one_is_far_steeper() {
        let [a, b, _] = WALL;
        let neighbour = triangle([b, a, [5.0, -6.0, -1.0]]);
        assert_eq!(relation(&triangle(WALL), &neighbour), Relation::Free);
    }

    #[test]
    fn a_fold_over_a_common_edge_is_decided_by_the_free_corner() {
        let [a, b, _] = WALL;
        let folded = triangle([a, b, [4.0, 7.0, 0.0]]);
        assert_eq!(relation(&folded, &triangle(WALL)), Relation::InFront);
        assert_eq!(relation(&triangle(WALL), &folded), Relation::Behind);
    }

    #[test]
    fn a_corner_that_touches_an_edge_does_not_overlap() {
        let touching = triangle([[5.0, 1.5, 0.9], [2.0, -4.0, 0.9], [7.0, -4.0, 0.9]]);
        assert_eq!(relation(&triangle(WALL), &touching), Relation::Free);
    }

    #[test]
    fn an_overlap_of_one_grid_step_counts() {
        let by_a_step = triangle([[5.0, 1.5 + 1.0 / 256.0, 0.9], [2.0, -4.0, 0.9], [7.0, -4.0, 0.9]]);
        assert_eq!(relation(&triangle(WALL), &by_a_step), Relation::Behind);
    }

    #[test]
    fn planes_that_cross_beside_the_overlap_do_not_pierce() {
        // The planes cross at x = 6; on the overlap, x < 4, the ramp is nearer.
        let ramp = triangle([[0.0, 0.0, 0.75], [4.0, 1.0, 0.25], [0.0, 9.0, 0.75]]);
        let flat = triangle([[-5.0, 3.0, 0.0], [12.0, 2.0, 0.0], [2.0, 5.0, 0.0]]);
        assert_eq!(relation(&ramp, &flat), Relation::InFront);
    }

    #[test]
    fn polygons_that_pass_through_each_other_pierce() {
        let ramp = triangle([[0.0, 0.0, 0.75], [12.0, 1.0, -0.5], [0.0, 9.0, 0.75]]);
        let flat = triangle([[-5.0, 3.0, 0.0], [12.0, 2.0, 0.0], [2.0, 5.0, 0.0]]);
        assert_eq!(relation(&ramp, &flat), Relation::Piercing);
        assert_eq!(relation(&flat, &ramp), Relation::Piercing);
    }

    #[test]
    fn a_difference_within_the_tolerance_is_none() {
        let lifted = |by: f32| triangle(WALL.map(|[x, y, z]| [x + 1.0, y, z + by]));
        let flat = |z: f32| triangle(WALL.map(|[x, y, _]| [x, y, z]));
        assert_eq!(relation(&flat(0.5), &flat(0.5 + 2.0 * f32::EPSILON)), Relation::Free);
        assert_eq!(relation(&flat(0.5), &flat(0.5 + 3.0 * f32::EPSILON)), Relation::Behind);
        assert_eq!(relation(&triangle(WALL), &lifted(1.0)), Relation::Behind);
    }

    #[test]
    fn each_of_the_three_long_triangles_lies_over_the_next() {
        let [a, b, c] = three_polygon_cycle();
        for (over, under) in [(a, b), (b, c), (c, a)] {
            assert_eq!(relation(&over, &under), Relation::InFront);
        }
    }
}
