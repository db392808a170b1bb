//! The normal of a triangle: the first step of flat shading (L37).

use glam::{Vec3, vec3};
use proptest::prelude::*;
use testkit::by_hand::{coordinate, corners, direction, point3};
use vocabulary::Triangle;

use crate::exercise::{arguments, signature};
use crate::{Concept, Example, Exercise, Law, Misconception, Title, close, that};

const STUB: &str = r#"//! The normal of a triangle (L37, step 1 of flat shading).
//!
//! Give the unit vector at right angles to the triangle, on its front: the side from which its corners a, b, c run
//! anticlockwise.
//!
//!     n = (b − a) × (c − a) / |(b − a) × (c − a)|
//!
//! - `triangle`: its corners are points of space, in any one coordinate system; n is a direction of the same system.
//! - A triangle without area, its corners on one line or in one point, has no normal: give `None`.
//!
//! glam: `u.cross(v)`, `v.normalize()`, `v.try_normalize()`.

use glam::Vec3;
use vocabulary::Triangle;

pub fn face_normal(triangle: Triangle) -> Option<Vec3> {
    todo!()
}
"#;

signature!((triangle: Triangle) -> Option<Vec3>);

/// Corners are quarters in [−4, 4]: edges and their cross product are exact. A unit vector made of it is off by three roundings,
/// 2⁻²² a coordinate, and a product with an edge, at most 8·√3 < 14 long, by 14 · 3 · 2⁻²² ≈ 1e-5.
const TOLERANCE: f32 = 3e-5;

pub(super) fn exercise() -> Exercise {
    Exercise {
        name: "face_normal",
        concept: Concept::Shading,
        items: "L37",
        title: Title { english: "The normal of a triangle", dutch: "Normaalvector van een polygoon" },
        prerequisites: &["lambert"],
        stub: STUB,
        signature: SIGNATURE,
        hints: [
            "Two vectors lie in the triangle, if you take the difference of two corners. Which product is at right angles to both?",
            "The cross product follows the right hand: from the first edge to the second, anticlockwise, it comes out towards you. \
                Its length is twice the area: what does that say about a triangle without one?",
            "(triangle.b - triangle.a).cross(triangle.c - triangle.a).try_normalize()",
        ],
        examples: examples(),
        laws: laws(),
        reference: program!(slide),
        variants: vec![program!(from_the_other_edges), program!(by_projected_areas)],
        misconceptions: misconceptions(),
        explanation: "Which side is the front is only an agreement about the order of the corners, and the normal is where it is written \
            down: a mesh with one triangle the wrong way round shows one black face. The length that you divided away is twice the area, \
            and `vertex_normals` can use it.",
        draw: super::drawing::face_normal,
        source: include_str!("face_normal.rs"),
    }
}

fn triangle([a, b, c]: [Vec3; 3]) -> Triangle {
    Triangle { a, b, c }
}

fn examples() -> Vec<Example> {
    vec![
        Example::new(
            "on the floor, anticlockwise from above",
            arguments![triangle([vec3(1.0, 1.0, 0.0), vec3(3.0, 1.0, 0.0), vec3(1.0, 2.0, 0.0)])],
            Some(Vec3::Z),
            TOLERANCE,
        ),
        Example::new(
            "the unit points, as in the lecture's exercise 4.2",
            arguments![triangle([Vec3::X, Vec3::Y, Vec3::Z])],
            Some(Vec3::splat(1.0 / 3.0_f32.sqrt())),
            TOLERANCE,
        ),
        Example::new(
            "three corners on one line",
            arguments![triangle([vec3(1.0, 0.0, 2.0), vec3(2.0, 1.0, 2.0), vec3(4.0, 3.0, 2.0)])],
            None::<Vec3>,
            TOLERANCE,
        ),
    ]
}

/// Three points on a line, two of them or all perhaps in one place.
fn without_area() -> impl Strategy<Value = [Vec3; 3]> + Clone {
    let steps = (-2..=2, -2..=2);
    (point3(2), direction(), steps).prop_map(|(a, along, (s, t)): (Vec3, Vec3, (i32, i32))| {
        [a, a + 0.25 * s as f32 * along, a + 0.25 * t as f32 * along]
    })
}

/// n, demanded to be there.
fn there(n: Option<Vec3>) -> Result<Vec3, crate::Stop> {
    that(n.is_some(), || "the answer is None, though the triangle has an area".to_owned())?;
    Ok(n.unwrap_or_default())
}

fn laws() -> Vec<Law> {
    vec![
        Law::of(
            "at_right_angles_to_the_edges",
            2,
            "n is at right angles to the triangle's edges: n·(b − a) = n·(c − a) = 0.",
            "n is not at right angles to the triangle: of which two vectors is it the product?",
        )
        .over(corners(4), |&[a, b, c], program| {
            let n = there(program.ask(arguments![triangle([a, b, c])])?)?;
            close("n·(b − a)", n.dot(b - a), 0.0, TOLERANCE)?;
            close("n·(c − a)", n.dot(c - a), 0.0, TOLERANCE)
        }),
        Law::of(
            "as_long_as_one",
            2,
            "n is a unit vector.",
            "n has another length: what is the length of a cross product?",
        )
        .over(corners(4), |&corners, program| {
            let n = there(program.ask(arguments![triangle(corners)])?)?;
            close("|n|", n.length(), 1.0, TOLERANCE)
        }),
        Law::of(
            "on_the_front",
            3,
            "Seen from the tip of n, the corners run anticlockwise: (b − a), (c − a), n form a right-handed system.",
            "n is on the other side of the triangle: the order of the corners should decide, and nothing else.",
        )
        .over(corners(4), |&[a, b, c], program| {
            let n = there(program.ask(arguments![triangle([a, b, c])])?)?;
            let volume = (b - a).cross(c - a).dot(n);
            that(volume > 0.0, || format!("((b − a)×(c − a))·n is {volume}, should be above 0"))
        }),
        Law::of(
            "wherever_it_lies",
            1,
            "Moving the triangle leaves n as it is.",
            "n depends on where the triangle lies: a corner is a place, only the difference of two is a direction.",
        )
        .over((corners(4), (coordinate(4), coordinate(4), coordinate(4))), |&(corners, (x, y, z)), program| {
            let here: Option<Vec3> = program.ask(arguments![triangle(corners)])?;
            let there: Option<Vec3> = program.ask(arguments![triangle(corners.map(|p| p + vec3(x, y, z)))])?;
            close("n of the moved triangle", there, here, TOLERANCE)
        }),
        Law::of(
            "none_without_area",
            2,
            "Corners on one line give None.",
            "The cross product is zero here: what does dividing by its length give, and what does the task ask for?",
        )
        .over(without_area(), |&corners, program| {
            let n: Option<Vec3> = program.ask(arguments![triangle(corners)])?;
            close("the answer for a triangle without area", n, None, TOLERANCE)
        }),
    ]
}

fn slide(triangle: Triangle) -> Option<Vec3> {
    (triangle.b - triangle.a).cross(triangle.c - triangle.a).try_normalize()
}

fn from_the_other_edges(triangle: Triangle) -> Option<Vec3> {
    let Triangle { a, b, c } = triangle;
    let twice_the_area = (a - c).cross(b - c);
    let length = twice_the_area.length();
    if length == 0.0 { None } else { Some(twice_the_area / length) }
}

/// Each coordinate is twice the area of the triangle's shadow along that axis.
fn by_projected_areas(triangle: Triangle) -> Option<Vec3> {
    let Triangle { a, b, c } = triangle;
    let shadow = |i: usize, j: usize| (b[i] - a[i]) * (c[j] - a[j]) - (b[j] - a[j]) * (c[i] - a[i]);
    let areas = glam::vec3(shadow(1, 2), shadow(2, 0), shadow(0, 1));
    (areas.length_squared() > 1e-6).then(|| areas.normalize())
}

fn misconceptions() -> Vec<Misconception> {
    vec![
        Misconception {
            program: program!(on_the_back),
            looks_like: "n points to the triangle's back",
            help: "u×v and v×u are opposite. (b − a)×(c − a) comes out where a, b, c run anticlockwise.",
        },
        Misconception {
            program: program!(not_of_unit_length),
            looks_like: "n is not brought to unit length",
            help: "The cross product's length is twice the triangle's area. Divide by it.",
        },
        Misconception {
            program: program!(divided_by_zero),
            looks_like: "the area is not asked whether it is 0",
            help: "0/0 is NaN, and a NaN travels through the whole picture. `try_normalize` gives None instead.",
        },
        Misconception {
            program: program!(zero_for_none),
            looks_like: "the answer is the zero vector where it should be None",
            help: "Some(zero) says that there is a normal. There is none: None.",
        },
        Misconception {
            program: program!(corners_for_edges),
            looks_like: "corners are multiplied, not edges",
            help: "b×c is at right angles to the ways from the origin to b and c. An edge is a difference of two corners.",
        },
        Misconception {
            program: program!(towards_z),
            looks_like: "n is always turned towards +z",
            help: "A triangle may face away from the viewer: its corners then run clockwise for him, and n shows it.",
        },
        Misconception {
            program: program!(lies_in_the_triangle),
            looks_like: "n lies in the triangle",
            help: "A sum or difference of edges stays in their plane. The cross product leaves it.",
        },
    ]
}

fn on_the_back(triangle: Triangle) -> Option<Vec3> {
    (triangle.c - triangle.a).cross(triangle.b - triangle.a).try_normalize()
}

fn not_of_unit_length(triangle: Triangle) -> Option<Vec3> {
    let product = (triangle.b - triangle.a).cross(triangle.c - triangle.a);
    (product != Vec3::ZERO).then_some(product)
}

fn divided_by_zero(triangle: Triangle) -> Option<Vec3> {
    let product = (triangle.b - triangle.a).cross(triangle.c - triangle.a);
    Some(product / product.length())
}

fn zero_for_none(triangle: Triangle) -> Option<Vec3> {
    Some((triangle.b - triangle.a).cross(triangle.c - triangle.a).normalize_or_zero())
}

fn corners_for_edges(triangle: Triangle) -> Option<Vec3> {
    triangle.b.cross(triangle.c).try_normalize()
}

fn towards_z(triangle: Triangle) -> Option<Vec3> {
    let n = (triangle.b - triangle.a).cross(triangle.c - triangle.a).try_normalize()?;
    Some(if n.z < 0.0 { -n } else { n })
}

fn lies_in_the_triangle(triangle: Triangle) -> Option<Vec3> {
    let (along, across) = (triangle.b - triangle.a, triangle.c - triangle.a);
    if along.cross(across) == Vec3::ZERO { None } else { (along + across).try_normalize() }
}
