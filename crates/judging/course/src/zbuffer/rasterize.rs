//! Which pixels does a triangle own? Those whose samples it covers (L16, E10).

use glam::{Vec2, vec2};
use proptest::prelude::*;
use vocabulary::{Pixel, Triangle2};

use super::drawing;
use super::inputs::{
    doubled_area, in_order, order, pixels, triangle_about_the_screen, triangle_without_area,
};
use crate::exercise::{arguments, signature};
use crate::law::{Asker, Stop, typed};
use crate::{Concept, Example, Exercise, Law, Misconception, Title, Value, that};

const STUB: &str = r#"//! The pixels of a triangle (L16, E10).
//!
//! Give all pixels of the screen whose sample the triangle covers, in any order, each once.
//!
//! - Pixel (i, j) is the square from i − ½ to i + ½ and from j − ½ to j + ½; its sample is its middle, the point (i, j).
//! - The screen has the columns i = 0 … width − 1 and the rows j = 0 … height − 1, j counted upwards.
//! - A sample on a side belongs to the triangle by the top-left rule: if that is a left side or a top side. In a corner both
//!   sides that meet there must be left or top sides.
//! - `triangle`: its corners in pixels, clockwise or anticlockwise. They may lie off the screen; the part on the screen counts.
//!   A triangle without area owns no pixel.
//! - Corners are multiples of ¼ and at most 18 away from 0, so that sums, differences and products of coordinates are exact.
//!
//! glam: `a.min(b)` and `a.max(b)` take the lesser and the greater of each coordinate; `u.perp_dot(v)` is u.x · v.y − u.y · v.x.
//! `glam::vec2(x, y)` is the point (x, y). You may copy your `covers` into the function, as a closure.

use vocabulary::{Pixel, Triangle2};

pub fn rasterize(triangle: Triangle2, width: u32, height: u32) -> Vec<Pixel> {
    todo!()
}
"#;

signature!((triangle: Triangle2, width: u32, height: u32) -> Vec<Pixel>);

pub(super) fn exercise() -> Exercise {
    Exercise {
        name: "rasterize",
        concept: Concept::Zbuffer,
        items: "L16, E10",
        title: Title { english: "Rasterize a triangle", dutch: "Een driehoek rasteriseren" },
        prerequisites: &["covers"],
        stub: STUB,
        signature: SIGNATURE,
        hints: [
            "You can already say whether a triangle covers a sample. Which samples are there to ask about?",
            "Two loops, over j from 0 and over i from 0, and the test of `covers` at the point (i, j). Only then make it \
                faster: samples outside the box around the corners need no test.",
            "for j in 0..height { for i in 0..width { if covers(triangle, vec2(i as f32, j as f32)) { push Pixel { i, j } } } }",
        ],
        examples: examples(),
        laws: laws(),
        reference: program!(within_the_box),
        variants: vec![program!(over_the_whole_screen), program!(row_by_row)],
        misconceptions: misconceptions(),
        explanation: "A rasterizer asks one question for each sample, and by the top-left rule neighbours never both say \
            yes. The box around the corners saves most questions; from one sample to the next an edge function changes by a \
            constant, so hardware asks many at once with additions alone.",
        draw: drawing::pixels,
        source: include_str!("rasterize.rs"),
    }
}

fn examples() -> Vec<Example> {
    let example =
        |caption, triangle: Triangle2, (width, height): (u32, u32), wanted: &'static [(u32, u32)]| {
            let answer: Vec<Pixel> = wanted.iter().map(|&(i, j)| Pixel { i, j }).collect();
            let check = move |given: &Value| {
                let given: Vec<Pixel> = typed(given)?;
                same_pixels(&given, |pixel| wanted.contains(&(pixel.i, pixel.j)), width, height)
            };
            Example::with_check(caption, arguments![triangle, width, height], answer, check)
        };
    vec![
        example(
            "corners on samples: the left side belongs, the bottom side and the diagonal do not",
            Triangle2 { a: vec2(1.0, 1.0), b: vec2(4.0, 1.0), c: vec2(1.0, 4.0) },
            (6, 5),
            &[(1, 2), (2, 2), (1, 3)],
        ),
        example(
            "the other half of the square: the diagonal and the top side belong, the right side does not",
            Triangle2 { a: vec2(4.0, 1.0), b: vec2(4.0, 4.0), c: vec2(1.0, 4.0) },
            (6, 5),
            &[(3, 2), (2, 3), (3, 3), (1, 4), (2, 4), (3, 4)],
        ),
        example(
            "partly off the screen",
            Triangle2 { a: vec2(-2.0, -0.5), b: vec2(1.5, -0.5), c: vec2(-2.0, 3.0) },
            (4, 3),
            &[(0, 0)],
        ),
        example(
            "between the samples there is nothing",
            Triangle2 { a: vec2(1.25, 1.25), b: vec2(1.75, 1.25), c: vec2(1.5, 1.75) },
            (4, 3),
            &[],
        ),
    ]
}

fn laws() -> Vec<Law> {
    vec![
        inside_and_outside(),
        each_pixel_once(),
        rectangle(),
        shared_side(),
        whole_pixels_on(),
        without_area(),
    ]
}

/// The samples of the screen.
fn samples(width: u32, height: u32) -> impl Iterator<Item = Pixel> {
    (0..height).flat_map(move |j| (0..width).map(move |i| Pixel { i, j }))
}

/// Positive if the sample lies inside, negative outside, 0 on a side.
fn depth_inside(t: Triangle2, pixel: Pixel) -> f32 {
    let p = vec2(pixel.i as f32, pixel.j as f32);
    let sign = doubled_area(t.a, t.b, t.c).signum();
    let edges = [doubled_area(t.a, t.b, p), doubled_area(t.b, t.c, p), doubled_area(t.c, t.a, p)];
    edges.into_iter().map(|edge| sign * edge).fold(f32::INFINITY, f32::min)
}

/// Demands the pixels that are `wanted`, no others and none twice.
fn same_pixels(given: &[Pixel], wanted: impl Fn(Pixel) -> bool, width: u32, height: u32) -> Result<(), Stop> {
    for Pixel { i, j } in given.iter().copied() {
        that(wanted(Pixel { i, j }), || format!("pixel ({i}, {j}) should not be there"))?;
    }
    for pixel in samples(width, height).filter(|pixel| wanted(*pixel)) {
        let times = given.iter().filter(|other| **other == pixel).count();
        let Pixel { i, j } = pixel;
        that(times > 0, || format!("pixel ({i}, {j}) is missing"))?;
        that(times == 1, || format!("pixel ({i}, {j}) is there {times} times"))?;
    }
    Ok(())
}

fn inside_and_outside() -> Law {
    Law::of(
        "samples_inside_and_no_others",
        3,
        "Pixels whose samples lie inside are there, pixels whose samples lie outside are not.",
        "No sample on a side is looked at here. Where is the sample of pixel (i, j), where do your loops begin and end, and \
            which way do rows and columns count?",
    )
    .over((triangle_about_the_screen(), pixels(), pixels()), |&(triangle, width, height), program| {
        let given: Vec<Pixel> = program.ask(arguments![triangle, width, height])?;
        let found = |pixel: Pixel| given.contains(&pixel);
        for pixel in samples(width, height) {
            let Pixel { i, j } = pixel;
            let inside = depth_inside(triangle, pixel);
            that(inside <= 0.0 || found(pixel), || format!("the sample of pixel ({i}, {j}) lies inside, the pixel is missing"))?;
            that(inside >= 0.0 || !found(pixel), || format!("the sample of pixel ({i}, {j}) lies outside, the pixel is there"))?;
        }
        Ok(())
    })
}

fn each_pixel_once() -> Law {
    Law::of(
        "each_pixel_once_and_on_the_screen",
        1,
        "Every pixel is on the screen and there only once.",
        "A pixel is there that the screen does not have, or one is there twice. Where do the columns and the rows end, and \
            what becomes of a negative number in a u32?",
    )
    .over((triangle_about_the_screen(), pixels(), pixels()), |&(triangle, width, height), program| {
        let given: Vec<Pixel> = program.ask(arguments![triangle, width, height])?;
        for (at, pixel) in given.iter().enumerate() {
            let Pixel { i, j } = *pixel;
            that(i < width && j < height, || format!("pixel ({i}, {j}) is not on a screen of {width} × {height}"))?;
            that(!given[..at].contains(pixel), || format!("pixel ({i}, {j}) is there twice"))?;
        }
        Ok(())
    })
}

fn rectangle() -> Law {
    Law::of(
        "a_rectangle_owns_left_and_top",
        2,
        "Two triangles make a rectangle with corners on samples: it owns its left column and its top row, but not its right \
            column and its bottom row.",
        "The rectangle's sides go through samples, and so may its diagonal: which sides are left or top, with y upwards?",
    )
    .over(
        ((0..4_u32, 0..4_u32), (1..=5_u32, 1..=5_u32), (order(), order())),
        |&((left, bottom), (columns, rows), (first, second)), program| {
            let [low, high] = [(left, bottom), (left + columns, bottom + rows)].map(|(x, y)| vec2(x as f32, y as f32));
            let (right_low, left_high) = (vec2(high.x, low.y), vec2(low.x, high.y));
            let mut given: Vec<Pixel> = program.ask(arguments![in_order([low, right_low, high], first), 10_u32, 10_u32])?;
            let upper: Vec<Pixel> = program.ask(arguments![in_order([low, high, left_high], second), 10_u32, 10_u32])?;
            given.extend(upper);
            let wanted = |Pixel { i, j }| {
                left <= i && i < left + columns && bottom < j && j <= bottom + rows
            };
            same_pixels(&given, wanted, 10, 10)
        },
    )
}

/// A slanted side with samples on it, and a corner on each side of it: `(from, to, left, right)`.
fn crossed_side() -> impl Strategy<Value = [Vec2; 4]> + Clone {
    let whole = || (0..=8_i32, 0..=8_i32);
    (whole(), whole(), triangle_about_the_screen())
        .prop_map(|((x0, y0), (x1, y1), t)| {
            let from = vec2(x0 as f32, y0 as f32);
            let to = vec2(x1 as f32, y1 as f32);
            // The third corner may lie on either side: the fourth goes to the other one.
            let middle = 0.5 * (from + to);
            let other = if doubled_area(from, to, t.a) * doubled_area(from, to, t.b) < 0.0 {
                t.b
            } else {
                2.0 * middle - t.b
            };
            [from, to, t.a, other]
        })
        .prop_filter("on one line", |[from, to, c, d]| {
            doubled_area(*from, *to, *c) != 0.0 && doubled_area(*from, *to, *d) != 0.0
        })
}

fn shared_side() -> Law {
    Law::of(
        "neighbours_share_no_pixel",
        2,
        "Two triangles with a common side have no pixel in common, and a sample on the side between its ends belongs to one \
            of them.",
        "A sample on the common side is drawn twice or not at all: the top-left rule decides which of the two owns it.",
    )
    .over((crossed_side(), order(), order()), |&([from, to, c, d], first, second), program| {
        let size = 9_u32;
        let one: Vec<Pixel> = program.ask(arguments![in_order([from, to, c], first), size, size])?;
        let two: Vec<Pixel> = program.ask(arguments![in_order([to, from, d], second), size, size])?;
        for pixel in samples(size, size) {
            let Pixel { i, j } = pixel;
            let owners = u32::from(one.contains(&pixel)) + u32::from(two.contains(&pixel));
            that(owners < 2, || format!("pixel ({i}, {j}) belongs to both triangles"))?;
            let p = vec2(i as f32, j as f32);
            let between = doubled_area(from, to, p) == 0.0 && (p - from).dot(p - to) < 0.0;
            that(owners == 1 || !between, || format!("pixel ({i}, {j}) on the common side belongs to neither triangle"))?;
        }
        Ok(())
    })
}

fn whole_pixels_on() -> Law {
    Law::of(
        "whole_pixels_further_on",
        1,
        "A triangle moved by whole pixels owns the pixels moved by as much, those that are on the screen.",
        "The triangle moved by whole pixels and its pixels did not move with it: what happens at the borders of the screen?",
    )
    .over(
        (triangle_about_the_screen(), (0..=3_u32, 0..=3_u32), pixels(), pixels()),
        |&(triangle, (right, up), width, height), program| {
            let by = vec2(right as f32, up as f32);
            let moved = Triangle2 { a: triangle.a + by, b: triangle.b + by, c: triangle.c + by };
            let first: Vec<Pixel> = program.ask(arguments![triangle, width, height])?;
            let second: Vec<Pixel> = program.ask(arguments![moved, width + right, height + up])?;
            for Pixel { i, j } in samples(width, height) {
                let before = first.contains(&Pixel { i, j });
                let after = second.contains(&Pixel { i: i + right, j: j + up });
                that(before == after, || {
                    let words = |there: bool| if there { "is there" } else { "is not there" };
                    let (x, y) = (i + right, j + up);
                    format!("pixel ({i}, {j}) {}, but after moving ({x}, {y}) {}", words(before), words(after))
                })?;
            }
            Ok(())
        },
    )
}

fn without_area() -> Law {
    Law::of(
        "without_area_no_pixels",
        1,
        "A triangle without area owns no pixel, even if its corners lie on samples.",
        "All corners lie on one line: which signs come out for a sample on that line?",
    )
    .over(
        (triangle_without_area(4), pixels(), pixels()),
        |&(triangle, width, height), program: &Asker<'_>| {
            // Moved so that its first corner lies on the sample (2, 2).
            let by = vec2(2.0, 2.0) - triangle.a;
            let moved = Triangle2 { a: triangle.a + by, b: triangle.b + by, c: triangle.c + by };
            let given: Vec<Pixel> = program.ask(arguments![moved, width, height])?;
            that(given.is_empty(), || format!("{} pixels belong to a triangle without area", given.len()))
        },
    )
}

fn within_the_box(triangle: Triangle2, width: u32, height: u32) -> Vec<Pixel> {
    let Triangle2 { a, b, c } = triangle;
    let clockwise = (b - a).perp_dot(c - a) < 0.0;
    let (b, c) = if clockwise { (c, b) } else { (b, c) };
    let covers = |p: glam::Vec2| {
        [(a, b), (b, c), (c, a)].into_iter().all(|(from, to)| {
            let along = to - from;
            let edge = along.perp_dot(p - from);
            let owned = along.y < 0.0 || (along.y == 0.0 && along.x < 0.0);
            edge > 0.0 || (edge == 0.0 && owned)
        })
    };
    // The samples of the box around the corners; `as` makes a negative number 0.
    let low = a.min(b).min(c).ceil();
    let high = a.max(b).max(c).floor() + glam::Vec2::ONE;
    let mut pixels = Vec::new();
    for j in low.y as u32..(high.y as u32).min(height) {
        for i in low.x as u32..(high.x as u32).min(width) {
            if covers(glam::vec2(i as f32, j as f32)) {
                pixels.push(Pixel { i, j });
            }
        }
    }
    pixels
}

fn over_the_whole_screen(triangle: Triangle2, width: u32, height: u32) -> Vec<Pixel> {
    // Each sample a hair to the right and a much finer one down: then none lies on a side, and both windings read alike.
    let nudge = glam::dvec2(2.0_f64.powi(-16), -(2.0_f64.powi(-32)));
    let [a, b, c] = [triangle.a, triangle.b, triangle.c].map(glam::Vec2::as_dvec2);
    let mut pixels = Vec::new();
    for i in (0..width).rev() {
        for j in 0..height {
            let p = glam::dvec2(i.into(), j.into()) + nudge;
            let edges = [(b - a).perp_dot(p - a), (c - b).perp_dot(p - b), (a - c).perp_dot(p - c)];
            if edges.iter().all(|edge| *edge > 0.0) || edges.iter().all(|edge| *edge < 0.0) {
                pixels.push(Pixel { i, j });
            }
        }
    }
    pixels
}

fn row_by_row(triangle: Triangle2, width: u32, height: u32) -> Vec<Pixel> {
    let Triangle2 { a, b, c } = triangle;
    let mut pixels = Vec::new();
    for j in 0..height {
        let y = j as f32;
        // Where the row enters and leaves: sides count from above their lower end up to and with their upper end.
        let mut crossings = Vec::new();
        for (from, to) in [(a, b), (b, c), (c, a)] {
            let (low, high) = if from.y < to.y { (from, to) } else { (to, from) };
            if low.y < y && y <= high.y {
                crossings.push(low.x + (y - low.y) * (high.x - low.x) / (high.y - low.y));
            }
        }
        if let [one, other] = crossings[..] {
            // From the first sample at or after the left crossing to the last one before the right crossing.
            let (enters, leaves) = (one.min(other).ceil() as u32, one.max(other).ceil() as u32);
            pixels.extend((enters..leaves.min(width)).map(|i| Pixel { i, j }));
        }
    }
    pixels
}

fn misconceptions() -> Vec<Misconception> {
    vec![
        Misconception {
            program: program!(samples_at_halves),
            looks_like: "the sample of pixel (i, j) is taken to be (i + ½, j + ½)",
            help: "In this lecture pixel (i, j) has its middle at (i, j): the screen begins at −½.",
        },
        Misconception {
            program: program!(the_whole_box),
            looks_like: "every pixel of the box around the triangle is taken",
            help: "The box only says which samples are worth a question; half of it or more lies outside the triangle.",
        },
        Misconception {
            program: program!(no_side),
            looks_like: "samples on a side belong to no triangle",
            help: "Along a common side a crack is left. Left sides and top sides belong.",
        },
        Misconception {
            program: program!(every_side),
            looks_like: "samples on a side belong to every triangle",
            help: "Along a common side pixels are drawn twice. Right sides and bottom sides belong to the neighbour.",
        },
        Misconception {
            program: program!(only_anticlockwise),
            looks_like: "a clockwise triangle has no pixels",
            help: "The area of a clockwise triangle is negative: exchange two corners, and all signs are as you expect them.",
        },
        Misconception {
            program: program!(all_or_nothing),
            looks_like: "a triangle that is partly off the screen is left out",
            help: "Cut the loops short, not the triangle: its part on the screen is seen.",
        },
        Misconception {
            program: program!(last_ones_missing),
            looks_like: "the last column and the last row of the box are left out",
            help: "`low..high` ends before high. If the last sample may still be covered, the loop must reach it.",
        },
        Misconception {
            program: program!(one_too_many),
            looks_like: "the loops run up to width and height themselves",
            help: "Columns are counted from 0: the last of them is width − 1. `0..width` ends there, `0..=width` does not.",
        },
        Misconception {
            program: program!(rows_from_the_top),
            looks_like: "rows are counted from the top",
            help: "Files of pictures count rows downwards, here j runs upwards like y: row j lies at y = j.",
        },
    ]
}

// Each of the wrong programs differs from the right one in one place. What they have in common stands here once, so that the place is seen.

/// The corners, so that they run anticlockwise.
fn anticlockwise(Triangle2 { a, b, c }: Triangle2) -> [glam::Vec2; 3] {
    if (b - a).perp_dot(c - a) < 0.0 { [a, c, b] } else { [a, b, c] }
}

/// The values of the three edge functions.
fn edges([a, b, c]: [glam::Vec2; 3], p: glam::Vec2) -> [f32; 3] {
    [(b - a).perp_dot(p - a), (c - b).perp_dot(p - b), (a - c).perp_dot(p - c)]
}

/// Whether the triangle with these corners owns p, by the top-left rule.
fn owns([a, b, c]: [glam::Vec2; 3], p: glam::Vec2) -> bool {
    let along = [b - a, c - b, a - c];
    along.iter().zip(edges([a, b, c], p)).all(|(along, edge)| {
        let owned = along.y < 0.0 || (along.y == 0.0 && along.x < 0.0);
        edge > 0.0 || (edge == 0.0 && owned)
    })
}

/// The pixels of the screen whose sample is chosen, row after row.
fn chosen(width: u32, height: u32, is_chosen: impl Fn(glam::Vec2) -> bool) -> Vec<Pixel> {
    let screen = (0..height).flat_map(|j| (0..width).map(move |i| Pixel { i, j }));
    screen.filter(|pixel| is_chosen(glam::vec2(pixel.i as f32, pixel.j as f32))).collect()
}

fn samples_at_halves(triangle: Triangle2, width: u32, height: u32) -> Vec<Pixel> {
    let corners = anticlockwise(triangle);
    chosen(width, height, |p| owns(corners, p + 0.5))
}

fn the_whole_box(triangle: Triangle2, width: u32, height: u32) -> Vec<Pixel> {
    let Triangle2 { a, b, c } = triangle;
    let low = a.min(b).min(c).ceil();
    let high = a.max(b).max(c).floor() + glam::Vec2::ONE;
    let columns = low.x as u32..(high.x as u32).min(width);
    let rows = low.y as u32..(high.y as u32).min(height);
    rows.flat_map(|j| columns.clone().map(move |i| Pixel { i, j })).collect()
}

fn no_side(triangle: Triangle2, width: u32, height: u32) -> Vec<Pixel> {
    let corners = anticlockwise(triangle);
    chosen(width, height, |p| edges(corners, p).iter().all(|edge| *edge > 0.0))
}

fn every_side(triangle: Triangle2, width: u32, height: u32) -> Vec<Pixel> {
    let corners = anticlockwise(triangle);
    chosen(width, height, |p| edges(corners, p).iter().all(|edge| *edge >= 0.0))
}

fn only_anticlockwise(triangle: Triangle2, width: u32, height: u32) -> Vec<Pixel> {
    let Triangle2 { a, b, c } = triangle;
    chosen(width, height, |p| owns([a, b, c], p))
}

fn all_or_nothing(triangle: Triangle2, width: u32, height: u32) -> Vec<Pixel> {
    let corners @ [a, b, c] = anticlockwise(triangle);
    let (least, greatest) = (a.min(b).min(c), a.max(b).max(c));
    if least.min_element() < -0.5 || greatest.x > width as f32 - 0.5 || greatest.y > height as f32 - 0.5 {
        return Vec::new();
    }
    chosen(width, height, |p| owns(corners, p))
}

fn last_ones_missing(triangle: Triangle2, width: u32, height: u32) -> Vec<Pixel> {
    let corners @ [a, b, c] = anticlockwise(triangle);
    let end = a.max(b).max(c).floor();
    chosen(width, height, |p| p.cmplt(end).all() && owns(corners, p))
}

fn one_too_many(triangle: Triangle2, width: u32, height: u32) -> Vec<Pixel> {
    let corners = anticlockwise(triangle);
    chosen(width + 1, height + 1, |p| owns(corners, p))
}

fn rows_from_the_top(triangle: Triangle2, width: u32, height: u32) -> Vec<Pixel> {
    let corners = anticlockwise(triangle);
    let pixels = chosen(width, height, |p| owns(corners, p));
    pixels.into_iter().map(|Pixel { i, j }| Pixel { i, j: height - 1 - j }).collect()
}
