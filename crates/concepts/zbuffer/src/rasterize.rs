//! Which pixels does a triangle cover, how deep is it there, and which of its points do they show? (L18)
//!
//! [`rasterize`] asks every pixel of the bounding box. [`rasterize_rows`] gives the same fragments, bit for bit, but goes
//! straight to the covered part of each row.
//!
//! Whether a pixel is covered is decided in whole numbers. Vertices are snapped to 1/256 pixel; then each edge has an
//! *edge function*: twice the signed area of the triangle that the edge makes with the pixel's centre, positive on the
//! inner side. Two triangles that share an edge get the same number there with opposite signs, without rounding. A
//! centre exactly on the edge belongs to one of them by the **top-left rule** (E10): a triangle owns its left edges (its
//! inside lies to the right) and its top edges (horizontal, its inside lies below). Rows run upwards here, so "top" is
//! where y is greatest, as it looks on the picture.

use std::ops::Range;

use geometry::Barycentric;
use glam::{DVec3, I64Vec2};

use crate::plane::depths_at_snapped;
use crate::screen::{Fragment, GREATEST_PIXEL, SUBPIXELS, ScreenTriangle, ScreenVertex};

/// Calls `draw` for every pixel of a `width` × `height` screen whose centre lies in the triangle: row by row upwards,
/// each from left to right.
///
/// Both orientations are drawn. A centre on an edge that two triangles share belongs to exactly one of them (E10). A
/// triangle whose snapped vertices lie on one line covers nothing. Snapping may turn a sliver thinner than 1/256 pixel over;
/// it then lies on its neighbours and a sample there is drawn three times, but never not at all.
///
/// - z is that of the plane through the vertices as they were projected, not as they were snapped, in every triangle of at least
///   1/362 pixel in height. Where a snapped corner lies beside the triangle, z leaves the range of the vertices' z, but never by more than
///   that range, however thin the triangle.
/// - The weights are perspective-correct: 1/w is affine on the screen, camera depth is not (E9). They are those between the snapped
///   vertices, so that none is ever negative; the point they name lies at most 1/362 pixel beside the pixel's center.
///
/// ```
/// use geometry::Barycentric;
/// use glam::dvec3;
/// use zbuffer::{ScreenTriangle, ScreenVertex, rasterize};
///
/// let vertex = |x, y, z, weights| ScreenVertex { position: dvec3(x, y, z), inv_w: -0.5, weights };
/// let vertices = [
///     vertex(1.0, 1.0, 0.2, Barycentric::A),
///     vertex(4.0, 1.0, 0.5, Barycentric::B),
///     vertex(1.0, 3.0, 0.4, Barycentric::C),
/// ];
/// let mut pixels = Vec::new();
/// rasterize(&ScreenTriangle { vertices }, 10, 10, |fragment| pixels.push((fragment.i, fragment.j)));
/// // The lower edge (j = 1) belongs to the triangle below; the left edge (i = 1) belongs to this one.
/// assert_eq!(pixels, [(1, 2), (2, 2)]);
/// ```
///
/// # Panics
/// If a vertex lies farther than [`GREATEST_PIXEL`] from the origin in x or y, if a z is not finite, or if the three
/// `inv_w` are not finite, different from 0 and of one sign. What [`crate::project`] returns is never like that.
pub fn rasterize(triangle: &ScreenTriangle, width: u32, height: u32, mut draw: impl FnMut(Fragment)) {
    let Some(setup) = Setup::new(triangle) else { return };
    for j in setup.rows(0..height) {
        for i in setup.columns(width) {
            let edges = setup.edges_at(i, j);
            if setup.covers(edges) {
                draw(setup.fragment(i, j, edges));
            }
        }
    }
}

/// The same fragments as [`rasterize`], bit for bit and in the same order, in those of the pixel rows j ∈ `rows`: the fast
/// version.
///
/// It solves each edge function for the first and the last covered pixel of a row, so that pixels outside cost
/// nothing, and steps from pixel to pixel by additions. Threads may draw disjoint bands of rows of one triangle.
///
/// # Panics
/// As [`rasterize`].
#[inline]
pub fn rasterize_rows(
    triangle: &ScreenTriangle,
    width: u32,
    rows: Range<u32>,
    mut draw: impl FnMut(Fragment),
) {
    let Some(setup) = Setup::new(triangle) else { return };
    let columns = setup.columns(width);
    for j in setup.rows(rows) {
        let span = setup.span(columns.clone(), j);
        let mut edges = setup.edges_at(span.start, j);
        for i in span {
            draw(setup.fragment(i, j, edges));
            edges = setup.stepped_right(edges);
        }
    }
}

/// A triangle made ready for its pixels: anticlockwise, with its edges and what is interpolated.
#[derive(Debug)]
pub(crate) struct Setup {
    /// The edges opposite to the vertices a, b, c: bc, ca, ab.
    edges: [Edge; 3],
    lowest: I64Vec2,
    highest: I64Vec2,
    /// 1 / (twice the area): turns edge functions into the affine weights of the vertices.
    inv_doubled_area: f64,
    /// The depths of the plane in the snapped vertices.
    z: DVec3,
    least_z: f64,
    greatest_z: f64,
    inv_w: DVec3,
    /// Each vertex's weights in the source triangle, times its 1/w: affine on the screen.
    weights_over_w: [DVec3; 3],
}

impl Setup {
    /// `None` if the triangle covers nothing.
    pub(crate) fn new(triangle: &ScreenTriangle) -> Option<Self> {
        let [a, b, c] = anticlockwise(triangle)?;
        let corners = [a, b, c].map(|v| v.snapped());
        let [p_a, p_b, p_c] = corners;
        let has_depth = [a, b, c].iter().all(|v| v.position.z.is_finite());
        assert!(has_depth, "a vertex has depth NaN or infinity: {triangle:?}");
        let z = depths_at_snapped([&a, &b, &c]);
        let inv_w = DVec3::new(a.inv_w.into(), b.inv_w.into(), c.inv_w.into());
        let one_sign = inv_w.min_element() > 0.0 || inv_w.max_element() < 0.0;
        assert!(one_sign && inv_w.is_finite(), "1/w must be of one sign and finite: {triangle:?}");
        Some(Self {
            edges: [Edge::new(p_b, p_c), Edge::new(p_c, p_a), Edge::new(p_a, p_b)],
            lowest: p_a.min(p_b).min(p_c),
            highest: p_a.max(p_b).max(p_c),
            inv_doubled_area: 1.0 / (p_b - p_a).perp_dot(p_c - p_a) as f64,
            z,
            least_z: z.min_element(),
            greatest_z: z.max_element(),
            inv_w,
            weights_over_w: [a, b, c].map(|v| v.weights.to_vec3().as_dvec3() * f64::from(v.inv_w)),
        })
    }

    /// The columns of the bounding box that are on the screen.
    pub(crate) fn columns(&self, width: u32) -> Range<u32> {
        pixels_between(self.lowest.x, self.highest.x, 0..width)
    }

    /// The rows of the bounding box that are among `rows`.
    pub(crate) fn rows(&self, rows: Range<u32>) -> Range<u32> {
        pixels_between(self.lowest.y, self.highest.y, rows)
    }

    pub(crate) fn edges_at(&self, i: u32, j: u32) -> [i64; 3] {
        let center = I64Vec2::new(i.into(), j.into()) * SUBPIXELS;
        self.edges.each_ref().map(|edge| edge.at(center))
    }

    /// Which edges the triangle owns (E10).
    pub(crate) fn owned_edges(&self) -> [bool; 3] {
        self.edges.each_ref().map(|edge| edge.threshold == 0)
    }

    /// The affine weights of the vertices, from the edge functions.
    pub(crate) fn screen_weights(&self, edges: [i64; 3]) -> [f64; 3] {
        edges.map(|edge| edge as f64 * self.inv_doubled_area)
    }

    fn stepped_right(&self, edges: [i64; 3]) -> [i64; 3] {
        let [bc, ca, ab] = &self.edges;
        [edges[0] + bc.step, edges[1] + ca.step, edges[2] + ab.step]
    }

    fn covers(&self, edges: [i64; 3]) -> bool {
        let [bc, ca, ab] = &self.edges;
        edges[0] >= bc.threshold && edges[1] >= ca.threshold && edges[2] >= ab.threshold
    }

    /// The columns of row `j` that the triangle covers: one run, since a triangle is convex.
    fn span(&self, columns: Range<u32>, j: u32) -> Range<u32> {
        let start = columns.start;
        if columns.is_empty() {
            return columns;
        }
        let values = self.edges_at(start, j);
        let mut steps = 0..i64::from(columns.end - start);
        for (edge, value) in self.edges.iter().zip(values) {
            edge.narrow(&mut steps, value);
        }
        // `steps` may have run empty with its end before its start.
        let end = steps.end.max(steps.start);
        start + steps.start as u32..start + end as u32
    }

    /// What the triangle leaves in pixel (i, j); `None` if it does not cover it.
    pub(crate) fn fragment_at(&self, i: u32, j: u32) -> Option<Fragment> {
        let edges = self.edges_at(i, j);
        self.covers(edges).then(|| self.fragment(i, j, edges))
    }

    /// What the triangle leaves in pixel (i, j), from the exact edge functions at its centre.
    ///
    /// Both rasterizers call it with the same whole numbers: that is why their fragments are the same.
    #[inline]
    fn fragment(&self, i: u32, j: u32, edges: [i64; 3]) -> Fragment {
        let areas = DVec3::new(edges[0] as f64, edges[1] as f64, edges[2] as f64);
        // z is affine on the screen (E9). Rounding must not carry it past the corners.
        let z = (areas.dot(self.z) * self.inv_doubled_area).clamp(self.least_z, self.greatest_z);
        // So are weights/w and 1/w; their quotient is the weights. All terms have one sign: nothing cancels.
        let [a, b, c] = self.weights_over_w;
        let weights = (areas.x * a + areas.y * b + areas.z * c) / areas.dot(self.inv_w);
        let weights = weights.as_vec3();
        let weights = Barycentric { alpha: weights.x, beta: weights.y, gamma: weights.z };
        Fragment { i, j, z, weights }
    }
}

/// A directed edge of an anticlockwise triangle: the inside lies to its left.
#[derive(Debug)]
struct Edge {
    from: I64Vec2,
    along: I64Vec2,
    /// The least value that counts as inside: 0 on an edge that the triangle owns, else 1.
    threshold: i64,
    /// What the edge function gains from one pixel to the next on the right.
    step: i64,
}

impl Edge {
    fn new(from: I64Vec2, to: I64Vec2) -> Self {
        let along = to - from;
        // Anticlockwise with y upwards: a left edge runs down, a top edge runs to the left.
        let is_left = along.y < 0;
        let is_top = along.y == 0 && along.x < 0;
        let threshold = if is_left || is_top { 0 } else { 1 };
        Self { from, along, threshold, step: -along.y * SUBPIXELS }
    }

    /// The edge function: twice the area of the triangle from the edge to `p`, positive on the left.
    fn at(&self, p: I64Vec2) -> i64 {
        self.along.perp_dot(p - self.from)
    }

    /// Keeps those of `steps` to the right of a place with edge function `value` that lie inside.
    fn narrow(&self, steps: &mut Range<i64>, value: i64) {
        let missing = self.threshold - value;
        if self.step > 0 {
            // value + k · step ≥ threshold from some k on.
            if missing > 0 {
                steps.start = steps.start.max((missing + self.step - 1) / self.step).min(steps.end);
            }
        } else if missing > 0 {
            // Outside, and it does not get better to the right.
            steps.end = steps.start;
        } else if self.step < 0 {
            // value + k · step ≥ threshold up to some k.
            steps.end = steps.end.min(missing / self.step + 1);
        }
    }
}

/// The vertices, b and c exchanged if that makes them anticlockwise; each vertex carries its own weights, so that changes
/// nothing else. `None` if they lie on one line.
fn anticlockwise(triangle: &ScreenTriangle) -> Option<[ScreenVertex; 3]> {
    let [a, b, c] = triangle.vertices;
    let in_range = |v: &ScreenVertex| {
        v.position.truncate().abs().max_element() <= GREATEST_PIXEL && !v.position.is_nan()
    };
    assert!(triangle.vertices.iter().all(in_range), "a vertex lies too far outside: {triangle:?}");
    match triangle.doubled_area() {
        0 => None,
        area if area > 0 => Some([a, b, c]),
        _ => Some([a, c, b]),
    }
}

/// Those of `pixels` whose centres lie between two snapped coordinates, both included.
fn pixels_between(lowest: i64, highest: i64, pixels: Range<u32>) -> Range<u32> {
    let first = (lowest + SUBPIXELS - 1).div_euclid(SUBPIXELS).max(pixels.start.into());
    let end = (highest.div_euclid(SUBPIXELS) + 1).min(pixels.end.into());
    // Clamped to `pixels`, both fit in 32 bits.
    if first < end { first as u32..end as u32 } else { pixels.start..pixels.start }
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::dvec3;

    fn triangle(corners: [(f64, f64, f64); 3]) -> ScreenTriangle {
        let weights = [Barycentric::A, Barycentric::B, Barycentric::C];
        let vertex = |k: usize| {
            let (x, y, z) = corners[k];
            ScreenVertex { position: dvec3(x, y, z), inv_w: -0.5, weights: weights[k] }
        };
        ScreenTriangle { vertices: [0, 1, 2].map(vertex) }
    }

    fn pixels(triangle: &ScreenTriangle) -> Vec<(u32, u32)> {
        let mut all = Vec::new();
        rasterize(triangle, 16, 12, |f| all.push((f.i, f.j)));
        all
    }

    #[test]
    fn a_rectangle_owns_its_left_and_its_top_side() {
        // Corners on the samples (2, 3) and (5, 5): 3 × 2 of the 4 × 3 samples, left column in, lowest row out.
        let lower = pixels(&triangle([(2.0, 3.0, 0.0), (5.0, 3.0, 0.0), (5.0, 5.0, 0.0)]));
        let upper = pixels(&triangle([(2.0, 3.0, 0.0), (5.0, 5.0, 0.0), (2.0, 5.0, 0.0)]));
        let mut both = [lower, upper].concat();
        both.sort_unstable_by_key(|(i, j)| (*j, *i));
        assert_eq!(both, [(2, 4), (3, 4), (4, 4), (2, 5), (3, 5), (4, 5)]);
    }

    #[test]
    fn depth_and_weights_are_worked_out_by_hand() {
        let t = triangle([(1.0, 1.0, 0.0), (9.0, 1.0, 0.75), (1.0, 5.0, 0.5)]);
        let mut at_3_2 = None;
        rasterize(&t, 16, 12, |f| at_3_2 = if (f.i, f.j) == (3, 2) { Some(f) } else { at_3_2 });
        // β = (3 − 1) / 8, γ = (2 − 1) / 4; z = ¼ · 0.75 + ¼ · 0.5.
        let weights = Barycentric { alpha: 0.5, beta: 0.25, gamma: 0.25 };
        assert_eq!(at_3_2, Some(Fragment { i: 3, j: 2, z: 0.3125, weights }));
    }

    #[test]
    fn triangles_without_area_or_off_the_screen_cover_nothing() {
        assert!(pixels(&triangle([(1.0, 1.0, 0.0), (5.0, 3.0, 0.0), (9.0, 5.0, 0.0)])).is_empty());
        assert!(pixels(&triangle([(-9.0, 1.0, 0.0), (-1.0, 2.0, 0.0), (-3.0, 8.0, 0.0)])).is_empty());
        assert!(pixels(&triangle([(20.0, 1.0, 0.0), (40.0, 2.0, 0.0), (30.0, 8.0, 0.0)])).is_empty());
        rasterize_rows(&triangle([(0.0, 0.0, 0.0), (8.0, 0.0, 0.0), (0.0, 8.0, 0.0)]), 0, 0..12, |_| {
            panic!("no columns")
        });
    }

    #[test]
    fn the_largest_triangle_has_sane_numbers() {
        let far = GREATEST_PIXEL;
        let t = triangle([(-far, -far, 0.25), (far, -far, 0.75), (-far, far, 0.5)]);
        let mut at_0_0 = None;
        rasterize(&t, 1, 1, |f| at_0_0 = Some(f));
        // The pixel is the middle of the long side, which lies on its upper right: not owned, so a hair larger it is.
        assert_eq!(at_0_0, None);
        let t = triangle([(-far, -far, 0.25), (far, -far + 4.0, 0.75), (-far, far, 0.5)]);
        rasterize(&t, 1, 1, |f| at_0_0 = Some(f));
        let f = at_0_0.expect("now it is inside");
        assert!((f.z - 0.625).abs() < 1e-5 && (f.weights.beta - 0.5).abs() < 1e-5, "{f:?}");
    }

    #[test]
    #[should_panic(expected = "depth NaN")]
    fn a_depth_that_is_not_a_number_is_the_callers_mistake() {
        pixels(&triangle([(1.0, 1.0, f64::INFINITY), (9.0, 1.0, 0.8), (1.0, 5.0, 0.4)]));
    }
}
