//! How deep is a triangle at a point of the screen? z is affine there (L18, E9).

use glam::{Vec2, Vec3, vec2, vec3};
use proptest::prelude::*;
use testkit::by_hand::{coordinate, point2, share};
use vocabulary::Triangle;

use super::drawing;
use super::inputs::{in_order, order, triangle};
use crate::exercise::{arguments, signature};
use crate::{Concept, Example, Exercise, Law, Misconception, Title, close};

const STUB: &str = r#"//! The depth of a triangle at a point of the screen (L18, E9).
//!
//! Depths are computed for the corners and interpolated for everything between them:
//!
//!     z = α z_a + β z_b + γ z_c
//!
//! where α, β, γ are the barycentric coordinates of p in the triangle on the screen (L48).
//!
//! - `triangle`: its corners after projection. x and y are in pixels, y upwards; z is the depth, from −1 (farthest) to 1
//!   (nearest). On the screen it has an area; clockwise or anticlockwise.
//! - `p`: a point of the screen, in pixels; inside the triangle or not. Outside, the triangle's plane goes on.
//!
//! glam: `corner.truncate()` leaves z out; `u.perp_dot(v)` is u.x · v.y − u.y · v.x.

use glam::Vec2;
use vocabulary::Triangle;

pub fn depth_at(triangle: Triangle, p: Vec2) -> f32 {
    todo!()
}
"#;

signature!((triangle: Triangle, p: Vec2) -> f32);

/// Coordinates are at most 4, twice the area is at least 4, depths are at most 1: a weight is at most 2·8·8 / 4 = 32, a depth at
/// most 96. It is a sum of products, or a quotient of such, with some 8 roundings of 2⁻²⁴ · 96: 5e-5; a law that mixes two
/// of them gets twice that. The slide's solution is off by less than 2e-5 against f64.
const TOLERANCE: f32 = 1e-4;

/// The least doubled area of a triangle on the screen: see [`TOLERANCE`].
const LEAST_DOUBLED_AREA: f32 = 4.0;

pub(super) fn exercise() -> Exercise {
    Exercise {
        name: "depth_at",
        concept: Concept::Zbuffer,
        items: "L18, E9",
        title: Title { english: "Depth between the corners", dutch: "Diepte tussen de hoekpunten" },
        prerequisites: &["barycentric"],
        stub: STUB,
        signature: SIGNATURE,
        hints: [
            "You can already say how much each corner weighs at p. What do you do with the corners' depths?",
            "Leave z out and compute the barycentric coordinates of p on the screen. Then the same weights mix the three depths.",
            "d = (b − a) × (c − a), β = (p − a) × (c − a) / d, γ = (b − a) × (p − a) / d on the screen; z = z_a + β (z_b − \
                z_a) + γ (z_c − z_a).",
        ],
        examples: examples(),
        laws: laws(),
        reference: program!(weighted_sum),
        variants: vec![program!(from_the_plane), program!(by_steps_of_a_pixel)],
        misconceptions: misconceptions(),
        explanation: "After the projection a plane is still a plane, so on the screen its depth is affine: one step to the \
            right always adds the same. Hardware adds that step from pixel to pixel. The camera's own depth is not affine \
            on the screen, and neither are texture coordinates: for those 1/w is interpolated first (E9).",
        draw: drawing::depths,
        source: include_str!("depth_at.rs"),
    }
}

fn examples() -> Vec<Example> {
    let triangle = Triangle { a: vec3(1.0, 1.0, 0.0), b: vec3(5.0, 1.0, 1.0), c: vec3(1.0, 3.0, 0.5) };
    vec![
        Example::new(
            "¼ of a, ¼ of b, ½ of c: ¼ · 0 + ¼ · 1 + ½ · ½",
            arguments![triangle, vec2(2.0, 2.0)],
            0.5_f32,
            TOLERANCE,
        ),
        Example::new(
            "in the middle of the side ab",
            arguments![triangle, vec2(3.0, 1.0)],
            0.5_f32,
            TOLERANCE,
        ),
        Example::new("in the corner c", arguments![triangle, vec2(1.0, 3.0)], 0.5_f32, TOLERANCE),
        Example::new(
            "outside, one pixel beyond b",
            arguments![triangle, vec2(6.0, 1.0)],
            1.25_f32,
            TOLERANCE,
        ),
    ]
}

/// A triangle of the screen with depths that are multiples of ⅛ in [−1, 1].
fn deep_triangle() -> impl Strategy<Value = Triangle> + Clone {
    let depth = || (-8..=8).prop_map(|eighths| eighths as f32 / 8.0);
    (triangle(4, LEAST_DOUBLED_AREA), depth(), depth(), depth()).prop_map(|(t, a, b, c)| Triangle {
        a: t.a.extend(a),
        b: t.b.extend(b),
        c: t.c.extend(c),
    })
}

/// The triangle with each depth z replaced.
fn with_depths(t: &Triangle, depth: impl Fn(f32) -> f32) -> Triangle {
    let replaced = |corner: Vec3| corner.truncate().extend(depth(corner.z));
    Triangle { a: replaced(t.a), b: replaced(t.b), c: replaced(t.c) }
}

fn laws() -> Vec<Law> {
    vec![
        Law::of(
            "corners_keep_their_depth",
            2,
            "In each corner the depth is that corner's.",
            "In a corner its own weight is 1 and the others are 0: nothing of the other depths is left.",
        )
        .over((deep_triangle(), 0..3_usize), |&(triangle, at), program| {
            let corner = [triangle.a, triangle.b, triangle.c][at];
            let z: f32 = program.ask(arguments![triangle, corner.truncate()])?;
            close("the depth in a corner", z, corner.z, TOLERANCE)
        }),
        Law::of(
            "depth_is_affine",
            3,
            "From p to q the depth changes evenly: a share s of the way is a share s of the change.",
            "The depth does not change evenly along a line of the screen: after projection it must. Is anything but a sum \
                of weights times depths in your formula, and do the weights keep their sign outside?",
        )
        .over((deep_triangle(), point2(4), point2(4), share()), |&(triangle, p, q, share), program| {
            let z_p: f32 = program.ask(arguments![triangle, p])?;
            let z_q: f32 = program.ask(arguments![triangle, q])?;
            let between: f32 = program.ask(arguments![triangle, p + share * (q - p)])?;
            close("the depth between p and q", between, z_p + share * (z_q - z_p), TOLERANCE)
        }),
        Law::of(
            "a_level_triangle_is_level",
            1,
            "If all corners have the same depth, every point has it.",
            "Three equal depths came out as another one: do the weights sum to 1?",
        )
        .over((deep_triangle(), point2(4)), |&(triangle, p), program| {
            let level = with_depths(&triangle, |_| triangle.a.z);
            let z: f32 = program.ask(arguments![level, p])?;
            close("the depth of a level triangle", z, triangle.a.z, TOLERANCE)
        }),
        Law::of(
            "depths_may_be_counted_anew",
            2,
            "Depths that are all scaled and shifted alike give depths scaled and shifted in the same way.",
            "z and k·z + m are two ways to count the same depth, so p must lie equally deep by both. What in your formula \
                depends on where the 0 of z lies?",
        )
        .over((deep_triangle(), point2(4), share(), coordinate(1)), |&(triangle, p, scale, shift), program| {
            let scale = 0.5 * scale;
            let shift = 0.5 * shift;
            let first: f32 = program.ask(arguments![triangle, p])?;
            let anew = with_depths(&triangle, |z| scale * z + shift);
            let second: f32 = program.ask(arguments![anew, p])?;
            close("the depth counted anew", second, scale * first + shift, TOLERANCE)
        }),
        Law::of(
            "the_order_of_corners_does_not_matter",
            1,
            "The same corners in another order, clockwise or anticlockwise, give the same depth.",
            "Only the order of the corners changed. Does each weight meet the depth of its own corner, and which sign has \
                the area?",
        )
        .over((deep_triangle(), point2(4), order()), |&(triangle, p, order), program| {
            let corners = [triangle.a, triangle.b, triangle.c];
            let first: f32 = program.ask(arguments![triangle, p])?;
            // The number of a corner travels as a coordinate.
            let places = in_order([0.0, 1.0, 2.0].map(Vec2::splat), order);
            let corner = |place: Vec2| corners[place.x as usize];
            let other = Triangle { a: corner(places.a), b: corner(places.b), c: corner(places.c) };
            let second: f32 = program.ask(arguments![other, p])?;
            close("the depth with reordered corners", second, first, TOLERANCE)
        }),
    ]
}

fn weighted_sum(triangle: Triangle, p: Vec2) -> f32 {
    let [a, b, c] = [triangle.a, triangle.b, triangle.c].map(|corner| corner.truncate());
    let determinant = (b - a).perp_dot(c - a);
    let beta = (p - a).perp_dot(c - a) / determinant;
    let gamma = (b - a).perp_dot(p - a) / determinant;
    let alpha = 1.0 - beta - gamma;
    alpha * triangle.a.z + beta * triangle.b.z + gamma * triangle.c.z
}

fn from_the_plane(triangle: Triangle, p: Vec2) -> f32 {
    // All points of the plane satisfy n · (point − a) = 0.
    let n = (triangle.b - triangle.a).cross(triangle.c - triangle.a);
    let along = p - triangle.a.truncate();
    triangle.a.z - n.truncate().dot(along) / n.z
}

fn by_steps_of_a_pixel(triangle: Triangle, p: Vec2) -> f32 {
    // What the depth gains by one pixel to the right and by one pixel up: two equations, one for each side.
    let [u, v] = [triangle.b - triangle.a, triangle.c - triangle.a];
    let sides = glam::mat2(glam::vec2(u.x, v.x), glam::vec2(u.y, v.y));
    let gain = sides.inverse() * glam::vec2(u.z, v.z);
    let steps = p - triangle.a.truncate();
    triangle.a.z + steps.x * gain.x + steps.y * gain.y
}

fn misconceptions() -> Vec<Misconception> {
    vec![
        Misconception {
            program: program!(mean_of_the_corners),
            looks_like: "the whole triangle has the mean depth of its corners",
            help: "One depth for a polygon is what the painter's algorithm uses; the z-buffer wants one for each pixel.",
        },
        Misconception {
            program: program!(through_the_inverse),
            looks_like: "1/z is interpolated",
            help: "1/w is what one interpolates for the camera's depth and for texture coordinates. z after the projection \
                is affine on the screen already.",
        },
        Misconception {
            program: program!(depths_of_the_wrong_corners),
            looks_like: "each weight meets the depth of another corner",
            help: "The area of abp through that of abc is the weight of c, not of a: it is 1 when p is in c.",
        },
        Misconception {
            program: program!(unsigned_weights),
            looks_like: "weights have lost their sign",
            help: "Outside the triangle a weight is negative; only so do they sum to 1.",
        },
        Misconception {
            program: program!(not_divided),
            looks_like: "areas serve as weights without being divided by the area of the triangle",
            help: "A weight is a share: the small area through the whole area. Weights sum to 1.",
        },
        Misconception {
            program: program!(weights_by_distance),
            looks_like: "corners weigh by how near they are",
            help: "Nearness is another way to mix, but not an affine one: the surface would be bent. Use areas.",
        },
    ]
}

fn mean_of_the_corners(triangle: Triangle, _p: Vec2) -> f32 {
    (triangle.a.z + triangle.b.z + triangle.c.z) / 3.0
}

fn through_the_inverse(triangle: Triangle, p: Vec2) -> f32 {
    let [a, b, c] = [triangle.a, triangle.b, triangle.c].map(|corner| corner.truncate());
    let determinant = (b - a).perp_dot(c - a);
    let beta = (p - a).perp_dot(c - a) / determinant;
    let gamma = (b - a).perp_dot(p - a) / determinant;
    let alpha = 1.0 - beta - gamma;
    1.0 / (alpha / triangle.a.z + beta / triangle.b.z + gamma / triangle.c.z)
}

fn depths_of_the_wrong_corners(triangle: Triangle, p: Vec2) -> f32 {
    let doubled_area = |a: Vec2, b: Vec2, c: Vec2| (b - a).perp_dot(c - a);
    let [a, b, c] = [triangle.a, triangle.b, triangle.c].map(|corner| corner.truncate());
    let whole = doubled_area(a, b, c);
    let alpha = doubled_area(a, b, p) / whole;
    let beta = doubled_area(b, c, p) / whole;
    let gamma = doubled_area(c, a, p) / whole;
    alpha * triangle.a.z + beta * triangle.b.z + gamma * triangle.c.z
}

fn unsigned_weights(triangle: Triangle, p: Vec2) -> f32 {
    let doubled_area = |a: Vec2, b: Vec2, c: Vec2| (b - a).perp_dot(c - a).abs();
    let [a, b, c] = [triangle.a, triangle.b, triangle.c].map(|corner| corner.truncate());
    let whole = doubled_area(a, b, c);
    let alpha = doubled_area(p, b, c) / whole;
    let beta = doubled_area(a, p, c) / whole;
    let gamma = doubled_area(a, b, p) / whole;
    alpha * triangle.a.z + beta * triangle.b.z + gamma * triangle.c.z
}

fn not_divided(triangle: Triangle, p: Vec2) -> f32 {
    let doubled_area = |a: Vec2, b: Vec2, c: Vec2| (b - a).perp_dot(c - a);
    let [a, b, c] = [triangle.a, triangle.b, triangle.c].map(|corner| corner.truncate());
    doubled_area(p, b, c) * triangle.a.z
        + doubled_area(a, p, c) * triangle.b.z
        + doubled_area(a, b, p) * triangle.c.z
}

fn weights_by_distance(triangle: Triangle, p: Vec2) -> f32 {
    let corners = [triangle.a, triangle.b, triangle.c];
    // In a corner 1/0 would be infinite.
    let weights = corners.map(|corner| 1.0 / corner.truncate().distance(p).max(1e-6));
    let sum: f32 = weights.iter().sum();
    corners.iter().zip(weights).map(|(corner, weight)| corner.z * weight / sum).sum()
}
