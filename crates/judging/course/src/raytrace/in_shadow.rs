//! Does anything stand between a point and the lamp? (L56, E12)

use glam::{Vec3, vec3};
use proptest::prelude::*;
use testkit::by_hand::{point3, unit_vector};
use vocabulary::{Ray, Sphere};

use super::drawing;
use super::inputs::{crossings, decided, height, radius, sphere, within};
use crate::exercise::{arguments, signature};
use crate::{Concept, Example, Exercise, Law, Misconception, Title, close};

const STUB: &str = r#"//! Is a point in shadow? (L56)
//!
//! Send a shadow ray from the point p to the lamp at l:
//!
//!     q(t) = p + t (l − p)        q(0) is the point, q(1) the lamp
//!
//! Give `true` if it crosses the surface of a sphere at some t with 0.001 < t < 1, `false` otherwise.
//!
//! - `point`: usually on the surface of one of the spheres, up to rounding; the list holds that sphere too.
//! - `light`: where the lamp is, outside all spheres. `spheres`: any number, also none. All in world space.
//! - Crossings close to t = 0.001 or t = 1, and rays that only touch, do not occur.

use glam::Vec3;
use vocabulary::Sphere;

pub fn in_shadow(point: Vec3, light: Vec3, spheres: &[Sphere]) -> bool {
    todo!()
}
"#;

signature!((point: Vec3, light: Vec3, spheres: &[Sphere]) -> bool);

/// The answer is true or false: nothing to round.
const TOLERANCE: f32 = 0.0;

pub(super) fn exercise() -> Exercise {
    Exercise {
        name: "in_shadow",
        concept: Concept::Raytrace,
        items: "L56, E12",
        title: Title { english: "In shadow or not", dutch: "Wel of niet in de schaduw" },
        prerequisites: &["ray_sphere", "nearest_hit"],
        stub: STUB,
        signature: SIGNATURE,
        hints: [
            "It does not matter which sphere is nearest: any one on the way is enough.",
            "The way from the point to the lamp is a ray with direction l − p. At which t is the lamp, and what must count neither before nor after?",
            "For each sphere find both crossings of p + t (l − p), the direction not normalized. If one of them has 0.001 < t < 1: true.",
        ],
        examples: examples(),
        laws: laws(),
        reference: program!(slide),
        variants: vec![program!(in_units_of_length), program!(nearest_point_of_the_way)],
        misconceptions: misconceptions(),
        explanation: "Rounding puts a point of a surface a little inside it, and without an offset the surface shades itself in speckles: \
            `shadow acne`. An offset that is too large lets light through thin things. The slide's light is at infinity; a lamp is not, and \
            what stands behind it casts no shadow here.",
        draw: drawing::on_the_way_to_the_lamp,
        source: include_str!("in_shadow.rs"),
    }
}

fn examples() -> Vec<Example> {
    let ground = Sphere { center: vec3(0.0, -2.0, 1.0), radius: 2.0 };
    let above = Sphere { center: vec3(0.0, 3.0, 1.0), radius: 1.0 };
    let (point, lamp) = (vec3(0.0, 0.0, 1.0), vec3(0.0, 6.0, 1.0));
    vec![
        Example::new("its own sphere below it", arguments![point, lamp, vec![ground]], false, TOLERANCE),
        Example::new("a ball between", arguments![point, lamp, vec![ground, above]], true, TOLERANCE),
        Example::new(
            "the lamp lower than the ball",
            arguments![point, vec3(0.0, 1.5, 1.0), vec![ground, above]],
            false,
            TOLERANCE,
        ),
        Example::new(
            "the lamp close by, a quarter away",
            arguments![point, vec3(0.0, 0.25, 1.0), vec![ground, above]],
            false,
            TOLERANCE,
        ),
        Example::new(
            "a ball beside the way",
            arguments![point, lamp, vec![ground, Sphere { center: vec3(2.0, 3.0, 1.0), ..above }]],
            false,
            TOLERANCE,
        ),
    ]
}

/// A point on a sphere, and a lamp that stands clearly before its surface, or clearly behind it.
fn on_a_sphere(before: bool) -> impl Strategy<Value = (Sphere, Vec3, Vec3)> + Clone {
    let placed = (sphere(3), unit_vector(), point3(6));
    let placed = placed.prop_map(|(own, n, light)| (own, own.center + own.radius * n, n, light));
    let slanted = placed.prop_filter("grazing", move |(own, p, n, light)| {
        let way = *light - *p;
        let cosine = n.dot(way.normalize_or_zero());
        let clear = if before { cosine > 0.15 } else { cosine < -0.15 };
        clear && way.length() >= 1.0 && height(light.as_dvec3(), own) > 0.1
    });
    slanted.prop_map(|(own, p, _, light)| (own, p, light))
}

/// A point on a sphere with the lamp before it, and another sphere of which the way's point at a share of these is well inside.
fn with_another(
    eighths: std::ops::RangeInclusive<i32>,
) -> impl Strategy<Value = (Sphere, Sphere, Vec3, Vec3)> + Clone {
    let placed = (on_a_sphere(true), eighths, within(), 2..=8);
    placed
        .prop_map(|((own, p, light), eighths, within, quarters)| {
            let radius = quarters as f32 / 4.0;
            let center = p + eighths as f32 / 8.0 * (light - p) + radius * within;
            (own, Sphere { center, radius }, p, light)
        })
        .prop_filter("close to a tie", |(own, other, p, light)| decided(*p, *light, &[*own, *other]))
}

fn laws() -> Vec<Law> {
    vec![
        Law::of(
            "its_own_surface_is_no_shadow",
            2,
            "A point that faces the lamp, alone with its own sphere, is lit.",
            "A sphere shades itself where it faces the lamp. At which t does the shadow ray meet the sphere that it starts from?",
        )
        .over(on_a_sphere(true), |&(own, p, light), program| {
            let shadow: bool = program.ask(arguments![p, light, vec![own]])?;
            close("in_shadow, facing the lamp", shadow, false, TOLERANCE)
        }),
        Law::of(
            "its_own_far_side_is",
            1,
            "A point on the far side of its own sphere is in shadow.",
            "The way to the lamp leads through the point's own sphere. Does that sphere count at all?",
        )
        .over(on_a_sphere(false), |&(own, p, light), program| {
            let shadow: bool = program.ask(arguments![p, light, vec![own]])?;
            close("in_shadow, behind its own sphere", shadow, true, TOLERANCE)
        }),
        Law::of(
            "something_between_is_shadow",
            2,
            "With a sphere on the way to the lamp the point is in shadow, wherever that sphere stands in the list.",
            "There is a sphere on the way. Which way does the ray go, how far, and is every sphere of the list asked?",
        )
        .over(with_another(2..=6), |&(own, other, p, light), program| {
            let shadow: bool = program.ask(arguments![p, light, vec![own, other]])?;
            close("in_shadow", shadow, true, TOLERANCE)?;
            let shadow: bool = program.ask(arguments![p, light, vec![other, own]])?;
            close("in_shadow, the list reversed", shadow, true, TOLERANCE)
        }),
        Law::of(
            "beyond_the_lamp_is_none",
            2,
            "A sphere beyond the lamp casts no shadow on the point.",
            "The sphere stands behind the lamp. At which t is the lamp?",
        )
        .over(with_another(9..=24), |&(own, other, p, light), program| {
            let shadow: bool = program.ask(arguments![p, light, vec![own, other]])?;
            close("in_shadow", shadow, false, TOLERANCE)
        }),
        Law::of(
            "behind_the_point_is_none",
            1,
            "A sphere behind the point, seen from the lamp, casts no shadow on it.",
            "The sphere lies on the line, but not between point and lamp. Which t has it?",
        )
        .over(with_another(-24..=-1), |&(_, other, p, light), program| {
            let shadow: bool = program.ask(arguments![p, light, vec![other]])?;
            close("in_shadow", shadow, false, TOLERANCE)
        }),
        Law::of(
            "beside_the_way_is_none",
            1,
            "A sphere that the way to the lamp passes by casts no shadow on the point.",
            "The way to the lamp does not meet the sphere. What does a discriminant below 0 say?",
        )
        .over(beside_the_way(), |&(p, light, other), program| {
            let shadow: bool = program.ask(arguments![p, light, vec![other]])?;
            close("in_shadow", shadow, false, TOLERANCE)
        }),
        Law::of(
            "seen_from_the_lamp_it_is_the_same",
            1,
            "If the lamp does not reach the point, a lamp at the point would not reach this lamp's place either.",
            "With point and lamp exchanged the answer changes, though the way between them is the same. What do you count beyond its ends?",
        )
        .over(in_the_open(), |(p, light, spheres), program| {
            let there: bool = program.ask(arguments![*p, *light, spheres.clone()])?;
            let back: bool = program.ask(arguments![*light, *p, spheres.clone()])?;
            close("in_shadow with point and lamp exchanged", back, there, TOLERANCE)
        }),
    ]
}

/// A point and a lamp, and a sphere beside the way: where the way passes its centre it is a quarter or more from the surface.
fn beside_the_way() -> impl Strategy<Value = (Vec3, Vec3, Sphere)> + Clone {
    (point3(6), point3(6), 1..=7, unit_vector(), radius(), 1..=4)
        .prop_map(|(p, light, eighths, any, radius, quarters)| {
            let way = light - p;
            let aside = (radius + quarters as f32 / 4.0) * way.cross(any).normalize_or_zero();
            (p, light, Sphere { center: p + eighths as f32 / 8.0 * way + aside, radius })
        })
        .prop_filter("on the way", |(p, light, sphere)| {
            p.distance(*light) >= 1.0 && height(p.as_dvec3(), sphere) > 0.1 && decided(*p, *light, &[*sphere])
        })
        .prop_filter("met", |(p, light, sphere)| {
            crossings(&Ray { origin: *p, direction: *light - *p }, sphere).is_none()
        })
}

/// Two places in the open, and spheres anywhere.
fn in_the_open() -> impl Strategy<Value = (Vec3, Vec3, Vec<Sphere>)> + Clone {
    (point3(6), point3(6), proptest::collection::vec(sphere(4), 1..=3)).prop_filter(
        "close to a tie",
        |(p, light, spheres)| {
            let open = spheres.iter().all(|sphere| height(p.as_dvec3(), sphere) > 0.1);
            open && p.distance(*light) >= 1.0 && decided(*p, *light, spheres)
        },
    )
}

fn slide(point: Vec3, light: Vec3, spheres: &[Sphere]) -> bool {
    let to_light = light - point;
    spheres.iter().any(|sphere| {
        let from_center = point - sphere.center;
        let a = to_light.length_squared();
        let b = to_light.dot(from_center);
        let c = from_center.length_squared() - sphere.radius * sphere.radius;
        let discriminant = b * b - a * c;
        if discriminant < 0.0 {
            return false;
        }
        let root = discriminant.sqrt();
        [(-b - root) / a, (-b + root) / a].into_iter().any(|t| 0.001 < t && t < 1.0)
    })
}

fn in_units_of_length(point: Vec3, light: Vec3, spheres: &[Sphere]) -> bool {
    // Start and end are moved instead of the interval.
    let distance = point.distance(light);
    let direction = (light - point) / distance;
    let start = point + 0.001 * distance * direction;
    for sphere in spheres {
        let nearest = direction.dot(sphere.center - start);
        let squared = sphere.radius.powi(2) - (start + nearest * direction).distance_squared(sphere.center);
        let half = squared.max(0.0).sqrt();
        for s in [nearest - half, nearest + half] {
            if squared > 0.0 && 0.0 < s && s < 0.999 * distance {
                return true;
            }
        }
    }
    false
}

fn nearest_point_of_the_way(point: Vec3, light: Vec3, spheres: &[Sphere]) -> bool {
    // Both ends are outside or on the surface: a sphere is on the way if the way's point nearest to its centre is inside.
    let way = light - point;
    spheres.iter().any(|sphere| {
        let t = ((sphere.center - point).dot(way) / way.length_squared()).clamp(0.001, 1.0);
        (point + t * way).distance(sphere.center) < 0.9999 * sphere.radius
    })
}

fn misconceptions() -> Vec<Misconception> {
    vec![
        Misconception {
            program: program!(no_offset),
            looks_like: "the ray is stopped by the very surface that it starts from",
            help: "Rounding leaves a crossing at a tiny t > 0. Count only those with t > 0.001.",
        },
        Misconception {
            program: program!(to_infinity),
            looks_like: "the ray does not end at the lamp",
            help: "What stands behind the lamp casts no shadow: with direction l − p only crossings with t < 1 count.",
        },
        Misconception {
            program: program!(the_whole_line),
            looks_like: "spheres behind the point count too",
            help: "t < 0 lies on the side away from the lamp. Do not take the absolute value, and look at t itself, not only at the discriminant.",
        },
        Misconception {
            program: program!(first_sphere_only),
            looks_like: "only the first sphere of the list is asked",
            help: "Return false only after all spheres were tried: any one of them can be in the way.",
        },
        Misconception {
            program: program!(away_from_the_lamp),
            looks_like: "the ray goes away from the lamp",
            help: "From p to l the direction is l − p, not p − l.",
        },
        Misconception {
            program: program!(ends_after_one_unit),
            looks_like: "the direction has length 1 and the ray still ends at t = 1",
            help: "With a direction of length 1, t is a length: the lamp is at t = |l − p|. Keep l − p as it is, or end there.",
        },
        Misconception {
            program: program!(no_way_past),
            looks_like: "a sphere that the way passes by counts as met",
            help: "A discriminant below 0 says that the line passes the sphere by. Made positive, its root gives a t where nothing is \
                crossed.",
        },
        Misconception {
            program: program!(own_sphere_left_out),
            looks_like: "the sphere that the point is on is left out",
            help: "A sphere does shade its own far side. Leave out the crossing at the point, not the whole sphere.",
        },
    ]
}

fn no_offset(point: Vec3, light: Vec3, spheres: &[Sphere]) -> bool {
    let direction = light - point;
    spheres.iter().any(|sphere| {
        let from_center = point - sphere.center;
        let (a, b) = (direction.length_squared(), direction.dot(from_center));
        let root = (b * b - a * (from_center.length_squared() - sphere.radius * sphere.radius)).sqrt();
        [(-b - root) / a, (-b + root) / a].into_iter().any(|t| 0.0 < t && t < 1.0)
    })
}

fn to_infinity(point: Vec3, light: Vec3, spheres: &[Sphere]) -> bool {
    let direction = light - point;
    spheres.iter().any(|sphere| {
        let from_center = point - sphere.center;
        let (a, b) = (direction.length_squared(), direction.dot(from_center));
        let root = (b * b - a * (from_center.length_squared() - sphere.radius * sphere.radius)).sqrt();
        [(-b - root) / a, (-b + root) / a].into_iter().any(|t| t > 0.001)
    })
}

fn the_whole_line(point: Vec3, light: Vec3, spheres: &[Sphere]) -> bool {
    let direction = light - point;
    spheres.iter().any(|sphere| {
        let from_center = point - sphere.center;
        let (a, b) = (direction.length_squared(), direction.dot(from_center));
        let root = (b * b - a * (from_center.length_squared() - sphere.radius * sphere.radius)).sqrt();
        [(-b - root) / a, (-b + root) / a].into_iter().any(|t| 0.001 < t.abs() && t < 1.0)
    })
}

fn first_sphere_only(point: Vec3, light: Vec3, spheres: &[Sphere]) -> bool {
    let direction = light - point;
    spheres.iter().take(1).any(|sphere| {
        let from_center = point - sphere.center;
        let (a, b) = (direction.length_squared(), direction.dot(from_center));
        let root = (b * b - a * (from_center.length_squared() - sphere.radius * sphere.radius)).sqrt();
        [(-b - root) / a, (-b + root) / a].into_iter().any(|t| 0.001 < t && t < 1.0)
    })
}

fn away_from_the_lamp(point: Vec3, light: Vec3, spheres: &[Sphere]) -> bool {
    let direction = point - light;
    spheres.iter().any(|sphere| {
        let from_center = point - sphere.center;
        let (a, b) = (direction.length_squared(), direction.dot(from_center));
        let root = (b * b - a * (from_center.length_squared() - sphere.radius * sphere.radius)).sqrt();
        [(-b - root) / a, (-b + root) / a].into_iter().any(|t| 0.001 < t && t < 1.0)
    })
}

fn ends_after_one_unit(point: Vec3, light: Vec3, spheres: &[Sphere]) -> bool {
    let direction = (light - point).normalize();
    spheres.iter().any(|sphere| {
        let from_center = point - sphere.center;
        let (a, b) = (direction.length_squared(), direction.dot(from_center));
        let root = (b * b - a * (from_center.length_squared() - sphere.radius * sphere.radius)).sqrt();
        [(-b - root) / a, (-b + root) / a].into_iter().any(|t| 0.001 < t && t < 1.0)
    })
}

fn own_sphere_left_out(point: Vec3, light: Vec3, spheres: &[Sphere]) -> bool {
    let direction = light - point;
    spheres.iter().any(|sphere| {
        if (point.distance(sphere.center) - sphere.radius).abs() < 1e-3 {
            return false;
        }
        let from_center = point - sphere.center;
        let (a, b) = (direction.length_squared(), direction.dot(from_center));
        let root = (b * b - a * (from_center.length_squared() - sphere.radius * sphere.radius)).sqrt();
        [(-b - root) / a, (-b + root) / a].into_iter().any(|t| 0.001 < t && t < 1.0)
    })
}

fn no_way_past(point: Vec3, light: Vec3, spheres: &[Sphere]) -> bool {
    let direction = light - point;
    spheres.iter().any(|sphere| {
        let from_center = point - sphere.center;
        let (a, b) = (direction.length_squared(), direction.dot(from_center));
        let root = (b * b - a * (from_center.length_squared() - sphere.radius * sphere.radius)).abs().sqrt();
        [(-b - root) / a, (-b + root) / a].into_iter().any(|t| 0.001 < t && t < 1.0)
    })
}
