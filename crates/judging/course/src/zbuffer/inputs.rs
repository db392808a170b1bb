//! Triangles on the screen that a person can check: corners on quarters of a pixel, so that samples often lie on edges.

use glam::{Vec2, vec2};
use proptest::prelude::*;
use testkit::by_hand::{between, coordinate, point2};
use vocabulary::Triangle2;

/// All orders of three corners: the first three one way round, the others the other way.
const ORDERS: [[usize; 3]; 6] = [[0, 1, 2], [1, 2, 0], [2, 0, 1], [0, 2, 1], [2, 1, 0], [1, 0, 2]];

/// Twice the signed area of abc; exact on quarters.
pub(super) fn doubled_area(a: Vec2, b: Vec2, c: Vec2) -> f32 {
    (b - a).perp_dot(c - a)
}

/// A triangle in the square [−`extent`, `extent`]², either way round; twice its area is `least` at least.
pub(super) fn triangle(extent: i32, least: f32) -> impl Strategy<Value = Triangle2> + Clone {
    (point2(extent), point2(extent), point2(extent))
        .prop_map(|(a, b, c)| Triangle2 { a, b, c })
        .prop_filter("a sliver", move |t| doubled_area(t.a, t.b, t.c).abs() >= least)
}

/// A triangle without area: corners on one line, often two or three in one point.
pub(super) fn triangle_without_area(extent: i32) -> impl Strategy<Value = Triangle2> + Clone {
    let along = (-2..=2, -2..=2).prop_map(|(x, y)| vec2(x as f32, y as f32));
    (point2(extent), along, coordinate(2), coordinate(2)).prop_map(|(a, along, s, t)| Triangle2 {
        a,
        b: a + s * along,
        c: a + t * along,
    })
}

/// A side of a triangle, from a point to another: level, upright or slanted, a third of each.
pub(super) fn side(extent: i32) -> impl Strategy<Value = (Vec2, Vec2)> + Clone {
    let along = prop_oneof![
        coordinate(extent).prop_map(|x| vec2(x, 0.0)),
        coordinate(extent).prop_map(|y| vec2(0.0, y)),
        point2(extent),
    ];
    (point2(extent), along.prop_filter("no side", |along| *along != Vec2::ZERO))
        .prop_map(|(a, along)| (a, a + along))
}

/// Where on a side, ends excluded: ⅛, ¼, … ⅞.
pub(super) fn place_on_side() -> impl Strategy<Value = f32> + Clone {
    (1..=7).prop_map(|eighths| eighths as f32 / 8.0)
}

/// One of the six orders of corners.
pub(super) fn order() -> impl Strategy<Value = usize> + Clone {
    0..ORDERS.len()
}

/// The triangle of three corners, taken in one of the six orders.
pub(super) fn in_order(corners: [Vec2; 3], order: usize) -> Triangle2 {
    let [a, b, c] = ORDERS[order].map(|at| corners[at]);
    Triangle2 { a, b, c }
}

/// A triangle on and around a screen of up to 9 × 9 pixels: corners in [−2, 10]², either way round.
pub(super) fn triangle_about_the_screen() -> impl Strategy<Value = Triangle2> + Clone {
    let corner = || (between(-2, 10), between(-2, 10)).prop_map(|(x, y)| vec2(x, y));
    (corner(), corner(), corner())
        .prop_map(|(a, b, c)| Triangle2 { a, b, c })
        .prop_filter("a sliver", |t| doubled_area(t.a, t.b, t.c).abs() >= 1.0)
}

/// A number of pixels in a row or in a column.
pub(super) fn pixels() -> impl Strategy<Value = u32> + Clone {
    3..=9_u32
}
