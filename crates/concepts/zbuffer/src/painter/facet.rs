//! Where is a triangle on the screen, exactly, and how deep is it there?

use glam::{DVec2, DVec3, I64Vec2};

use crate::screen::{GREATEST_PIXEL, SUBPIXELS, ScreenTriangle};

/// A triangle that covers something: its corners on the 1/256-pixel grid, anticlockwise, and their depths.
///
/// The depths are those of the vertices, wherever they were snapped to: so neighbors in a mesh meet in their common edge, and neither
/// hides the other. Fragments have the depth of the unsnapped plane instead; the two differ by at most √2/512 pixel of its slope.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Facet {
    pub(super) corners: [I64Vec2; 3],
    pub(super) depths: [f64; 3],
    doubled_area: i64,
}

/// A box around a facet or a part of one: x and y in 1/256 pixels, z in depth.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Bounds {
    pub(super) min: DVec3,
    pub(super) max: DVec3,
}

impl Facet {
    /// `None` if the triangle has no area once it is snapped: it covers no pixel.
    ///
    /// # Panics
    /// If a coordinate is not finite or a position lies beyond [`GREATEST_PIXEL`].
    pub(super) fn new(triangle: &ScreenTriangle) -> Option<Self> {
        for vertex in &triangle.vertices {
            let p = vertex.position;
            assert!(
                p.is_finite() && p.truncate().abs().max_element() <= GREATEST_PIXEL,
                "a vertex at {p} is not on the screen; clip first"
            );
        }
        let [a, b, c] = triangle.vertices;
        let doubled_area = triangle.doubled_area();
        let anticlockwise = if doubled_area < 0 { [a, c, b] } else { [a, b, c] };
        (doubled_area != 0).then(|| Self {
            corners: anticlockwise.map(|v| v.snapped()),
            depths: anticlockwise.map(|v| v.position.z),
            doubled_area: doubled_area.abs(),
        })
    }

    /// Twice the area of the triangle (corner k, corner k+1, `p`): positive if `p` lies on the inner side of edge k,
    /// 0 on its line. Exact.
    pub(super) fn side(&self, k: usize, p: I64Vec2) -> i64 {
        let (from, to) = (self.corners[k], self.corners[(k + 1) % 3]);
        (to - from).perp_dot(p - from)
    }

    /// The depth at the point with these three sides. Exact sides of a point inside give a depth to a few 2^−53.
    pub(super) fn depth_from_sides(&self, sides: [i64; 3]) -> f64 {
        let [a, b, c] = self.depths;
        // Edge k lies opposite corner k+2, so side k is that corner's weight.
        let rise = sides[2] as f64 * (b - a) + sides[0] as f64 * (c - a);
        a + rise / self.doubled_area as f64
    }

    /// The depth of the plane at a point of the grid.
    pub(super) fn depth_at(&self, p: I64Vec2) -> f64 {
        self.depth_from_sides([0, 1, 2].map(|k| self.side(k, p)))
    }

    /// The depth of the plane at a point between those of the grid.
    pub(super) fn depth_between(&self, p: DVec2) -> f64 {
        let [a, b, c] = self.corners.map(|corner| corner.as_dvec2());
        let [za, zb, zc] = self.depths;
        let weight_b = (a - c).perp_dot(p - c);
        let weight_c = (b - a).perp_dot(p - a);
        za + (weight_b * (zb - za) + weight_c * (zc - za)) / self.doubled_area as f64
    }

    /// How large the products are that [`Facet::depth_at`] adds up at `p`: its rounding is a few 2^−53 of this.
    pub(super) fn magnitude_at(&self, p: I64Vec2) -> f64 {
        let [a, b, c] = self.depths;
        let terms = self.side(2, p) as f64 * (b - a).abs();
        let others = self.side(0, p) as f64 * (c - a).abs();
        a.abs() + (terms.abs() + others.abs()) / self.doubled_area as f64
    }

    pub(super) fn doubled_area(&self) -> i64 {
        self.doubled_area
    }

    /// The corners as a polygon.
    pub(super) fn outline(&self) -> Vec<DVec2> {
        self.corners.iter().map(|corner| corner.as_dvec2()).collect()
    }

    /// The least and the greatest depth of a corner.
    pub(super) fn depth_range(&self) -> (f64, f64) {
        let [a, b, c] = self.depths;
        (a.min(b).min(c), a.max(b).max(c))
    }

    pub(super) fn bounds(&self) -> Bounds {
        let [a, b, c] = self.corners;
        let (min, max) = self.depth_range();
        Bounds { min: a.min(b).min(c).as_dvec2().extend(min), max: a.max(b).max(c).as_dvec2().extend(max) }
    }
}

impl Bounds {
    /// The box that holds both.
    pub(super) fn union(&self, other: &Self) -> Self {
        Self { min: self.min.min(other.min), max: self.max.max(other.max) }
    }

    /// Whether something in this box can be hidden by something in `front`: they overlap on the screen, a common
    /// border aside, and this box reaches farther back than the other's nearest depth.
    pub(super) fn can_be_behind(&self, front: &Self) -> bool {
        self.min.x < front.max.x
            && front.min.x < self.max.x
            && self.min.y < front.max.y
            && front.min.y < self.max.y
            && self.min.z < front.max.z
    }
}

/// The centre of pixel (i, j) on the grid.
pub(super) fn pixel_centre(i: i64, j: i64) -> I64Vec2 {
    SUBPIXELS * I64Vec2::new(i, j)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::painter::example::triangle;

    #[test]
    fn depth_is_affine_between_the_corners_whatever_the_orientation() {
        let corners = [[1.0, 2.0, 0.5], [9.0, 2.0, 0.25], [1.0, 6.0, -0.5]];
        let front = Facet::new(&triangle(corners)).unwrap();
        let back = Facet::new(&triangle([corners[2], corners[1], corners[0]])).unwrap();
        // (5, 3) = ¼ a + ½ b + ¼ c.
        for facet in [front, back] {
            assert_eq!(facet.depth_at(pixel_centre(5, 3)), 0.125);
            assert_eq!(facet.depth_between(pixel_centre(5, 3).as_dvec2()), 0.125);
        }
    }

    #[test]
    fn a_triangle_that_snaps_to_a_line_is_no_facet() {
        assert!(Facet::new(&triangle([[0.0, 0.0, 0.1], [8.0, 0.001, 0.2], [4.0, 0.0, 0.3]])).is_none());
    }

    #[test]
    #[should_panic(expected = "clip first")]
    fn a_vertex_off_the_screen_is_the_callers_mistake() {
        let _ = Facet::new(&triangle([[0.0, 0.0, 0.1], [3e6, 0.0, 0.2], [4.0, 5.0, 0.3]]));
    }
}
