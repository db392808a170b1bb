//! What is left of a triangle after cuts? The pixels on one side of each.

use std::ops::Range;
use std::sync::Arc;

use super::facet::{Facet, pixel_centre};
use crate::screen::SUBPIXELS;

/// A part of a triangle: those of its pixels that lie on the right side of every cut.
///
/// The parts of a triangle share no pixel and miss none: where a cut separates two of them, both ask for the sign of
/// the very same floating-point number, one whether it is negative, the other whether it is not.
#[derive(Clone, Debug, PartialEq)]
pub struct Piece {
    /// The index of the triangle.
    pub triangle: usize,
    cuts: Vec<Cut>,
}

/// A cut along the line on the screen where two planes have the same depth.
#[derive(Clone, Debug, PartialEq)]
pub struct Cut {
    /// The index of the triangle whose plane cuts.
    pub by: usize,
    /// Which side of that plane the piece lies on.
    pub side: Side,
    line: Arc<CutLine>,
}

/// A side of a plane.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Side {
    /// At the plane's depth or nearer.
    Nearer,
    /// Farther than the plane.
    Farther,
}

/// Where a plane that is cut meets the plane that cuts it.
#[derive(Debug, PartialEq)]
pub(super) struct CutLine {
    pub(super) ours: Facet,
    pub(super) theirs: Facet,
}

/// How much larger than 2^−53 of its terms the rounding of [`CutLine::difference`] can be: fewer than 16 operations.
const ROUNDING: f64 = 16.0 * f64::EPSILON;

impl Piece {
    /// The whole triangle.
    pub(super) fn whole(triangle: usize) -> Self {
        Self { triangle, cuts: Vec::new() }
    }

    /// The part of this piece on one side of a line.
    pub(super) fn cut(&self, by: usize, side: Side, line: Arc<CutLine>) -> Self {
        let mut cuts = Vec::with_capacity(self.cuts.len() + 1);
        cuts.extend_from_slice(&self.cuts);
        cuts.push(Cut { by, side, line });
        Self { triangle: self.triangle, cuts }
    }

    /// The cuts that made this piece; none if it is the whole triangle.
    #[must_use]
    pub fn cuts(&self) -> &[Cut] {
        &self.cuts
    }

    /// Whether a pixel of the triangle belongs to this piece. For a pixel outside the triangle it means nothing.
    #[must_use]
    pub fn covers(&self, i: u32, j: u32) -> bool {
        self.cuts.iter().all(|cut| cut.keeps(i64::from(i), i64::from(j)))
    }

    /// The rows of a screen of this height in which the piece can have pixels.
    pub(super) fn rows(&self, height: u32) -> Range<u32> {
        let Some(first_cut) = self.cuts.first() else {
            return 0..height;
        };
        let bounds = first_cut.line.ours.bounds();
        let pixels = |lowest: f64, highest: f64| {
            let size = SUBPIXELS as f64;
            ((lowest / size).ceil() as i64, (highest / size).floor() as i64)
        };
        let (left, right) = pixels(bounds.min.x, bounds.max.x);
        let (bottom, top) = pixels(bounds.min.y, bounds.max.y);
        let can_have_pixels = |j: &i64| self.cuts.iter().all(|cut| cut.can_keep_some(left, right, *j));
        let mut rows = bottom.max(0)..(top + 1).min(i64::from(height)).max(0);
        // The piece is convex, so its rows are neighbours.
        let Some(first) = rows.find(can_have_pixels) else {
            return 0..0;
        };
        let last = rows.rfind(can_have_pixels).unwrap_or(first);
        first as u32..last as u32 + 1
    }
}

impl Cut {
    fn keeps(&self, i: i64, j: i64) -> bool {
        let is_nearer = 0.0 <= self.line.difference(i, j);
        is_nearer == (self.side == Side::Nearer)
    }

    /// Whether [`Cut::keeps`] can hold for a pixel of row `j` between two columns. The difference is affine, so it is
    /// nowhere greater than at one of the ends, rounding aside.
    fn can_keep_some(&self, left: i64, right: i64, j: i64) -> bool {
        let sign = if self.side == Side::Nearer { 1.0 } else { -1.0 };
        let greatest = (sign * self.line.difference(left, j)).max(sign * self.line.difference(right, j));
        let magnitude = self.line.magnitude(left, j).max(self.line.magnitude(right, j));
        -ROUNDING * magnitude <= greatest
    }
}

impl CutLine {
    /// By how much the plane that is cut lies nearer than the one that cuts, at a pixel's centre.
    fn difference(&self, i: i64, j: i64) -> f64 {
        let centre = pixel_centre(i, j);
        self.ours.depth_at(centre) - self.theirs.depth_at(centre)
    }

    fn magnitude(&self, i: i64, j: i64) -> f64 {
        let centre = pixel_centre(i, j);
        self.ours.magnitude_at(centre) + self.theirs.magnitude_at(centre)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::painter::example::triangle;

    /// A ramp that falls with x through a flat triangle, at x = 7.2.
    fn line() -> Arc<CutLine> {
        let ours = Facet::new(&triangle([[0.0, 0.0, 0.75], [12.0, 0.0, -0.5], [0.0, 9.0, 0.75]])).unwrap();
        let theirs = Facet::new(&triangle([[-5.0, 3.0, 0.0], [12.0, 2.0, 0.0], [2.0, 5.0, 0.0]])).unwrap();
        Arc::new(CutLine { ours, theirs })
    }

    #[test]
    fn two_halves_of_a_cut_share_the_pixels_out() {
        let nearer = Piece::whole(4).cut(1, Side::Nearer, line());
        let farther = Piece::whole(4).cut(1, Side::Farther, line());
        for i in 0..12 {
            assert_eq!((nearer.covers(i, 2), farther.covers(i, 2)), (i <= 7, 7 < i));
        }
    }

    #[test]
    fn rows_leave_out_what_lies_beyond_the_cut() {
        let farther = Piece::whole(4).cut(1, Side::Farther, line());
        assert_eq!(Piece::whole(4).rows(6), 0..6);
        // The rows are judged by the triangle's box, where this cut leaves something in each.
        assert_eq!(farther.rows(6), 0..6);
        assert_eq!(farther.rows(100), 0..10);
    }
}
