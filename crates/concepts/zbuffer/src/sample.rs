//! Why does a pixel show a triangle, or not? The numbers behind [`crate::rasterize()`]'s decision for one pixel.

use crate::rasterize::Setup;
use crate::screen::{Fragment, ScreenTriangle};

/// What [`crate::rasterize()`] finds out about one pixel in a triangle's bounding box.
///
/// The three numbers of each list belong to the edges opposite to the triangle's vertices a, b, c: bc, ca, ab.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sample {
    /// The edge functions at the pixel's centre, exactly, in units of 1/256 pixel squared: positive on the inner side.
    pub edges: [i64; 3],
    /// Whether the triangle owns the edge, so that a centre on it counts as inside: left and top edges (E10).
    pub owns: [bool; 3],
    /// The edge functions over twice the area: the weights of a, b, c on the screen, where z is affine. They are not those
    /// in space (E9), which the fragment has.
    pub screen_weights: [f64; 3],
    /// What the triangle leaves in the pixel; `None` if the centre lies outside.
    pub fragment: Option<Fragment>,
}

/// What [`crate::rasterize()`] asks at pixel (i, j); `None` if it does not come there: the bounding box does not hold the
/// pixel's centre, or the triangle has no area.
///
/// ```
/// use geometry::Barycentric;
/// use glam::dvec3;
/// use zbuffer::{ScreenTriangle, ScreenVertex, sample::sample};
///
/// let vertex = |x, y, z, weights| ScreenVertex { position: dvec3(x, y, z), inv_w: -0.5, weights };
/// let triangle = ScreenTriangle {
///     vertices: [
///         vertex(1.0, 1.0, 0.0, Barycentric::A),
///         vertex(9.0, 1.0, 0.75, Barycentric::B),
///         vertex(1.0, 5.0, 0.5, Barycentric::C),
///     ],
/// };
/// let inside = sample(&triangle, 3, 2).unwrap();
/// assert_eq!(inside.screen_weights, [0.5, 0.25, 0.25]);
/// assert_eq!(inside.fragment.unwrap().z, 0.3125);
/// // On the lower side, which belongs to the triangle below.
/// let below = sample(&triangle, 3, 1).unwrap();
/// assert_eq!((below.edges[2], below.owns[2], below.fragment), (0, false, None));
/// assert_eq!(sample(&triangle, 10, 2), None);
/// ```
///
/// # Panics
/// As [`crate::rasterize()`].
#[must_use]
pub fn sample(triangle: &ScreenTriangle, i: u32, j: u32) -> Option<Sample> {
    let setup = Setup::new(triangle)?;
    let comes_there = setup.rows(j..j + 1).contains(&j) && setup.columns(i + 1).contains(&i);
    if !comes_there {
        return None;
    }
    let edges = setup.edges_at(i, j);
    let mut sample = Sample {
        edges,
        owns: setup.owned_edges(),
        screen_weights: setup.screen_weights(edges),
        fragment: setup.fragment_at(i, j),
    };
    if triangle.doubled_area() < 0 {
        // Made ready, its vertices are a, c, b.
        sample.edges.swap(1, 2);
        sample.owns.swap(1, 2);
        sample.screen_weights.swap(1, 2);
    }
    Some(sample)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{ScreenVertex, rasterize};
    use geometry::Barycentric;
    use glam::dvec3;

    fn triangle(corners: [(f64, f64, f64); 3]) -> ScreenTriangle {
        let weights = [Barycentric::A, Barycentric::B, Barycentric::C];
        let vertex = |k: usize| {
            let (x, y, z) = corners[k];
            ScreenVertex { position: dvec3(x, y, z), inv_w: -0.5 - 0.1 * k as f32, weights: weights[k] }
        };
        ScreenTriangle { vertices: [0, 1, 2].map(vertex) }
    }

    #[test]
    fn its_fragments_are_those_of_the_rasterizer_whichever_way_the_triangle_runs() {
        let corners = [(1.3, 0.7, 0.1), (13.2, 2.0, 0.8), (4.0, 9.5, 0.4)];
        for corners in [corners, [corners[0], corners[2], corners[1]]] {
            let triangle = triangle(corners);
            let mut drawn = Vec::new();
            rasterize(&triangle, 16, 12, |fragment| drawn.push(fragment));
            let pixels = (0..12).flat_map(|j| (0..16).map(move |i| (i, j)));
            let asked: Vec<_> =
                pixels.filter_map(|(i, j)| sample(&triangle, i, j)).filter_map(|s| s.fragment).collect();
            assert_eq!(asked, drawn);
        }
    }

    #[test]
    fn the_numbers_belong_to_the_vertices_as_they_were_given() {
        let corners = [(1.0, 1.0, 0.0), (9.0, 1.0, 0.8), (1.0, 5.0, 0.4)];
        let there = sample(&triangle(corners), 4, 2).unwrap();
        let back = sample(&triangle([corners[0], corners[2], corners[1]]), 4, 2).unwrap();
        assert_eq!(there.screen_weights, [0.375, 0.375, 0.25]);
        assert_eq!(back.screen_weights, [0.375, 0.25, 0.375]);
        assert_eq!([there.edges[1], there.edges[2]], [back.edges[2], back.edges[1]]);
        // The left edge runs from c to a; with b and c exchanged it is ab.
        assert_eq!([there.owns, back.owns], [[false, true, false], [false, false, true]]);
    }
}
