//! Each sample in exactly one triangle (E10).

use std::f64::consts::TAU;

use glam::I64Vec2;
use proptest::prelude::*;
use testkit::{Law, ensure};
use zbuffer::screen::SUBPIXELS;
use zbuffer::{Fragment, ScreenTriangle, rasterize_rows};

use super::{HEIGHT, WIDTH, area, coverage, deep, flat, fragments, position, triangulation};

fn samples() -> impl Iterator<Item = I64Vec2> {
    (0..HEIGHT).flat_map(|j| (0..WIDTH).map(move |i| I64Vec2::new(i.into(), j.into()) * SUBPIXELS))
}

#[test]
fn the_top_left_rule_partitions_a_triangulation() {
    Law::new("each sample lies in exactly one triangle of a triangulation")
        .demand("a sample on an edge", 0.75)
        .demand("a sample on an inner vertex", 0.75)
        .demand("a horizontal edge through samples", 0.3)
        .holds_for(proptest::collection::vec(position(0), 1..40), |points, seen| {
            // One pixel beyond the screen on every side, so that every sample lies inside.
            let (lowest, highest) = (I64Vec2::new(-1, -1), I64Vec2::new(WIDTH.into(), HEIGHT.into()));
            let triangles = triangulation(lowest * SUBPIXELS, highest * SUBPIXELS, &points);
            let edges = || triangles.iter().flat_map(|[a, b, c]| [(*a, *b), (*b, *c), (*c, *a)]);
            let between =
                |p: I64Vec2, (a, b): (I64Vec2, I64Vec2)| area(a, b, p) == 0 && (a - p).dot(b - p) < 0;
            seen.class("a sample on an edge", edges().any(|edge| samples().any(|p| between(p, edge))));
            seen.class("a sample on an inner vertex", points.iter().any(|p| *p % SUBPIXELS == I64Vec2::ZERO));
            let level = |(a, b): (I64Vec2, I64Vec2)| a.y == b.y && a.y % SUBPIXELS == 0;
            seen.class(
                "a horizontal edge through samples",
                edges().any(|e| level(e) && e.0.y.abs() < 19 * SUBPIXELS && e.0.y >= 0),
            );
            // Every third runs clockwise: orientation must not matter.
            let turned = triangles
                .iter()
                .zip(0..)
                .map(|(&[a, b, c], k)| flat(if k % 3 == 0 { [a, c, b] } else { [a, b, c] }));
            let counts = coverage(turned);
            ensure(counts.iter().all(|count| *count == 1), || format!("{counts:?}"))
        });
}

#[test]
fn the_strict_and_the_inclusive_test_of_the_slides_do_not_partition() {
    // E10: two triangles whose common edge runs through samples (1, 1) to (4, 4).
    let [a, b, c, d] = [(0, 0), (5, 0), (5, 5), (0, 5)].map(|(x, y)| I64Vec2::new(x, y) * SUBPIXELS);
    let p = I64Vec2::new(3, 3) * SUBPIXELS;
    let inner = |[a, b, c]: [I64Vec2; 3]| area(a, b, p).min(area(b, c, p)).min(area(c, a, p));
    let both = [[a, b, c], [a, c, d]];
    assert_eq!(both.iter().filter(|t| inner(**t) > 0).count(), 0, "strict: a hole");
    assert_eq!(both.iter().filter(|t| inner(**t) >= 0).count(), 2, "inclusive: drawn twice");
    assert_eq!(coverage(both.map(flat))[(3 * WIDTH + 3) as usize], 1);
}

#[test]
fn a_fan_of_a_thousand_slivers_covers_each_sample_once() {
    const SLIVERS: usize = 1000;
    Law::new("a fan of a thousand slivers covers each sample inside exactly once, none outside")
        .cases(64)
        .demand("its hub is a sample", 0.15)
        .demand("some samples lie outside", 0.3)
        .demand("all samples lie inside", 0.2)
        .holds_for(
            (position(0), prop_oneof![3.0_f64..15.0, 15.0..100.0], 0.0_f64..1.0),
            |(hub, radius, turn), seen| {
                let rim = |k: usize| {
                    let angle = TAU * ((k % SLIVERS) as f64 + turn) / SLIVERS as f64;
                    let arm = SUBPIXELS as f64 * radius;
                    hub + I64Vec2::new((arm * angle.cos()).round() as i64, (arm * angle.sin()).round() as i64)
                };
                let counts = coverage((0..SLIVERS).map(|k| flat([hub, rim(k), rim(k + 1)])));
                // Snapping moves the rim by less than a hundredth of a pixel, its chords cut off less than another.
                let distances: Vec<f64> =
                    samples().map(|p| (p - hub).as_dvec2().length() / SUBPIXELS as f64 - radius).collect();
                seen.class("its hub is a sample", hub % SUBPIXELS == I64Vec2::ZERO);
                seen.class("some samples lie outside", distances.iter().any(|d| *d > 0.02));
                seen.class("all samples lie inside", distances.iter().all(|d| *d < -0.02));
                let right = |(count, distance): (&u32, &f64)| match *distance {
                    d if d < -0.02 => *count == 1,
                    d if d > 0.02 => *count == 0,
                    _ => *count <= 1,
                };
                ensure(counts.iter().zip(&distances).all(right), || format!("{counts:?}"))
            },
        );
}

/// Any corners: on samples, between them, far outside, twice the same.
fn wild_corners() -> impl Strategy<Value = [I64Vec2; 3]> {
    let far = SUBPIXELS << 20;
    let huge = (-far..=far, -far..=far).prop_map(|(x, y)| I64Vec2::new(x, y));
    let corner = prop_oneof![3 => position(5), 1 => huge];
    let any = [corner.clone(), corner.clone(), corner];
    let degenerate = (position(5), position(5)).prop_map(|(a, b)| [a, b, a]);
    let sliver = (position(3), position(3), 1..4_i64).prop_map(|(a, b, d)| [a, b, b + I64Vec2::new(d, 0)]);
    prop_oneof![6 => any, 1 => degenerate, 2 => sliver]
}

fn wild_triangle() -> impl Strategy<Value = ScreenTriangle> {
    let depths = [-1.0_f32..1.0, -1.0..1.0, -1.0..1.0];
    let inv_w = [-5.0_f32..-0.01, -5.0..-0.01, -5.0..-0.01];
    (wild_corners(), depths, inv_w).prop_map(|(corners, z, inv_w)| deep(corners, z, inv_w))
}

#[test]
fn the_fast_rasterizer_gives_the_fragments_of_the_slides_one() {
    Law::new("rasterize_rows gives the fragments of rasterize, bit for bit, in bands too")
        .cases(2000)
        .demand("something is drawn", 0.4)
        .demand("nothing is drawn", 0.05)
        .demand("a vertex beyond 1000 pixels", 0.2)
        .holds_for((wild_triangle(), 0..=HEIGHT), |(triangle, cut), seen| {
            let slide = fragments(&triangle);
            let mut fast = Vec::new();
            rasterize_rows(&triangle, WIDTH, 0..cut, |fragment| fast.push(fragment));
            rasterize_rows(&triangle, WIDTH, cut..HEIGHT, |fragment| fast.push(fragment));
            seen.class("something is drawn", !slide.is_empty());
            seen.class("nothing is drawn", slide.is_empty());
            seen.class(
                "a vertex beyond 1000 pixels",
                triangle.vertices.iter().any(|v| v.position.x.abs() > 1e3),
            );
            let bits =
                |f: &Fragment| (f.i, f.j, f.z.to_bits(), f.weights.to_vec3().to_array().map(f32::to_bits));
            ensure(slide.iter().map(bits).eq(fast.iter().map(bits)), || {
                format!("slide {slide:?}\nfast {fast:?}")
            })
        });
}

#[test]
fn coverage_does_not_depend_on_the_order_of_the_vertices() {
    Law::new("all six orders of the vertices cover the same pixels")
        .demand("something is drawn", 0.4)
        .holds_for(wild_corners(), |[a, b, c], seen| {
            let covered = |corners| coverage([flat(corners)]);
            let first = covered([a, b, c]);
            seen.class("something is drawn", first.contains(&1));
            let others = [[a, c, b], [b, a, c], [b, c, a], [c, a, b], [c, b, a]];
            ensure(others.into_iter().all(|order| covered(order) == first), || format!("{first:?}"))
        });
}

#[test]
fn moving_a_triangle_by_whole_pixels_moves_its_fragments() {
    let corners = [position(-6), position(-6), position(-6)];
    Law::new("a triangle moved by whole pixels leaves the same fragments, moved")
        .demand("something is drawn", 0.5)
        .holds_for(
            (corners, [-1.0_f32..1.0, -1.0..1.0, -1.0..1.0], -6..=6_i64, -6..=6_i64),
            |(corners, z, di, dj), seen| {
                let triangle = |by: I64Vec2| deep(corners.map(|p| p + by * SUBPIXELS), z, [-0.5, -2.0, -0.1]);
                let here = fragments(&triangle(I64Vec2::ZERO));
                let there = fragments(&triangle(I64Vec2::new(di, dj)));
                seen.class("something is drawn", !here.is_empty());
                let moved = |f: &Fragment| Fragment {
                    i: (i64::from(f.i) + di) as u32,
                    j: (i64::from(f.j) + dj) as u32,
                    ..*f
                };
                ensure(here.iter().map(moved).eq(there.iter().copied()), || format!("{here:?}\n{there:?}"))
            },
        );
}
