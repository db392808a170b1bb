//! On which side of its three edges is a pixel, exactly? The slide's whole numbers, in f64, where they are exact too.

use glam::{DVec2, DVec3};

use crate::fast::bins::{doubled_area, place};
use crate::fast::vertices::{Rest, Vertex};
use crate::plane::followed;
use crate::screen::SUBPIXELS;

/// A triangle made ready for its pixels: as the slide's `Setup`, number for number.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Edges {
    /// The vertices, anticlockwise.
    pub(crate) corners: [Vertex; 3],
    /// The depths of the plane in the snapped corners.
    pub(crate) depths: [f64; 3],
    /// Where the edges bc, ca, ab start, and which way they go, in 1/256 pixels.
    from: [[f64; 2]; 3],
    along: [[f64; 2]; 3],
    pub(crate) inv_doubled_area: f64,
}

/// 1/256 pixels from a pixel to the next.
const STEP: f64 = SUBPIXELS as f64;

impl Edges {
    /// The edges of a triangle with an area.
    #[inline(always)]
    pub(crate) fn new([a, b, c]: [(&Vertex, &Rest); 3]) -> Self {
        let area = doubled_area(a.0, b.0, c.0);
        let is_turned = area < 0.0;
        let turned = if is_turned { [a, c, b] } else { [a, b, c] };
        let corners = three!(k => *turned[k].0);
        let depths = depths(turned);
        let [a, b, c] = three!(k => place(&corners[k]));
        let along = |from: [f64; 2], to: [f64; 2]| [to[0] - from[0], to[1] - from[1]];
        Self {
            corners,
            depths,
            from: [b, c, a],
            along: [along(b, c), along(c, a), along(a, b)],
            inv_doubled_area: 1.0 / area.abs(),
        }
    }

    /// The three edge functions at the centre of pixel (i, j).
    #[inline(always)]
    pub(crate) fn at(&self, i: f64, j: f64) -> [f64; 3] {
        three!(k => {
            let ([x, y], [dx, dy]) = (self.from[k], self.along[k]);
            dx * (STEP * j - y) - dy * (STEP * i - x)
        })
    }

    /// What edge function `k` gains from a pixel to the next on the right.
    #[inline(always)]
    pub(crate) fn step_right(&self, k: usize) -> f64 {
        -STEP * self.along[k][1]
    }

    /// What edge function `k` gains from a row to the next one up.
    #[inline(always)]
    pub(crate) fn step_up(&self, k: usize) -> f64 {
        STEP * self.along[k][0]
    }

    /// The least value of edge function `k` that counts as inside, by the top-left rule (E10).
    #[inline(always)]
    pub(crate) fn threshold(&self, k: usize) -> f64 {
        let [dx, dy] = self.along[k];
        let is_owned = dy < 0.0 || dy == 0.0 && dx < 0.0;
        if is_owned { 0.0 } else { 1.0 }
    }

    /// The columns and rows of the box around the triangle that are on a screen, both ends included; rows j upwards.
    #[inline(always)]
    pub(crate) fn pixels(&self, (width, height): (u32, u32)) -> ([u32; 2], [u32; 2]) {
        let [a, b, c] = self.corners;
        let range = |axis: usize, size: u32| {
            let least = a[axis].min(b[axis]).min(c[axis]);
            let greatest = a[axis].max(b[axis]).max(c[axis]);
            let in_pixels = 1.0 / SUBPIXELS as f32;
            // `as` turns what lies below 0 into 0.
            let first = (least * in_pixels).ceil() as u32;
            let last = (greatest * in_pixels).floor().min(size as f32 - 1.0) as u32;
            [first, last]
        };
        (range(0, width), range(1, height))
    }

    /// Whether the triangle's box has more columns than that.
    #[inline(always)]
    pub(crate) fn is_wider_than(&self, columns: u32) -> bool {
        let [a, b, c] = three!(k => self.corners[k][0]);
        a.max(b).max(c) - a.min(b).min(c) > (STEP as f32) * columns as f32
    }

    /// The greatest depth of a corner.
    #[inline(always)]
    pub(crate) fn nearest_corner(&self) -> f64 {
        let [a, b, c] = self.depths;
        a.max(b).max(c)
    }

    /// Columns of row j, and of the row below it, that may be covered: at least all that are.
    #[inline(always)]
    pub(crate) fn covered(&self, [left, right]: [u32; 2], j: f64) -> [u32; 2] {
        const NO_COLUMNS: [u32; 2] = [1, 0];
        let at = self.at(f64::from(left), j);
        let (mut first, mut last) = (0.0_f64, f64::from(right - left));
        for (k, at) in at.into_iter().enumerate() {
            let step = self.step_right(k);
            // The greater value of the two rows: inside there, where either is.
            let greatest = at.max(at - self.step_up(k));
            if step > 0.0 {
                first = first.max(-greatest / step);
            } else if step < 0.0 {
                last = last.min(greatest / -step);
            } else if greatest < 0.0 {
                return NO_COLUMNS;
            }
        }
        // Rounding is far below a pixel.
        let (first, last) = ((first - 1.0).max(0.0), (last + 1.0).min(f64::from(right - left)));
        if first <= last { [left + first as u32, left + last as u32] } else { NO_COLUMNS }
    }

    /// A depth that no pixel in these columns and rows exceeds.
    #[inline(always)]
    pub(crate) fn nearest(&self, columns: [u32; 2], rows: [f64; 2]) -> f64 {
        /// Far more than what rounding does to a depth between −3 and 3.
        const SLACK: f64 = 1e-6;
        let [a, b, c] = self.depths;
        let z_at = |i: u32, j: f64| {
            let at = self.at(f64::from(i), j);
            (at[0] * a + at[1] * b + at[2] * c) * self.inv_doubled_area
        };
        // z is affine: greatest in a corner of the box, or in a vertex.
        let upper = z_at(columns[0], rows[1]).max(z_at(columns[1], rows[1]));
        let lower = z_at(columns[0], rows[0]).max(z_at(columns[1], rows[0]));
        upper.max(lower).min(a.max(b).max(c)) + SLACK
    }
}

/// The depths of a triangle's plane in its snapped corners, from the same numbers as the slide's.
#[inline(always)]
fn depths(corners: [(&Vertex, &Rest); 3]) -> [f64; 3] {
    let rest = |k: usize| DVec2::new(corners[k].1[0].into(), corners[k].1[1].into());
    let projected = three!(k => DVec2::from_array(place(corners[k].0)) + rest(k));
    let z = three!(k => f64::from(corners[k].0[2]) + f64::from(corners[k].1[2]));
    followed(projected, three!(k => rest(k)), DVec3::from_array(z)).to_array()
}
