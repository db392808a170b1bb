//! What do the drawings have in common? Inks for yours and right, an empty sheet in pixels, and parts of it that show parts of a plane.

use glam::Vec2;
use sheet::{Ink, Sheet, Words};
use worker::{Plain, Value};

use crate::exercise::Picture;

/// What a given answer is drawn in…
pub(crate) const YOURS: Ink = Ink::A;

/// …and what is right.
pub(crate) const RIGHT: Ink = Ink::C;

/// What a value holds, if it is of this type.
pub(crate) fn read<T: Plain>(value: &Value) -> Option<T> {
    T::from_value(value.clone())
}

/// An empty sheet of this size; its unit is the pixel.
pub(crate) fn blank(size: Vec2) -> Sheet {
    Sheet::new(Vec2::ZERO, size, size.x)
}

/// The sheet as a picture without a text, with words for those who do not see it.
pub(crate) fn finished(sheet: Sheet, said: impl Into<String>) -> Option<Picture> {
    let said = said.into();
    Some(Picture { svg: sheet.svg(&Words::new(said.clone(), said)), text: None })
}

/// A part of a sheet that shows a part of a plane, as large as it can be.
pub(crate) struct Panel {
    /// The middle of the part, in pixels of the sheet.
    middle: Vec2,
    /// What of the plane lies there.
    shown: Vec2,
    /// Pixels for each unit of the plane.
    pub(crate) scale: f32,
}

impl Panel {
    /// The part of the sheet between two of its corners, with a margin for names, showing all points. Points that are not
    /// numbers are passed over.
    pub(crate) fn showing(points: &[Vec2], [lower_left, upper_right]: [Vec2; 2], margin: f32) -> Self {
        let (least, greatest) = extent(points);
        let room = upper_right - lower_left - Vec2::splat(2.0 * margin);
        let scale = (room / (greatest - least).max(Vec2::splat(1e-3))).min_element();
        Self { middle: (lower_left + upper_right) / 2.0, shown: (least + greatest) / 2.0, scale }
    }

    /// Where a point of the plane lies on the sheet.
    pub(crate) fn at(&self, p: Vec2) -> Vec2 {
        self.middle + self.scale * (p - self.shown)
    }

    /// Where points of the plane lie on the sheet.
    pub(crate) fn all_at(&self, points: &[Vec2]) -> Vec<Vec2> {
        points.iter().map(|p| self.at(*p)).collect()
    }
}

/// The least and the greatest coordinates of points that are numbers.
pub(crate) fn extent(points: &[Vec2]) -> (Vec2, Vec2) {
    let finite = || points.iter().copied().filter(|p| p.is_finite());
    (finite().fold(Vec2::INFINITY, Vec2::min), finite().fold(Vec2::NEG_INFINITY, Vec2::max))
}

/// Whether a point is a number and no farther from the middle of the others than so many times their extent: else the others could
/// not be seen beside it.
pub(crate) fn is_near(p: Vec2, others: &[Vec2], times: f32) -> bool {
    let (least, greatest) = extent(others);
    p.is_finite() && p.distance((least + greatest) / 2.0) <= times * (greatest - least).max_element()
}
