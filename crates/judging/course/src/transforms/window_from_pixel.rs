//! Where does the ray through a pixel cross the window? (L8, L9, E14)

use glam::{Mat3, Vec2, mat3, vec2, vec3};
use vocabulary::ViewVolume;

use super::drawing;
use super::inputs::{screen, screen_and_pixel, volume};
use crate::exercise::{arguments, signature};
use crate::{Concept, Example, Exercise, Law, Misconception, Title, close};

const STUB: &str = r#"//! From the pixel to the window (L8).
//!
//! A ray through pixel (i, j) crosses the window [l, r] × [b, t] on the view plane in the point (u_s, v_s). Give the 3×3 matrix
//! that carries (i, j, 1) to (u_s, v_s, 1):
//!
//!     translate(l, b) · scale((r−l)/n_x, (t−b)/n_y) · translate(½, ½)
//!
//! so that u_s = l + (r−l)·(i+½)/n_x and v_s = b + (t−b)·(j+½)/n_y (L9). One matrix on the slide has an error: find it (E14).
//!
//! The screen is [−½, n_x−½] × [−½, n_y−½]: pixel (i, j) reaches from i−½ to i+½ and from j−½ to j+½. j runs upwards.
//!
//! - `volume`: the window's sides `left`, `right`, `bottom`, `top` (l, r, b, t) in camera coordinates. near and far play no part.
//! - `width`, `height`: n_x and n_y, at least 1. No input is degenerate: l < r and b < t.
//! - A point is a column (x, y, 1).
//!
//! glam: `Mat3::from_translation`, `Mat3::from_scale` (both take a `Vec2`), or `mat3` with three columns.

use glam::Mat3;
use vocabulary::ViewVolume;

pub fn window_from_pixel(volume: ViewVolume, width: u32, height: u32) -> Mat3 {
    todo!()
}
"#;

signature!((volume: ViewVolume, width: u32, height: u32) -> Mat3);

/// Sides of the window are at most 10, so a point of it is the sum of terms up to 10 or, across a screen of 16 pixels, their
/// products with rounded quotients: 6 roundings of 10 · 2⁻²⁴ are 4e-6.
const TOLERANCE: f32 = 1e-5;

pub(super) fn exercise() -> Exercise {
    Exercise {
        name: "window_from_pixel",
        concept: Concept::Transforms,
        items: "L8, L9, E14",
        title: Title { english: "From the pixel to the window", dutch: "Van pixel naar venster" },
        prerequisites: &["screen_from_canonical"],
        stub: STUB,
        signature: SIGNATURE,
        hints: [
            "The screen begins at −½ and is n_x wide; the window begins at l and is r − l wide. What brings the screen's \
                corner to the origin?",
            "Move by (½, ½), scale a pixel to its width (r−l)/n_x and height (t−b)/n_y on the window, move by (l, b). What \
             acts first stands rightmost.",
            "Every translation has a 1 in the lower right corner; the slide's last one has a 0. Multiplied out, the last \
             column is (l + ½(r−l)/n_x, b + ½(t−b)/n_y, 1).",
        ],
        examples: examples(),
        laws: laws(),
        reference: program!(slide),
        variants: vec![program!(multiplied_out), program!(from_two_corners)],
        misconceptions: misconceptions(),
        explanation: "Every pixel gets a cell of the window, and its ray goes through the middle of the cell. The rasterizer \
            goes the other way, from the window through [−1, 1] to the screen: the two matrices undo each other up to that \
            range, which is why ray tracer and z-buffer can make the same picture.",
        draw: drawing::pixels_on_the_window,
        source: include_str!("window_from_pixel.rs"),
    }
}

fn examples() -> Vec<Example> {
    let aside = ViewVolume { left: -2.0, right: 4.0, bottom: -1.0, top: 3.0, near: -1.0, far: -9.0 };
    let unit = ViewVolume { left: -1.0, right: 1.0, bottom: -1.0, top: 1.0, near: -1.0, far: -9.0 };
    vec![
        Example::new(
            "4 × 2 pixels, window [−1, 1] × [−1, 1]",
            arguments![unit, 4_u32, 2_u32],
            mat3(vec3(0.5, 0.0, 0.0), vec3(0.0, 1.0, 0.0), vec3(-0.75, -0.5, 1.0)),
            TOLERANCE,
        ),
        Example::new(
            "12 × 8 pixels, window [−2, 4] × [−1, 3]",
            arguments![aside, 12_u32, 8_u32],
            mat3(vec3(0.5, 0.0, 0.0), vec3(0.0, 0.5, 0.0), vec3(-1.75, -0.75, 1.0)),
            TOLERANCE,
        ),
    ]
}

/// Where a point of the screen lands, after division by the third coordinate.
fn landed(m: Mat3, p: Vec2) -> Vec2 {
    let image = m * p.extend(1.0);
    image.truncate() / image.z
}

fn laws() -> Vec<Law> {
    vec![
        Law::of(
            "corners_meet_corners",
            3,
            "The screen's corners land on the window's: (−½, −½) on (l, b), (n_x−½, n_y−½) on (r, t).",
            "A corner of the screen misses the corner of the window: take (−½, −½) through the three steps by hand.",
        )
        .over((volume(), screen()), |&(volume, (width, height)), program| {
            let m: Mat3 = program.ask(arguments![volume, width, height])?;
            let last = vec2(width as f32 - 0.5, height as f32 - 0.5);
            let ViewVolume { left, right, bottom, top, .. } = volume;
            close("the image of (−½, −½)", landed(m, vec2(-0.5, -0.5)), vec2(left, bottom), TOLERANCE)?;
            close("the image of (n_x−½, n_y−½)", landed(m, last), vec2(right, top), TOLERANCE)
        }),
        Law::of(
            "neighbours_are_a_cell_apart",
            2,
            "Pixels that are neighbours land (r−l)/n_x apart, or (t−b)/n_y for one above the other.",
            "Neighbours land at the wrong distance, or on the wrong side: how many cells lie between l and r?",
        )
        .over((volume(), screen_and_pixel()), |&(volume, ((width, height), (i, j))), program| {
            let m: Mat3 = program.ask(arguments![volume, width, height])?;
            let pixel = vec2(i as f32, j as f32);
            let cell = vec2(
                (volume.right - volume.left) / width as f32,
                (volume.top - volume.bottom) / height as f32,
            );
            let here = landed(m, pixel);
            close("the step to the right", landed(m, pixel + Vec2::X) - here, cell.with_y(0.0), TOLERANCE)?;
            close("the step upwards", landed(m, pixel + Vec2::Y) - here, cell.with_x(0.0), TOLERANCE)
        }),
        Law::of(
            "opposite_pixels_balance",
            2,
            "Pixel (i, j) and the one opposite, (n_x−1−i, n_y−1−j), lie on opposite sides of the window's middle.",
            "The pixels are not spread evenly about the middle of the window: is the half pixel added, and before or after \
                scaling?",
        )
        .over((volume(), screen_and_pixel()), |&(volume, ((width, height), (i, j))), program| {
            let m: Mat3 = program.ask(arguments![volume, width, height])?;
            let opposite = vec2((width - 1 - i) as f32, (height - 1 - j) as f32);
            let middle = (landed(m, vec2(i as f32, j as f32)) + landed(m, opposite)) / 2.0;
            let wanted = vec2((volume.left + volume.right) / 2.0, (volume.bottom + volume.top) / 2.0);
            close("the middle between them", middle, wanted, TOLERANCE)
        }),
        Law::of(
            "points_stay_points",
            2,
            "The last row is (0, 0, 1): a point stays a point.",
            "The last row is not (0, 0, 1): look at the corner at the lower right of every factor, on the slide too.",
        )
        .over((volume(), screen()), |&(volume, (width, height)), program| {
            let m: Mat3 = program.ask(arguments![volume, width, height])?;
            close("the last row", m.row(2), vec3(0.0, 0.0, 1.0), TOLERANCE)
        }),
    ]
}

fn slide(volume: ViewVolume, width: u32, height: u32) -> Mat3 {
    let ViewVolume { left, right, bottom, top, .. } = volume;
    let cell = glam::vec2((right - left) / width as f32, (top - bottom) / height as f32);
    Mat3::from_translation(glam::vec2(left, bottom))
        * Mat3::from_scale(cell)
        * Mat3::from_translation(glam::vec2(0.5, 0.5))
}

fn multiplied_out(volume: ViewVolume, width: u32, height: u32) -> Mat3 {
    let ViewVolume { left: l, right: r, bottom: b, top: t, .. } = volume;
    let (n_x, n_y) = (width as f32, height as f32);
    glam::mat3(
        glam::vec3((r - l) / n_x, 0.0, 0.0),
        glam::vec3(0.0, (t - b) / n_y, 0.0),
        glam::vec3(0.5 * (r - l) / n_x + l, 0.5 * (t - b) / n_y + b, 1.0),
    )
}

fn from_two_corners(volume: ViewVolume, width: u32, height: u32) -> Mat3 {
    // A line through two points for each axis: from −½ to the low side, from count − ½ to the high side.
    let line = |low: f32, high: f32, count: u32| {
        let slope = (high - low) / count as f32;
        (slope, low + 0.5 * slope)
    };
    let (across, i_zero) = line(volume.left, volume.right, width);
    let (upwards, j_zero) = line(volume.bottom, volume.top, height);
    Mat3::from_cols_array(&[across, 0.0, 0.0, 0.0, upwards, 0.0, i_zero, j_zero, 1.0])
}

fn misconceptions() -> Vec<Misconception> {
    vec![
        Misconception {
            program: program!(corner_as_printed),
            looks_like: "the slide's matrix with the 0 in its corner",
            help: "The slide's translate(½, ½) ends in 0 (E14). With it every point loses its 1, and (l, b) is never added.",
        },
        Misconception {
            program: program!(half_pixel_forgotten),
            looks_like: "the half pixel is left out",
            help: "Without it pixel (0, 0) looks through the corner of its cell, (l, b), and not through the middle.",
        },
        Misconception {
            program: program!(half_after_scaling),
            looks_like: "½ is added on the window instead of on the screen",
            help: "The ½ is half a pixel: add it while lengths are still measured in pixels, before scaling.",
        },
        Misconception {
            program: program!(factors_in_reading_order),
            looks_like: "the factors stand in the order in which they happen",
            help: "The rightmost matrix meets the pixel first: translate(½, ½) stands on the right, translate(l, b) on the \
                left.",
        },
        Misconception {
            program: program!(spread_to_the_edges),
            looks_like: "the first and the last pixel lie on the window's edges",
            help: "n_x pixels have n_x cells, not n_x − 1: the centres of the outer ones lie half a cell inside the window.",
        },
        Misconception {
            program: program!(downwards),
            looks_like: "j runs downwards from the top",
            help: "In the lecture j runs upwards, as v does: row 0 is the lowest.",
        },
        Misconception {
            program: program!(window_at_the_origin),
            looks_like: "the window is taken to begin at the origin",
            help: "The window begins at (l, b): one more translation, after scaling.",
        },
    ]
}

fn corner_as_printed(volume: ViewVolume, width: u32, height: u32) -> Mat3 {
    let ViewVolume { left, right, bottom, top, .. } = volume;
    let cell = glam::vec2((right - left) / width as f32, (top - bottom) / height as f32);
    let printed = glam::mat3(glam::Vec3::X, glam::Vec3::Y, glam::vec3(0.5, 0.5, 0.0));
    Mat3::from_translation(glam::vec2(left, bottom)) * Mat3::from_scale(cell) * printed
}

fn half_pixel_forgotten(volume: ViewVolume, width: u32, height: u32) -> Mat3 {
    let ViewVolume { left, right, bottom, top, .. } = volume;
    let cell = glam::vec2((right - left) / width as f32, (top - bottom) / height as f32);
    Mat3::from_translation(glam::vec2(left, bottom)) * Mat3::from_scale(cell)
}

fn half_after_scaling(volume: ViewVolume, width: u32, height: u32) -> Mat3 {
    let ViewVolume { left, right, bottom, top, .. } = volume;
    let cell = glam::vec2((right - left) / width as f32, (top - bottom) / height as f32);
    Mat3::from_translation(glam::vec2(left + 0.5, bottom + 0.5)) * Mat3::from_scale(cell)
}

fn factors_in_reading_order(volume: ViewVolume, width: u32, height: u32) -> Mat3 {
    let ViewVolume { left, right, bottom, top, .. } = volume;
    let cell = glam::vec2((right - left) / width as f32, (top - bottom) / height as f32);
    Mat3::from_translation(glam::vec2(0.5, 0.5))
        * Mat3::from_scale(cell)
        * Mat3::from_translation(glam::vec2(left, bottom))
}

fn spread_to_the_edges(volume: ViewVolume, width: u32, height: u32) -> Mat3 {
    let ViewVolume { left, right, bottom, top, .. } = volume;
    let cell = glam::vec2((right - left) / (width as f32 - 1.0), (top - bottom) / (height as f32 - 1.0));
    Mat3::from_translation(glam::vec2(left, bottom)) * Mat3::from_scale(cell)
}

fn downwards(volume: ViewVolume, width: u32, height: u32) -> Mat3 {
    let ViewVolume { left, right, bottom, top, .. } = volume;
    let cell = glam::vec2((right - left) / width as f32, (bottom - top) / height as f32);
    Mat3::from_translation(glam::vec2(left, top))
        * Mat3::from_scale(cell)
        * Mat3::from_translation(glam::vec2(0.5, 0.5))
}

fn window_at_the_origin(volume: ViewVolume, width: u32, height: u32) -> Mat3 {
    let ViewVolume { left, right, bottom, top, .. } = volume;
    let cell = glam::vec2((right - left) / width as f32, (top - bottom) / height as f32);
    Mat3::from_scale(cell) * Mat3::from_translation(glam::vec2(0.5, 0.5))
}
