//! Where a ray first meets a sphere, from outside or inside (L43, L47).

use glam::vec3;
use proptest::prelude::*;
use vocabulary::{Ray, Sphere};

use super::drawing;
use super::inputs::{at, crossings, forwards, height, is_clear, sphere, step, within};
use crate::exercise::{arguments, signature};
use crate::{Concept, Example, Exercise, Law, Misconception, Title, close, that};

const STUB: &str = r#"//! Where a ray first meets a sphere (L43, L47).
//!
//! A point p(t) = e + t d is on the sphere if it is r away from the centre c:
//!
//!     (e + t d − c)·(e + t d − c) = r²
//!
//! That is a quadratic equation in t. Give its smallest solution t > 0, or `None` if there is none.
//!
//! - `ray`: origin e and direction d, not zero, of any length: t counts steps of d. `sphere`: centre and radius. One space.
//! - From inside the sphere the ray meets it on its way out.
//! - Rays that only touch and origins on the surface do not occur.
//!
//! glam: `dot`, `length_squared`.

use vocabulary::{Ray, Sphere};

pub fn ray_sphere(ray: Ray, sphere: Sphere) -> Option<f32> {
    todo!()
}
"#;

signature!((ray: Ray, sphere: Sphere) -> Option<f32>);

/// e is at most 16 + 2 from c and d at most 5.2 long. The terms of the discriminant are below (18 · 5.2)² = 8800, with some four
/// roundings: off by 2e-3. Its root is at least r·|d|/2, so off by 2e-3/(2·0.25·5.2) = 8e-4, and t by that over |d|² = 27, which
/// is 3e-5; in length, 1.6e-4. Shorter directions have smaller terms.
const TOLERANCE: f32 = 2e-4;

pub(super) fn exercise() -> Exercise {
    Exercise {
        name: "ray_sphere",
        concept: Concept::Raytrace,
        items: "L43, L47",
        title: Title { english: "Where a ray meets a sphere", dutch: "Snijpunt van straal en bol" },
        prerequisites: &["viewing_ray"],
        stub: STUB,
        signature: SIGNATURE,
        hints: [
            "Multiply out: what stands before t², before t, and alone? That is A t² + B t + C = 0.",
            "A = d·d, B = 2 d·(e − c), C = (e − c)·(e − c) − r². A negative discriminant: a miss. Two solutions: try the smaller first.",
            "t = (−B − √(B² − 4AC)) / (2A) if that is above 0; else the one with +√ if that is above 0; else None.",
        ],
        examples: examples(),
        laws: laws(),
        reference: program!(slide),
        variants: vec![program!(from_the_nearest_point), program!(without_cancellation)],
        misconceptions: misconceptions(),
        explanation: "Two solutions, because a line that goes in must come out. Which of them counts depends on where the ray starts: before \
            the sphere the entry, inside it the exit, behind it none. Far away B² and 4AC are huge and nearly equal, and their difference \
            loses its digits: a ray tracer measures how far the line passes from the centre instead.",
        draw: drawing::sphere_along_the_ray,
        source: include_str!("ray_sphere.rs"),
    }
}

fn examples() -> Vec<Example> {
    let ball = Sphere { center: vec3(0.0, 3.0, -5.0), radius: 2.0 };
    let towards = |z: f32, step: f32| Ray { origin: vec3(0.0, 3.0, z), direction: vec3(0.0, 0.0, step) };
    vec![
        Example::new(
            "from before it, in steps of 4",
            arguments![towards(5.0, -4.0), ball],
            Some(2.0_f32),
            TOLERANCE,
        ),
        Example::new("from its centre", arguments![towards(-5.0, -4.0), ball], Some(0.5_f32), TOLERANCE),
        Example::new("from behind it", arguments![towards(-9.0, -4.0), ball], None::<f32>, TOLERANCE),
    ]
}

/// A ray from outside a sphere that is aimed at a point inside.
fn from_outside() -> impl Strategy<Value = (Ray, Sphere)> + Clone {
    (sphere(4), within(), step(), forwards())
        .prop_map(|(sphere, within, direction, t)| {
            let origin = sphere.center + sphere.radius * within - t * direction;
            (Ray { origin, direction }, sphere)
        })
        .prop_filter("inside", |(ray, sphere)| height(at(ray, 0.0), sphere) > 0.1)
}

/// A ray that starts well inside a sphere.
fn from_inside() -> impl Strategy<Value = (Ray, Sphere)> + Clone {
    (sphere(4), within(), step()).prop_map(|(sphere, within, direction)| {
        (Ray { origin: sphere.center + sphere.radius * within, direction }, sphere)
    })
}

/// A ray that leaves a sphere behind, or passes beside it.
fn missing() -> impl Strategy<Value = (Ray, Sphere)> + Clone {
    let behind = from_outside().prop_map(|(ray, sphere)| (Ray { direction: -ray.direction, ..ray }, sphere));
    let beside = (sphere(4), step(), step(), forwards())
        .prop_map(|(sphere, away, direction, t)| {
            let passed = sphere.center + 2.0 * sphere.radius * direction.cross(away);
            (Ray { origin: passed - t * direction, direction }, sphere)
        })
        .prop_filter("parallel", |(ray, sphere)| is_clear(ray, sphere) && crossings(ray, sphere).is_none());
    prop_oneof![behind, beside]
}

fn laws() -> Vec<Law> {
    vec![
        Law::of(
            "the_point_is_on_the_sphere",
            2,
            "A ray aimed at the sphere meets it, and the point e + t d is r away from the centre.",
            "Put your t into e + t d: the point is not on the sphere. Check A, B and C, and what the division takes in.",
        )
        .over(from_outside(), |&(ray, sphere), program| {
            let t: Option<f32> = program.ask(arguments![ray, sphere])?;
            that(t.is_some(), || "the answer is None, but the ray is aimed at the sphere's inside".to_owned())?;
            let distance = at(&ray, f64::from(t.unwrap_or(0.0))).distance(sphere.center.as_dvec3());
            close("the distance from the centre", distance as f32, sphere.radius, TOLERANCE)
        }),
        Law::of(
            "all_before_it_is_outside",
            2,
            "From outside it is the entry: every point before it on the ray is outside the sphere.",
            "Some of the way to your point leads through the sphere. Of two solutions, which comes first?",
        )
        .over(from_outside(), |&(ray, sphere), program| {
            let t: Option<f32> = program.ask(arguments![ray, sphere])?;
            let t = f64::from(t.unwrap_or(0.0));
            let way = |share: i32| at(&ray, t * f64::from(share) / 8.0);
            let passed = (1..8).find(|share| height(way(*share), &sphere) < -f64::from(TOLERANCE));
            that(passed.is_none(), || format!("the answer is {t}, but at {} of the way there the ray is inside already", share(passed)))
        }),
        Law::of(
            "from_inside_it_is_the_exit",
            2,
            "From inside the ray meets the sphere on its way out, at t > 0.",
            "One solution is negative here, the other positive. Both belong to the line, but only one to the ray.",
        )
        .over(from_inside(), |&(ray, sphere), program| {
            let t: Option<f32> = program.ask(arguments![ray, sphere])?;
            that(t.is_some_and(|t| t > 0.0), || format!("the answer is {}, but the ray must come out at some t > 0", say(t)))?;
            let distance = at(&ray, f64::from(t.unwrap_or(0.0))).distance(sphere.center.as_dvec3());
            close("the distance from the centre", distance as f32, sphere.radius, TOLERANCE)
        }),
        Law::of(
            "a_miss_is_none",
            2,
            "A sphere behind the ray's origin, or beside the ray, is not met.",
            "There is no t > 0 at which this ray is on the sphere. What are your two solutions, and which signs have they?",
        )
        .over(missing(), |&(ray, sphere), program| {
            let t: Option<f32> = program.ask(arguments![ray, sphere])?;
            close("the answer", t, None, TOLERANCE)
        }),
        Law::of(
            "twice_the_step_half_the_t",
            1,
            "With twice the direction t is half.",
            "t counts steps of d. Where does the length of d enter your equation?",
        )
        .over(from_outside(), |&(ray, sphere), program| {
            let slow: Option<f32> = program.ask(arguments![ray, sphere])?;
            let twice = Ray { direction: 2.0 * ray.direction, ..ray };
            let fast: Option<f32> = program.ask(arguments![twice, sphere])?;
            close("t with twice the direction", fast, slow.map(|t| t / 2.0), TOLERANCE)
        }),
    ]
}

/// "3/8", for a law's sentence.
fn share(eighths: Option<i32>) -> String {
    format!("{}/8", eighths.unwrap_or(0))
}

/// A number, or None.
fn say(t: Option<f32>) -> String {
    t.map_or_else(|| "None".to_owned(), |t| t.to_string())
}

fn slide(ray: Ray, sphere: Sphere) -> Option<f32> {
    let from_center = ray.origin - sphere.center;
    let a = ray.direction.dot(ray.direction);
    let b = 2.0 * ray.direction.dot(from_center);
    let c = from_center.dot(from_center) - sphere.radius * sphere.radius;
    let discriminant = b * b - 4.0 * a * c;
    if discriminant < 0.0 {
        return None;
    }
    let root = discriminant.sqrt();
    let entry = (-b - root) / (2.0 * a);
    let exit = (-b + root) / (2.0 * a);
    if entry > 0.0 {
        Some(entry)
    } else if exit > 0.0 {
        Some(exit)
    } else {
        None
    }
}

fn from_the_nearest_point(ray: Ray, sphere: Sphere) -> Option<f32> {
    // Where the line is nearest to the centre, and Pythagoras from there to the surface; in units of length.
    let length = ray.direction.length();
    let d = ray.direction / length;
    let nearest = d.dot(sphere.center - ray.origin);
    let distance = (ray.origin + nearest * d).distance(sphere.center);
    if distance > sphere.radius {
        return None;
    }
    let half = ((sphere.radius - distance) * (sphere.radius + distance)).sqrt();
    [nearest - half, nearest + half].into_iter().find(|s| *s > 0.0).map(|s| s / length)
}

fn without_cancellation(ray: Ray, sphere: Sphere) -> Option<f32> {
    let (f, d) = (ray.origin.as_dvec3() - sphere.center.as_dvec3(), ray.direction.as_dvec3());
    let (a, b) = (d.length_squared(), -f.dot(d));
    let c = f.length_squared() - f64::from(sphere.radius).powi(2);
    // Half of B, and the second solution from the product C/A of both.
    let root = (b * b - a * c).sqrt();
    let q = b + root.copysign(b);
    let mut crossings = [q / a, c / q];
    crossings.sort_by(f64::total_cmp);
    crossings.into_iter().find(|t| *t > 0.0).filter(|t| t.is_finite()).map(|t| t as f32)
}

fn misconceptions() -> Vec<Misconception> {
    vec![
        Misconception {
            program: program!(direction_taken_for_unit),
            looks_like: "the direction is taken for one of length 1",
            help: "d·d stands before t², and it is 1 only for a unit direction. Keep A in the equation.",
        },
        Misconception {
            program: program!(always_the_exit),
            looks_like: "the ray meets the sphere where it leaves it",
            help: "The solution with −√ is the smaller one: the entry. Take the other only if that one is not above 0.",
        },
        Misconception {
            program: program!(also_behind),
            looks_like: "points behind the origin count, with t < 0",
            help: "A solution with t < 0 is on the line but not on the ray. Check the sign before you return it.",
        },
        Misconception {
            program: program!(only_the_entry),
            looks_like: "a ray from inside meets nothing",
            help: "If the smaller solution is negative the larger may still be positive: then the ray starts inside and comes out there.",
        },
        Misconception {
            program: program!(radius_not_squared),
            looks_like: "r stands in the equation, not r²",
            help: "The left side is a distance squared; so is the right side, r².",
        },
        Misconception {
            program: program!(divided_by_two_times_a),
            looks_like: "x / 2.0 * a is divided by 2 and then multiplied by a",
            help: "* and / are worked off from the left. Write / (2.0 * a).",
        },
        Misconception {
            program: program!(sphere_at_the_origin),
            looks_like: "the sphere stands at the origin, wherever its centre is",
            help: "Distances are measured from c: e − c belongs where e alone stands.",
        },
    ]
}

fn direction_taken_for_unit(ray: Ray, sphere: Sphere) -> Option<f32> {
    let from_center = ray.origin - sphere.center;
    let b = ray.direction.dot(from_center);
    let c = from_center.dot(from_center) - sphere.radius * sphere.radius;
    let discriminant = b * b - c;
    if discriminant < 0.0 {
        return None;
    }
    let root = discriminant.sqrt();
    [-b - root, -b + root].into_iter().find(|t| *t > 0.0)
}

fn always_the_exit(ray: Ray, sphere: Sphere) -> Option<f32> {
    let from_center = ray.origin - sphere.center;
    let a = ray.direction.dot(ray.direction);
    let b = 2.0 * ray.direction.dot(from_center);
    let c = from_center.dot(from_center) - sphere.radius * sphere.radius;
    let discriminant = b * b - 4.0 * a * c;
    if discriminant < 0.0 {
        return None;
    }
    let exit = (-b + discriminant.sqrt()) / (2.0 * a);
    (exit > 0.0).then_some(exit)
}

fn also_behind(ray: Ray, sphere: Sphere) -> Option<f32> {
    let from_center = ray.origin - sphere.center;
    let a = ray.direction.dot(ray.direction);
    let b = 2.0 * ray.direction.dot(from_center);
    let c = from_center.dot(from_center) - sphere.radius * sphere.radius;
    let discriminant = b * b - 4.0 * a * c;
    if discriminant < 0.0 {
        return None;
    }
    Some((-b - discriminant.sqrt()) / (2.0 * a))
}

fn only_the_entry(ray: Ray, sphere: Sphere) -> Option<f32> {
    let from_center = ray.origin - sphere.center;
    let a = ray.direction.dot(ray.direction);
    let b = 2.0 * ray.direction.dot(from_center);
    let c = from_center.dot(from_center) - sphere.radius * sphere.radius;
    let discriminant = b * b - 4.0 * a * c;
    if discriminant < 0.0 {
        return None;
    }
    let entry = (-b - discriminant.sqrt()) / (2.0 * a);
    (entry > 0.0).then_some(entry)
}

fn radius_not_squared(ray: Ray, sphere: Sphere) -> Option<f32> {
    let from_center = ray.origin - sphere.center;
    let a = ray.direction.dot(ray.direction);
    let b = 2.0 * ray.direction.dot(from_center);
    let c = from_center.dot(from_center) - sphere.radius;
    let discriminant = b * b - 4.0 * a * c;
    if discriminant < 0.0 {
        return None;
    }
    let root = discriminant.sqrt();
    [(-b - root) / (2.0 * a), (-b + root) / (2.0 * a)].into_iter().find(|t| *t > 0.0)
}

fn divided_by_two_times_a(ray: Ray, sphere: Sphere) -> Option<f32> {
    let from_center = ray.origin - sphere.center;
    let a = ray.direction.dot(ray.direction);
    let b = 2.0 * ray.direction.dot(from_center);
    let c = from_center.dot(from_center) - sphere.radius * sphere.radius;
    let discriminant = b * b - 4.0 * a * c;
    if discriminant < 0.0 {
        return None;
    }
    let root = discriminant.sqrt();
    [(-b - root) / 2.0 * a, (-b + root) / 2.0 * a].into_iter().find(|t| *t > 0.0)
}

fn sphere_at_the_origin(ray: Ray, sphere: Sphere) -> Option<f32> {
    let a = ray.direction.dot(ray.direction);
    let b = 2.0 * ray.direction.dot(ray.origin);
    let c = ray.origin.dot(ray.origin) - sphere.radius * sphere.radius;
    let discriminant = b * b - 4.0 * a * c;
    if discriminant < 0.0 {
        return None;
    }
    let root = discriminant.sqrt();
    [(-b - root) / (2.0 * a), (-b + root) / (2.0 * a)].into_iter().find(|t| *t > 0.0)
}
