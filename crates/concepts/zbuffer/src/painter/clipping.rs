//! What do two convex polygons have in common? Clip one by the edges of the other.

use glam::DVec2;

use super::facet::Facet;
use super::relation::{DepthDifferences, Relation};
use crate::screen::ScreenTriangle;

/// An overlap is none if its doubled area is less than this part of its extent squared: f64 keeps 52 bits, and the
/// corners of an overlap lose a few of them in each cut.
const NO_AREA: f64 = 1.0 / (1_u64 << 40) as f64;

/// What `a` is to `b`, the plain way: the polygon they have in common on the screen, and at each of its corners the
/// depths of both planes. The slow twin of [`relation`](super::relation()), in floating point throughout.
///
/// # Panics
/// As [`relation`](super::relation()).
#[must_use]
pub fn relation_by_clipping(a: &ScreenTriangle, b: &ScreenTriangle) -> Relation {
    match (Facet::new(a), Facet::new(b)) {
        (Some(a), Some(b)) => relation_of_polygons(&a, &a.outline(), &b, &b.outline()),
        _ => Relation::Free,
    }
}

/// What the polygon `p` in the plane of `a` is to the polygon `q` in the plane of `b`. Both are convex, anticlockwise.
pub(super) fn relation_of_polygons(a: &Facet, p: &[DVec2], b: &Facet, q: &[DVec2]) -> Relation {
    let overlap = intersection(p, q);
    if !has_area(&overlap) {
        return Relation::Free;
    }
    let mut differences = DepthDifferences::default();
    for corner in overlap {
        differences.add(a.depth_between(corner) - b.depth_between(corner));
    }
    differences.relation()
}

/// The polygon common to `p` and `q` (Sutherland and Hodgman): `p`, cut along each edge of `q` in turn.
fn intersection(p: &[DVec2], q: &[DVec2]) -> Vec<DVec2> {
    let mut rest = p.to_vec();
    for k in 0..q.len() {
        let (from, to) = (q[k], q[(k + 1) % q.len()]);
        rest = part_where_not_negative(&rest, |point| (to - from).perp_dot(point - from));
    }
    rest
}

/// The part of a convex polygon where an affine function is not negative.
pub(super) fn part_where_not_negative(polygon: &[DVec2], f: impl Fn(DVec2) -> f64) -> Vec<DVec2> {
    let mut part = Vec::with_capacity(polygon.len() + 1);
    for (k, corner) in polygon.iter().enumerate() {
        let next = polygon[(k + 1) % polygon.len()];
        let (here, there) = (f(*corner), f(next));
        if 0.0 <= here {
            part.push(*corner);
        }
        if (here < 0.0 && 0.0 < there) || (there < 0.0 && 0.0 < here) {
            part.push(corner.lerp(next, here / (here - there)));
        }
    }
    part
}

fn has_area(polygon: &[DVec2]) -> bool {
    let Some(first) = polygon.first() else {
        return false;
    };
    let arms = polygon.iter().map(|corner| *corner - *first);
    let doubled_area: f64 = arms.clone().zip(arms.clone().skip(1)).map(|(a, b)| a.perp_dot(b)).sum();
    let extent = arms.map(|arm| arm.abs().max_element()).fold(0.0, f64::max);
    NO_AREA * extent * extent < doubled_area
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::dvec2;

    #[test]
    fn two_triangles_share_a_pentagon() {
        let p = [dvec2(0.0, 0.0), dvec2(6.0, 0.0), dvec2(0.0, 6.0)];
        let q = [dvec2(1.0, -1.0), dvec2(9.0, 2.0), dvec2(1.0, 2.0)];
        let common = intersection(&p, &q);
        assert_eq!(common.len(), 5);
        for corner in [dvec2(1.0, 0.0), dvec2(11.0 / 3.0, 0.0), dvec2(4.0, 2.0), dvec2(1.0, 2.0)] {
            assert!(common.iter().any(|c| c.distance(corner) < 1e-14), "{corner} is missing in {common:?}");
        }
    }

    #[test]
    fn a_common_edge_has_no_area() {
        let p = [dvec2(0.0, 0.0), dvec2(6.0, 1.0), dvec2(0.0, 6.0)];
        let q = [dvec2(6.0, 1.0), dvec2(0.0, 0.0), dvec2(3.0, -5.0)];
        assert!(!has_area(&intersection(&p, &q)));
    }
}
