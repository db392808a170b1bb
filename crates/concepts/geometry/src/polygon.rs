//! How is a polygon cut into triangles? A convex one as a fan, any other one ear by ear.

use glam::{DVec2, DVec3};

/// What a polygon turned out to be.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Shape {
    /// Its outline does not cross itself, and it has an area.
    Simple,
    /// Its outline crosses itself, so that no triangles cover it exactly.
    CrossesItself,
    /// All its corners lie on a line.
    WithoutArea,
}

impl Shape {
    /// Returns what to tell the author of the polygon, if anything.
    #[must_use]
    pub fn warning(self) -> Option<&'static str> {
        match self {
            Self::Simple => None,
            Self::CrossesItself => Some("a face crosses itself; it is cut into triangles as well as may be"),
            Self::WithoutArea => Some("a face with more than three corners has no area"),
        }
    }
}

/// Maximum number of point-in-triangle tests for all polygons of a file together. That is enough for a concave
/// polygon of ten thousand corners, and takes about a second.
pub const MOST_TESTS: u64 = 200_000_000;

/// Cuts a polygon in space into triangles over its corners, and says what it is. The corners may lie a little off a
/// common plane.
///
/// - `points`: the corners in order. Triangles run round as the polygon does.
/// - `tests_left`: number of point-in-triangle tests that may still be made, at first [`MOST_TESTS`]; lowered by those made.
/// - Result: each triangle as places in `points`; `None` if `tests_left` runs out.
///
/// ```
/// use geometry::polygon::{MOST_TESTS, Shape, triangulate};
/// use glam::dvec3;
///
/// // An arrowhead with its dent at (1, 0, 0): a fan from the first corner would cover the outside too.
/// let arrow = [dvec3(0.0, -2.0, 0.0), dvec3(5.0, 0.0, 0.0), dvec3(0.0, 2.0, 0.0), dvec3(1.0, 0.0, 0.0)];
/// let (triangles, shape) = triangulate(&arrow, &mut MOST_TESTS.clone()).unwrap();
/// assert_eq!((triangles, shape), (vec![[3, 0, 1], [1, 2, 3]], Shape::Simple));
/// ```
#[must_use]
pub fn triangulate(points: &[DVec3], tests_left: &mut u64) -> Option<(Vec<[usize; 3]>, Shape)> {
    let fan = || (2..points.len()).map(|k| [0, k - 1, k]).collect();
    if points.len() == 3 {
        return Some((fan(), Shape::Simple));
    }
    let Some(flat) = on_its_plane(points) else {
        return Some((fan(), Shape::WithoutArea));
    };
    if turns_left_everywhere(&flat) {
        // A pentagram turns left everywhere too, but goes round twice.
        let shape = if rounds(&flat) < 1.5 { Shape::Simple } else { Shape::CrossesItself };
        return Some((fan(), shape));
    }
    Ears::new(&flat).clip(tests_left)
}

/// The polygon in coordinates of its mean plane, anticlockwise. `None` if it has no area.
fn on_its_plane(points: &[DVec3]) -> Option<Vec<DVec2>> {
    let from_first = || points.iter().map(|p| *p - points[0]);
    let size = from_first().map(|p| p.abs().max_element()).fold(0.0, f64::max);
    // Newell's normal: the sum over a fan, right for concave and for bent polygons too.
    let normal: DVec3 = from_first().zip(from_first().skip(1)).map(|(p, q)| (p / size).cross(q / size)).sum();
    let normal = (normal.length() > STRAIGHT).then(|| normal.normalize())?;
    let (right, up) = normal.any_orthonormal_pair();
    Some(from_first().map(|p| DVec2::new(p.dot(right), p.dot(up)) / size).collect())
}

/// The sine of the angle below which a corner is straight: coordinates are rounded to f32, so no smaller angle is meant.
const STRAIGHT: f64 = f32::EPSILON as f64;

/// The sine of the left turn at `b` on the way from `a` to `c`; 0 where two points coincide.
fn turn(a: DVec2, b: DVec2, c: DVec2) -> f64 {
    let (before, after) = (b - a, c - b);
    let lengths = before.length() * after.length();
    if lengths > 0.0 { before.perp_dot(after) / lengths } else { 0.0 }
}

fn turns_left_everywhere(points: &[DVec2]) -> bool {
    corners(points).all(|(a, b, c)| turn(a, b, c) > STRAIGHT)
}

/// How many rounds all turns make together: one, unless the outline crosses itself.
fn rounds(points: &[DVec2]) -> f64 {
    corners(points).map(|(a, b, c)| (b - a).angle_to(c - b)).sum::<f64>() / std::f64::consts::TAU
}

fn corners(points: &[DVec2]) -> impl Iterator<Item = (DVec2, DVec2, DVec2)> {
    let n = points.len();
    (0..n).map(move |k| (points[k], points[(k + 1) % n], points[(k + 2) % n]))
}

/// A polygon that loses one ear after the other: a corner whose triangle holds no other corner.
struct Ears<'a> {
    points: &'a [DVec2],
    before: Vec<usize>,
    after: Vec<usize>,
    /// Corners that turned right at first. Of a polygon that does not cross itself only they can lie in an ear.
    reflex: Vec<usize>,
}

/// What counts as an ear, from what one wants to what must do when there is nothing better.
#[derive(Clone, Copy, PartialEq)]
enum Pickiness {
    /// It has an area, and no other corner lies in it or on its border.
    Strict,
    /// It may be flat, and corners may touch its border.
    Lenient,
    /// Anything.
    Desperate,
}

impl<'a> Ears<'a> {
    fn new(points: &'a [DVec2]) -> Self {
        let n = points.len();
        let before: Vec<_> = (0..n).map(|k| (k + n - 1) % n).collect();
        let after: Vec<_> = (0..n).map(|k| (k + 1) % n).collect();
        let turns_right = |k: &usize| turn(points[before[*k]], points[*k], points[after[*k]]) < -STRAIGHT;
        let reflex = (0..n).filter(turns_right).collect();
        Self { points, before, after, reflex }
    }

    fn clip(mut self, tests_left: &mut u64) -> Option<(Vec<[usize; 3]>, Shape)> {
        let mut triangles = Vec::with_capacity(self.points.len() - 2);
        let mut shape = Shape::Simple;
        let (mut corner, mut left, mut tried, mut pickiness) = (0, self.points.len(), 0, Pickiness::Strict);
        while left > 3 {
            if self.is_ear(corner, pickiness, tests_left)? {
                if pickiness == Pickiness::Desperate {
                    shape = Shape::CrossesItself;
                }
                triangles.push([self.before[corner], corner, self.after[corner]]);
                let next = self.after[corner];
                self.remove(corner);
                // Not the very next corner: ears from one corner in a row make slivers.
                corner = self.after[next];
                (left, tried, pickiness) = (left - 1, 0, Pickiness::Strict);
                continue;
            }
            corner = self.after[corner];
            tried += 1;
            if tried == left {
                tried = 0;
                pickiness =
                    if pickiness == Pickiness::Strict { Pickiness::Lenient } else { Pickiness::Desperate };
            }
        }
        triangles.push([self.before[corner], corner, self.after[corner]]);
        Some((triangles, shape))
    }

    fn is_ear(&self, corner: usize, pickiness: Pickiness, tests_left: &mut u64) -> Option<bool> {
        *tests_left = tests_left.checked_sub(1)?;
        let ends = [self.before[corner], corner, self.after[corner]];
        let [a, b, c] = ends.map(|k| self.points[k]);
        let turn = turn(a, b, c);
        let is_outward = match pickiness {
            Pickiness::Strict => turn > STRAIGHT,
            Pickiness::Lenient => turn >= -STRAIGHT,
            Pickiness::Desperate => return Some(true),
        };
        if !is_outward {
            return Some(false);
        }
        *tests_left = tests_left.checked_sub(self.reflex.len() as u64)?;
        // Another corner at the very place of an end is no obstacle: outlines with holes go to and fro along a bridge.
        let is_obstacle = |p: DVec2| p != a && p != b && p != c && is_in(p, [a, b, c], pickiness);
        Some(!self.reflex.iter().any(|k| is_obstacle(self.points[*k])))
    }

    fn remove(&mut self, corner: usize) {
        let (before, after) = (self.before[corner], self.after[corner]);
        self.after[before] = after;
        self.before[after] = before;
    }
}

/// Whether `p` lies in the anticlockwise triangle; on its border counts unless the search is lenient.
fn is_in(p: DVec2, [a, b, c]: [DVec2; 3], pickiness: Pickiness) -> bool {
    let inside = |from: DVec2, to: DVec2| {
        let side = (to - from).perp_dot(p - from);
        if pickiness == Pickiness::Strict { side >= 0.0 } else { side > 0.0 }
    };
    inside(a, b) && inside(b, c) && inside(c, a)
}

#[cfg(test)]
mod tests {
    use glam::dvec3;

    use super::*;

    fn cut_all(points: &[DVec3]) -> (Vec<[usize; 3]>, Shape) {
        triangulate(points, &mut MOST_TESTS.clone()).expect("small")
    }

    /// The signed area, seen from +z, of the triangles and of the least of them.
    fn areas(points: &[DVec3], triangles: &[[usize; 3]]) -> (f64, f64) {
        let area = |t: &[usize; 3]| 0.5 * (points[t[1]] - points[t[0]]).cross(points[t[2]] - points[t[0]]).z;
        (triangles.iter().map(area).sum(), triangles.iter().map(area).fold(f64::INFINITY, f64::min))
    }

    #[test]
    fn convex_polygon_becomes_a_fan() {
        let house =
            [(0.0, 0.0), (3.0, 0.0), (3.0, 2.0), (1.0, 4.0), (0.0, 2.5)].map(|(x, y)| dvec3(x, y, 7.0));
        assert_eq!(cut_all(&house), (vec![[0, 1, 2], [0, 2, 3], [0, 3, 4]], Shape::Simple));
    }

    #[test]
    fn concave_quad_is_cut_at_its_dent_wherever_it_begins() {
        // An arrowhead with its dent at (1, 0): a fan from a wing would cover the outside.
        let arrow = [(0.0, 2.0), (0.0, -2.0), (5.0, 0.0), (1.0, 0.0)];
        let arrow = [arrow[1], arrow[2], arrow[0], arrow[3]].map(|(x, y)| dvec3(x, y, 0.0));
        for start in 0..4 {
            let mut points = arrow;
            points.rotate_left(start);
            let (triangles, shape) = cut_all(&points);
            let (sum, least) = areas(&points, &triangles);
            assert_eq!((triangles.len(), shape, sum), (2, Shape::Simple, 8.0));
            assert!(least > 0.0, "starting at {start}: {triangles:?}");
        }
    }

    #[test]
    fn comb_and_spiral_keep_their_area() {
        let comb: Vec<_> = (0..20)
            .flat_map(|k| [(f64::from(k), 0.0), (f64::from(k) + 0.5, 5.0 + f64::from(k % 3))])
            .chain([(20.0, 9.0), (-1.0, 9.0)])
            .map(|(x, y)| dvec3(x, y, 0.0))
            .collect();
        let (triangles, shape) = cut_all(&comb);
        let (sum, least) = areas(&comb, &triangles);
        let shoelace: f64 = (0..comb.len()).map(|k| comb[k].cross(comb[(k + 1) % comb.len()]).z / 2.0).sum();
        assert_eq!((triangles.len(), shape), (comb.len() - 2, Shape::Simple));
        assert!((sum - shoelace).abs() < 1e-12 && least > 0.0);
    }

    #[test]
    fn corner_on_a_straight_edge_makes_no_flat_triangle() {
        // A rectangle with two more corners on its lower edge.
        let points = [(0.0, 0.0), (1.0, 0.0), (2.0, 0.0), (4.0, 0.0), (4.0, 3.0), (0.0, 3.0)]
            .map(|(x, y)| dvec3(x, y, 0.0));
        let (triangles, shape) = cut_all(&points);
        let (sum, least) = areas(&points, &triangles);
        assert_eq!((triangles.len(), shape, sum), (4, Shape::Simple, 12.0));
        assert!(least > 0.1, "{triangles:?}");
    }

    #[test]
    fn outline_with_a_hole_on_a_bridge_keeps_its_area() {
        let points = [
            (0.0, 0.0),
            (6.0, 0.0),
            (6.0, 5.0),
            (0.0, 5.0),
            (0.0, 0.0), // the outside, back to its start
            (1.0, 1.0),
            (1.0, 3.0),
            (4.0, 3.0),
            (4.0, 1.0),
            (1.0, 1.0), // over the bridge, round the hole
        ]
        .map(|(x, y)| dvec3(x, y, 0.0));
        let (triangles, shape) = cut_all(&points);
        let (sum, least) = areas(&points, &triangles);
        assert_eq!((triangles.len(), shape, sum), (8, Shape::Simple, 24.0));
        assert!(least > 0.0);
    }

    #[test]
    fn polygon_that_crosses_itself_or_is_flat_ends_all_the_same() {
        let star = (0..5).map(|k| {
            let (sin, cos) = (f64::from(2 * k) * std::f64::consts::TAU / 5.0).sin_cos();
            dvec3(cos, sin, 0.0)
        });
        let (triangles, shape) = cut_all(&star.collect::<Vec<_>>());
        assert_eq!((triangles.len(), shape), (3, Shape::CrossesItself));
        let bow_tie = [(0.0, 0.0), (4.0, 3.0), (4.0, 0.0), (0.0, 2.0)].map(|(x, y)| dvec3(x, y, 0.0));
        assert_eq!(cut_all(&bow_tie).0.len(), 2);
        let line = [0.0, 1.0, 5.0, 2.0].map(|x| dvec3(x, 2.0 * x, 3.0));
        assert_eq!(cut_all(&line).1, Shape::WithoutArea);
        assert_eq!(cut_all(&[dvec3(1.0, 2.0, 3.0); 6]).1, Shape::WithoutArea);
        assert_eq!(cut_all(&[]).0.len(), 0);
    }

    #[test]
    fn work_on_huge_concave_polygons_is_limited() {
        let zigzag: Vec<_> = (0..3000).map(|k| dvec3(f64::from(k), f64::from(k % 2), 0.0)).collect();
        let around = [dvec3(3000.0, -9.0, 0.0), dvec3(0.0, -9.0, 0.0)];
        let points: Vec<_> = zigzag.into_iter().rev().chain(around.into_iter().rev()).collect();
        assert!(triangulate(&points, &mut 1000).is_none());
        assert_eq!(cut_all(&points).0.len(), 3000);
    }
}
