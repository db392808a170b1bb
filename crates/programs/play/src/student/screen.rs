//! How does a function of the rasterizer look? On a small screen whose pixels are seen one by one.

use canvas::Rgb;
use course::{Value, arguments};
use glam::{Vec2, Vec3, vec2, vec3};
use vocabulary::{Barycentric, Buffers, Fragment, Occlusion, Pixel, Triangle, Triangle2};

use super::knobs::Knobs;
use super::panel::{Dot, Panel, dot};
use super::rays::tint;

/// What is not covered.
const EMPTY: Rgb = Rgb::new(0.12, 0.13, 0.16);

fn triangle(a: [f32; 2], b: [f32; 2], c: [f32; 2]) -> Triangle2 {
    Triangle2 { a: a.into(), b: b.into(), c: c.into() }
}

/// Two triangles that share a side, one with a level side above, one below; the same the other way round; and a slanted one. Many samples lie on sides.
pub(super) fn covers(_: &Knobs<'_>) -> Vec<Panel> {
    /// Two samples a unit.
    const SIDE: u32 = 33;
    let sample = |i: u32, j: u32| 0.5 * vec2(i as f32, j as f32);
    let triangles = [
        (0, triangle([2.0, 2.0], [14.0, 2.0], [14.0, 14.0])),
        (1, triangle([2.0, 2.0], [2.0, 14.0], [14.0, 14.0])),
        (2, triangle([8.0, 1.0], [15.0, 8.0], [1.0, 11.0])),
    ];
    let panel = |(k, triangle): (usize, Triangle2)| {
        let color = move |_, _, covered: bool| Some(if covered { tint(k) } else { EMPTY });
        Panel::of_pixels((SIDE, SIDE), move |i, j| Some(arguments![triangle, sample(i, j)]), color)
    };
    triangles.into_iter().map(panel).collect()
}

/// Two triangles that share a side, one anticlockwise, one clockwise; and one that is partly off
/// the screen at the other end, with a side at the right of its last column.
pub(super) fn rasterize(_: &Knobs<'_>) -> Vec<Panel> {
    const SIZE: (u32, u32) = (18, 15);
    let sharing =
        [triangle([1.0, 1.0], [13.0, 3.0], [4.0, 12.0]), triangle([13.0, 3.0], [4.0, 12.0], [19.5, 16.5])];
    let leaving = [triangle([-4.0, 2.25], [11.25, 2.25], [11.25, 12.25])];
    let asked = |triangles: &[Triangle2]| -> Vec<Vec<Value>> {
        triangles.iter().map(|triangle| arguments![*triangle, SIZE.0, SIZE.1]).collect()
    };
    // Where two triangles own one pixel, or one owns it twice, it is white; what is not on the screen is counted in the corner.
    let color = |i: u32, j: u32, answers: &[Option<Vec<Pixel>>]| {
        let mut owners = Vec::new();
        for (k, answer) in answers.iter().enumerate() {
            let Some(pixels) = answer else { return Dot::Missing };
            let here = |p: &&Pixel| (p.i, p.j) == (i, j);
            let astray = |p: &&Pixel| (i, j) == (SIZE.0 - 1, 0) && (p.i >= SIZE.0 || p.j >= SIZE.1);
            owners.extend(pixels.iter().filter(|p| here(p) || astray(p)).map(|_| k));
        }
        dot(Some(match owners[..] {
            [] => EMPTY,
            [k] => tint(k),
            _ => Rgb::ONE,
        }))
    };
    vec![Panel::of_all(SIZE, asked(&sharing), color), Panel::of_all(SIZE, asked(&leaving), color)]
}

/// Weights as colours, outside the triangle too: in an anticlockwise triangle, a clockwise one, and one without area, which has none.
pub(super) fn barycentric(_: &Knobs<'_>) -> Vec<Panel> {
    const SIDE: u32 = 40;
    let triangles = [
        triangle([8.0, 6.0], [32.0, 10.0], [14.0, 33.0]),
        triangle([8.0, 6.0], [14.0, 33.0], [32.0, 10.0]),
        triangle([4.0, 4.0], [20.0, 20.0], [36.0, 36.0]),
    ];
    let panel = |triangle: Triangle2| {
        let color = |_, _, weights: Option<Barycentric>| {
            let Some(Barycentric { alpha, beta, gamma }) = weights else { return Some(EMPTY) };
            // Weights from −2 to 3 can be told apart.
            Some((vec3(alpha, beta, gamma) + 2.0) / 5.0)
        };
        let at = |i: u32, j: u32| vec2(i as f32, j as f32);
        Panel::of_pixels((SIDE, SIDE), move |i, j| Some(arguments![triangle, at(i, j)]), color)
    };
    triangles.into_iter().map(panel).collect()
}

/// Depth as brightness, near is bright: over an anticlockwise triangle and a clockwise one, and its plane around them.
pub(super) fn depth_at(knobs: &Knobs<'_>) -> Vec<Panel> {
    const SIDE: u32 = 40;
    let near = knobs.or("gap", 0.0).clamp(0.0, 0.2);
    let corner = |x: f32, y: f32, z: f32| vec3(x, y, z);
    let front =
        Triangle { a: corner(6.0, 5.0, 0.9 - near), b: corner(35.0, 9.0, -0.3), c: corner(12.0, 34.0, 0.15) };
    let back = Triangle { b: front.c, c: front.b, ..front };
    let panel = |triangle: Triangle| {
        let color = |_, _, z: f32| Some(Rgb::splat(0.5 + 0.3 * z));
        let at = |i: u32, j: u32| vec2(i as f32, j as f32);
        Panel::of_pixels((SIDE, SIDE), move |i, j| Some(arguments![triangle, at(i, j)]), color)
    };
    [front, back].into_iter().map(panel).collect()
}

/// The slide's grid.
const GRID: (u32, u32) = (6, 5);

/// The fragments of the slide's three polygons with these depths: two rectangles from the lower left corner, and a triangle.
fn fragments(depths: [Option<f32>; 3]) -> Vec<Fragment> {
    let corner = Vec2::splat(-0.5);
    let polygons = [
        vec![[corner, vec2(3.5, -0.5), vec2(3.5, 2.5)], [corner, vec2(3.5, 2.5), vec2(-0.5, 2.5)]],
        vec![[corner, vec2(5.5, -0.5), vec2(5.5, 4.5)], [corner, vec2(5.5, 4.5), vec2(-0.5, 4.5)]],
        vec![[vec2(2.5, 5.0), vec2(-0.25, -0.5), vec2(8.0, -0.5)]],
    ];
    let mut fragments = Vec::new();
    for (k, (polygon, z)) in polygons.iter().zip(depths).enumerate() {
        // One without a depth is left out.
        let Some(z) = z else { continue };
        for corners in polygon {
            let places = (0..GRID.1).flat_map(|j| (0..GRID.0).map(move |i| (i, j)));
            let covered = places.filter(|(i, j)| is_inside(corners, vec2(*i as f32, *j as f32)));
            fragments.extend(covered.map(|(i, j)| Fragment { i, j, z, colour: tint(k) }));
        }
    }
    fragments
}

/// Whether a sample is inside; no sample lies on the outer sides of these polygons, and one on a diagonal may come twice.
fn is_inside(corners: &[Vec2; 3], p: Vec2) -> bool {
    let side = |k: usize| (corners[(k + 1) % 3] - corners[k]).perp_dot(p - corners[k]);
    let sides = [side(0), side(1), side(2)];
    sides.iter().all(|s| *s >= 0.0) || sides.iter().all(|s| *s <= 0.0)
}

/// The rgb-buffer and the z-buffer of the slide's polygons; and the first and the last alone, equally near.
pub(super) fn zbuffer(knobs: &Knobs<'_>) -> Vec<Panel> {
    let [first, second, third] =
        [("first", 10.0), ("second", 5.0), ("third", 15.0)].map(|(name, z)| knobs.or(name, z));
    let background = vec3(0.25, 0.25, 0.3);
    let buffers = |depths: [Option<f32>; 3], look: fn(Vec3, f32) -> Rgb| {
        let question = arguments![fragments(depths), background, GRID.0, GRID.1];
        Panel::of_all(GRID, vec![question], move |i, j, answers: &[Option<Buffers>]| {
            let cell = answers.first().and_then(Option::as_ref).and_then(|buffers| {
                let (i, j) = (i as usize, j as usize);
                Some(look(*buffers.rgb.get(j)?.get(i)?, *buffers.z.get(j)?.get(i)?))
            });
            dot(cell)
        })
    };
    let depth = |_, z: f32| Rgb::splat((0.05 + z / 22.0).clamp(0.0, 1.0));
    vec![
        buffers([Some(first), Some(second), Some(third)], |colour, _| colour),
        buffers([Some(first), Some(second), Some(third)], depth),
        buffers([Some(first), None, Some(first)], |colour, _| colour),
    ]
}

/// Five sheets, each over a part of the next, and one that stands alone, painted in the given order; and three that hide each other in a ring, for
/// which there is none.
pub(super) fn painters_order(_: &Knobs<'_>) -> Vec<Panel> {
    /// From the nearest to the farthest; the numbers do not give the order away.
    const NEAREST_FIRST: [usize; 5] = [3, 0, 4, 1, 2];
    /// The one that hides nothing, and that nothing hides.
    const ALONE: usize = 5;
    const SIDE: u32 = 40;
    let sheet = |k: usize| match NEAREST_FIRST.iter().position(|sheet| *sheet == k) {
        Some(place) => Some((Vec2::splat(2.0 + 4.5 * place as f32), 16.0)),
        None => (k == ALONE).then_some((vec2(1.0, 29.0), 9.0)),
    };
    let mut pairs = Vec::new();
    for (k, in_front) in NEAREST_FIRST.iter().enumerate() {
        let hidden = &NEAREST_FIRST[k + 1..];
        pairs.extend(hidden.iter().map(|behind| Occlusion { behind: *behind, in_front: *in_front }));
    }
    // In no particular order, as the exercise says.
    pairs.rotate_left(4);
    let order = arguments![NEAREST_FIRST.len() + 1, pairs];
    let painted = move |i: u32, j: u32, answers: &[Option<Option<Vec<usize>>>]| {
        let Some(Some(order)) = answers.first() else { return Dot::Missing };
        let Some(order) = order else { return Dot::Color(EMPTY) };
        let p = vec2(i as f32, j as f32);
        let is_on = |(corner, side): (Vec2, f32)| {
            (p - corner).min_element() >= 0.0 && (p - corner).max_element() < side
        };
        let last = order.iter().rev().find(|k| sheet(**k).is_some_and(is_on));
        Dot::Color(last.map_or(Rgb::splat(0.04), |k| tint(*k)))
    };
    let ring = (0..3).map(|k| Occlusion { behind: k, in_front: (k + 1) % 3 }).collect::<Vec<_>>();
    // Beside the ring stands a sheet that nothing hides.
    let cycle = arguments![4_usize, ring];
    vec![Panel::of_all((SIDE, SIDE), vec![order], painted), Panel::of_all((SIDE, SIDE), vec![cycle], painted)]
}
