//! Where does a cut piece lie, and on which side of a plane? Its outline says it, well enough to put it in order.

use std::sync::Arc;

use glam::DVec2;

use super::clipping::{part_where_not_negative, relation_of_polygons};
use super::facet::{Bounds, Facet};
use super::piece::{CutLine, Piece, Side};
use super::relation::{DEPTH_TOLERANCE, Relation, relation_of_facets};

/// A piece with its outline. The outline is used to order pieces only; the piece's cuts decide which pixels it covers.
pub(super) struct OutlinedPiece {
    piece: Piece,
    facet: Arc<Facet>,
    outline: Vec<DVec2>,
}

/// On which side of a plane a part lies.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Position {
    Behind,
    Before,
    Through,
}

/// How far a part may reach through a plane and still count as on one side. Of two parts on either side, one then hides
/// the other by at most twice this, which is no constraint: so a division leaves no cycle that runs through the plane.
const REACH: f64 = 0.5 * DEPTH_TOLERANCE;

impl OutlinedPiece {
    pub(super) fn whole(triangle: usize, facet: Arc<Facet>) -> Self {
        Self { piece: Piece::whole(triangle), outline: facet.outline(), facet }
    }

    pub(super) fn triangle(&self) -> usize {
        self.piece.triangle
    }

    pub(super) fn area_of_triangle(&self) -> i64 {
        self.facet.doubled_area()
    }

    pub(super) fn into_piece(self) -> Piece {
        self.piece
    }

    /// A box around the part: its outline, and the depths of its whole triangle.
    pub(super) fn bounds(&self) -> Bounds {
        let whole = self.facet.bounds();
        let start = (whole.max.truncate(), whole.min.truncate());
        let (min, max) = self.outline.iter().fold(start, |(min, max), p| (min.min(*p), max.max(*p)));
        Bounds { min: min.extend(whole.min.z), max: max.extend(whole.max.z) }
    }

    /// What this part is to the other.
    pub(super) fn relation(&self, other: &Self) -> Relation {
        if self.piece.cuts().is_empty() && other.piece.cuts().is_empty() {
            relation_of_facets(&self.facet, &other.facet)
        } else {
            relation_of_polygons(&self.facet, &self.outline, &other.facet, &other.outline)
        }
    }

    /// Where this part lies as seen from the plane of `root`. A part in that plane counts as before it.
    pub(super) fn position(&self, root: &Self) -> Position {
        let (mut least, mut greatest) = (f64::INFINITY, f64::NEG_INFINITY);
        for corner in &self.outline {
            let difference = self.nearer_by(root, *corner);
            (least, greatest) = (least.min(difference), greatest.max(difference));
        }
        if -REACH <= least {
            Position::Before
        } else if greatest <= REACH {
            Position::Behind
        } else {
            Position::Through
        }
    }

    /// The halves before and behind the plane of `root`.
    pub(super) fn split(self, root: &Self) -> (Self, Self) {
        let line = Arc::new(CutLine { ours: *self.facet, theirs: *root.facet });
        let half = |side: Side, sign: f64| Self {
            piece: self.piece.cut(root.triangle(), side, line.clone()),
            facet: self.facet.clone(),
            outline: part_where_not_negative(&self.outline, |p| sign * self.nearer_by(root, p)),
        };
        (half(Side::Nearer, 1.0), half(Side::Farther, -1.0))
    }

    /// By how much this part's plane lies nearer than that of `root`.
    fn nearer_by(&self, root: &Self, p: DVec2) -> f64 {
        self.facet.depth_between(p) - root.facet.depth_between(p)
    }
}
