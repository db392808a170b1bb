//! How does a wrong matrix look? What it does to points, beside what it should do.
//!
//! - [`plane`]: points of the plane, one picture over the other.
//! - [`space`]: axes and cameras in space, side by side.
//! - [`volume`]: what happens to the viewing volume, side by side.
//!
//! A student's answer may hold any numbers: a shape of which a point is not a number, or lies far off, is left out and words
//! stand in its place.

mod plane;
mod space;
mod volume;

use glam::{Vec2, vec2};
use sheet::{Ink, LETTER, Letters, Sheet, Side};

use crate::stage::{YOURS, is_near};

pub(super) use plane::{pixels_on_the_window, rotation, square_on_the_screen};
pub(super) use space::{camera_axes, carried_axes, carried_back_axes, world_before_the_camera};
pub(super) use volume::{box_from_pyramid, cube_from_pyramid};

/// So many times as large as what is right may a given shape be; else it would make all the rest a dot.
const LARGEST: f32 = 8.0;

/// Room for names around what a panel shows, in pixels.
const MARGIN: f32 = 34.0;

/// The left and the right half of a sheet of this size, between headings and notes.
fn halves(size: Vec2) -> [[Vec2; 2]; 2] {
    let top = size.y - 2.0 * LETTER;
    let (middle, bottom) = (size.x / 2.0, 1.2 * LETTER);
    [[vec2(0.0, bottom), vec2(middle, top)], [vec2(middle, bottom), vec2(size.x, top)]]
}

/// The upper and the lower half, each below its heading, with room for a note at the bottom.
fn rows(size: Vec2) -> [[Vec2; 2]; 2] {
    let (heading, bottom) = (2.0 * LETTER, 1.2 * LETTER);
    let height = (size.y - bottom) / 2.0 - heading;
    [bottom + height + heading, bottom].map(|low| [vec2(0.0, low), vec2(size.x, low + height)])
}

/// The points, unless one is not a number or lies so far off that the right ones could not be seen beside it.
fn near(points: Vec<Vec2>, right: &[Vec2]) -> Option<Vec<Vec2>> {
    points.iter().all(|p| is_near(*p, right, LARGEST)).then_some(points)
}

/// A heading above a part of a sheet.
fn heading(sheet: &mut Sheet, [lower_left, upper_right]: [Vec2; 2], words: &str) {
    let place = vec2(lower_left.x + 6.0, upper_right.y + 0.9 * LETTER);
    sheet.label(place, Side::Right, words, Letters::Plain, Ink::Main);
}

/// What the inks of a drawing mean, side by side at the top.
fn legend(sheet: &mut Sheet, entries: &[(&str, Ink)]) {
    let mut left = 20.0;
    for (words, ink) in entries {
        let (from, to) = (sheet.place(left, LETTER), sheet.place(left + 26.0, LETTER));
        sheet.line(from, to, ink.pen().wide());
        sheet.label(to, Side::Right, *words, Letters::Plain, Ink::Main);
        left += 70.0 + 0.52 * LETTER * words.chars().count() as f32;
    }
}

/// A line of words at the bottom.
fn note(sheet: &mut Sheet, left: f32, words: String) {
    let place = sheet.place(left, 0.0);
    let place = vec2(place.x, 0.9 * LETTER);
    sheet.label_sized(place, Side::Right, words, Letters::Plain, YOURS, 0.85 * LETTER);
}

/// What stands where a given answer cannot be drawn.
const NOT_SHOWN: &str = "yours is not a number, or lies far off";
