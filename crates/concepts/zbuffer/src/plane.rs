//! How deep is a triangle's plane in the places its corners were snapped to?
//!
//! Which pixels a triangle covers is decided on corners that were moved to the grid of 1/256 pixels, by up to half a step
//! in x and in y. Depth must not move with them: on a steep surface that would cost thousands of the steps of a 24-bit
//! buffer. So the plane is taken through the corners as they were projected, and followed to where they are now. From
//! there on depth is interpolated between the snapped corners, with weights that are exact and never negative.
//!
//! # How exact that is
//! Let g be the plane's slope in depth a pixel, h the least height of the triangle in pixels, L its longest side.
//!
//! - A corner moves by at most √2/512 pixel, so its depth by at most |g| · √2/512. The width of a triangle in any
//!   direction is at least h, hence |g| ≤ r/h, with r the range of the vertices' depths. So the depth of a corner
//!   moves by at most r wherever h ≥ √2/512 ≈ 1/362 pixel. Thinner slivers may lie wholly beside the pixel centers
//!   that their snapped corners hold, and a plane says nothing there: their corners are kept within r.
//! - Differences of positions are exact (multiples of 2⁻³² pixel below 2¹⁷), the area is rounded by at most 2⁻⁵² L²,
//!   that is by a share of 2⁻⁵² L/h. The slope carries this error and a few roundings more, and counts over √2/512 pixel only:
//!   an error in depth of less than 2⁻⁴⁸ (1 + L/h) · r · min(1, 1/(362 h)).
//! - The interpolation adds four roundings of a sum without cancellation.

use glam::{DVec2, DVec3};

use crate::screen::{SUBPIXELS, ScreenVertex};

/// Returns the depths that the plane through three vertices has in their snapped positions.
pub(crate) fn depths_at_snapped(vertices: [&ScreenVertex; 3]) -> DVec3 {
    let projected = vertices.map(|v| v.position.truncate() * SUBPIXELS as f64);
    let snapped = vertices.map(|v| v.snapped().as_dvec2());
    let rests = [0, 1, 2].map(|k| projected[k] - snapped[k]);
    followed(projected, rests, DVec3::from_array(vertices.map(|v| v.position.z)))
}

/// The depths of the plane through `places` with depths `z`, each followed back by what rounding left over: `rests`.
///
/// The fast version computes it for eight triangles at a time, with the same roundings.
pub(crate) fn followed([a, b, c]: [DVec2; 3], rests: [DVec2; 3], z: DVec3) -> DVec3 {
    let (ab, ac) = (b - a, c - a);
    let (z_ab, z_ac) = (z.y - z.x, z.z - z.x);
    let area = ab.x * ac.y - ab.y * ac.x;
    // Without an area there is no plane; the snapped triangle shows a corner or an edge of this one.
    let inv_area = if area == 0.0 { 0.0 } else { 1.0 / area };
    // The slope of the plane along x and y, from z = a.z + slope · (p − a) in b and c (Cramer's rule).
    let slope_x = (z_ab * ac.y - z_ac * ab.y) * inv_area;
    let slope_y = (z_ac * ab.x - z_ab * ac.x) * inv_area;
    let range = z.max_element() - z.min_element();
    // `max` and `min` rather than `clamp`: they let no NaN through where a slope overflows.
    let at = |k: usize| z[k] - (slope_x * rests[k].x + slope_y * rests[k].y).max(-range).min(range);
    DVec3::new(at(0), at(1), at(2))
}
