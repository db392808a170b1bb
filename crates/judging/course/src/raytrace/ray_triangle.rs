//! Exercise 4.2 for any ray and triangle: where they meet, if they do (L51–L54, E10, E11).

use glam::{Vec3, vec3};
use proptest::prelude::*;
use vocabulary::{Ray, Triangle, TriangleHit};

use super::drawing;
use super::inputs::{aimed, forwards, inside, outside, parallel};
use crate::exercise::{arguments, signature};
use crate::{Concept, Example, Exercise, Law, Misconception, Title, close};

const STUB: &str = r#"//! Where a ray hits a triangle (L51 to L54).
//!
//! Solve the system of `ray_triangle_system` for β, γ and t, by Cramer's rule, the inverse or elimination:
//!
//!     β(a − b) + γ(a − c) + t d = a − e
//!
//! Give t, β and γ if t > 0 and the point is in the triangle: β ≥ 0, γ ≥ 0, β + γ ≤ 1. Otherwise `None`.
//!
//! - `ray`: origin e and direction d, of any length. `triangle`: corners a, b, c, with an area. All in one space.
//! - The triangle is hit from both sides.
//! - A ray that is parallel to the triangle's plane hits nothing, even if it runs in that plane: `None`. The determinant is 0
//!   there, or almost: at most 0.00001 with rounding. For the other rays here it is at least 0.05 in size.
//! - On the triangle's border and at t = 0 either answer is right.
//!
//! glam: `cross`, `dot`, `Mat3::from_cols`, `Mat3::determinant`, `Mat3::inverse`.

use vocabulary::{Ray, Triangle, TriangleHit};

pub fn ray_triangle(ray: Ray, triangle: Triangle) -> Option<TriangleHit> {
    todo!()
}
"#;

signature!((ray: Ray, triangle: Triangle) -> Option<TriangleHit>);

/// The edges at a are at least 1 long, the determinant is at least 0.3 · 0.3 of the product of its columns' lengths, and a − e is
/// at most 3·5.2 + 10.4 = 26 long. A determinant takes about ten roundings: an unknown is off by 10 · 2⁻²⁴ · 26 / 0.09 = 1.8e-4.
const TOLERANCE: f32 = 2e-4;

pub(super) fn exercise() -> Exercise {
    Exercise {
        name: "ray_triangle",
        concept: Concept::Raytrace,
        items: "L51, L52, L53, L54, E10, E11",
        title: Title { english: "Where a ray hits a triangle", dutch: "Snijpunt van straal en driehoek" },
        prerequisites: &["ray_triangle_system"],
        stub: STUB,
        signature: SIGNATURE,
        hints: [
            "Three unknowns in three equations. Before you divide: by what, and can that be 0?",
            "Cramer's rule: each unknown is the determinant with its column replaced by a − e, divided by the determinant of A. Then compare.",
            "If det A is about 0: None. t = det(a−b, a−c, a−e)/det A, β = det(a−e, a−c, d)/det A, γ = det(a−b, a−e, d)/det A. Then all of t > 0, β ≥ 0, γ ≥ 0, β + γ ≤ 1.",
        ],
        examples: examples(),
        laws: laws(),
        reference: program!(slide),
        variants: vec![program!(by_the_inverse), program!(by_elimination), program!(by_areas)],
        misconceptions: misconceptions(),
        explanation: "The slide's raytri asks `is it outside?` and has no test for a parallel ray: 0/0 is NaN, NaN is not outside, so a ray \
            in the plane `hits`. Ask `is it inside?` and look at the determinant first. The border is another matter: with ≥ two triangles \
            that share an edge are both hit there, with > neither.",
        draw: drawing::triangle_from_outside,
        source: include_str!("ray_triangle.rs"),
    }
}

fn examples() -> Vec<Example> {
    let units = Triangle { a: Vec3::X, b: Vec3::Y, c: Vec3::Z };
    let level = Triangle { a: vec3(0.0, 0.0, 1.0), b: vec3(4.0, 0.0, 1.0), c: vec3(0.0, 8.0, 1.0) };
    let third = 1.0 / 3.0;
    vec![
        Example::new(
            "the lecture's exercise 4.2",
            arguments![Ray { origin: Vec3::ONE, direction: Vec3::NEG_ONE }, units],
            Some(TriangleHit { t: 2.0 * third, beta: third, gamma: third }),
            TOLERANCE,
        ),
        Example::new(
            "straight down onto a level triangle",
            arguments![Ray { origin: vec3(1.0, 2.0, 7.0), direction: vec3(0.0, 0.0, -2.0) }, level],
            Some(TriangleHit { t: 3.0, beta: 0.25, gamma: 0.25 }),
            TOLERANCE,
        ),
        Example::new(
            "the same ray turned round",
            arguments![Ray { origin: vec3(1.0, 2.0, 7.0), direction: vec3(0.0, 0.0, 2.0) }, level],
            None::<TriangleHit>,
            TOLERANCE,
        ),
        Example::new(
            "a small triangle and a short direction: the determinant is 0.125, which is not 0",
            arguments![
                Ray { origin: vec3(1.125, 0.25, 3.0), direction: vec3(0.0, 0.0, -0.5) },
                Triangle { a: vec3(1.0, 0.0, 2.0), b: vec3(1.5, 0.0, 2.0), c: vec3(1.0, 0.5, 2.0) }
            ],
            Some(TriangleHit { t: 2.0, beta: 0.25, gamma: 0.5 }),
            TOLERANCE,
        ),
    ]
}

/// A ray as parallel as rounded numbers can be: its determinant need not be exactly 0. In f64 it is at most half of the task's 0.00001;
/// a program's own ten roundings, with edges whose lengths have a product of at most 8, are off by 10 · 2⁻²⁴ · 8 = 4.8e-6 and not more.
fn rounded_parallel() -> impl Strategy<Value = (Ray, Triangle)> + Clone {
    let rounded = parallel().prop_map(|(ray, triangle)| {
        let direction = ray.direction.normalize();
        // So that a ray in the plane does not begin exactly in it either.
        (Ray { origin: ray.origin - 0.7 * direction, direction }, triangle)
    });
    rounded.prop_filter("too far from parallel", |(ray, triangle)| {
        let [a, b, c] = [triangle.a, triangle.b, triangle.c].map(|corner| corner.as_dvec3());
        let determinant = (a - b).cross(a - c).dot(ray.direction.as_dvec3());
        (a - b).length() * (a - c).length() <= 8.0 && determinant.abs() <= 5e-6
    })
}

fn laws() -> Vec<Law> {
    vec![
        Law::of(
            "a_known_point_is_hit",
            3,
            "A ray aimed at the point with weights β and γ hits it there, at the t at which it was to arrive.",
            "The ray passes the inside of the triangle, in front of its origin. Put your β, γ and t into both sides of the equation.",
        )
        .over(aimed(inside(), forwards()), |&(ray, triangle, [_, beta, gamma], t), program| {
            let hit: Option<TriangleHit> = program.ask(arguments![ray, triangle])?;
            close("the hit", hit, Some(TriangleHit { t, beta, gamma }), TOLERANCE)
        }),
        Law::of(
            "outside_is_missed",
            2,
            "A ray that meets the plane outside the triangle hits nothing.",
            "One of the three weights is negative here. Which of β, γ and α = 1 − β − γ did you look at?",
        )
        .over(aimed(outside(), forwards()), |&(ray, triangle, _, _), program| {
            let hit: Option<TriangleHit> = program.ask(arguments![ray, triangle])?;
            close("the hit", hit, None, TOLERANCE)
        }),
        Law::of(
            "behind_is_missed",
            1,
            "A triangle behind the ray's origin is not hit: t < 0.",
            "A ray goes one way only. What does t say about a triangle behind the origin?",
        )
        .over(aimed(inside(), forwards().prop_map(|t| -t)), |&(ray, triangle, _, _), program| {
            let hit: Option<TriangleHit> = program.ask(arguments![ray, triangle])?;
            close("the hit", hit, None, TOLERANCE)
        }),
        Law::of(
            "a_parallel_ray_misses",
            2,
            "A ray parallel to the triangle's plane hits nothing, beside the plane or in it.",
            "The determinant is 0 here. What does a division by it give, and how do comparisons with that come out?",
        )
        .over(prop_oneof![parallel(), rounded_parallel()], |&(ray, triangle), program| {
            let hit: Option<TriangleHit> = program.ask(arguments![ray, triangle])?;
            close("the hit", hit, None, TOLERANCE)
        }),
        Law::of(
            "both_sides_are_hit",
            1,
            "With b and c exchanged the ray meets the same point, and β and γ are exchanged.",
            "With b and c exchanged the triangle shows its other side. Does the determinant's sign decide anything?",
        )
        .over(aimed(inside(), forwards()), |&(ray, triangle, _, _), program| {
            let hit: Option<TriangleHit> = program.ask(arguments![ray, triangle])?;
            let turned = Triangle { b: triangle.c, c: triangle.b, ..triangle };
            let back: Option<TriangleHit> = program.ask(arguments![ray, turned])?;
            let wanted = hit.map(|hit| TriangleHit { beta: hit.gamma, gamma: hit.beta, ..hit });
            close("the hit with b and c exchanged", back, wanted, TOLERANCE)
        }),
    ]
}

fn slide(ray: Ray, triangle: Triangle) -> Option<TriangleHit> {
    let (to_b, to_c, to_e) = (triangle.a - triangle.b, triangle.a - triangle.c, triangle.a - ray.origin);
    let d = ray.direction;
    let determinant = to_b.dot(to_c.cross(d));
    // The slide forgets the parallel ray (E11). Rounding leaves no more than this of a 0 here.
    if determinant.abs() < 1e-4 {
        return None;
    }
    let t = to_b.dot(to_c.cross(to_e)) / determinant;
    if t <= 0.0 {
        return None;
    }
    let gamma = to_b.dot(to_e.cross(d)) / determinant;
    if !(0.0..=1.0).contains(&gamma) {
        return None;
    }
    let beta = to_e.dot(to_c.cross(d)) / determinant;
    if !(0.0..=1.0 - gamma).contains(&beta) {
        return None;
    }
    Some(TriangleHit { t, beta, gamma })
}

fn by_the_inverse(ray: Ray, triangle: Triangle) -> Option<TriangleHit> {
    let matrix = glam::Mat3::from_cols(triangle.b - triangle.a, triangle.c - triangle.a, -ray.direction);
    if matrix.determinant().abs() < 1e-3 {
        return None;
    }
    let x = matrix.inverse() * (ray.origin - triangle.a);
    let is_hit = x.z > 0.0 && x.x > 0.0 && x.y > 0.0 && x.x + x.y < 1.0;
    is_hit.then_some(TriangleHit { t: x.z, beta: x.x, gamma: x.y })
}

fn by_elimination(ray: Ray, triangle: Triangle) -> Option<TriangleHit> {
    let (to_b, to_c, to_e) = (triangle.a - triangle.b, triangle.a - triangle.c, triangle.a - ray.origin);
    let mut rows: [[f32; 4]; 3] = std::array::from_fn(|k| [to_b[k], to_c[k], ray.direction[k], to_e[k]]);
    for column in 0..3 {
        let pivot = (column..3).max_by(|&k, &l| rows[k][column].abs().total_cmp(&rows[l][column].abs()))?;
        rows.swap(column, pivot);
        let above = rows[column];
        if above[column].abs() < 1e-4 {
            return None;
        }
        // Gauss and Jordan: the column is cleared below and above the pivot.
        for (k, row) in rows.iter_mut().enumerate() {
            let factor = row[column] / above[column];
            if k != column {
                (0..4).for_each(|l| row[l] -= factor * above[l]);
            }
        }
    }
    let [beta, gamma, t] = std::array::from_fn(|k| rows[k][3] / rows[k][k]);
    let inside = beta >= 0.0 && gamma >= 0.0 && 1.0 - beta - gamma >= 0.0;
    (inside && t > 0.0).then_some(TriangleHit { t, beta, gamma })
}

fn by_areas(ray: Ray, triangle: Triangle) -> Option<TriangleHit> {
    let Triangle { a, b, c } = triangle;
    // First the plane, then the share of the area that lies opposite a corner.
    let normal = (b - a).cross(c - a);
    let fall = normal.dot(ray.direction);
    if fall.abs() < 1e-4 {
        return None;
    }
    let t = normal.dot(a - ray.origin) / fall;
    let p = ray.origin + t * ray.direction;
    let share =
        |from: glam::Vec3, to: glam::Vec3| (to - from).cross(p - from).dot(normal) / normal.length_squared();
    let (alpha, beta, gamma) = (share(b, c), share(c, a), share(a, b));
    (t > 0.0 && alpha.min(beta).min(gamma) >= 0.0).then_some(TriangleHit { t, beta, gamma })
}

fn misconceptions() -> Vec<Misconception> {
    vec![
        Misconception {
            program: program!(parallel_forgotten),
            looks_like: "a ray in the triangle's plane hits it, with t, β and γ not a number",
            help: "0/0 is NaN, and NaN is neither below 0 nor above 1: no early exit is taken. Leave before dividing if the determinant is 0.",
        },
        Misconception {
            program: program!(the_whole_parallelogram),
            looks_like: "β and γ may each be up to 1, which is a parallelogram",
            help: "The third weight is α = 1 − β − γ, and it too must not be negative: β + γ ≤ 1.",
        },
        Misconception {
            program: program!(the_whole_plane),
            looks_like: "every point of the plane counts as hit",
            help: "β, γ and t say where the ray meets the plane. Whether that is inside the triangle must still be asked.",
        },
        Misconception {
            program: program!(both_ways),
            looks_like: "triangles behind the origin are hit",
            help: "t < 0 is behind the ray's origin: such a point is not on the ray.",
        },
        Misconception {
            program: program!(only_the_front),
            looks_like: "the triangle is hit from one side only",
            help: "The determinant's sign says which side the ray comes from. Both count here: only 0 is special.",
        },
        Misconception {
            program: program!(beta_and_gamma_exchanged),
            looks_like: "β and γ are exchanged",
            help: "β is b's weight: in its determinant it is the column of b, the first one, that a − e replaces.",
        },
        Misconception {
            program: program!(distance_for_t),
            looks_like: "t is the distance in units of length",
            help: "p = e + t d: t counts steps of d, which need not have length 1. Do not normalize it.",
        },
    ]
}

fn parallel_forgotten(ray: Ray, triangle: Triangle) -> Option<TriangleHit> {
    let (to_b, to_c, to_e) = (triangle.a - triangle.b, triangle.a - triangle.c, triangle.a - ray.origin);
    let d = ray.direction;
    let determinant = to_b.dot(to_c.cross(d));
    let t = to_b.dot(to_c.cross(to_e)) / determinant;
    if t < 0.0 {
        return None;
    }
    let gamma = to_b.dot(to_e.cross(d)) / determinant;
    // Asked for outside, as on the slide: NaN is neither below nor above.
    let (below, above) = (gamma < 0.0, gamma > 1.0);
    if below || above {
        return None;
    }
    let beta = to_e.dot(to_c.cross(d)) / determinant;
    if beta < 0.0 || beta > 1.0 - gamma {
        return None;
    }
    Some(TriangleHit { t, beta, gamma })
}

fn the_whole_parallelogram(ray: Ray, triangle: Triangle) -> Option<TriangleHit> {
    let (to_b, to_c, to_e) = (triangle.a - triangle.b, triangle.a - triangle.c, triangle.a - ray.origin);
    let determinant = to_b.dot(to_c.cross(ray.direction));
    if determinant.abs() < 1e-4 {
        return None;
    }
    let t = to_b.dot(to_c.cross(to_e)) / determinant;
    let gamma = to_b.dot(to_e.cross(ray.direction)) / determinant;
    let beta = to_e.dot(to_c.cross(ray.direction)) / determinant;
    let inside = (0.0..=1.0).contains(&beta) && (0.0..=1.0).contains(&gamma);
    (t > 0.0 && inside).then_some(TriangleHit { t, beta, gamma })
}

fn the_whole_plane(ray: Ray, triangle: Triangle) -> Option<TriangleHit> {
    let matrix = glam::Mat3::from_cols(triangle.a - triangle.b, triangle.a - triangle.c, ray.direction);
    if matrix.determinant().abs() < 1e-4 {
        return None;
    }
    let x = matrix.inverse() * (triangle.a - ray.origin);
    (x.z > 0.0).then_some(TriangleHit { t: x.z, beta: x.x, gamma: x.y })
}

fn both_ways(ray: Ray, triangle: Triangle) -> Option<TriangleHit> {
    let matrix = glam::Mat3::from_cols(triangle.a - triangle.b, triangle.a - triangle.c, ray.direction);
    if matrix.determinant().abs() < 1e-4 {
        return None;
    }
    let x = matrix.inverse() * (triangle.a - ray.origin);
    let inside = x.x >= 0.0 && x.y >= 0.0 && x.x + x.y <= 1.0;
    inside.then_some(TriangleHit { t: x.z, beta: x.x, gamma: x.y })
}

fn only_the_front(ray: Ray, triangle: Triangle) -> Option<TriangleHit> {
    let matrix = glam::Mat3::from_cols(triangle.a - triangle.b, triangle.a - triangle.c, ray.direction);
    if matrix.determinant() < 1e-4 {
        return None;
    }
    let x = matrix.inverse() * (triangle.a - ray.origin);
    let inside = x.x >= 0.0 && x.y >= 0.0 && x.x + x.y <= 1.0;
    (x.z > 0.0 && inside).then_some(TriangleHit { t: x.z, beta: x.x, gamma: x.y })
}

fn beta_and_gamma_exchanged(ray: Ray, triangle: Triangle) -> Option<TriangleHit> {
    let matrix = glam::Mat3::from_cols(triangle.a - triangle.c, triangle.a - triangle.b, ray.direction);
    if matrix.determinant().abs() < 1e-4 {
        return None;
    }
    let x = matrix.inverse() * (triangle.a - ray.origin);
    let inside = x.x >= 0.0 && x.y >= 0.0 && x.x + x.y <= 1.0;
    (x.z > 0.0 && inside).then_some(TriangleHit { t: x.z, beta: x.x, gamma: x.y })
}

fn distance_for_t(ray: Ray, triangle: Triangle) -> Option<TriangleHit> {
    let d = ray.direction.normalize();
    let matrix = glam::Mat3::from_cols(triangle.a - triangle.b, triangle.a - triangle.c, d);
    if matrix.determinant().abs() < 1e-4 {
        return None;
    }
    let x = matrix.inverse() * (triangle.a - ray.origin);
    let inside = x.x >= 0.0 && x.y >= 0.0 && x.x + x.y <= 1.0;
    (x.z > 0.0 && inside).then_some(TriangleHit { t: x.z, beta: x.x, gamma: x.y })
}
