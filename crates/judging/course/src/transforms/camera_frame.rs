//! Which way are right, up and backwards for a camera? (L6)

use glam::{Vec3, vec3};
use proptest::prelude::*;
use testkit::by_hand::direction;
use vocabulary::Basis;

use super::drawing;
use crate::exercise::{arguments, signature};
use crate::law::{Broken, Stop, that};
use crate::{Concept, Example, Exercise, Law, Misconception, Title, close};

const STUB: &str = r#"//! The camera's frame (Fig 4.8, L6).
//!
//! A camera looks along `gaze`, and `up` says roughly which way is up on its picture. Give its three axes:
//!
//!     w = −gaze / ‖gaze‖          backwards: the camera looks along −w
//!     u = (up × w) / ‖up × w‖     to the right
//!     v = w × u                   up on the picture
//!
//! - `gaze`, `up`: directions in world coordinates, of any length; they need not be at right angles.
//! - Degenerate: return `None` if `gaze` is zero, if `up` is zero, or if `up` is parallel to `gaze` (along it or against it).
//!   Then nothing says where right is.
//! - Numbers are rounded, and the cross product of two parallel vectors may come out as 0.0000001. So compare the sine of the
//!   angle, ‖up × gaze‖ / (‖up‖·‖gaze‖), with a small number like 0.001. No input lies between: where up and gaze are not
//!   parallel up to rounding, they are at least half a degree apart.
//!
//! glam: `cross`, `length`, `normalize`, `try_normalize` (an Option: `None` for a vector of length 0).

use glam::Vec3;
use vocabulary::Basis;

pub fn camera_frame(gaze: Vec3, up: Vec3) -> Option<Basis> {
    todo!()
}
"#;

signature!((gaze: Vec3, up: Vec3) -> Option<Basis>);

/// Whole numbers up to 5: a cross product of two such vectors that are not parallel has at least length 1, their lengths
/// are at most 5·√3, so the sine of their angle is at least 1/75. Unit vectors are off by two roundings a coordinate, products
/// and differences add as many: 6 · 2⁻²⁴ over 1/75 gives less than 3e-5 in a direction, and two directions are compared.
const TOLERANCE: f32 = 1e-4;

pub(super) fn exercise() -> Exercise {
    Exercise {
        name: "camera_frame",
        concept: Concept::Transforms,
        items: "L6",
        title: Title { english: "The camera's frame", dutch: "Het assenstelsel van de camera" },
        prerequisites: &[],
        stub: STUB,
        signature: SIGNATURE,
        hints: [
            "The gaze alone fixes one of the three axes. Which one, and with which sign?",
            "up itself is usually not at right angles to the gaze. up × w is at right angles to both, but not of length 1.",
            "Take w = −gaze.try_normalize()?, the cross product of up.try_normalize()? and w, return None where it is \
             shorter than 0.001; else normalize it: u. Then v = w.cross(u) needs no normalizing any more.",
        ],
        examples: examples(),
        laws: laws(),
        reference: program!(slide),
        variants: vec![program!(gram_schmidt), program!(by_sine_in_double_precision)],
        misconceptions: misconceptions(),
        explanation: "up only chooses among the turns about the line of sight: u is what is at right angles to both, and v \
            is the part of up that is at right angles to the gaze. So a camera that looks straight along up has no frame, \
            and one that looks almost so has a frame that turns wildly with every small movement.",
        draw: drawing::camera_axes,
        source: include_str!("camera_frame.rs"),
    }
}

fn examples() -> Vec<Example> {
    let ahead = Basis { u: Vec3::X, v: Vec3::Y, w: Vec3::Z };
    // Looking down a slope of 3 to 4: v leans forward as much as the gaze leans down.
    let down = Basis { u: Vec3::X, v: vec3(0.0, 0.8, -0.6), w: vec3(0.0, 0.6, 0.8) };
    vec![
        Example::new(
            "along −z, up roughly y",
            arguments![vec3(0.0, 0.0, -4.0), vec3(0.0, 2.0, 1.0)],
            Some(ahead),
            TOLERANCE,
        ),
        Example::new("down a slope", arguments![vec3(0.0, -3.0, -4.0), Vec3::Y], Some(down), TOLERANCE),
        Example::new(
            "straight down, up along the gaze",
            arguments![vec3(0.0, -2.0, 0.0), Vec3::Y],
            None::<Basis>,
            TOLERANCE,
        ),
        Example::new(
            "up one degree beside the gaze: enough to say where right is",
            arguments![vec3(0.0, 0.0, -1.0), vec3(0.0, 1.0, -60.0)],
            Some(ahead),
            TOLERANCE,
        ),
    ]
}

/// Gaze and up of whole numbers, not parallel.
fn gaze_and_up() -> impl Strategy<Value = (Vec3, Vec3)> + Clone {
    // Exact in whole numbers.
    (direction(), direction()).prop_filter("parallel", |(gaze, up)| gaze.cross(*up) != Vec3::ZERO)
}

/// Gaze and up that span no frame: one is zero, or both lie on one line, which is so of three in four.
fn no_frame() -> impl Strategy<Value = (Vec3, Vec3)> + Clone {
    let times = prop_oneof![Just(1.0_f32), Just(-1.0), Just(3.0), Just(-0.5)];
    prop_oneof![
        1 => direction().prop_map(|up| (Vec3::ZERO, up)),
        1 => direction().prop_map(|gaze| (gaze, Vec3::ZERO)),
        4 => (direction(), times.clone()).prop_map(|(gaze, times)| (gaze, times * gaze)),
        // Parallel as well as rounded numbers can be: their cross product need not be exactly zero.
        2 => (direction(), times).prop_map(|(gaze, times)| (gaze.normalize(), times * gaze)),
    ]
}

/// The basis, where there must be one.
fn some(frame: Option<Basis>) -> Result<Basis, Stop> {
    let missing = || Broken { what: "None, though gaze and up are not parallel".to_owned(), values: None };
    frame.ok_or_else(|| Stop::Broken(missing()))
}

fn laws() -> Vec<Law> {
    vec![
        Law::of(
            "unit_and_at_right_angles",
            2,
            "u, v and w have length 1 and stand at right angles to each other.",
            "Lengths or angles are off: which of the vectors were never made to have length 1, and which never put at a \
                right angle?",
        )
        .over(gaze_and_up(), |&(gaze, up), program| {
            let Basis { u, v, w } = some(program.ask(arguments![gaze, up])?)?;
            for (name, axis) in [("u", u), ("v", v), ("w", w)] {
                close(&format!("the length of {name}"), axis.length(), 1.0, TOLERANCE)?;
            }
            for (name, dot) in [("u·v", u.dot(v)), ("v·w", v.dot(w)), ("w·u", w.dot(u))] {
                close(name, dot, 0.0, TOLERANCE)?;
            }
            Ok(())
        }),
        Law::of(
            "right_handed",
            1,
            "The axes are right-handed: u × v = w.",
            "u × v is not w: a cross product changes its sign when its factors change places. Check each against the task.",
        )
        .over(gaze_and_up(), |&(gaze, up), program| {
            let Basis { u, v, w } = some(program.ask(arguments![gaze, up])?)?;
            close("u × v", u.cross(v), w, TOLERANCE)
        }),
        Law::of(
            "w_looks_back",
            2,
            "The camera looks along −w: −‖gaze‖·w is gaze.",
            "w does not point backwards along the gaze: which sign and which length has it?",
        )
        .over(gaze_and_up(), |&(gaze, up), program| {
            let frame = some(program.ask(arguments![gaze, up])?)?;
            close("−‖gaze‖·w", -gaze.length() * frame.w, gaze, TOLERANCE)
        }),
        Law::of(
            "up_is_up",
            2,
            "On the picture up points straight up: up·u = 0, and up·v > 0.",
            "up leans sideways or hangs down on the picture: to which vectors must u be at right angles, and in which order \
             does the cross product take them?",
        )
        .over(gaze_and_up(), |&(gaze, up), program| {
            let Basis { u, v, .. } = some(program.ask(arguments![gaze, up])?)?;
            close("up·u", up.dot(u), 0.0, TOLERANCE)?;
            that(up.dot(v) > 0.0, || format!("up·v is {}, which is not above 0", up.dot(v)))
        }),
        Law::of(
            "no_frame_without_directions",
            2,
            "There is no frame if gaze is zero, or up is zero or parallel to gaze.",
            "There is no right answer here, and one came back. Rounding may turn a cross product of length 0 into a tiny one: \
             what do you compare with what?",
        )
        .over(no_frame(), |&(gaze, up), program| {
            let frame: Option<Basis> = program.ask(arguments![gaze, up])?;
            that(frame.is_none(), || "a frame, where there is none: the answer should be None".to_owned())
        }),
    ]
}

fn slide(gaze: Vec3, up: Vec3) -> Option<Basis> {
    let w = -gaze.try_normalize()?;
    let right = up.try_normalize()?.cross(w);
    if right.length() < 1e-3 {
        return None;
    }
    let u = right.normalize();
    Some(Basis { u, v: w.cross(u), w })
}

fn gram_schmidt(gaze: Vec3, up: Vec3) -> Option<Basis> {
    if gaze == Vec3::ZERO || up == Vec3::ZERO {
        return None;
    }
    let (w, up) = (-gaze.normalize(), up.normalize());
    // What is left of up without its part along the gaze.
    let v = up - up.dot(w) * w;
    if v.length() < 1e-3 {
        return None;
    }
    let v = v.normalize();
    Some(Basis { u: v.cross(w), v, w })
}

fn by_sine_in_double_precision(gaze: Vec3, up: Vec3) -> Option<Basis> {
    let (gaze, up) = (gaze.as_dvec3(), up.as_dvec3());
    let right = gaze.cross(up);
    // Written so that a zero vector, for which both sides are zero, has no frame either.
    if right.length_squared() <= 1e-6 * gaze.length_squared() * up.length_squared() {
        return None;
    }
    let unit = |v: glam::DVec3| (v / v.length()).as_vec3();
    Some(Basis { u: unit(right), v: unit(right.cross(gaze)), w: unit(-gaze) })
}

fn misconceptions() -> Vec<Misconception> {
    vec![
        Misconception {
            program: program!(w_along_the_gaze),
            looks_like: "w points where the camera looks",
            help: "The camera looks along −w: w points backwards, out of the picture, so that the axes are right-handed.",
        },
        Misconception {
            program: program!(up_kept_as_v),
            looks_like: "v is up itself, made as long as 1",
            help: "up need not be at right angles to the gaze. v = w × u is.",
        },
        Misconception {
            program: program!(cross_product_exchanged),
            looks_like: "u is w × up, and points to the left",
            help: "up × w points to the right; with the factors exchanged the sign changes, and the picture stands on its \
                head.",
        },
        Misconception {
            program: program!(left_handed),
            looks_like: "v is u × w, and points down",
            help: "From u × v = w follows w × u = v: go round in the order u, v, w, u, v, ….",
        },
        Misconception {
            program: program!(cross_product_taken_for_a_unit_vector),
            looks_like: "u is not made as long as 1",
            help: "The cross product of two unit vectors is as long as the sine of their angle: it is 1 only at a right angle.",
        },
        Misconception {
            program: program!(degenerate_case_forgotten),
            looks_like: "the degenerate cases are not looked at",
            help: "A vector of length 0 divided by its length is NaN. Ask first whether there is a direction.",
        },
        Misconception {
            program: program!(compared_with_exactly_zero),
            looks_like: "the cross product is compared with exactly zero",
            help: "After rounding, parallel vectors have a cross product that is tiny but not zero. Compare its length with \
                a small number.",
        },
    ]
}

fn w_along_the_gaze(gaze: Vec3, up: Vec3) -> Option<Basis> {
    let w = gaze.try_normalize()?;
    let right = up.try_normalize()?.cross(w);
    if right.length() < 1e-3 {
        return None;
    }
    let u = right.normalize();
    Some(Basis { u, v: w.cross(u), w })
}

fn up_kept_as_v(gaze: Vec3, up: Vec3) -> Option<Basis> {
    let w = -gaze.try_normalize()?;
    let v = up.try_normalize()?;
    let right = v.cross(w);
    if right.length() < 1e-3 {
        return None;
    }
    Some(Basis { u: right.normalize(), v, w })
}

fn cross_product_exchanged(gaze: Vec3, up: Vec3) -> Option<Basis> {
    let w = -gaze.try_normalize()?;
    let left = w.cross(up.try_normalize()?);
    if left.length() < 1e-3 {
        return None;
    }
    let u = left.normalize();
    Some(Basis { u, v: w.cross(u), w })
}

fn left_handed(gaze: Vec3, up: Vec3) -> Option<Basis> {
    let w = -gaze.try_normalize()?;
    let right = up.try_normalize()?.cross(w);
    if right.length() < 1e-3 {
        return None;
    }
    let u = right.normalize();
    Some(Basis { u, v: u.cross(w), w })
}

fn cross_product_taken_for_a_unit_vector(gaze: Vec3, up: Vec3) -> Option<Basis> {
    let w = -gaze.try_normalize()?;
    let u = up.try_normalize()?.cross(w);
    if u.length() < 1e-3 {
        return None;
    }
    Some(Basis { u, v: w.cross(u), w })
}

fn degenerate_case_forgotten(gaze: Vec3, up: Vec3) -> Option<Basis> {
    let w = -gaze.normalize();
    let right = up.cross(w);
    let u = right / right.length();
    Some(Basis { u, v: w.cross(u), w })
}

fn compared_with_exactly_zero(gaze: Vec3, up: Vec3) -> Option<Basis> {
    if gaze == Vec3::ZERO {
        return None;
    }
    let w = -gaze.normalize();
    let right = up.cross(w);
    if right == Vec3::ZERO {
        return None;
    }
    let u = right / right.length();
    Some(Basis { u, v: w.cross(u), w })
}
