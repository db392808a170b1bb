//! The direction in which a mirror would send the light on (L31).

use glam::{Vec3, vec3};
use testkit::by_hand::{direction, unit_vector};

use crate::exercise::{arguments, signature};
use crate::{Concept, Example, Exercise, Law, Misconception, Title, close};

const STUB: &str = r#"//! The reflected direction (L31, Fig 10.5).
//!
//! Give r, the direction in which light goes on that comes from `to_light` and meets a mirror:
//!
//!     r = 2 (n·l) n − l
//!
//! - `n`: unit vector, the mirror's normal.
//! - `to_light`: l, from the surface towards the light. It may have any length; r has the same.
//! - r starts at the surface, as l does. It lies on the same side of the surface as l, whichever that is.
//!
//! glam: `a.dot(b)`. Its `reflect` has another convention: there the light travels *towards* the surface.

use glam::Vec3;

pub fn reflection(n: Vec3, to_light: Vec3) -> Vec3 {
    todo!()
}
"#;

signature!((n: Vec3, to_light: Vec3) -> Vec3);

/// l is at most 5·√3 < 9 long, n·l off by at most 9 · 2⁻²², a coordinate of r by 2 · 9 · 2⁻²² and roundings of numbers below 18:
/// 9e-6 at most, and twice that where r is reflected once more. Relative to l's coordinates that are larger than 1 it is less.
const TOLERANCE: f32 = 3e-5;

pub(super) fn exercise() -> Exercise {
    Exercise {
        name: "reflection",
        concept: Concept::Lighting,
        items: "L31, E5",
        title: Title { english: "The reflected direction", dutch: "Terugkaatsrichting" },
        prerequisites: &["lambert"],
        stub: STUB,
        signature: SIGNATURE,
        hints: [
            "Split l into a part along n and a part along the surface. Which of the two does a mirror turn around?",
            "The part along n is (n·l) n. What is left, l − (n·l) n, lies in the surface and changes sign; the part along n stays.",
            "(n·l) n − (l − (n·l) n) is 2 (n·l) n − l: glam writes it 2.0 * n.dot(to_light) * n - to_light.",
        ],
        examples: examples(),
        laws: laws(),
        reference: program!(slide),
        variants: vec![
            program!(from_its_two_parts),
            program!(half_a_turn_about_the_normal),
            program!(householder_matrix),
        ],
        misconceptions: misconceptions(),
        explanation: "Reflecting keeps the length, so r needs no square root and no division, though a slide calls it expensive (E5). It \
            is half a turn about n: done twice, it gives l back.",
        draw: super::drawing::reflection,
        source: include_str!("reflection.rs"),
    }
}

fn examples() -> Vec<Example> {
    vec![
        Example::new(
            "a floor, light from the right",
            arguments![Vec3::Z, vec3(0.6, 0.0, 0.8)],
            vec3(-0.6, 0.0, 0.8),
            TOLERANCE,
        ),
        Example::new(
            "a slope: n = (0.6, 0, 0.8), light of length 5 from above",
            arguments![vec3(0.6, 0.0, 0.8), vec3(0.0, 0.0, 5.0)],
            vec3(4.8, 0.0, 1.4),
            TOLERANCE,
        ),
    ]
}

fn laws() -> Vec<Law> {
    vec![
        Law::of(
            "as_long_as_before",
            1,
            "r is as long as l.",
            "The length changed: how large a part of n belongs into r?",
        )
        .over((unit_vector(), direction()), |&(n, to_light), program| {
            let r: Vec3 = program.ask(arguments![n, to_light])?;
            close("|r|", r.length(), to_light.length(), TOLERANCE)
        }),
        Law::of(
            "the_same_angle_with_the_normal",
            3,
            "r makes the same angle with n as l does, on the same side: n·r = n·l.",
            "Light goes on at another angle, or behind the surface: which part of l keeps its sign?",
        )
        .over((unit_vector(), direction()), |&(n, to_light), program| {
            let r: Vec3 = program.ask(arguments![n, to_light])?;
            close("n·r", n.dot(r), n.dot(to_light), TOLERANCE)
        }),
        Law::of(
            "in_one_plane_across_the_normal",
            2,
            "r and l lie in one plane with n, on opposite sides of it: r + l points along n.",
            "r + l is not along n: what lies along the surface should change its sign and nothing else.",
        )
        .over((unit_vector(), direction()), |&(n, to_light), program| {
            let r: Vec3 = program.ask(arguments![n, to_light])?;
            close("(r + l)×n", (r + to_light).cross(n), Vec3::ZERO, TOLERANCE)
        }),
        Law::of(
            "twice_is_nothing",
            2,
            "Reflecting r gives l back.",
            "Light that runs back the way it came should come out where it came from: try l, then your own r.",
        )
        .over((unit_vector(), direction()), |&(n, to_light), program| {
            let r: Vec3 = program.ask(arguments![n, to_light])?;
            let back: Vec3 = program.ask(arguments![n, r])?;
            close("r of r", back, to_light, TOLERANCE)
        }),
        Law::of(
            "both_sides_reflect_alike",
            1,
            "A mirror with normal −n reflects as one with normal n.",
            "The mirror's two sides differ: here n·l may be negative, and that is right.",
        )
        .over((unit_vector(), direction()), |&(n, to_light), program| {
            let front: Vec3 = program.ask(arguments![n, to_light])?;
            let back: Vec3 = program.ask(arguments![-n, to_light])?;
            close("r with −n", back, front, TOLERANCE)
        }),
    ]
}

fn slide(n: Vec3, to_light: Vec3) -> Vec3 {
    2.0 * n.dot(to_light) * n - to_light
}

fn from_its_two_parts(n: Vec3, to_light: Vec3) -> Vec3 {
    let along_normal = n.dot(to_light) * n;
    let along_surface = to_light - along_normal;
    along_normal - along_surface
}

fn half_a_turn_about_the_normal(n: Vec3, to_light: Vec3) -> Vec3 {
    glam::Quat::from_xyzw(n.x, n.y, n.z, 0.0) * to_light
}

fn householder_matrix(n: Vec3, to_light: Vec3) -> Vec3 {
    let outer = glam::Mat3::from_cols(n * n.x, n * n.y, n * n.z);
    (outer * 2.0 - glam::Mat3::IDENTITY) * to_light
}

fn misconceptions() -> Vec<Misconception> {
    vec![
        Misconception {
            program: program!(into_the_surface),
            looks_like: "r points into the surface: the signs are those of glam's reflect",
            help: "l − 2(n·l)n reflects light that travels towards the surface. Here l starts at the surface: both signs change.",
        },
        Misconception {
            program: program!(without_the_two),
            looks_like: "the factor 2 is missing",
            help: "(n·l)n − l only takes the part along n away. To come out on the other side of n, it is added once more.",
        },
        Misconception {
            program: program!(n_and_l_exchanged),
            looks_like: "n and l have changed places",
            help: "2(n·l)l − n reflects the normal in the light. The vector that is reflected has the minus.",
        },
        Misconception {
            program: program!(with_a_maximum),
            looks_like: "n·l is cut off at 0",
            help: "The maximum belongs to brightness, not to directions: light from behind is reflected too, behind.",
        },
        Misconception {
            program: program!(brought_to_unit_length),
            looks_like: "r is brought to unit length",
            help: "r has the length of l by itself: no square root is needed (E5).",
        },
        Misconception {
            program: program!(turned_around),
            looks_like: "the light is sent straight back",
            help: "−l is the direction in which the light travels, not where a mirror sends it. n has to occur in r.",
        },
    ]
}

fn into_the_surface(n: Vec3, to_light: Vec3) -> Vec3 {
    to_light - 2.0 * n.dot(to_light) * n
}

fn without_the_two(n: Vec3, to_light: Vec3) -> Vec3 {
    n.dot(to_light) * n - to_light
}

fn n_and_l_exchanged(n: Vec3, to_light: Vec3) -> Vec3 {
    2.0 * n.dot(to_light) * to_light - n
}

fn with_a_maximum(n: Vec3, to_light: Vec3) -> Vec3 {
    2.0 * n.dot(to_light).max(0.0) * n - to_light
}

fn brought_to_unit_length(n: Vec3, to_light: Vec3) -> Vec3 {
    (2.0 * n.dot(to_light) * n - to_light).normalize_or_zero()
}

fn turned_around(_n: Vec3, to_light: Vec3) -> Vec3 {
    -to_light
}
