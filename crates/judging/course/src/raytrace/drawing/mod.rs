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
use sheet::{Ink, LETTER, Letters, Sheet, Side};

use crate::stage::{RIGHT, YOURS, is_near};

pub(super) use along::{nearest_along_the_ray, on_the_way_to_the_lamp, sphere_along_the_ray};
pub(super) use interface::bent_ray;
pub(super) use pictures::{mirror_pictures, shadow_pictures};
pub(super) use space::{solved_system, triangle_from_outside};
pub(super) use window::ray_through_the_window;

/// So many times as large as all the rest may a given shape be; else it would make the rest a dot.
const LARGEST: f32 = 3.0;

/// Room for names around what a panel shows, in pixels.
const MARGIN: f32 = 30.0;

/// The point, unless it is not a number or lies so far off that the others could not be seen beside it.
fn near(p: Vec2, others: &[Vec2]) -> Option<Vec2> {
    is_near(p, others, LARGEST).then_some(p)
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
