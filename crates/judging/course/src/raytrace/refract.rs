//! The way on through glass: Snell's law and total reflection (L58).

use glam::{Vec3, vec3};
use proptest::prelude::*;
use proptest::sample::select;
use testkit::by_hand::{unit_vector, unit_vector_above};

use super::drawing;
use crate::exercise::{arguments, signature};
use crate::{Asker, Concept, Example, Exercise, Law, Misconception, Stop, Title, close, that};

const STUB: &str = r#"//! A ray on its way into glass, water or air (L58).
//!
//! Where light passes from one clear medium into another it is bent, by Snell's law:
//!
//!     n₁ sin θ₁ = n₂ sin θ₂
//!
//! θ₁ is the angle between the ray and the surface's normal before the surface, θ₂ the one behind it. Give the direction in which the
//! ray goes on, of length 1; `None` if no θ₂ exists: then all light is reflected, none passes.
//!
//! - `direction`: unit vector along the incoming ray, towards the surface. `normal`: unit vector on the side that the ray
//!   comes from, so that direction · normal < 0.
//! - `ratio`: n₁/n₂, greater than 0.
//! - The new direction lies in the plane of direction and normal. Rays at the very limit of total reflection do not occur.

use glam::Vec3;

pub fn refract(direction: Vec3, normal: Vec3, ratio: f32) -> Option<Vec3> {
    todo!()
}
"#;

signature!((direction: Vec3, normal: Vec3, ratio: f32) -> Option<Vec3>);

/// Unit vectors and their products are off by a few 2⁻²⁴; ratio² ≤ 4 makes cos² θ₂ off by at most 12 · 4 · 2⁻²⁴ = 3e-6. The root of
/// it is at least 0.1 on the way back, which makes 3e-6/0.2 = 1.5e-5 of that.
const TOLERANCE: f32 = 2e-5;

pub(super) fn exercise() -> Exercise {
    Exercise {
        name: "refract",
        concept: Concept::Raytrace,
        items: "L58",
        title: Title { english: "Refraction and total reflection", dutch: "Breking en totale reflectie" },
        prerequisites: &["viewing_ray"],
        stub: STUB,
        signature: SIGNATURE,
        hints: [
            "Split the direction in two: a part along the normal and a part along the surface. How long is each, in terms of θ₁?",
            "The part along the surface has length sin θ₁. Behind the surface it is n₁/n₂ times as long. The rest must make the length 1.",
            "c = −d·n. along = ratio (d + c n). k = 1 − along·along. If k < 0: None. Else along − √k n.",
        ],
        examples: examples(),
        laws: laws(),
        reference: program!(slide),
        variants: vec![program!(expanded), program!(by_the_angles), program!(as_glam_does)],
        misconceptions: misconceptions(),
        explanation: "No angle is needed: the sines are lengths along the surface. Into the denser medium (ratio < 1) the ray always finds a way, \
            bent towards the normal. Out of it, from a slant of sin θ₁ = n₂/n₁ on, none: for glass of index 1.5 from 41.8° on. The ray that \
            goes back takes the same way, with the ratio inverted.",
        draw: drawing::bent_ray,
        source: include_str!("refract.rs"),
    }
}

fn examples() -> Vec<Example> {
    let slanted = vec3(0.8, 0.0, -0.6);
    vec![
        Example::new(
            "from air into an index of 4/3, sin θ₁ = 0.8",
            arguments![slanted, Vec3::Z, 0.75_f32],
            Some(vec3(0.6, 0.0, -0.8)),
            TOLERANCE,
        ),
        Example::new(
            "the other way round: total reflection",
            arguments![slanted, Vec3::Z, 4.0_f32 / 3.0],
            None::<Vec3>,
            TOLERANCE,
        ),
        Example::new(
            "straight in, straight on",
            arguments![vec3(0.0, -1.0, 0.0), Vec3::Y, 1.5_f32],
            Some(vec3(0.0, -1.0, 0.0)),
            TOLERANCE,
        ),
    ]
}

/// A direction, a normal on the side that it comes from, at most 84° away from it, and a ratio.
fn arriving() -> impl Strategy<Value = (Vec3, Vec3, f32)> + Clone {
    let ratio = select(vec![0.5_f32, 2.0 / 3.0, 0.75, 0.8, 1.25, 4.0 / 3.0, 1.5, 2.0]);
    unit_vector()
        .prop_flat_map(|n| (unit_vector_above(n), Just(n)))
        .prop_map(|(from, n)| (-from, n))
        .prop_flat_map(move |(d, n)| (Just(d), Just(n), ratio.clone()))
}

/// sin θ₂, if there is such an angle.
fn sine_behind(&(d, n, ratio): &(Vec3, Vec3, f32)) -> f32 {
    ratio * d.cross(n).length()
}

/// Of [`arriving`] what passes.
fn passing() -> impl Strategy<Value = (Vec3, Vec3, f32)> + Clone {
    arriving().prop_filter("reflected", |arriving| sine_behind(arriving) < 0.95)
}

/// The same, at a slant.
fn slanted() -> impl Strategy<Value = (Vec3, Vec3, f32)> + Clone {
    passing().prop_filter("straight", |(d, n, _)| d.cross(*n).length() > 0.1)
}

/// The direction behind the surface, where there must be one.
fn asked(&(d, n, ratio): &(Vec3, Vec3, f32), program: &Asker<'_>) -> Result<Vec3, Stop> {
    let on: Option<Vec3> = program.ask(arguments![d, n, ratio])?;
    let sine = sine_behind(&(d, n, ratio));
    that(on.is_some(), || format!("the answer is None, but sin θ₂ = {sine} exists"))?;
    Ok(on.unwrap_or(Vec3::NAN))
}

fn laws() -> Vec<Law> {
    vec![
        Law::of(
            "snell",
            3,
            "n₁ sin θ₁ = n₂ sin θ₂: the sine behind the surface is ratio times that before it.",
            "The sines do not fit. Which of the two indices stands above in the ratio, and is it sines that you compare?",
        )
        .over(slanted(), |input, program| {
            let on = asked(input, program)?;
            close("sin θ₂", on.cross(input.1).length(), sine_behind(input), TOLERANCE)
        }),
        Law::of(
            "it_goes_on_beyond",
            2,
            "The ray goes on beyond the surface, and along the surface in the sense in which it came.",
            "The new direction does not lead through the surface and onwards. Which side is the normal on?",
        )
        .over(slanted(), |input, program| {
            let (d, n, _) = *input;
            let on = asked(input, program)?;
            that(on.dot(n) < 0.0, || format!("direction · normal is {}, should be below 0", on.dot(n)))?;
            let along = |v: Vec3| v - v.dot(n) * n;
            let sense = along(on).dot(along(d));
            that(sense > 0.0, || "along the surface the ray goes back to where it came from".to_owned())
        }),
        Law::of(
            "a_unit_vector_in_the_plane",
            2,
            "The new direction has length 1 and lies in the plane of direction and normal.",
            "The length is not 1, or the ray left the plane. Do both parts, along the surface and along the normal, have their length?",
        )
        .over(passing(), |input, program| {
            let (d, n, _) = *input;
            let on = asked(input, program)?;
            close("the length", on.length(), 1.0, TOLERANCE)?;
            close("the way out of the plane", on.dot(d.cross(n)), 0.0, TOLERANCE)
        }),
        Law::of(
            "the_way_back_is_the_same",
            2,
            "Light can go back: sent in from behind, with the ratio inverted, the ray comes out where it came from.",
            "There and back does not end where it began. What happens to the angle on the way in, and what on the way out?",
        )
        .over(passing(), |input, program| {
            let (d, n, ratio) = *input;
            let on = asked(input, program)?;
            let back: Option<Vec3> = program.ask(arguments![-on, -n, ratio.recip()])?;
            close("the way back", back, Some(-d), TOLERANCE)
        }),
        Law::of(
            "total_reflection_is_none",
            2,
            "If sin θ₂ would have to be above 1, nothing passes: None.",
            "No angle has this sine. What comes out of your root here?",
        )
        .over(
            arriving().prop_filter("passes", |arriving| sine_behind(arriving) > 1.05),
            |&(d, n, ratio), program| {
                let on: Option<Vec3> = program.ask(arguments![d, n, ratio])?;
                close("the answer", on, None, TOLERANCE)
            },
        ),
    ]
}

fn slide(direction: Vec3, normal: Vec3, ratio: f32) -> Option<Vec3> {
    // The part along the surface has length sin θ₁, and n₁/n₂ times that beyond it.
    let cosine = -direction.dot(normal);
    let along = ratio * (direction + cosine * normal);
    let squared = 1.0 - along.length_squared();
    if squared < 0.0 {
        return None;
    }
    Some(along - squared.sqrt() * normal)
}

fn expanded(direction: Vec3, normal: Vec3, ratio: f32) -> Option<Vec3> {
    let cosine = -direction.dot(normal);
    let squared = 1.0 - ratio * ratio * (1.0 - cosine * cosine);
    (squared >= 0.0).then(|| (ratio * direction + (ratio * cosine - squared.sqrt()) * normal).normalize())
}

fn by_the_angles(direction: Vec3, normal: Vec3, ratio: f32) -> Option<Vec3> {
    let axis = normal.cross(direction);
    let sine = ratio * axis.length();
    if sine > 1.0 {
        return None;
    }
    // Straight in, any axis will do: the angle is 0.
    let axis = axis.try_normalize().unwrap_or(normal.any_orthonormal_vector());
    Some(glam::Quat::from_axis_angle(axis, -sine.asin()) * -normal)
}

fn as_glam_does(direction: Vec3, normal: Vec3, ratio: f32) -> Option<Vec3> {
    let on = direction.refract(normal, ratio);
    (on != Vec3::ZERO).then_some(on)
}

fn misconceptions() -> Vec<Misconception> {
    vec![
        Misconception {
            program: program!(ratio_inverted),
            looks_like: "the ratio is taken for n₂/n₁",
            help: "sin θ₂ = (n₁/n₂) sin θ₁: multiply by the ratio, do not divide.",
        },
        Misconception {
            program: program!(angles_in_proportion),
            looks_like: "the angles are in the ratio, not their sines",
            help: "θ₂ = (n₁/n₂) θ₁ is nearly right for small angles only. Snell's law is about sines.",
        },
        Misconception {
            program: program!(root_of_a_negative),
            looks_like: "at total reflection the answer is not a number",
            help: "Below the root stands cos² θ₂. If that is negative there is no θ₂: leave with None before taking the root.",
        },
        Misconception {
            program: program!(mirrored_at_the_limit),
            looks_like: "at total reflection the mirrored direction is returned",
            help: "The mirrored ray exists, but it does not pass the surface. This function answers None; the caller mirrors.",
        },
        Misconception {
            program: program!(cosine_negative),
            looks_like: "d·n is taken for cos θ₁, and it is negative",
            help: "The normal looks against the ray: cos θ₁ = −d·n.",
        },
        Misconception {
            program: program!(back_to_its_own_side),
            looks_like: "the ray comes back on the side from which it came",
            help: "Behind the surface the ray goes against the normal: that part is −cos θ₂ n.",
        },
        Misconception {
            program: program!(only_the_part_along_n),
            looks_like: "the part along the surface is not multiplied by the ratio",
            help: "It is the part along the surface whose length is the sine. Multiply d by the ratio as well.",
        },
    ]
}

fn ratio_inverted(direction: Vec3, normal: Vec3, ratio: f32) -> Option<Vec3> {
    let cosine = -direction.dot(normal);
    let along = (direction + cosine * normal) / ratio;
    let squared = 1.0 - along.length_squared();
    (squared >= 0.0).then(|| along - squared.sqrt() * normal)
}

fn angles_in_proportion(direction: Vec3, normal: Vec3, ratio: f32) -> Option<Vec3> {
    let along = direction - direction.dot(normal) * normal;
    let angle = ratio * along.length().atan2(-direction.dot(normal));
    let passes = angle < std::f32::consts::FRAC_PI_2;
    passes.then(|| angle.sin() * along.normalize_or_zero() - angle.cos() * normal)
}

fn root_of_a_negative(direction: Vec3, normal: Vec3, ratio: f32) -> Option<Vec3> {
    let cosine = -direction.dot(normal);
    let along = ratio * (direction + cosine * normal);
    Some(along - (1.0 - along.length_squared()).sqrt() * normal)
}

fn mirrored_at_the_limit(direction: Vec3, normal: Vec3, ratio: f32) -> Option<Vec3> {
    let cosine = -direction.dot(normal);
    let along = ratio * (direction + cosine * normal);
    let squared = 1.0 - along.length_squared();
    if squared < 0.0 {
        return Some(direction + 2.0 * cosine * normal);
    }
    Some(along - squared.sqrt() * normal)
}

fn cosine_negative(direction: Vec3, normal: Vec3, ratio: f32) -> Option<Vec3> {
    let cosine = direction.dot(normal);
    let squared = 1.0 - ratio * ratio * (1.0 - cosine * cosine);
    (squared >= 0.0).then(|| ratio * direction + (ratio * cosine - squared.sqrt()) * normal)
}

fn back_to_its_own_side(direction: Vec3, normal: Vec3, ratio: f32) -> Option<Vec3> {
    let cosine = -direction.dot(normal);
    let along = ratio * (direction + cosine * normal);
    let squared = 1.0 - along.length_squared();
    (squared >= 0.0).then(|| along + squared.sqrt() * normal)
}

fn only_the_part_along_n(direction: Vec3, normal: Vec3, ratio: f32) -> Option<Vec3> {
    let cosine = -direction.dot(normal);
    let squared = 1.0 - ratio * ratio * (1.0 - cosine * cosine);
    (squared >= 0.0).then(|| direction + (ratio * cosine - squared.sqrt()) * normal)
}
