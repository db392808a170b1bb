//! Does a sample belong to a triangle? The top-left rule (E10).

use glam::{Vec2, vec2};
use proptest::prelude::*;
use testkit::by_hand::{point2, weights};
use vocabulary::Triangle2;

use super::drawing;
use super::inputs::{doubled_area, in_order, order, place_on_side, side, triangle, triangle_without_area};
use crate::exercise::{arguments, signature};
use crate::law::{Asker, Stop};
use crate::{Concept, Example, Exercise, Law, Misconception, Title, that};

const STUB: &str = r#"//! Does a triangle cover a sample? The top-left rule (E10).
//!
//! The slides ask for β > 0, γ > 0, β + γ < 1 once (L49), and with ≥ in `raytri` (L53). With > nobody draws a sample on a
//! side that two triangles share; with ≥ both do. A rasterizer gives it to exactly one of them:
//!
//! - A sample inside belongs to the triangle, one outside does not.
//! - A sample on a side belongs to the triangle if that is a left side or a top side.
//! - A left side is any that is not level and has the triangle on its right; a top side is level and has the triangle below it.
//! - A sample in a corner belongs to the triangle if both sides that meet there are left or top sides.
//! - A triangle without area covers nothing.
//!
//! Here y runs upwards: in an anticlockwise triangle a left side runs down, and a top side runs from right to left.
//!
//! - `triangle`: its corners on the screen, in pixels; clockwise or anticlockwise.
//! - `p`: the sample.
//! - All coordinates are multiples of 1/32 and at most 16, so that sums, differences and products of them are exact and "on the
//!   side" is exactly 0. A quotient is rounded: do not divide.
//!
//! glam: `u.perp_dot(v)` is u.x · v.y − u.y · v.x: positive if v points to the left of u.

use glam::Vec2;
use vocabulary::Triangle2;

pub fn covers(triangle: Triangle2, p: Vec2) -> bool {
    todo!()
}
"#;

signature!((triangle: Triangle2, p: Vec2) -> bool);

pub(super) fn exercise() -> Exercise {
    Exercise {
        name: "covers",
        concept: Concept::Zbuffer,
        items: "L49, E10",
        title: Title {
            english: "Who owns the edge? The top-left rule",
            dutch: "Van wie is de rand? De linksbovenregel",
        },
        prerequisites: &["barycentric"],
        stub: STUB,
        signature: SIGNATURE,
        hints: [
            "For each side ask on which side of it p lies: the sign of a `perp_dot`. What sign means inside, and when does \
                it not?",
            "Make the triangle anticlockwise first: exchange b and c if the area is negative. Then p is inside when all \
                three signs are positive; a 0 means p lies on the line of that side, and the side's direction decides.",
            "For a side from `from` to `to`, with along = to − from: e = along.perp_dot(p − from). It is passed if e > 0, \
                or if e is 0 and along.y < 0 (left), or e is 0, along.y is 0 and along.x < 0 (top). All three must be \
                passed.",
        ],
        examples: examples(),
        laws: laws(),
        reference: program!(by_edge_functions),
        variants: vec![program!(by_a_nudge), program!(by_counting_crossings)],
        misconceptions: misconceptions(),
        explanation: "The rule is as if each sample were moved a hair to the right and a much finer hair down: then it lies \
            on no side at all, and in exactly one of the triangles that meet there. That is why a mesh has neither cracks \
            nor samples drawn twice. It needs exact arithmetic: hardware snaps corners to a grid and counts in whole \
            numbers.",
        draw: drawing::coverage,
        source: include_str!("covers.rs"),
    }
}

/// The lower left half of a square and its upper right half: they share the diagonal from (1, 5) to (5, 1).
const LOWER: Triangle2 = Triangle2 { a: vec2(1.0, 1.0), b: vec2(5.0, 1.0), c: vec2(1.0, 5.0) };
const UPPER: Triangle2 = Triangle2 { a: vec2(5.0, 1.0), b: vec2(5.0, 5.0), c: vec2(1.0, 5.0) };

fn examples() -> Vec<Example> {
    let example = |caption, triangle: Triangle2, x, y, covered: bool| {
        Example::new(caption, arguments![triangle, vec2(x, y)], covered, 0.0)
    };
    vec![
        example("inside", LOWER, 2.0, 2.0, true),
        example("outside", LOWER, 4.0, 4.0, false),
        example("on the left side", LOWER, 1.0, 3.0, true),
        example("on the bottom side", LOWER, 3.0, 1.0, false),
        example("on the diagonal, which is a right side of this triangle", LOWER, 3.0, 3.0, false),
        example("on the same diagonal, which is a left side of this one", UPPER, 3.0, 3.0, true),
        example("on the top side", UPPER, 3.0, 5.0, true),
    ]
}

fn laws() -> Vec<Law> {
    vec![inside_and_outside(), left_and_top(), shared_side(), fan(), order_of_corners(), without_area()]
}

fn inside_and_outside() -> Law {
    Law::of(
        "inside_and_outside",
        2,
        "A sample inside the triangle is covered, a sample outside is not, whichever way round the corners run.",
        "No side is met here, so only the signs matter: what sign has the area of a clockwise triangle?",
    )
    .over((triangle(4, 1.0), weights(1), any::<bool>()), |&(triangle, [alpha, beta, gamma], inside), program| {
        // Outside: beyond bc, where the weight of a is negative; the sum stays 1.
        let [alpha, beta] = if inside { [alpha, beta] } else { [-alpha, beta + 2.0 * alpha] };
        let p = alpha * triangle.a + beta * triangle.b + gamma * triangle.c;
        let covered: bool = program.ask(arguments![triangle, p])?;
        that(covered == inside, || {
            if inside { "a sample inside is not covered".to_owned() } else { "a sample outside is covered".to_owned() }
        })
    })
}

fn left_and_top() -> Law {
    Law::of(
        "left_and_top_sides_belong",
        2,
        "A sample on a left side or on a top side is covered, a sample on another side is not.",
        "The sample lies exactly on a side: which way does that side run when the corners run anticlockwise and y upwards? \
            If you divided, the 0 may have been lost in rounding.",
    )
    .over((side(4), point2(4), place_on_side(), order()), |&((a, b), c, place, order), program| {
        if doubled_area(a, b, c) == 0.0 {
            return Ok(());
        }
        let p = a + place * (b - a);
        let covered: bool = program.ask(arguments![in_order([a, b, c], order), p])?;
        let wanted = is_left_or_top(a, b, c);
        that(covered == wanted, || {
            let side = if wanted { "a left or top side is not covered" } else { "a right or bottom side is covered" };
            format!("a sample on {side}")
        })
    })
}

/// Whether ab is a left side or a top side of the triangle abc: c lies to its right, or below it where it is level.
fn is_left_or_top(a: Vec2, b: Vec2, c: Vec2) -> bool {
    if a.y == b.y {
        return c.y < a.y;
    }
    let (low, high) = if a.y < b.y { (a, b) } else { (b, a) };
    doubled_area(low, high, c) < 0.0
}

fn shared_side() -> Law {
    Law::of(
        "a_shared_side_is_covered_once",
        2,
        "A sample on the side that two triangles share is covered by exactly one of them.",
        "Both triangles see the same side from different sides: the answer must depend on where the triangle lies, not only \
            on the side.",
    )
    .over(
        (side(4), point2(4), point2(4), place_on_side(), order(), order()),
        |&((a, b), c, d, place, first, second), program| {
            // The fourth corner on the other side of ab, unless it lies there already.
            let (side, other) = (doubled_area(a, b, c), doubled_area(a, b, d));
            if side == 0.0 || other == 0.0 {
                return Ok(());
            }
            let d = if side * other < 0.0 { d } else { a + b - d };
            let p = a + place * (b - a);
            let triangles = [in_order([a, b, c], first), in_order([b, a, d], second)];
            covered_once(program, &triangles, p)
        },
    )
}

fn fan() -> Law {
    Law::of(
        "a_common_corner_is_covered_once",
        2,
        "Where triangles meet all around a corner, exactly one of them covers the sample in it.",
        "In a corner two sides meet, and both must be left or top sides. A corner is neither free nor forbidden.",
    )
    .over((point2(2), ring(), order()), |(middle, ring, order), program| {
        let spoke = |at: usize| *middle + ring[at % ring.len()];
        let triangles: Vec<Triangle2> =
            (0..ring.len()).map(|at| in_order([*middle, spoke(at), spoke(at + 1)], *order)).collect();
        covered_once(program, &triangles, *middle)
    })
}

/// Three to five arrows all around the origin, anticlockwise, each less than 180° from the next.
fn ring() -> impl Strategy<Value = Vec<Vec2>> + Clone {
    // Steps of 45°: a ring is where its arrows stand.
    let rings = prop_oneof![
        Just(vec![0, 3, 6]),
        Just(vec![1, 4, 6]),
        Just(vec![0, 2, 4, 6]),
        Just(vec![1, 3, 5, 7]),
        Just(vec![0, 1, 2, 4, 7]),
    ];
    (rings, 0..8_usize, 1..=4_i32, 1..=3_i32, -2..=2_i32).prop_map(|(steps, turn, width, height, shear)| {
        const ARROWS: [(f32, f32); 8] = [
            (1.0, 0.0),
            (1.0, 1.0),
            (0.0, 1.0),
            (-1.0, 1.0),
            (-1.0, 0.0),
            (-1.0, -1.0),
            (0.0, -1.0),
            (1.0, -1.0),
        ];
        let arrow = |step: usize| {
            let (x, y) = ARROWS[(step + turn) % 8];
            // Stretched and sheared, an anticlockwise ring stays one.
            vec2(width as f32 * x + 0.5 * shear as f32 * y, 0.5 * height as f32 * y)
        };
        steps.into_iter().map(arrow).collect()
    })
}

fn covered_once(program: &Asker<'_>, triangles: &[Triangle2], p: Vec2) -> Result<(), Stop> {
    let mut owners = 0;
    for triangle in triangles {
        owners += u32::from(program.ask::<bool>(arguments![*triangle, p])?);
    }
    that(owners == 1, || {
        format!("the sample is covered by {owners} of {} triangles, should be by 1", triangles.len())
    })
}

fn order_of_corners() -> Law {
    Law::of(
        "the_order_of_corners_does_not_matter",
        1,
        "The same corners in another order, clockwise or anticlockwise, cover the same samples.",
        "Only the order of the corners changed, and so did the answer. What changes its sign when two corners change places?",
    )
    .over((triangle(4, 1.0), weights(0), order()), |&(triangle, [alpha, beta, gamma], order), program| {
        // Weights of 0 are frequent: the sample often lies on a side or in a corner.
        let p = alpha * triangle.a + beta * triangle.b + gamma * triangle.c;
        let first: bool = program.ask(arguments![triangle, p])?;
        let other = in_order([triangle.a, triangle.b, triangle.c], order);
        let second: bool = program.ask(arguments![other, p])?;
        that(first == second, || format!("one order says {first}, the other {second}"))
    })
}

fn without_area() -> Law {
    Law::of(
        "without_area_nothing_is_covered",
        1,
        "A triangle without area covers nothing, not even its own corners.",
        "All corners lie on one line: which signs come out for a sample on that line?",
    )
    .over((triangle_without_area(2), place_on_side()), |&(triangle, place), program| {
        let p = triangle.a + place * (triangle.b - triangle.a);
        let covered: bool = program.ask(arguments![triangle, p])?;
        that(!covered, || "a triangle without area covers a sample".to_owned())
    })
}

fn by_edge_functions(triangle: Triangle2, p: Vec2) -> bool {
    let Triangle2 { a, b, c } = triangle;
    // Anticlockwise: the inside lies to the left of every side.
    let clockwise = (b - a).perp_dot(c - a) < 0.0;
    let (b, c) = if clockwise { (c, b) } else { (b, c) };
    [(a, b), (b, c), (c, a)].into_iter().all(|(from, to)| {
        let along = to - from;
        let edge = along.perp_dot(p - from);
        let left = along.y < 0.0;
        let top = along.y == 0.0 && along.x < 0.0;
        edge > 0.0 || (edge == 0.0 && (left || top))
    })
}

fn by_a_nudge(triangle: Triangle2, p: Vec2) -> bool {
    // A hair to the right, and a much finer one down: the sample then lies on no side. Coordinates are multiples of 1/32, so an
    // edge function that is not 0 is at least 2⁻¹⁰, more than what 24 · 2⁻¹⁶ adds to it.
    let p = p.as_dvec2() + glam::dvec2(2.0_f64.powi(-16), -(2.0_f64.powi(-32)));
    let [a, b, c] = [triangle.a, triangle.b, triangle.c].map(Vec2::as_dvec2);
    let edges = [(b - a).perp_dot(p - a), (c - b).perp_dot(p - b), (a - c).perp_dot(p - c)];
    edges.iter().all(|edge| *edge > 0.0) || edges.iter().all(|edge| *edge < 0.0)
}

fn by_counting_crossings(triangle: Triangle2, p: Vec2) -> bool {
    let Triangle2 { a, b, c } = triangle;
    let mut inside = false;
    for (from, to) in [(a, b), (b, c), (c, a)] {
        let (low, high) = if from.y < to.y { (from, to) } else { (to, from) };
        // A side takes part from above its lower end up to and with its upper end; a level one never does.
        let in_its_rows = low.y < p.y && p.y <= high.y;
        // Walking in from the left, the side is crossed before p, or at p.
        if in_its_rows && (high - low).perp_dot(p - low) <= 0.0 {
            inside = !inside;
        }
    }
    inside
}

fn misconceptions() -> Vec<Misconception> {
    vec![
        Misconception {
            program: program!(no_side),
            looks_like: "no side belongs to a triangle, as on the slide with β > 0",
            help: "A sample on a shared side then belongs to nobody: a crack. Left sides and top sides do belong.",
        },
        Misconception {
            program: program!(every_side),
            looks_like: "every side belongs to a triangle, as in raytri",
            help: "A sample on a shared side is then drawn twice. Right sides and bottom sides belong to the neighbour.",
        },
        Misconception {
            program: program!(bottom_left),
            looks_like: "left sides and bottom sides belong: y is taken to run downwards",
            help: "With y upwards, the top side of an anticlockwise triangle runs from right to left.",
        },
        Misconception {
            program: program!(left_only),
            looks_like: "left sides belong, but no level side does",
            help: "A level side has no triangle on its right: it needs a rule of its own, and the top one belongs.",
        },
        Misconception {
            program: program!(right_and_bottom),
            looks_like: "right sides and bottom sides belong instead of left and top ones",
            help: "Follow an anticlockwise triangle with y upwards: it goes down on its left and up on its right.",
        },
        Misconception {
            program: program!(only_anticlockwise),
            looks_like: "a clockwise triangle covers nothing",
            help: "All signs are negative inside a clockwise triangle: exchange two corners first.",
        },
        Misconception {
            program: program!(directions_of_a_clockwise_triangle),
            looks_like: "the signs of a clockwise triangle are turned round, but not the directions of its sides",
            help: "In a clockwise triangle a left side runs up: exchange two corners first, then signs and directions agree.",
        },
    ]
}

fn no_side(triangle: Triangle2, p: Vec2) -> bool {
    let Triangle2 { a, b, c } = triangle;
    let edges = [(b - a).perp_dot(p - a), (c - b).perp_dot(p - b), (a - c).perp_dot(p - c)];
    edges.iter().all(|edge| *edge > 0.0) || edges.iter().all(|edge| *edge < 0.0)
}

fn every_side(triangle: Triangle2, p: Vec2) -> bool {
    let Triangle2 { a, b, c } = triangle;
    let edges = [(b - a).perp_dot(p - a), (c - b).perp_dot(p - b), (a - c).perp_dot(p - c)];
    edges.iter().all(|edge| *edge >= 0.0) || edges.iter().all(|edge| *edge <= 0.0)
}

fn bottom_left(triangle: Triangle2, p: Vec2) -> bool {
    let Triangle2 { a, b, c } = triangle;
    let clockwise = (b - a).perp_dot(c - a) < 0.0;
    let (b, c) = if clockwise { (c, b) } else { (b, c) };
    [(a, b), (b, c), (c, a)].into_iter().all(|(from, to)| {
        let along = to - from;
        let edge = along.perp_dot(p - from);
        let owned = along.y < 0.0 || (along.y == 0.0 && along.x > 0.0);
        edge > 0.0 || (edge == 0.0 && owned)
    })
}

fn left_only(triangle: Triangle2, p: Vec2) -> bool {
    let Triangle2 { a, b, c } = triangle;
    let clockwise = (b - a).perp_dot(c - a) < 0.0;
    let (b, c) = if clockwise { (c, b) } else { (b, c) };
    [(a, b), (b, c), (c, a)].into_iter().all(|(from, to)| {
        let along = to - from;
        let edge = along.perp_dot(p - from);
        edge > 0.0 || (edge == 0.0 && along.y < 0.0)
    })
}

fn right_and_bottom(triangle: Triangle2, p: Vec2) -> bool {
    let Triangle2 { a, b, c } = triangle;
    let clockwise = (b - a).perp_dot(c - a) < 0.0;
    let (b, c) = if clockwise { (c, b) } else { (b, c) };
    [(a, b), (b, c), (c, a)].into_iter().all(|(from, to)| {
        let along = to - from;
        let edge = along.perp_dot(p - from);
        let owned = along.y > 0.0 || (along.y == 0.0 && along.x > 0.0);
        edge > 0.0 || (edge == 0.0 && owned)
    })
}

fn only_anticlockwise(triangle: Triangle2, p: Vec2) -> bool {
    let Triangle2 { a, b, c } = triangle;
    [(a, b), (b, c), (c, a)].into_iter().all(|(from, to)| {
        let along = to - from;
        let edge = along.perp_dot(p - from);
        let owned = along.y < 0.0 || (along.y == 0.0 && along.x < 0.0);
        edge > 0.0 || (edge == 0.0 && owned)
    })
}

fn directions_of_a_clockwise_triangle(triangle: Triangle2, p: Vec2) -> bool {
    let Triangle2 { a, b, c } = triangle;
    let sign = (b - a).perp_dot(c - a).signum();
    [(a, b), (b, c), (c, a)].into_iter().all(|(from, to)| {
        let along = to - from;
        let edge = sign * along.perp_dot(p - from);
        let owned = along.y < 0.0 || (along.y == 0.0 && along.x < 0.0);
        edge > 0.0 || (edge == 0.0 && owned)
    })
}
