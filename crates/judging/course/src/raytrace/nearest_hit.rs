//! Of several spheres, the one that a ray meets first (L43, L47, L52).

use glam::{Vec3, vec3};
use proptest::prelude::*;
use testkit::by_hand::{between, point3};
use vocabulary::{Ray, Sphere};

use super::drawing;
use super::inputs::{at, crossings, height, is_clear, radius, step};
use crate::exercise::{arguments, signature};
use crate::{Concept, Example, Exercise, Law, Misconception, Title, close, that};

const STUB: &str = r#"//! The nearest of several spheres along a ray (L43, L47, L52).
//!
//! A ray crosses the surfaces of spheres at several t. Give the smallest of them with
//!
//!     t0 < t < t1
//!
//! and the index of its sphere in the list, as Some((index, t)); `None` if there is none.
//!
//! - `ray`: origin e and direction d, not zero, of any length: t counts steps of d. `spheres`: any number, also none.
//! - `t0`, `t1`: 0 ≤ t0 < t1; t1 may be f32::INFINITY.
//! - Spheres may overlap, and the ray may start inside one. A sphere that is entered before t0 and left after it is met where
//!   the ray leaves it.
//! - Rays that only touch, two crossings at one t, and crossings at t0 or t1 themselves do not occur.
//!
//! What you wrote for `ray_sphere` helps: copy it into this file as a function of its own.

use vocabulary::{Ray, Sphere};

pub fn nearest_hit(ray: Ray, spheres: &[Sphere], t0: f32, t1: f32) -> Option<(usize, f32)> {
    todo!()
}
"#;

signature!((ray: Ray, spheres: &[Sphere], t0: f32, t1: f32) -> Option<(usize, f32)>);

/// Centres are at most 4·5.2 + 3 = 24 from e, and d at most 5.2 long. The discriminant's terms are below (24 · 5.2)² = 15600, with
/// some four roundings: off by 4e-3. Its root is at least 0.3 · r · |d|, r ≥ ½: off by 4e-3/(2·0.15·5.2) = 2.6e-3, t by that over
/// |d|² = 27, which is 1e-4; half as much again for what t itself rounds.
const TOLERANCE: f32 = 1.5e-4;

/// The same in units of length: times |d| ≤ 5.2.
const LENGTH_TOLERANCE: f32 = 8e-4;

/// No two crossings, and none and an end of the interval, are nearer than this: far above rounding.
const GAP: f64 = 0.02;

pub(super) fn exercise() -> Exercise {
    Exercise {
        name: "nearest_hit",
        concept: Concept::Raytrace,
        items: "L43, L47, L52",
        title: Title { english: "The nearest hit", dutch: "Het dichtstbijzijnde object" },
        prerequisites: &["ray_sphere"],
        stub: STUB,
        signature: SIGNATURE,
        hints: [
            "Keep the best hit so far, with its index, and go through the whole list. What makes another hit better?",
            "A crossing counts only if t0 < t < t1. Each sphere has up to two; the smaller may lie before t0 and the larger not.",
            "For each index: of its crossings that lie in the interval take the smaller; keep it if nothing was kept yet or if it is smaller.",
        ],
        examples: examples(),
        laws: laws(),
        reference: program!(slide),
        variants: vec![program!(interval_shrinks), program!(sorted)],
        misconceptions: misconceptions(),
        explanation: "Along a ray smaller t is nearer; in the lecture's z-buffer larger z is nearer. The interval is worth having from the \
            beginning: the near and far plane are t0 and t1 of a viewing ray, the light is t1 of a shadow ray. And t1 may shrink to the best t \
            found so far, which is what makes acceleration structures fast.",
        draw: drawing::nearest_along_the_ray,
        source: include_str!("nearest_hit.rs"),
    }
}

fn examples() -> Vec<Example> {
    let ball = |z: f32, radius: f32| Sphere { center: vec3(1.0, 2.0, z), radius };
    let ray = Ray { origin: vec3(1.0, 2.0, 10.0), direction: vec3(0.0, 0.0, -2.0) };
    let row = vec![ball(-4.0, 2.0), ball(14.0, 1.0), ball(3.0, 1.0)];
    vec![
        Example::new(
            "one behind, one near, one far",
            arguments![ray, row.clone(), 0.0_f32, f32::INFINITY],
            Some((2_usize, 3.0_f32)),
            TOLERANCE,
        ),
        Example::new(
            "from inside the near one on, it is left first",
            arguments![ray, row.clone(), 3.5_f32, 20.0_f32],
            Some((2_usize, 4.0_f32)),
            TOLERANCE,
        ),
        Example::new(
            "nothing between",
            arguments![ray, row, 0.0_f32, 2.5_f32],
            None::<(usize, f32)>,
            TOLERANCE,
        ),
    ]
}

/// A ray, one to five spheres along it of which it meets most, and an interval; everything is [`decided`].
fn along_a_ray() -> impl Strategy<Value = (Ray, Vec<Sphere>, f32, f32)> + Clone {
    let beside = (-3..=3, -3..=3, -3..=3).prop_map(|(x, y, z)| vec3(x as f32, y as f32, z as f32) / 4.0);
    let placed = proptest::collection::vec((between(-2, 4), beside, radius()), 1..=5);
    let far = prop_oneof![between(1, 4), Just(f32::INFINITY)];
    (point3(3), step(), placed, between(0, 2), far)
        .prop_map(|(origin, direction, placed, t0, far)| {
            let place = |(t, beside, radius): (f32, Vec3, f32)| Sphere {
                center: origin + t * direction + radius * beside,
                radius,
            };
            (Ray { origin, direction }, placed.into_iter().map(place).collect::<Vec<_>>(), t0, t0 + far)
        })
        .prop_filter("close to a tie", |(ray, spheres, t0, t1)| decided(ray, spheres, *t0, *t1))
}

/// Whether nothing is close to a tie: touching, two crossings at once, a crossing at an end of the interval.
fn decided(ray: &Ray, spheres: &[Sphere], t0: f32, t1: f32) -> bool {
    let mut all: Vec<f64> = spheres.iter().filter_map(|sphere| crossings(ray, sphere)).flatten().collect();
    all.extend([f64::from(t0), f64::from(t1)]);
    all.sort_by(f64::total_cmp);
    spheres.iter().all(|sphere| is_clear(ray, sphere)) && all.windows(2).all(|pair| pair[1] - pair[0] > GAP)
}

/// The smallest crossing in the interval, in f64.
fn first_in(ray: &Ray, spheres: &[Sphere], t0: f64, t1: f64) -> Option<f64> {
    let all = spheres.iter().filter_map(|sphere| crossings(ray, sphere)).flatten();
    all.filter(|t| t0 < *t && *t < t1).min_by(f64::total_cmp)
}

fn laws() -> Vec<Law> {
    vec![
        Law::of(
            "it_is_a_hit",
            2,
            "The answer is a hit: t0 < t < t1, and e + t d is on the surface of the sphere with that index.",
            "Put your t into e + t d. Is the index that of the list as it was given, is t in steps of d, and is it within t0 and t1?",
        )
        .over(along_a_ray(), |(ray, spheres, t0, t1), program| {
            let hit: Option<(usize, f32)> = program.ask(arguments![*ray, spheres.clone(), *t0, *t1])?;
            let Some((index, t)) = hit else { return Ok(()) };
            that(index < spheres.len(), || format!("index {index} is not in a list of {}", spheres.len()))?;
            that(*t0 < t && t < *t1, || format!("t is {t}, should be between {t0} and {t1}"))?;
            let away = height(at(ray, f64::from(t)), &spheres[index]) as f32;
            close("the height over the sphere's surface", away, 0.0, LENGTH_TOLERANCE)
        }),
        Law::of(
            "nothing_is_nearer",
            3,
            "Between t0 and t the ray crosses no sphere; and where it crosses one between t0 and t1, there is an answer.",
            "There is a crossing nearer than yours, or you found none at all. Do you look at all spheres and at both crossings of each?",
        )
        .over(along_a_ray(), |(ray, spheres, t0, t1), program| {
            let hit: Option<(usize, f32)> = program.ask(arguments![*ray, spheres.clone(), *t0, *t1])?;
            let end = hit.map_or(f64::from(*t1), |(_, t)| f64::from(t) - f64::from(TOLERANCE));
            let nearer = first_in(ray, spheres, f64::from(*t0), end.min(f64::from(*t1)));
            let given = hit.map_or_else(|| "None".to_owned(), |(_, t)| format!("t = {t}"));
            that(nearer.is_none(), || format!("the answer is {given}, but a sphere is crossed at t = {:.3}", nearer.unwrap_or(0.0)))
        }),
        Law::of(
            "the_order_of_the_list_does_not_matter",
            2,
            "With the list reversed it is the same sphere, at the same t.",
            "The answer changes with the order of the list. What must a later hit be, to replace an earlier one?",
        )
        .over(along_a_ray(), |(ray, spheres, t0, t1), program| {
            let hit: Option<(usize, f32)> = program.ask(arguments![*ray, spheres.clone(), *t0, *t1])?;
            let reversed: Vec<Sphere> = spheres.iter().rev().copied().collect();
            let other: Option<(usize, f32)> = program.ask(arguments![*ray, reversed, *t0, *t1])?;
            let wanted = hit.map(|(index, t)| (spheres.len().saturating_sub(index + 1), t));
            close("the answer for the reversed list", other, wanted, TOLERANCE)
        }),
        Law::of(
            "nothing_between_is_none",
            1,
            "If all crossings lie before t0 or after t1, the answer is None.",
            "Your hit lies outside the interval. Which of the two ends is not looked at?",
        )
        .over(
            along_a_ray().prop_filter("a hit", |(ray, spheres, t0, t1)| {
                first_in(ray, spheres, f64::from(*t0), f64::from(*t1)).is_none()
                    && spheres.iter().any(|sphere| crossings(ray, sphere).is_some())
            }),
            |(ray, spheres, t0, t1), program| {
                let hit: Option<(usize, f32)> = program.ask(arguments![*ray, spheres.clone(), *t0, *t1])?;
                close("the answer", hit, None, TOLERANCE)
            },
        ),
    ]
}

fn slide(ray: Ray, spheres: &[Sphere], t0: f32, t1: f32) -> Option<(usize, f32)> {
    let mut nearest: Option<(usize, f32)> = None;
    for (index, sphere) in spheres.iter().enumerate() {
        let from_center = ray.origin - sphere.center;
        let a = ray.direction.length_squared();
        let b = ray.direction.dot(from_center);
        let c = from_center.length_squared() - sphere.radius * sphere.radius;
        let discriminant = b * b - a * c;
        if discriminant < 0.0 {
            continue;
        }
        let root = discriminant.sqrt();
        for t in [(-b - root) / a, (-b + root) / a] {
            if t0 < t && t < t1 && nearest.is_none_or(|(_, best)| t < best) {
                nearest = Some((index, t));
            }
        }
    }
    nearest
}

fn interval_shrinks(ray: Ray, spheres: &[Sphere], t0: f32, mut t1: f32) -> Option<(usize, f32)> {
    fn crossings(ray: Ray, sphere: Sphere) -> [f32; 2] {
        // NaN if there are none: it lies in no interval.
        let length = ray.direction.length();
        let d = ray.direction / length;
        let nearest = d.dot(sphere.center - ray.origin);
        let distance = (ray.origin + nearest * d).distance(sphere.center);
        let half = ((sphere.radius - distance) * (sphere.radius + distance)).sqrt();
        [(nearest - half) / length, (nearest + half) / length]
    }
    let mut index = None;
    for (k, sphere) in spheres.iter().enumerate() {
        if let Some(t) = crossings(ray, *sphere).into_iter().find(|t| t0 < *t && *t < t1) {
            (index, t1) = (Some(k), t);
        }
    }
    index.map(|index| (index, t1))
}

fn sorted(ray: Ray, spheres: &[Sphere], t0: f32, t1: f32) -> Option<(usize, f32)> {
    let d = ray.direction.as_dvec3();
    let mut hits = Vec::new();
    for (index, sphere) in spheres.iter().enumerate() {
        let f = (ray.origin - sphere.center).as_dvec3();
        let middle = -f.dot(d) / d.length_squared();
        let radius = f64::from(sphere.radius);
        let squared = (radius * radius - (f + middle * d).length_squared()) / d.length_squared();
        hits.push((index, (middle - squared.sqrt()) as f32));
        hits.push((index, (middle + squared.sqrt()) as f32));
    }
    hits.retain(|(_, t)| t0 < *t && *t < t1);
    hits.sort_by(|(_, s), (_, t)| s.total_cmp(t));
    hits.first().copied()
}

fn misconceptions() -> Vec<Misconception> {
    vec![
        Misconception {
            program: program!(first_in_the_list),
            looks_like: "the first sphere of the list that is hit wins",
            help: "The list is in no order. A later sphere may be nearer: compare its t with the best so far.",
        },
        Misconception {
            program: program!(larger_is_nearer),
            looks_like: "the largest t wins, as the largest z does in the z-buffer",
            help: "Along a ray t grows away from its origin: smaller t is nearer.",
        },
        Misconception {
            program: program!(from_minus_infinity),
            looks_like: "hits before t0, or behind the origin, count too",
            help: "Only crossings with t > t0 count: compare with both ends before you keep one.",
        },
        Misconception {
            program: program!(to_infinity),
            looks_like: "hits beyond t1 count too",
            help: "Only crossings with t < t1 count: the search ends there.",
        },
        Misconception {
            program: program!(entries_only),
            looks_like: "a sphere that is entered before t0 is dropped, though it is left after t0",
            help: "Each sphere has two crossings. If the entry does not lie in the interval, look at the exit.",
        },
        Misconception {
            program: program!(counted_among_the_hits),
            looks_like: "the index counts only the spheres that are hit",
            help: "Number the spheres before you leave out those that are missed: `enumerate` comes first.",
        },
        Misconception {
            program: program!(distance_for_t),
            looks_like: "t is returned as a distance, t·|d|",
            help: "p = e + t d: t counts steps of d, and is not multiplied by the length of d.",
        },
    ]
}

fn first_in_the_list(ray: Ray, spheres: &[Sphere], t0: f32, t1: f32) -> Option<(usize, f32)> {
    let crossings = |sphere: &Sphere| {
        let from_center = ray.origin - sphere.center;
        let (a, b) = (ray.direction.length_squared(), ray.direction.dot(from_center));
        let root = (b * b - a * (from_center.length_squared() - sphere.radius * sphere.radius)).sqrt();
        [(-b - root) / a, (-b + root) / a]
    };
    spheres.iter().enumerate().find_map(|(index, sphere)| {
        let t = crossings(sphere).into_iter().find(|t| t0 < *t && *t < t1)?;
        Some((index, t))
    })
}

fn larger_is_nearer(ray: Ray, spheres: &[Sphere], t0: f32, t1: f32) -> Option<(usize, f32)> {
    let crossings = |sphere: &Sphere| {
        let from_center = ray.origin - sphere.center;
        let (a, b) = (ray.direction.length_squared(), ray.direction.dot(from_center));
        let root = (b * b - a * (from_center.length_squared() - sphere.radius * sphere.radius)).sqrt();
        [(-b - root) / a, (-b + root) / a]
    };
    let mut nearest = None;
    let mut best = f32::NEG_INFINITY;
    for (index, sphere) in spheres.iter().enumerate() {
        for t in crossings(sphere) {
            if t0 < t && t < t1 && t > best {
                best = t;
                nearest = Some((index, t));
            }
        }
    }
    nearest
}

fn from_minus_infinity(ray: Ray, spheres: &[Sphere], _t0: f32, t1: f32) -> Option<(usize, f32)> {
    let crossings = |sphere: &Sphere| {
        let from_center = ray.origin - sphere.center;
        let (a, b) = (ray.direction.length_squared(), ray.direction.dot(from_center));
        let root = (b * b - a * (from_center.length_squared() - sphere.radius * sphere.radius)).sqrt();
        [(-b - root) / a, (-b + root) / a]
    };
    let mut nearest: Option<(usize, f32)> = None;
    for (index, sphere) in spheres.iter().enumerate() {
        for t in crossings(sphere) {
            if t < t1 && nearest.is_none_or(|(_, best)| t < best) {
                nearest = Some((index, t));
            }
        }
    }
    nearest
}

fn to_infinity(ray: Ray, spheres: &[Sphere], t0: f32, _t1: f32) -> Option<(usize, f32)> {
    let crossings = |sphere: &Sphere| {
        let from_center = ray.origin - sphere.center;
        let (a, b) = (ray.direction.length_squared(), ray.direction.dot(from_center));
        let root = (b * b - a * (from_center.length_squared() - sphere.radius * sphere.radius)).sqrt();
        [(-b - root) / a, (-b + root) / a]
    };
    let mut nearest: Option<(usize, f32)> = None;
    for (index, sphere) in spheres.iter().enumerate() {
        for t in crossings(sphere) {
            if t > t0 && nearest.is_none_or(|(_, best)| t < best) {
                nearest = Some((index, t));
            }
        }
    }
    nearest
}

fn entries_only(ray: Ray, spheres: &[Sphere], t0: f32, t1: f32) -> Option<(usize, f32)> {
    let crossings = |sphere: &Sphere| {
        let from_center = ray.origin - sphere.center;
        let (a, b) = (ray.direction.length_squared(), ray.direction.dot(from_center));
        let root = (b * b - a * (from_center.length_squared() - sphere.radius * sphere.radius)).sqrt();
        [(-b - root) / a, (-b + root) / a]
    };
    let entries = spheres.iter().enumerate().map(|(index, sphere)| (index, crossings(sphere)[0]));
    entries.filter(|(_, t)| t0 < *t && *t < t1).min_by(|(_, s), (_, t)| s.total_cmp(t))
}

fn counted_among_the_hits(ray: Ray, spheres: &[Sphere], t0: f32, t1: f32) -> Option<(usize, f32)> {
    let crossings = |sphere: &Sphere| {
        let from_center = ray.origin - sphere.center;
        let (a, b) = (ray.direction.length_squared(), ray.direction.dot(from_center));
        let root = (b * b - a * (from_center.length_squared() - sphere.radius * sphere.radius)).sqrt();
        [(-b - root) / a, (-b + root) / a]
    };
    let hits = spheres.iter().filter_map(|sphere| crossings(sphere).into_iter().find(|t| t0 < *t && *t < t1));
    hits.enumerate().min_by(|(_, s), (_, t)| s.total_cmp(t))
}

fn distance_for_t(ray: Ray, spheres: &[Sphere], t0: f32, t1: f32) -> Option<(usize, f32)> {
    let crossings = |sphere: &Sphere| {
        let from_center = ray.origin - sphere.center;
        let (a, b) = (ray.direction.length_squared(), ray.direction.dot(from_center));
        let root = (b * b - a * (from_center.length_squared() - sphere.radius * sphere.radius)).sqrt();
        [(-b - root) / a, (-b + root) / a]
    };
    let mut nearest: Option<(usize, f32)> = None;
    let length = ray.direction.length();
    for (index, sphere) in spheres.iter().enumerate() {
        for t in crossings(sphere) {
            if t0 < t && t < t1 && nearest.is_none_or(|(_, best)| t * length < best) {
                nearest = Some((index, t * length));
            }
        }
    }
    nearest
}
