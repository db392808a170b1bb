//! How does a wrong ray look? Beside the right one, seen from where the difference shows.
//!
//! - [`window`]: the viewing ray, on the window and from outside.
//! - [`space`]: ray and triangle, from outside.
//! - [`along`]: a ray and the spheres along it, each turned about the ray into the sheet.
//! - [`interface`]: a ray that is bent.
//! - [`pictures`]: small pictures, traced with the given function and with the right one.
//!
//! A student's answer may hold any numbers: what is not a number or lies far off is left out, and words say so.

mod along;
mod interface;
mod pictures;
mod space;
mod window;

use glam::{Vec2, vec2};
use sheet::{Ink, LETTER, Letters, Sheet, Side, Words};
use worker::{Plain, Value};

use crate::exercise::{Picture, Seen};

pub(super) use along::{nearest_along_the_ray, on_the_way_to_the_lamp, sphere_along_the_ray};
pub(super) use interface::bent_ray;
pub(super) use pictures::{mirror_pictures, shadow_pictures};
pub(super) use space::{solved_system, triangle_from_outside};
pub(super) use window::ray_through_the_window;

/// What a given answer is drawn in, and what is right.
const YOURS: Ink = Ink::A;
const RIGHT: Ink = Ink::C;

/// So many times as large as all the rest may a given shape be; else it would make the rest a dot.
const LARGEST: f32 = 3.0;

fn read<T: Plain>(value: &Value) -> Option<T> {
    T::from_value(value.clone())
}

/// The given answer, if there is one of this type.
fn given<T: Plain>(seen: &Seen<'_>) -> Option<T> {
    read(seen.given?)
}

/// An empty sheet of this size; its unit is the pixel.
fn blank(size: Vec2) -> Sheet {
    Sheet::new(Vec2::ZERO, size, size.x)
}

fn finished(sheet: Sheet, said: &str) -> Option<Picture> {
    Some(Picture { svg: sheet.svg(&Words::new(said, said)), text: None })
}

/// A part of a sheet that shows a part of a plane, as large as it can be.
struct Panel {
    /// The middle of the part, in pixels of the sheet.
    middle: Vec2,
    /// What of the plane lies there.
    shown: Vec2,
    /// Pixels for each unit of the plane.
    scale: f32,
}

impl Panel {
    /// The part of the sheet between two of its corners, with a margin for names, showing all points.
    fn showing(points: &[Vec2], [lower_left, upper_right]: [Vec2; 2]) -> Self {
        const MARGIN: f32 = 30.0;
        let (least, greatest) = extent(points);
        let room = upper_right - lower_left - Vec2::splat(2.0 * MARGIN);
        let scale = (room / (greatest - least).max(Vec2::splat(1e-3))).min_element();
        Self { middle: (lower_left + upper_right) / 2.0, shown: (least + greatest) / 2.0, scale }
    }

    /// Where a point of the plane lies on the sheet.
    fn at(&self, p: Vec2) -> Vec2 {
        self.middle + self.scale * (p - self.shown)
    }

    fn all_at(&self, points: &[Vec2]) -> Vec<Vec2> {
        points.iter().map(|p| self.at(*p)).collect()
    }
}

/// The least and the greatest coordinates of points that are numbers.
fn extent(points: &[Vec2]) -> (Vec2, Vec2) {
    let finite = || points.iter().copied().filter(|p| p.is_finite());
    (finite().fold(Vec2::INFINITY, Vec2::min), finite().fold(Vec2::NEG_INFINITY, Vec2::max))
}

/// The point, unless it is not a number or lies so far off that the others could not be seen beside it.
fn near(p: Vec2, others: &[Vec2]) -> Option<Vec2> {
    let (least, greatest) = extent(others);
    let most = LARGEST * (greatest - least).max_element();
    (p.is_finite() && p.distance((least + greatest) / 2.0) <= most).then_some(p)
}

/// A line of words, in pixels from the left and the top.
fn heading(sheet: &mut Sheet, left: f32, top: f32, words: &str, ink: Ink) {
    let place = sheet.place(left, top);
    sheet.label_sized(place, Side::Right, words, Letters::Plain, ink, 0.9 * LETTER);
}

/// What was given and what is right, as words at the top of a sheet.
fn compared(sheet: &mut Sheet, yours: &str, right: &str) {
    heading(sheet, 8.0, 1.1 * LETTER, &format!("should be: {right}"), RIGHT);
    heading(sheet, 8.0, 2.5 * LETTER, &format!("yours: {yours}"), YOURS);
}

/// A dot with a ring, so that one drawn over another does not hide it.
fn mark(sheet: &mut Sheet, p: Vec2, ink: Ink, ring: f32) {
    sheet.dot(p, ink);
    sheet.circle(p, ring, ink.pen());
}

/// An arrow, unless it is too short for its point.
fn arrow(sheet: &mut Sheet, from: Vec2, to: Vec2, ink: Ink) {
    if from.distance(to) > 14.0 {
        sheet.arrow(from, to, ink.pen());
    } else {
        sheet.line(from, to, ink.pen());
    }
}

/// The whole of a sheet below its two lines of words.
fn below_the_words(size: Vec2) -> [Vec2; 2] {
    [Vec2::ZERO, vec2(size.x, size.y - 3.2 * LETTER)]
}
