//! All lights together: each adds what it would give alone (L32, L24).

use glam::{DVec3, Vec3, vec3};
use proptest::prelude::*;
use testkit::by_hand::{
    colour, exponent, light_colour, normal_and_direction, point3, unit_vector, unit_vector_above,
};
use vocabulary::{Light, Material, SurfacePoint};

use crate::exercise::{arguments, signature};
use crate::{Concept, Example, Exercise, Law, Misconception, Title, close};

const STUB: &str = r#"//! Phong's lighting model with several lights (L32, L24).
//!
//! Give the colour of a point of a surface in ambient light and the light of all lamps together:
//!
//!     c = c_r · c_a + Σ ( c_r · c_l · max(0, n·l) + c_l · max(0, e·r)^p )        where r = 2 (n·l) n − l
//!
//! - `material`: c_r is `material.diffuse`, p is `material.exponent`, at least 1.
//! - `c_a`: the colour of the ambient light. It shines once, however many lamps there are.
//! - `lights`: for a `Light::Directional`, l is its `to_light`; for a `Light::Point`, l is the unit vector from the point of
//!   the surface to its `position`. c_l is its `colour`: light does not fall off with distance here (E6). No lamp stands
//!   at the point itself. The list may be empty.
//! - `at`: where the point is, its unit normal n, and e, the unit vector to the eye. All is in world space.
//! - A light behind the surface, n·l ≤ 0, adds nothing, no highlight either (E3).
//! - Colours have no upper end: do not clamp the sum (E8).
//!
//! glam: `a.dot(b)`, `v.normalize()`; std: `match`, `f32::powf`, `f32::max`.

use glam::Vec3;
use vocabulary::{Light, Material, SurfacePoint};

pub fn light_all(material: Material, c_a: Vec3, lights: &[Light], at: SurfacePoint) -> Vec3 {
    todo!()
}
"#;

signature!((material: Material, c_a: Vec3, lights: &[Light], at: SurfacePoint) -> Vec3);

/// One light's share is off by at most 1e-4: e·r by 2⁻²⁰, its p-th power by p times that with p ≤ 32, times a c_l of at most 3.
/// The direction to a point light is rounded once more, which doubles that. At most 6 lights: 6 · 2e-4 where none is brighter
/// than 1, and differences count relative to sums above 1.
const TOLERANCE: f32 = 1e-3;

pub(super) fn exercise() -> Exercise {
    Exercise {
        name: "light_all",
        concept: Concept::Lighting,
        items: "L32, L24, E3, E6, E8",
        title: Title {
            english: "All lights together",
            dutch: "Phong belichtingsmodel met meer lichtbronnen",
        },
        prerequisites: &["blinn_phong"],
        stub: STUB,
        signature: SIGNATURE,
        hints: [
            "Light adds up: what would each lamp give alone, without ambient light? And what is there without any lamp?",
            "Begin with material.diffuse * c_a. For each light find l and c_l with a `match`, then add its diffuse share and its highlight.",
            "For a point light l is (position - at.position).normalize(). Skip the light if at.n.dot(l) <= 0.0; else add \
                c_l * (material.diffuse * n·l + max(0, e·r)^p).",
        ],
        examples: examples(),
        laws: laws(),
        reference: program!(slide),
        variants: vec![program!(as_a_sum_of_parts), program!(with_the_eye_mirrored)],
        misconceptions: misconceptions(),
        explanation: "Light adds up, so the sum may be above 1: 0.8·(0.2 + 1) + 1 = 1.96 (E8). Whoever clamps each lamp changes the hue: \
            clamp once, at output. A lamp does not grow dim with distance here, for the lecture gives no falloff; the light of a real one \
            falls with the square.",
        draw: super::drawing::light_all,
        source: include_str!("light_all.rs"),
    }
}

fn examples() -> Vec<Example> {
    let grey = Material { diffuse: Vec3::splat(0.8), exponent: 32.0 };
    let red = Material { diffuse: vec3(0.5, 0.25, 0.25), exponent: 8.0 };
    let above = |position| SurfacePoint { position, n: Vec3::Z, to_eye: Vec3::Z };
    let sun = Light::Directional { to_light: Vec3::Z, colour: Vec3::ONE };
    let lamp = Light::Point { position: vec3(4.0, 2.0, 3.0), colour: vec3(1.0, 2.0, 1.0) };
    // l = (0.6, 0, 0.8) at (1, 2, −1); the eye in the mirror direction.
    let aside = SurfacePoint { position: vec3(1.0, 2.0, -1.0), n: Vec3::Z, to_eye: vec3(-0.6, 0.0, 0.8) };
    vec![
        Example::new(
            "the lecture's numbers, all head-on: 0.8·(0.2 + 1) + 1, above 1 (E8)",
            arguments![grey, Vec3::splat(0.2), vec![sun], above(Vec3::ZERO)],
            Vec3::splat(1.96),
            TOLERANCE,
        ),
        Example::new(
            "no lamp",
            arguments![red, Vec3::splat(0.5), Vec::<Light>::new(), above(vec3(1.0, 2.0, 3.0))],
            vec3(0.25, 0.125, 0.125),
            TOLERANCE,
        ),
        Example::new(
            "a lamp 5 away, n·l = 0.8, the eye in the mirror direction",
            arguments![red, Vec3::ZERO, vec![lamp], aside],
            vec3(1.4, 2.4, 1.2),
            TOLERANCE,
        ),
        Example::new(
            "the light on the horizon, n·l = 0, the eye in the mirror direction: nothing but ambient light (E3)",
            arguments![
                red,
                Vec3::splat(0.5),
                vec![Light::Directional { to_light: Vec3::X, colour: Vec3::ONE }],
                SurfacePoint { position: Vec3::ZERO, n: Vec3::Z, to_eye: Vec3::NEG_X }
            ],
            vec3(0.25, 0.125, 0.125),
            TOLERANCE,
        ),
    ]
}

fn material() -> impl Strategy<Value = Material> + Clone {
    (colour(), exponent()).prop_map(|(diffuse, exponent)| Material { diffuse, exponent })
}

/// A point with an eye above the surface, high or low.
fn point() -> impl Strategy<Value = SurfacePoint> + Clone {
    let low = normal_and_direction().prop_map(|(n, v)| {
        let along = (v - n.dot(v) * n).try_normalize().unwrap_or_else(|| n.any_orthonormal_vector());
        (n, (along + 0.15 * n).normalize())
    });
    let anywhere = unit_vector().prop_flat_map(|n| (Just(n), unit_vector_above(n)));
    (point3(2), prop_oneof![low, anywhere]).prop_map(|(position, (n, to_eye))| SurfacePoint {
        position,
        n,
        to_eye,
    })
}

/// A direction to a light, above the surface more often than below; often not far from where the eye sees it mirrored, or just
/// set, so that only the condition n·l > 0 keeps its highlight away.
fn way_to_light(at: SurfacePoint) -> impl Strategy<Value = Vec3> + Clone {
    let mirrored = 2.0 * at.n.dot(at.to_eye) * at.n - at.to_eye;
    let near = unit_vector().prop_map(move |aside| (mirrored + 0.4 * aside).normalize());
    let just_set = (mirrored - (mirrored.dot(at.n) + 0.1) * at.n).normalize();
    prop_oneof![near, unit_vector_above(at.n), unit_vector(), Just(just_set)]
        .prop_filter("grazing", move |l| l.dot(at.n).abs() > 0.01)
}

/// A light, of one kind or the other, at most 6 away.
fn light(at: SurfacePoint) -> impl Strategy<Value = Light> + Clone {
    (way_to_light(at), testkit::by_hand::between(1, 6), light_colour(), any::<bool>()).prop_map(
        move |(to_light, distance, colour, far)| {
            if far {
                Light::Directional { to_light, colour }
            } else {
                Light::Point { position: at.position + distance * to_light, colour }
            }
        },
    )
}

fn lights(at: SurfacePoint) -> impl Strategy<Value = Vec<Light>> + Clone {
    prop::collection::vec(light(at), 0..=3)
}

/// A point with one way to a light.
fn one_light() -> impl Strategy<Value = (SurfacePoint, Vec3)> + Clone {
    point().prop_flat_map(|at| (Just(at), way_to_light(at)))
}

/// A point with two lists of lights.
fn two_lists() -> impl Strategy<Value = (SurfacePoint, Vec<Light>, Vec<Light>)> + Clone {
    point().prop_flat_map(|at| (Just(at), lights(at), lights(at)))
}

fn laws() -> Vec<Law> {
    vec![
        Law::of(
            "light_adds_up",
            3,
            "The lamps of two lists together give what each list gives, less the ambient light that was counted twice.",
            "Adding a lamp changed what the others give: is anything clamped, divided or begun anew for each lamp?",
        )
        .over((material(), colour(), two_lists()), |(material, c_a, (at, one, other)), program| {
            let both: Vec<Light> = one.iter().chain(other).copied().collect();
            let c_1: Vec3 = program.ask(arguments![*material, *c_a, one.clone(), *at])?;
            let c_2: Vec3 = program.ask(arguments![*material, *c_a, other.clone(), *at])?;
            let c: Vec3 = program.ask(arguments![*material, *c_a, both, *at])?;
            close("c", c, c_1 + c_2 - material.diffuse * *c_a, TOLERANCE)
        }),
        Law::of(
            "one_light_by_phongs_model",
            3,
            "One directional light gives c_r·(c_a + c_l·max(0, n·l)) + c_l·max(0, e·r)^p, and c_r·c_a if it is behind the surface.",
            "With a single lamp the colour is already another: compare it with the formula, term by term.",
        )
        .over((material(), colour(), light_colour(), one_light()), |&(material, c_a, c_l, (at, l)), program| {
            let sun = Light::Directional { to_light: l, colour: c_l };
            let c: Vec3 = program.ask(arguments![material, c_a, vec![sun], at])?;
            close("c", c, phong(material, c_a, c_l, at, l), TOLERANCE)
        }),
        Law::of(
            "from_a_point_as_from_afar",
            2,
            "A point light gives what a directional one gives whose light comes from the same side, however near it is.",
            "A lamp does not shine as the sun from its direction: from where to where runs l, how long is it, does light get lost on the way?",
        )
        .over(
            (material(), light_colour(), one_light(), testkit::by_hand::between(1, 6)),
            |&(material, colour, (at, l), distance), program| {
                let lamp = Light::Point { position: at.position + distance * l, colour };
                let sun = Light::Directional { to_light: l, colour };
                let near: Vec3 = program.ask(arguments![material, Vec3::ZERO, vec![lamp], at])?;
                let far: Vec3 = program.ask(arguments![material, Vec3::ZERO, vec![sun], at])?;
                close("c of a point light", near, far, TOLERANCE)
            },
        ),
        Law::of(
            "order_does_not_matter",
            1,
            "The lamps in another order give the same.",
            "The first or the last lamp has more say than the others: is every one added?",
        )
        .over((material(), two_lists()), |(material, (at, one, other)), program| {
            let forwards: Vec<Light> = one.iter().chain(other).copied().collect();
            let backwards: Vec<Light> = forwards.iter().rev().copied().collect();
            let c: Vec3 = program.ask(arguments![*material, Vec3::ZERO, forwards, *at])?;
            let reversed: Vec3 = program.ask(arguments![*material, Vec3::ZERO, backwards, *at])?;
            close("c in the other order", reversed, c, TOLERANCE)
        }),
    ]
}

/// L32 in twice as many digits.
fn phong(material: Material, c_a: Vec3, c_l: Vec3, at: SurfacePoint, to_light: Vec3) -> Vec3 {
    let [n, e, l] = [at.n, at.to_eye, to_light].map(|v| v.as_dvec3());
    let (c_r, c_a, c_l) = (material.diffuse.as_dvec3(), c_a.as_dvec3(), c_l.as_dvec3());
    let facing = n.dot(l);
    let r = 2.0 * facing * n - l;
    let (diffuse, highlight) = if facing > 0.0 {
        (c_r * c_l * facing, c_l * e.dot(r).max(0.0).powf(material.exponent.into()))
    } else {
        (DVec3::ZERO, DVec3::ZERO)
    };
    (c_r * c_a + diffuse + highlight).as_vec3()
}

fn slide(material: Material, c_a: Vec3, lights: &[Light], at: SurfacePoint) -> Vec3 {
    let mut c = material.diffuse * c_a;
    for light in lights {
        let (to_light, c_l) = match *light {
            Light::Point { position, colour } => ((position - at.position).normalize(), colour),
            Light::Directional { to_light, colour } => (to_light, colour),
        };
        let facing = at.n.dot(to_light);
        if facing > 0.0 {
            let r = 2.0 * facing * at.n - to_light;
            c += c_l * (material.diffuse * facing + at.to_eye.dot(r).max(0.0).powf(material.exponent));
        }
    }
    c
}

fn as_a_sum_of_parts(material: Material, c_a: Vec3, lights: &[Light], at: SurfacePoint) -> Vec3 {
    let arriving: Vec<(Vec3, Vec3)> = lights
        .iter()
        .map(|light| match light {
            Light::Point { position, colour } => ((*position - at.position).normalize_or_zero(), *colour),
            Light::Directional { to_light, colour } => (*to_light, *colour),
        })
        .filter(|(to_light, _)| at.n.dot(*to_light) > 0.0)
        .collect();
    let scattered: Vec3 = arriving.iter().map(|(to_light, c_l)| at.n.dot(*to_light) * *c_l).sum();
    let mirrored = arriving.iter().map(|(to_light, c_l)| {
        let cosine = -at.to_eye.dot(to_light.reflect(at.n));
        if cosine > 0.0 { cosine.powf(material.exponent) * *c_l } else { Vec3::ZERO }
    });
    material.diffuse * (c_a + scattered) + mirrored.sum::<Vec3>()
}

/// The eye's mirror image is the same for all lights.
fn with_the_eye_mirrored(material: Material, c_a: Vec3, lights: &[Light], at: SurfacePoint) -> Vec3 {
    let mirrored = 2.0 * at.n.dot(at.to_eye) * at.n - at.to_eye;
    lights.iter().rev().fold(material.diffuse * c_a, |sum, light| {
        let (way, c_l) = match *light {
            Light::Point { position, colour } => (position - at.position, colour),
            Light::Directional { to_light, colour } => (to_light, colour),
        };
        let gate = if way.dot(at.n) > 0.0 { 1.0 } else { 0.0 };
        let [facing, sigma] = [at.n, mirrored].map(|v| (v.dot(way) / way.length()).max(0.0));
        sum + gate * (material.diffuse * facing + sigma.powf(material.exponent)) * c_l
    })
}

fn misconceptions() -> Vec<Misconception> {
    vec![
        Misconception {
            program: program!(ambient_light_for_each),
            looks_like: "ambient light is added once for each lamp",
            help: "c_a is one light for all: it belongs before the loop.",
        },
        Misconception {
            program: program!(sum_clamped),
            looks_like: "the sum is clamped to 1",
            help: "Linear colours have no upper end (E8): clamping happens once, when the picture is written.",
        },
        Misconception {
            program: program!(each_clamped),
            looks_like: "each lamp's share is clamped to 1",
            help: "A lamp may be brighter than 1, and keeps its hue only if no channel is cut off.",
        },
        Misconception {
            program: program!(the_average),
            looks_like: "the sum is divided by the number of lamps",
            help: "A second lamp makes a room brighter: light adds up, it is not averaged.",
        },
        Misconception {
            program: program!(the_last_one),
            looks_like: "only the last lamp counts",
            help: "Each lamp is added to the sum: `+=`, not `=`.",
        },
        Misconception {
            program: program!(position_as_direction),
            looks_like: "a point light's position is taken for its direction",
            help: "l runs from the point of the surface to the lamp: position − at.position, then made 1 long.",
        },
        Misconception {
            program: program!(direction_not_of_unit_length),
            looks_like: "the direction to a point light is not brought to unit length",
            help: "n·l is a cosine only for unit vectors: `normalize` what leads to the lamp.",
        },
        Misconception {
            program: program!(weaker_with_distance),
            looks_like: "light falls off with the square of the distance",
            help: "That is what real light does, but not in this lecture (E6): c_l arrives as it is.",
        },
        Misconception {
            program: program!(without_the_gate),
            looks_like: "a light behind the surface gives a highlight",
            help: "n·l > 0 is asked for once a lamp, before its diffuse share and its highlight (E3).",
        },
    ]
}

// Each of the wrong programs differs from the slide's in one place. What they have in common stands here once, so that the place is seen.

/// The direction to a light, and what arrives from it.
fn arriving(light: &Light, at: SurfacePoint) -> (Vec3, Vec3) {
    match *light {
        Light::Point { position, colour } => ((position - at.position).normalize(), colour),
        Light::Directional { to_light, colour } => (to_light, colour),
    }
}

/// What the surface sends to the eye of that.
fn lit(material: Material, at: SurfacePoint, (to_light, c_l): (Vec3, Vec3)) -> Vec3 {
    let facing = at.n.dot(to_light).max(0.0);
    let r = 2.0 * facing * at.n - to_light;
    let highlight = if facing > 0.0 { at.to_eye.dot(r).max(0.0).powf(material.exponent) } else { 0.0 };
    c_l * (material.diffuse * facing + highlight)
}

fn ambient_light_for_each(material: Material, c_a: Vec3, lights: &[Light], at: SurfacePoint) -> Vec3 {
    lights.iter().map(|light| material.diffuse * c_a + lit(material, at, arriving(light, at))).sum()
}

fn sum_clamped(material: Material, c_a: Vec3, lights: &[Light], at: SurfacePoint) -> Vec3 {
    let sum: Vec3 = lights.iter().map(|light| lit(material, at, arriving(light, at))).sum();
    (material.diffuse * c_a + sum).min(Vec3::ONE)
}

fn each_clamped(material: Material, c_a: Vec3, lights: &[Light], at: SurfacePoint) -> Vec3 {
    let sum: Vec3 = lights.iter().map(|light| lit(material, at, arriving(light, at)).min(Vec3::ONE)).sum();
    material.diffuse * c_a + sum
}

fn the_average(material: Material, c_a: Vec3, lights: &[Light], at: SurfacePoint) -> Vec3 {
    let sum: Vec3 = lights.iter().map(|light| lit(material, at, arriving(light, at))).sum();
    material.diffuse * c_a + sum / lights.len().max(1) as f32
}

fn the_last_one(material: Material, c_a: Vec3, lights: &[Light], at: SurfacePoint) -> Vec3 {
    let last = lights.last().map(|light| lit(material, at, arriving(light, at)));
    material.diffuse * c_a + last.unwrap_or(Vec3::ZERO)
}

fn position_as_direction(material: Material, c_a: Vec3, lights: &[Light], at: SurfacePoint) -> Vec3 {
    let wrong = |light: &Light| match *light {
        Light::Point { position, colour } => (position.normalize(), colour),
        Light::Directional { .. } => arriving(light, at),
    };
    let sum: Vec3 = lights.iter().map(|light| lit(material, at, wrong(light))).sum();
    material.diffuse * c_a + sum
}

fn direction_not_of_unit_length(material: Material, c_a: Vec3, lights: &[Light], at: SurfacePoint) -> Vec3 {
    let wrong = |light: &Light| match *light {
        Light::Point { position, colour } => (position - at.position, colour),
        Light::Directional { .. } => arriving(light, at),
    };
    lights.iter().fold(material.diffuse * c_a, |sum, light| sum + lit(material, at, wrong(light)))
}

fn weaker_with_distance(material: Material, c_a: Vec3, lights: &[Light], at: SurfacePoint) -> Vec3 {
    let wrong = |light: &Light| match *light {
        Light::Point { position, colour } => {
            let way = position - at.position;
            (way.normalize(), colour / way.length_squared())
        }
        Light::Directional { .. } => arriving(light, at),
    };
    let sum: Vec3 = lights.iter().map(|light| lit(material, at, wrong(light))).sum();
    material.diffuse * c_a + sum
}

fn without_the_gate(material: Material, c_a: Vec3, lights: &[Light], at: SurfacePoint) -> Vec3 {
    let mut c = material.diffuse * c_a;
    for light in lights {
        let (to_light, c_l) = arriving(light, at);
        let facing = at.n.dot(to_light);
        let r = 2.0 * facing * at.n - to_light;
        c += c_l * (material.diffuse * facing.max(0.0) + at.to_eye.dot(r).max(0.0).powf(material.exponent));
    }
    c
}
