//! What is left of a triangle after cuts? The pixels on one side of each.

use std::ops::RangeInclusive;
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

/// The rounding of [`CutLine::difference`] as a part of its terms: each of fewer than 16 operations adds half an epsilon.
const ROUNDING: f64 = 8.0 * f64::EPSILON;

/// A span without pixels.
#[expect(clippy::reversed_empty_ranges, reason = "the empty span is meant")]
const NO_COLUMNS: RangeInclusive<i64> = 1..=0;

impl Piece {
    /// The whole triangle, by its index.
    #[must_use]
    pub fn whole(triangle: usize) -> Self {
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

    /// The pixels of row `j` among which all of this piece's are, if it is cut; the rest need not be asked.
    pub(super) fn span(&self, columns: RangeInclusive<i64>, j: i64) -> RangeInclusive<i64> {
        self.cuts.iter().fold(columns, |columns, cut| cut.span(columns, j))
    }

    /// The box around the triangle if it is cut: columns and rows of pixels, possibly off the screen.
    pub(super) fn box_to_search(&self) -> Option<(RangeInclusive<i64>, RangeInclusive<i64>)> {
        let bounds = self.cuts.first()?.line.ours.bounds();
        let (min, max) = (bounds.min / SUBPIXELS as f64, bounds.max / SUBPIXELS as f64);
        let pixels = |min: f64, max: f64| min.ceil() as i64..=max.floor() as i64;
        Some((pixels(min.x, max.x), pixels(min.y, max.y)))
    }
}

impl Cut {
    fn keeps(&self, i: i64, j: i64) -> bool {
        let is_nearer = 0.0 <= self.line.difference(i, j);
        is_nearer == (self.side == Side::Nearer)
    }

    /// The part of a row outside which [`Cut::keeps`] never holds. The difference is affine along the row, so its values
    /// at the ends bound it in between; rounding can lift those and the one in between.
    fn span(&self, columns: RangeInclusive<i64>, j: i64) -> RangeInclusive<i64> {
        let (left, right) = (*columns.start(), *columns.end());
        let sign = if self.side == Side::Nearer { 1.0 } else { -1.0 };
        let magnitude = self.line.magnitude(left, j).max(self.line.magnitude(right, j));
        let bound = |i: i64| sign * self.line.difference(i, j) + 2.0 * ROUNDING * magnitude;
        let (at_left, at_right) = (bound(left), bound(right));
        // Where the bound is 0, to a pixel.
        let zero = || left + ((right - left) as f64 * (at_left / (at_left - at_right))) as i64;
        match (0.0 <= at_left, 0.0 <= at_right) {
            (true, true) => columns,
            (true, false) => left..=right.min(zero() + 1),
            (false, true) => left.max(zero() - 1)..=right,
            (false, false) => NO_COLUMNS,
        }
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
    fn a_span_leaves_out_what_lies_beyond_the_cut_and_nothing_else() {
        let nearer = Piece::whole(4).cut(1, Side::Nearer, line());
        let farther = Piece::whole(4).cut(1, Side::Farther, line());
        let (columns, rows) = farther.box_to_search().unwrap();
        assert_eq!((columns.clone(), rows), (0..=12, 0..=9));
        // The cut lies between 7 and 8; a pixel more on either side is allowed.
        assert_eq!(nearer.span(columns.clone(), 2), 0..=8);
        assert_eq!(farther.span(columns, 2), 6..=12);
        assert!(farther.span(0..=5, 2).is_empty());
        // The same where the row begins elsewhere.
        assert_eq!((nearer.span(3..=12, 2), farther.span(3..=12, 2)), (3..=8, 6..=12));
        assert_eq!(Piece::whole(4).box_to_search(), None);
    }

    #[test]
    fn a_span_keeps_every_pixel_where_rounding_alone_decides() {
        // One plane, computed from two of its corners: the difference is nothing but rounding, of either sign in any pixel.
        let [a, b, c] = [[1.0, 2.0, 700.3], [59.0, 7.0, -413.7], [23.0, 61.0, 951.1]];
        let [ours, theirs] = [[a, b, c], [b, c, a]].map(|corners| Facet::new(&triangle(corners)).unwrap());
        let line = Arc::new(CutLine { ours, theirs });
        let mut between = 0;
        for side in [Side::Nearer, Side::Farther] {
            let piece = Piece::whole(4).cut(1, side, line.clone());
            for j in 0..60 {
                let kept: Vec<i64> = (0..60).filter(|i| piece.covers(*i, j)).map(i64::from).collect();
                let span = piece.span(0..=59, j.into());
                assert!(kept.iter().all(|i| span.contains(i)), "row {j}: {kept:?} are not all in {span:?}");
                between += usize::from(!kept.is_empty() && !piece.covers(0, j) && !piece.covers(59, j));
            }
        }
        assert!(between > 0, "in no row does a pixel belong to a piece that neither end belongs to");
    }
}
