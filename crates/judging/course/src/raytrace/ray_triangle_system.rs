//! Three equations, one a coordinate, in β, γ and t (L50).

use glam::{DMat3, DVec3, Mat3, Vec3, mat3, vec3};
use testkit::by_hand::coordinate;
use vocabulary::{Ray, Triangle};

use super::drawing;
use super::inputs::{aimed, inside, outside, parallel};
use crate::exercise::{arguments, signature};
use crate::{Concept, Example, Exercise, Law, Misconception, Stop, Title, close, that};

const STUB: &str = r#"//! The system that says where a ray meets a triangle's plane (L50).
//!
//! Where the ray meets the plane, both sides name the same point:
//!
//!     e + t d = a + β(b − a) + γ(c − a)
//!
//! Bring what is unknown to one side and give the system A·(β, γ, t) = b as the pair (A, b):
//!
//! - `ray`: origin e and direction d, of any length. `triangle`: corners a, b, c. All in one space.
//! - The unknowns stand in the order β, γ, t.
//! - Do not solve it. Rows in another order, or with another sign on both sides, are right as well: its solution counts.
//! - No input is degenerate; a ray parallel to the plane has its system too, which has no (or not one) solution.
//!
//! glam: `Mat3::from_cols(first, second, third)` takes columns, not rows.

use glam::{Mat3, Vec3};
use vocabulary::{Ray, Triangle};

pub fn ray_triangle_system(ray: Ray, triangle: Triangle) -> (Mat3, Vec3) {
    todo!()
}
"#;

signature!((ray: Ray, triangle: Triangle) -> (Mat3, Vec3));

/// Corners are at most 3, weights at most 2, so entries are at most 24 in size and t at most 3. An entry is one difference, off
/// by at most 24·2⁻²⁴ = 1.4e-6 where it is rounded at all. Solving multiplies that by no more than 1/(0.3 · 0.3) = 11 for the
/// angles between the columns, by the three columns, and by the unknowns, at most 3: 1.4e-6 · 11 · 3 · 3 = 1.4e-4.
const TOLERANCE: f32 = 2e-4;

/// Below this share of the product of its columns' lengths a determinant is that of a matrix without inverse. Those of the other
/// laws are at least 0.3 · 0.3; those of parallel rays are 0, but for a dozen roundings.
const SINGULAR: f64 = 1e-5;

pub(super) fn exercise() -> Exercise {
    Exercise {
        name: "ray_triangle_system",
        concept: Concept::Raytrace,
        items: "L50, L54",
        title: Title {
            english: "The system for ray and triangle",
            dutch: "De matrixvergelijking voor straal en driehoek",
        },
        prerequisites: &["viewing_ray"],
        stub: STUB,
        signature: SIGNATURE,
        hints: [
            "Write the equation for x alone: one row of A is what stands before β, before γ and before t.",
            "Everything with β, γ or t goes to the left, everything else to the right; what changes sides changes its sign.",
            "On the left stand β(a − b) + γ(a − c) + t d, on the right a − e. The three vectors on the left are A's columns.",
        ],
        examples: examples(),
        laws: laws(),
        reference: program!(slide),
        variants: vec![program!(ray_on_the_other_side), program!(row_by_row), program!(edges_from_c)],
        misconceptions: misconceptions(),
        explanation: "A matrix times a column of unknowns mixes the matrix's columns: β of the first, γ of the second, t of the third. So each \
            vector that belongs to an unknown is a column. If A has no inverse, its three columns lie in one plane: the ray runs along the \
            triangle's plane. The lecture's exercise 4.2 has each row times −1: the same solution.",
        draw: drawing::solved_system,
        source: include_str!("ray_triangle_system.rs"),
    }
}

fn examples() -> Vec<Example> {
    let lecture = Ray { origin: Vec3::ONE, direction: Vec3::NEG_ONE };
    let units = Triangle { a: Vec3::X, b: Vec3::Y, c: Vec3::Z };
    let matrix = mat3(vec3(1.0, -1.0, 0.0), vec3(1.0, 0.0, -1.0), vec3(-1.0, -1.0, -1.0));
    let ray = Ray { origin: vec3(1.0, 2.0, 7.0), direction: vec3(0.0, 0.0, -2.0) };
    let triangle = Triangle { a: vec3(0.0, 0.0, 1.0), b: vec3(4.0, 0.0, 1.0), c: vec3(0.0, 8.0, 1.0) };
    let second = mat3(vec3(-4.0, 0.0, 0.0), vec3(0.0, -8.0, 0.0), vec3(0.0, 0.0, -2.0));
    let third = 1.0 / 3.0;
    vec![
        Example::with_check(
            "the lecture's exercise 4.2: β = γ = 1/3, t = 2/3",
            arguments![lecture, units],
            (matrix, vec3(0.0, -1.0, -1.0)),
            move |given| solved_by(given, vec3(third, third, 2.0 * third)),
        ),
        Example::with_check(
            "straight down onto a level triangle: β = γ = 1/4, t = 3",
            arguments![ray, triangle],
            (second, vec3(-1.0, -2.0, -6.0)),
            |given| solved_by(given, vec3(0.25, 0.25, 3.0)),
        ),
    ]
}

/// Whether this, and nothing else, solves the system.
fn solved_by(given: &crate::Value, solution: Vec3) -> Result<(), Stop> {
    use crate::Plain;
    let system = <(Mat3, Vec3)>::from_value(given.clone());
    that(system.is_some(), || format!("{given} is not a matrix and a vector"))?;
    system.map_or(Ok(()), |system| close("the solution (β, γ, t)", solve(system)?, solution, TOLERANCE))
}

/// The system's one solution, in f64.
fn solve((matrix, right): (Mat3, Vec3)) -> Result<Vec3, Stop> {
    that(!is_singular(matrix), || {
        "A has no inverse, though the ray is not parallel to the plane".to_owned()
    })?;
    Ok((matrix.as_dmat3().inverse() * right.as_dvec3()).as_vec3())
}

/// Whether the columns lie in one plane.
fn is_singular(matrix: Mat3) -> bool {
    let DMat3 { x_axis, y_axis, z_axis } = matrix.as_dmat3();
    let volume: f64 = [x_axis, y_axis, z_axis].map(DVec3::length).iter().product();
    matrix.as_dmat3().determinant().abs() <= SINGULAR * volume
}

fn laws() -> Vec<Law> {
    vec![
        Law::of(
            "a_known_hit_solves_it",
            3,
            "For a ray aimed at the point with weights β and γ, to be there at t: (β, γ, t) solves the system.",
            "Put in known numbers: does every row give the same left and right? Look at signs, and at rows and columns.",
        )
        .over(aimed(inside(), coordinate(3)), |&(ray, triangle, [_, beta, gamma], t), program| {
            let system: (Mat3, Vec3) = program.ask(arguments![ray, triangle])?;
            close("the solution (β, γ, t)", solve(system)?, vec3(beta, gamma, t), TOLERANCE)
        }),
        Law::of(
            "both_sides_name_one_point",
            2,
            "Outside the triangle too the solution names one point: e + t d = a + β(b − a) + γ(c − a).",
            "Solved for β, γ and t, ray and plane are at different points. Which term stands on which side?",
        )
        .over(aimed(outside(), coordinate(3)), |&(ray, triangle, _, _), program| {
            let system: (Mat3, Vec3) = program.ask(arguments![ray, triangle])?;
            let x = solve(system)?;
            let on_plane = triangle.a + x.x * (triangle.b - triangle.a) + x.y * (triangle.c - triangle.a);
            // Three unknowns within the tolerance, times vectors of length at most 11, and a dozen roundings.
            close("e + t d", ray.origin + x.z * ray.direction, on_plane, 30.0 * TOLERANCE)
        }),
        Law::of(
            "twice_the_step_half_the_t",
            2,
            "With twice the direction, β and γ stay and t is half.",
            "t counts steps of the ray's direction. Does it stand in the matrix as it is, in the column of t?",
        )
        .over(aimed(inside(), coordinate(3)), |&(ray, triangle, _, _), program| {
            let slow: (Mat3, Vec3) = program.ask(arguments![ray, triangle])?;
            let twice = Ray { direction: 2.0 * ray.direction, ..ray };
            let fast: (Mat3, Vec3) = program.ask(arguments![twice, triangle])?;
            let x = solve(slow)?;
            close("(β, γ, t)", solve(fast)?, vec3(x.x, x.y, x.z / 2.0), TOLERANCE)
        }),
        Law::of(
            "a_parallel_ray_has_no_inverse",
            1,
            "For a ray parallel to the plane A has no inverse: its determinant is 0.",
            "A ray along the plane never meets it, but this system has a solution. Is it the direction that stands in A?",
        )
        .over(parallel(), |&(ray, triangle), program| {
            let (matrix, _): (Mat3, Vec3) = program.ask(arguments![ray, triangle])?;
            that(is_singular(matrix), || format!("the determinant of A is {}, should be 0", matrix.determinant()))
        }),
    ]
}

fn slide(ray: Ray, triangle: Triangle) -> (Mat3, Vec3) {
    let matrix = Mat3::from_cols(triangle.a - triangle.b, triangle.a - triangle.c, ray.direction);
    (matrix, triangle.a - ray.origin)
}

fn ray_on_the_other_side(ray: Ray, triangle: Triangle) -> (Mat3, Vec3) {
    // As exercise 4.2 writes it: β(b − a) + γ(c − a) − t d = e − a.
    let matrix = Mat3::from_cols(triangle.b - triangle.a, triangle.c - triangle.a, -ray.direction);
    (matrix, ray.origin - triangle.a)
}

fn row_by_row(ray: Ray, triangle: Triangle) -> (Mat3, Vec3) {
    let Triangle { a, b, c } = triangle;
    let (e, d) = (ray.origin, ray.direction);
    // One equation a coordinate, z first.
    let rows = [2, 0, 1].map(|k| ([a[k] - b[k], a[k] - c[k], d[k]], a[k] - e[k]));
    let [(first, p), (second, q), (third, r)] = rows;
    (Mat3::from_cols_array_2d(&[first, second, third]).transpose(), Vec3::new(p, q, r))
}

fn edges_from_c(ray: Ray, triangle: Triangle) -> (Mat3, Vec3) {
    // The difference of two rows may stand for one of them.
    let (ab, ac, ae) = (triangle.a - triangle.b, triangle.a - triangle.c, triangle.a - ray.origin);
    let mixed = |v: Vec3| Vec3::new(v.x + v.y, v.y, v.z - v.y);
    (Mat3::from_cols(mixed(ab), mixed(ac), mixed(ray.direction)), mixed(ae))
}

fn misconceptions() -> Vec<Misconception> {
    vec![
        Misconception {
            program: program!(rows_for_columns),
            looks_like: "the vectors stand in the rows of A",
            help: "β multiplies every coordinate of a − b: they stand below one another, in a column.",
        },
        Misconception {
            program: program!(t_on_the_wrong_side),
            looks_like: "t d changed sides without changing its sign, so t comes out negated",
            help: "With a − b, a − c and a − e the ray's t d stays on its side, with a plus.",
        },
        Misconception {
            program: program!(right_side_negated),
            looks_like: "the right side is e − a where it should be a − e",
            help: "The ray's e moves to the right side and gets a minus: a − e.",
        },
        Misconception {
            program: program!(t_first),
            looks_like: "t stands first among the unknowns",
            help: "The columns stand in the order of the unknowns: β, γ, t.",
        },
        Misconception {
            program: program!(b_and_c_exchanged),
            looks_like: "the columns of β and γ are exchanged",
            help: "β goes with the corner b, γ with c.",
        },
        Misconception {
            program: program!(direction_for_a_point),
            looks_like: "e is subtracted from the direction, as if d were a point",
            help: "The slide's d is s − e already: a ray holds its direction, not the point that it goes through.",
        },
        Misconception {
            program: program!(edges_turned_round),
            looks_like: "the columns b − a and c − a stand beside +d",
            help: "Terms that change sides change their sign: b − a becomes a − b, c − a becomes a − c.",
        },
        Misconception {
            program: program!(direction_of_length_one),
            looks_like: "the direction is brought to length 1 first",
            help: "t is to count steps of d. With a direction of length 1 it counts units of length.",
        },
    ]
}

fn rows_for_columns(ray: Ray, triangle: Triangle) -> (Mat3, Vec3) {
    let rows = Mat3::from_cols(triangle.a - triangle.b, triangle.a - triangle.c, ray.direction);
    (rows.transpose(), triangle.a - ray.origin)
}

fn t_on_the_wrong_side(ray: Ray, triangle: Triangle) -> (Mat3, Vec3) {
    let matrix = Mat3::from_cols(triangle.a - triangle.b, triangle.a - triangle.c, -ray.direction);
    (matrix, triangle.a - ray.origin)
}

fn right_side_negated(ray: Ray, triangle: Triangle) -> (Mat3, Vec3) {
    let matrix = Mat3::from_cols(triangle.a - triangle.b, triangle.a - triangle.c, ray.direction);
    (matrix, ray.origin - triangle.a)
}

fn t_first(ray: Ray, triangle: Triangle) -> (Mat3, Vec3) {
    let matrix = Mat3::from_cols(ray.direction, triangle.a - triangle.b, triangle.a - triangle.c);
    (matrix, triangle.a - ray.origin)
}

fn b_and_c_exchanged(ray: Ray, triangle: Triangle) -> (Mat3, Vec3) {
    let matrix = Mat3::from_cols(triangle.a - triangle.c, triangle.a - triangle.b, ray.direction);
    (matrix, triangle.a - ray.origin)
}

fn direction_for_a_point(ray: Ray, triangle: Triangle) -> (Mat3, Vec3) {
    let matrix =
        Mat3::from_cols(triangle.a - triangle.b, triangle.a - triangle.c, ray.direction - ray.origin);
    (matrix, triangle.a - ray.origin)
}

fn edges_turned_round(ray: Ray, triangle: Triangle) -> (Mat3, Vec3) {
    let matrix = Mat3::from_cols(triangle.b - triangle.a, triangle.c - triangle.a, ray.direction);
    (matrix, triangle.a - ray.origin)
}

fn direction_of_length_one(ray: Ray, triangle: Triangle) -> (Mat3, Vec3) {
    let matrix =
        Mat3::from_cols(triangle.a - triangle.b, triangle.a - triangle.c, ray.direction.normalize_or_zero());
    (matrix, triangle.a - ray.origin)
}
