//! Which pixel is it? From the canonical square to the screen (L4).

use glam::{Mat4, Vec4, vec2, vec3};
use proptest::prelude::*;
use testkit::by_hand::share;

use super::drawing;
use super::inputs::{screen, screen_and_pixel};
use crate::exercise::{arguments, signature};
use crate::{Concept, Example, Exercise, Law, Misconception, Title, close};

const STUB: &str = r#"//! From the canonical cube to the screen: the viewport matrix (L4).
//!
//! Give the 4×4 matrix that carries [−1, 1] × [−1, 1] to a screen of n_x × n_y pixels:
//!
//!     n_x/2   0   0  (n_x−1)/2
//!       0   n_y/2 0  (n_y−1)/2
//!       0     0   1      0
//!       0     0   0      1
//!
//! Pixel (i, j) covers [i−½, i+½] × [j−½, j+½]: its centre has whole coordinates. So the screen is [−½, n_x−½] × [−½, n_y−½].
//! j runs upwards, as y does. z is not touched: the z-buffer wants it later.
//!
//! - `width`, `height`: n_x and n_y, at least 1.
//! - A point is a column (x, y, z, 1). No input is degenerate.
//!
//! In Rust 7 / 2 is 3: turn whole numbers into `f32` first, `width as f32`.
//!
//! glam: `Mat4::from_scale`, `Mat4::from_translation`, or `Mat4::from_cols` with four columns.

use glam::Mat4;

pub fn screen_from_canonical(width: u32, height: u32) -> Mat4 {
    todo!()
}
"#;

signature!((width: u32, height: u32) -> Mat4);

/// Coordinates are at most 16, sums of two products of at most 8; a point and its image take four roundings of that size:
/// 4 · 16 · 2⁻²⁴ ≈ 4e-6.
const TOLERANCE: f32 = 1e-5;

pub(super) fn exercise() -> Exercise {
    Exercise {
        name: "screen_from_canonical",
        concept: Concept::Transforms,
        items: "L4",
        title: Title {
            english: "From the canonical cube to the screen",
            dutch: "Van canoniek volume naar scherm",
        },
        prerequisites: &["rotate_about_point"],
        stub: STUB,
        signature: SIGNATURE,
        hints: [
            "How wide is [−1, 1], and how wide is the screen in pixels? Where is the middle of the screen?",
            "First scale: a width of 2 becomes n_x. The middle of [−1, 1] is 0, that of [−½, n_x−½] is (n_x−1)/2: then move \
                by that.",
            "Mat4::from_translation((n_x−1)/2, (n_y−1)/2, 0) · Mat4::from_scale(n_x/2, n_y/2, 1), all in f32.",
        ],
        examples: examples(),
        laws: laws(),
        reference: program!(slide),
        variants: vec![program!(column_by_column), program!(corner_by_corner)],
        misconceptions: misconceptions(),
        explanation: "The half pixels come from the convention that a pixel's centre has whole coordinates: the screen's \
            edge then lies half a pixel before the first centre. Where pixel corners have whole coordinates, as in many \
            libraries, the translation is n_x/2. Mixing both shifts every picture by half a pixel.",
        draw: drawing::square_on_the_screen,
        source: include_str!("screen_from_canonical.rs"),
    }
}

fn examples() -> Vec<Example> {
    let small = Mat4::from_cols(
        Vec4::new(2.0, 0.0, 0.0, 0.0),
        Vec4::new(0.0, 1.5, 0.0, 0.0),
        Vec4::new(0.0, 0.0, 1.0, 0.0),
        Vec4::new(1.5, 1.0, 0.0, 1.0),
    );
    let usual = Mat4::from_cols(
        Vec4::new(320.0, 0.0, 0.0, 0.0),
        Vec4::new(0.0, 240.0, 0.0, 0.0),
        Vec4::new(0.0, 0.0, 1.0, 0.0),
        Vec4::new(319.5, 239.5, 0.0, 1.0),
    );
    vec![
        Example::new("4 × 3 pixels", arguments![4_u32, 3_u32], small, TOLERANCE),
        Example::new("640 × 480 pixels", arguments![640_u32, 480_u32], usual, TOLERANCE),
    ]
}

/// A canonical coordinate, a multiple of ¼ in [−1, 1]; shrinks towards −1.
fn canonical() -> impl Strategy<Value = f32> + Clone {
    share().prop_map(|share| 2.0 * share - 1.0)
}

fn laws() -> Vec<Law> {
    vec![
        Law::of(
            "corners_meet_corners",
            3,
            "The square's corners become the screen's: (−1, −1) goes to (−½, −½) and (1, 1) to (n_x−½, n_y−½).",
            "A corner of the square misses the corner of the screen: where does a screen begin whose first pixel has its \
                centre at 0?",
        )
        .over((screen(), canonical()), |&((width, height), z), program| {
            let m: Mat4 = program.ask(arguments![width, height])?;
            let image = |x: f32, y: f32| m.project_point3(vec3(x, y, z)).truncate();
            let last = vec2(width as f32 - 0.5, height as f32 - 0.5);
            close("x and y of (−1, −1, z)", image(-1.0, -1.0), vec2(-0.5, -0.5), TOLERANCE)?;
            close("x and y of (1, 1, z)", image(1.0, 1.0), last, TOLERANCE)
        }),
        Law::of(
            "centres_are_whole",
            2,
            "Cut the square into n_x × n_y equal cells: the centre of cell (i, j) lands on (i, j), j counted from below.",
            "The centre of a cell does not land on its pixel: how wide is a cell, how wide a pixel, and which way does j run?",
        )
        .over(screen_and_pixel(), |&((width, height), (i, j)), program| {
            let m: Mat4 = program.ask(arguments![width, height])?;
            let cell = |at: u32, count: u32| (2 * at + 1) as f32 / count as f32 - 1.0;
            let centre = vec3(cell(i, width), cell(j, height), 0.0);
            let landed = m.project_point3(centre).truncate();
            close("the centre", landed, vec2(i as f32, j as f32), TOLERANCE)
        }),
        Law::of(
            "depth_stays",
            2,
            "z stays as it is.",
            "z changed. The z-buffer compares the depths of the canonical cube as they are: what stands in the third row?",
        )
        .over((screen(), canonical(), canonical(), canonical()), |&((width, height), x, y, z), program| {
            let m: Mat4 = program.ask(arguments![width, height])?;
            close("z", m.project_point3(vec3(x, y, z)).z, z, TOLERANCE)
        }),
        Law::of(
            "points_stay_points",
            1,
            "The last row is (0, 0, 0, 1): a point stays a point.",
            "The last row is not (0, 0, 0, 1): glam's `from_cols` takes columns. Is the matrix transposed?",
        )
        .over(screen(), |&(width, height), program| {
            let m: Mat4 = program.ask(arguments![width, height])?;
            close("the last row", m.row(3), Vec4::W, TOLERANCE)
        }),
    ]
}

fn slide(width: u32, height: u32) -> Mat4 {
    let (n_x, n_y) = (width as f32, height as f32);
    let middle = glam::vec3((n_x - 1.0) / 2.0, (n_y - 1.0) / 2.0, 0.0);
    Mat4::from_translation(middle) * Mat4::from_scale(glam::vec3(n_x / 2.0, n_y / 2.0, 1.0))
}

fn column_by_column(width: u32, height: u32) -> Mat4 {
    let half = 0.5 * glam::vec2(width as f32, height as f32);
    Mat4::from_cols(
        glam::vec4(half.x, 0.0, 0.0, 0.0),
        glam::vec4(0.0, half.y, 0.0, 0.0),
        glam::Vec4::Z,
        glam::vec4(half.x - 0.5, half.y - 0.5, 0.0, 1.0),
    )
}

fn corner_by_corner(width: u32, height: u32) -> Mat4 {
    // Step by step: the corner (−1, −1) to the origin, the square to the unit square, to the pixels, half a pixel back.
    let mut m = Mat4::IDENTITY;
    for (axis, count) in [width, height].into_iter().enumerate() {
        let (mut scale, mut shift) = (1.0, 1.0);
        for factor in [0.5, count as f32] {
            scale *= factor;
            shift *= factor;
        }
        m.col_mut(axis)[axis] = scale;
        m.col_mut(3)[axis] = shift - 0.5;
    }
    m
}

fn misconceptions() -> Vec<Misconception> {
    vec![
        Misconception {
            program: program!(half_a_pixel_off),
            looks_like: "the square goes to [0, n_x] × [0, n_y]",
            help: "The first pixel's centre is 0, so the screen begins half a pixel before it: translate by (n_x−1)/2, not \
                n_x/2.",
        },
        Misconception {
            program: program!(centre_to_centre),
            looks_like: "the square goes to [0, n_x−1] × [0, n_y−1]",
            help: "The square's edge is the edge of the first pixel, not its centre: n_x pixels are n_x wide, so scale by \
                n_x/2.",
        },
        Misconception {
            program: program!(downwards),
            looks_like: "j runs downwards",
            help: "In the lecture j runs upwards, as y does: nothing is turned over.",
        },
        Misconception {
            program: program!(scaled_by_the_whole_width),
            looks_like: "the square is scaled by n_x instead of n_x/2",
            help: "[−1, 1] is 2 wide: to become n_x wide it is scaled by n_x/2.",
        },
        Misconception {
            program: program!(factors_in_reading_order),
            looks_like: "the middle is moved before the square is scaled",
            help: "The rightmost matrix meets the point first: the scaling stands on the right, the translation, in pixels, \
                on the left.",
        },
        Misconception {
            program: program!(depth_to_zero_and_one),
            looks_like: "z is carried to [0, 1]",
            help: "Some libraries do this in their viewport. Here z stays as it is.",
        },
        Misconception {
            program: program!(whole_number_division),
            looks_like: "whole numbers are divided",
            help: "7 / 2 is 3 for whole numbers. Write `width as f32 / 2.0`.",
        },
        Misconception {
            program: program!(transposed),
            looks_like: "rows and columns are exchanged",
            help: "`from_cols` takes columns: rows read from the slide, one after the other, come out transposed.",
        },
    ]
}

fn half_a_pixel_off(width: u32, height: u32) -> Mat4 {
    let half = 0.5 * glam::vec3(width as f32, height as f32, 0.0);
    Mat4::from_translation(half) * Mat4::from_scale(half.with_z(1.0))
}

fn centre_to_centre(width: u32, height: u32) -> Mat4 {
    let half = 0.5 * glam::vec3(width as f32 - 1.0, height as f32 - 1.0, 0.0);
    Mat4::from_translation(half) * Mat4::from_scale(half.with_z(1.0))
}

fn downwards(width: u32, height: u32) -> Mat4 {
    let (n_x, n_y) = (width as f32, height as f32);
    let middle = glam::vec3((n_x - 1.0) / 2.0, (n_y - 1.0) / 2.0, 0.0);
    Mat4::from_translation(middle) * Mat4::from_scale(glam::vec3(n_x / 2.0, -n_y / 2.0, 1.0))
}

fn scaled_by_the_whole_width(width: u32, height: u32) -> Mat4 {
    let (n_x, n_y) = (width as f32, height as f32);
    let middle = glam::vec3((n_x - 1.0) / 2.0, (n_y - 1.0) / 2.0, 0.0);
    Mat4::from_translation(middle) * Mat4::from_scale(glam::vec3(n_x, n_y, 1.0))
}

fn factors_in_reading_order(width: u32, height: u32) -> Mat4 {
    let (n_x, n_y) = (width as f32, height as f32);
    let middle = glam::vec3((n_x - 1.0) / 2.0, (n_y - 1.0) / 2.0, 0.0);
    Mat4::from_scale(glam::vec3(n_x / 2.0, n_y / 2.0, 1.0)) * Mat4::from_translation(middle)
}

fn depth_to_zero_and_one(width: u32, height: u32) -> Mat4 {
    let (n_x, n_y) = (width as f32, height as f32);
    let middle = glam::vec3((n_x - 1.0) / 2.0, (n_y - 1.0) / 2.0, 0.5);
    Mat4::from_translation(middle) * Mat4::from_scale(glam::vec3(n_x / 2.0, n_y / 2.0, 0.5))
}

fn whole_number_division(width: u32, height: u32) -> Mat4 {
    let middle = glam::vec3(((width - 1) / 2) as f32, ((height - 1) / 2) as f32, 0.0);
    Mat4::from_translation(middle)
        * Mat4::from_scale(glam::vec3((width / 2) as f32, (height / 2) as f32, 1.0))
}

fn transposed(width: u32, height: u32) -> Mat4 {
    let half = 0.5 * glam::vec2(width as f32, height as f32);
    Mat4::from_cols(
        glam::vec4(half.x, 0.0, 0.0, half.x - 0.5),
        glam::vec4(0.0, half.y, 0.0, half.y - 0.5),
        glam::Vec4::Z,
        glam::Vec4::W,
    )
}
