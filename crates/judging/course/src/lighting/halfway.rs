//! The halfway vector, between the directions to eye and light (L33).

use glam::{Vec3, vec3};
use proptest::prelude::*;
use testkit::by_hand::unit_vector;

use crate::exercise::{arguments, signature};
use crate::{Concept, Example, Exercise, Law, Misconception, Title, close, that};

const STUB: &str = r#"//! The halfway vector (L33, Fig 10.8).
//!
//! Give the unit vector that lies halfway between the directions to the eye and to the light:
//!
//!     h = (e + l) / |e + l|
//!
//! - `to_eye`, `to_light`: unit vectors, e and l.
//! - Where eye and light lie in exactly opposite directions, e = −l, nothing lies halfway: give `None`.
//!
//! glam: `v.length()`, `v.normalize()`, `v.try_normalize()`.

use glam::Vec3;

pub fn halfway(to_eye: Vec3, to_light: Vec3) -> Option<Vec3> {
    todo!()
}
"#;

signature!((to_eye: Vec3, to_light: Vec3) -> Option<Vec3>);

/// e + l is off by at most 2⁻²² a coordinate, and here at least 0.1 long, so that dividing makes that ten times as much:
/// 10 · 2⁻²² ≈ 2.4e-6, and three times that in a product with a unit vector. Other ways to the same vector get as much again.
const TOLERANCE: f32 = 1.5e-5;

/// e + l is at least this long, or exactly zero: in between, rounding has too much to say.
const SHORTEST: f32 = 0.1;

pub(super) fn exercise() -> Exercise {
    Exercise {
        name: "halfway",
        concept: Concept::Lighting,
        items: "L33, E3, E5",
        title: Title { english: "The halfway vector", dutch: "Halfway vector" },
        prerequisites: &["lambert"],
        stub: STUB,
        signature: SIGNATURE,
        hints: [
            "Draw e and l as two sides of a rhombus: both are 1 long. Which direction has the diagonal between them?",
            "The diagonal is e + l. Its length is anything from 0 to 2, so it has to be divided by it; what if the length is 0?",
            "(to_eye + to_light).try_normalize() is None where the sum is zero, and h everywhere else.",
        ],
        examples: examples(),
        laws: laws(),
        reference: program!(slide),
        variants: vec![program!(from_halves), program!(through_the_angle)],
        misconceptions: misconceptions(),
        explanation: "If the surface were a mirror with normal h, it would send the light straight into the eye: so h·n says how near n is \
            to that. h needs a square root and r none: of the two, the slide calls the wrong one expensive (E5).",
        draw: super::drawing::halfway,
        source: include_str!("halfway.rs"),
    }
}

fn examples() -> Vec<Example> {
    let (left, right) = (vec3(-0.6, 0.0, 0.8), vec3(0.6, 0.0, 0.8));
    vec![
        Example::new("e and l at equal angles from z", arguments![left, right], Some(Vec3::Z), TOLERANCE),
        Example::new(
            "e along x, l along y",
            arguments![Vec3::X, Vec3::Y],
            Some(vec3(0.5_f32.sqrt(), 0.5_f32.sqrt(), 0.0)),
            TOLERANCE,
        ),
        Example::new("e = −l", arguments![Vec3::X, Vec3::NEG_X], None::<Vec3>, TOLERANCE),
    ]
}

/// Two directions that are not opposite.
fn eye_and_light() -> impl Strategy<Value = (Vec3, Vec3)> + Clone {
    (unit_vector(), unit_vector()).prop_filter("opposite", |(e, l)| (*e + *l).length() > SHORTEST)
}

/// h, demanded to be there.
fn there(h: Option<Vec3>) -> Result<Vec3, crate::Stop> {
    that(h.is_some(), || "the answer is None, though e is not −l".to_owned())?;
    Ok(h.unwrap_or_default())
}

fn laws() -> Vec<Law> {
    vec![
        Law::of(
            "as_long_as_one",
            2,
            "h is a unit vector.",
            "h has another length: half the sum of two unit vectors is no unit vector, unless they are the same.",
        )
        .over(eye_and_light(), |&(e, l), program| {
            let h = there(program.ask(arguments![e, l])?)?;
            close("|h|", h.length(), 1.0, TOLERANCE)
        }),
        Law::of(
            "in_the_middle",
            3,
            "h makes the same angle with e and with l, at most 90°.",
            "h leans to one of the two, or away from both.",
        )
        .over(eye_and_light(), |&(e, l), program| {
            let h = there(program.ask(arguments![e, l])?)?;
            close("h·e", h.dot(e), h.dot(l), TOLERANCE)?;
            that(h.dot(e) > 0.0, || format!("h·e is {}, h points away from e", h.dot(e)))
        }),
        Law::of(
            "between_the_two",
            1,
            "h lies in the plane of e and l.",
            "h left the plane of e and l: it should be made of these two alone.",
        )
        .over(eye_and_light(), |&(e, l), program| {
            let h = there(program.ask(arguments![e, l])?)?;
            close("h·(e×l)", h.dot(e.cross(l)), 0.0, TOLERANCE)
        }),
        Law::of(
            "eye_and_light_change_places",
            1,
            "Exchanging eye and light leaves h as it is.",
            "Eye and light should count the same.",
        )
        .over(eye_and_light(), |&(e, l), program| {
            let one: Option<Vec3> = program.ask(arguments![e, l])?;
            let other: Option<Vec3> = program.ask(arguments![l, e])?;
            close("h with e and l exchanged", other, one, TOLERANCE)
        }),
        Law::of(
            "nothing_between_opposites",
            2,
            "Where e = −l the answer is None.",
            "e + l has length 0 here: what does dividing by it give, and what does the task ask for?",
        )
        .over(unit_vector(), |&e, program| {
            let h: Option<Vec3> = program.ask(arguments![e, -e])?;
            close("the answer for e = −l", h, None, TOLERANCE)
        })
        .cases(20),
    ]
}

fn slide(to_eye: Vec3, to_light: Vec3) -> Option<Vec3> {
    let sum = to_eye + to_light;
    (sum != Vec3::ZERO).then(|| sum / sum.length())
}

/// The sides of the rhombus need not be 1 long: half of each gives the same direction.
fn from_halves(to_eye: Vec3, to_light: Vec3) -> Option<Vec3> {
    let half = 0.5 * (to_eye + to_light);
    if half.length_squared() < 1e-8 { None } else { Some(half * half.length().recip()) }
}

/// e, turned by half the angle towards l.
fn through_the_angle(to_eye: Vec3, to_light: Vec3) -> Option<Vec3> {
    let cosine_of_half = 0.5 * (to_eye + to_light).length();
    let across = (to_light - to_eye * to_light.dot(to_eye)).normalize_or_zero();
    let sine_of_half = 0.5 * (to_eye - to_light).length();
    (cosine_of_half > 1e-3).then(|| cosine_of_half * to_eye + sine_of_half * across)
}

fn misconceptions() -> Vec<Misconception> {
    vec![
        Misconception {
            program: program!(half_the_sum),
            looks_like: "the sum is divided by 2, not by its length",
            help: "(e + l)/2 is shorter than 1 unless e = l. Dividing by |e + l| makes it a unit vector.",
        },
        Misconception {
            program: program!(the_sum_alone),
            looks_like: "the sum is not divided by its length",
            help: "e + l points the right way, but is between 0 and 2 long: divide it by |e + l|.",
        },
        Misconception {
            program: program!(divided_by_zero),
            looks_like: "the length is not asked whether it is 0",
            help: "Where e = −l, 0/0 is NaN, and a NaN travels through the whole picture. `try_normalize` gives None instead.",
        },
        Misconception {
            program: program!(zero_for_none),
            looks_like: "the answer is the zero vector where it should be None",
            help: "Some(zero) says that there is a halfway vector. There is none: None.",
        },
        Misconception {
            program: program!(the_difference),
            looks_like: "e is subtracted, not added",
            help: "l − e is the rhombus's other diagonal, from the tip of e to the tip of l.",
        },
        Misconception {
            program: program!(none_beyond_a_right_angle),
            looks_like: "None is given wherever e and l are more than 90° apart",
            help: "h exists for all but opposite directions. Whether the light reaches the surface is another question, which n answers.",
        },
        Misconception {
            program: program!(the_common_perpendicular),
            looks_like: "the cross product stands where the sum should",
            help: "e×l is at right angles to both. What lies between them is their sum.",
        },
    ]
}

fn half_the_sum(to_eye: Vec3, to_light: Vec3) -> Option<Vec3> {
    let sum = to_eye + to_light;
    (sum != Vec3::ZERO).then_some(0.5 * sum)
}

fn the_sum_alone(to_eye: Vec3, to_light: Vec3) -> Option<Vec3> {
    let sum = to_eye + to_light;
    (sum != Vec3::ZERO).then_some(sum)
}

fn divided_by_zero(to_eye: Vec3, to_light: Vec3) -> Option<Vec3> {
    let sum = to_eye + to_light;
    Some(sum / sum.length())
}

fn zero_for_none(to_eye: Vec3, to_light: Vec3) -> Option<Vec3> {
    Some((to_eye + to_light).normalize_or_zero())
}

fn the_difference(to_eye: Vec3, to_light: Vec3) -> Option<Vec3> {
    (to_light - to_eye).try_normalize()
}

fn none_beyond_a_right_angle(to_eye: Vec3, to_light: Vec3) -> Option<Vec3> {
    if to_eye.dot(to_light) < 0.0 { None } else { (to_eye + to_light).try_normalize() }
}

fn the_common_perpendicular(to_eye: Vec3, to_light: Vec3) -> Option<Vec3> {
    to_eye.cross(to_light).try_normalize()
}
