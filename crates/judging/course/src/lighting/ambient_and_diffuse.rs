//! Ambient light added to diffuse reflection: no shadow is quite black (L28).

use glam::{Vec3, vec3};
use testkit::by_hand::{colour, light_colour, normal_and_direction};

use crate::exercise::{arguments, signature};
use crate::{Concept, Example, Exercise, Law, Misconception, Title, close};

const STUB: &str = r#"//! Ambient light and diffuse reflection (L28).
//!
//! A surface that faces away from the lamp is black, which looks too hard. Ambient light comes from everywhere at once:
//!
//!     c = c_r · (c_a + c_l · max(0, n·l))
//!
//! - `c_r`: what share of light the surface scatters, each between 0 and 1.
//! - `c_a`, `c_l`: the colours of the ambient light and of the lamp, linear RGB; they may be brighter than 1.
//! - `n`, `to_light`: unit vectors; the normal, and l, from the surface towards the light.
//! - Colours have no upper end: do not clamp the result.
//!
//! glam: `a.dot(b)`, `f32::max`; `a * b` of two vectors multiplies channel by channel.

use glam::Vec3;

pub fn ambient_and_diffuse(c_r: Vec3, c_a: Vec3, c_l: Vec3, n: Vec3, to_light: Vec3) -> Vec3 {
    todo!()
}
"#;

signature!((c_r: Vec3, c_a: Vec3, c_l: Vec3, n: Vec3, to_light: Vec3) -> Vec3);

/// n·l is off by at most 2⁻²², the light that arrives, at most 3 + 3, by 3 · 2⁻²² and two roundings of 6: 1.4e-6 in all, and
/// a c_r of at most 1 makes it no larger. Other orders of the same steps, and sums of two answers, get six times as much room.
const TOLERANCE: f32 = 1e-5;

pub(super) fn exercise() -> Exercise {
    Exercise {
        name: "ambient_and_diffuse",
        concept: Concept::Lighting,
        items: "L28, E8",
        title: Title { english: "Ambient light", dutch: "Omgevingslicht of ambient light" },
        prerequisites: &["lambert"],
        stub: STUB,
        signature: SIGNATURE,
        hints: [
            "Two lights fall on the surface. Which of them asks where the surface faces?",
            "First add up the light that arrives, c_a and the lamp's share; then the surface scatters its share of the sum.",
            "The lamp gives c_l * n.dot(to_light).max(0.0). Add c_a to that, then multiply all of it by c_r.",
        ],
        examples: examples(),
        laws: laws(),
        reference: program!(slide),
        variants: vec![program!(multiplied_out), program!(channel_by_channel)],
        misconceptions: misconceptions(),
        explanation: "c_a has no source and no direction: it stands in for all the light that bounces about in a room, and it is set by \
            trying until it looks right. A grey surface of 0.8 under 0.2 + 1 gives 0.96; a bright lamp gives more than 1, which is \
            nobody's mistake (E8).",
        draw: super::drawing::ambient_and_diffuse,
        source: include_str!("ambient_and_diffuse.rs"),
    }
}

fn examples() -> Vec<Example> {
    let grey = Vec3::splat(0.8);
    vec![
        Example::new(
            "the lecture's numbers: c_r = 0.8, c_a = 0.2, c_l = 1, head-on",
            arguments![grey, Vec3::splat(0.2), Vec3::ONE, Vec3::Z, Vec3::Z],
            Vec3::splat(0.96),
            TOLERANCE,
        ),
        Example::new(
            "facing away, only ambient light is left",
            arguments![
                vec3(0.5, 0.25, 1.0),
                vec3(0.2, 0.4, 0.1),
                Vec3::ONE,
                Vec3::NEG_Z,
                vec3(0.6, 0.0, 0.8)
            ],
            vec3(0.1, 0.1, 0.1),
            TOLERANCE,
        ),
    ]
}

fn laws() -> Vec<Law> {
    let lights = (colour(), colour(), light_colour(), normal_and_direction());
    vec![
        Law::of(
            "in_the_dark_only_ambient_light",
            2,
            "Where the surface faces away from the lamp, c = c_r·c_a.",
            "The lamp still has a say where its light does not arrive, or the ambient light has not: what is the sum there?",
        )
        .over(lights.clone(), |&(c_r, c_a, c_l, (n, to_light)), program| {
            let n = if n.dot(to_light) > 0.0 { -n } else { n };
            let c: Vec3 = program.ask(arguments![c_r, c_a, c_l, n, to_light])?;
            close("c", c, c_r * c_a, TOLERANCE)
        }),
        Law::of(
            "without_ambient_light_it_is_lambert",
            2,
            "With c_a = 0, c = c_r·c_l·max(0, n·l), as before.",
            "Ambient light is switched off here: what is left should be the formula of the exercise `lambert`.",
        )
        .over(lights.clone(), |&(c_r, _, c_l, (n, to_light)), program| {
            let c: Vec3 = program.ask(arguments![c_r, Vec3::ZERO, c_l, n, to_light])?;
            let cosine = n.as_dvec3().dot(to_light.as_dvec3()).max(0.0);
            close("c", c, (c_r.as_dvec3() * c_l.as_dvec3() * cosine).as_vec3(), TOLERANCE)
        }),
        Law::of(
            "ambient_light_has_no_direction",
            3,
            "Ambient light adds c_r·c_a, wherever the lamp stands.",
            "What ambient light adds depends on the lamp: which part of the formula does the cosine belong to?",
        )
        .over(lights.clone(), |&(c_r, c_a, c_l, (n, to_light)), program| {
            let with: Vec3 = program.ask(arguments![c_r, c_a, c_l, n, to_light])?;
            let without: Vec3 = program.ask(arguments![c_r, Vec3::ZERO, c_l, n, to_light])?;
            close("what ambient light adds", with - without, c_r * c_a, TOLERANCE)
        }),
        Law::of(
            "black_stays_black",
            1,
            "A surface that scatters nothing, c_r = 0, is black in any light.",
            "Light came from a surface that scatters none: is all light multiplied by c_r?",
        )
        .over(lights, |&(_, c_a, c_l, (n, to_light)), program| {
            let c: Vec3 = program.ask(arguments![Vec3::ZERO, c_a, c_l, n, to_light])?;
            close("c", c, Vec3::ZERO, TOLERANCE)
        }),
    ]
}

fn slide(c_r: Vec3, c_a: Vec3, c_l: Vec3, n: Vec3, to_light: Vec3) -> Vec3 {
    c_r * (c_a + c_l * n.dot(to_light).max(0.0))
}

fn multiplied_out(c_r: Vec3, c_a: Vec3, c_l: Vec3, n: Vec3, to_light: Vec3) -> Vec3 {
    let ambient = c_r * c_a;
    let cosine = n.dot(to_light);
    if cosine > 0.0 { ambient + cosine * c_r * c_l } else { ambient }
}

fn channel_by_channel(c_r: Vec3, c_a: Vec3, c_l: Vec3, n: Vec3, to_light: Vec3) -> Vec3 {
    let facing = (n * to_light).element_sum().clamp(0.0, 1.0);
    let channel = |k: usize| c_r[k] * c_l[k].mul_add(facing, c_a[k]);
    Vec3::from_array(std::array::from_fn(channel))
}

fn misconceptions() -> Vec<Misconception> {
    vec![
        Misconception {
            program: program!(not_scattered),
            looks_like: "ambient light is not multiplied by c_r",
            help: "Ambient light is light too: of it, too, the surface scatters only its share c_r. The bracket stands around the whole sum.",
        },
        Misconception {
            program: program!(also_by_the_cosine),
            looks_like: "ambient light falls off with the angle as well",
            help: "Ambient light comes from everywhere: the cosine belongs to c_l alone.",
        },
        Misconception {
            program: program!(maximum_around_the_sum),
            looks_like: "the maximum stands around the whole sum",
            help: "A negative n·l must not eat up the ambient light: the maximum belongs to n·l, before anything is added.",
        },
        Misconception {
            program: program!(only_in_the_dark),
            looks_like: "ambient light shines only where the lamp does not",
            help: "Ambient light is everywhere, on the lit side too: it is added, not a replacement.",
        },
        Misconception {
            program: program!(the_brighter_one),
            looks_like: "the brighter of the two lights is taken",
            help: "Light adds up: the ambient light and the lamp's arrive both.",
        },
        Misconception {
            program: program!(without_the_maximum),
            looks_like: "n·l is used where it is negative",
            help: "Where the surface faces away, n·l is below 0. max(0, n·l) makes that no light.",
        },
        Misconception {
            program: program!(clamped),
            looks_like: "the colour is clamped to 1",
            help: "Linear colours have no upper end (E8): clamping happens once, when the picture is written.",
        },
    ]
}

fn not_scattered(c_r: Vec3, c_a: Vec3, c_l: Vec3, n: Vec3, to_light: Vec3) -> Vec3 {
    c_a + c_r * c_l * n.dot(to_light).max(0.0)
}

fn also_by_the_cosine(c_r: Vec3, c_a: Vec3, c_l: Vec3, n: Vec3, to_light: Vec3) -> Vec3 {
    c_r * (c_a + c_l) * n.dot(to_light).max(0.0)
}

fn maximum_around_the_sum(c_r: Vec3, c_a: Vec3, c_l: Vec3, n: Vec3, to_light: Vec3) -> Vec3 {
    c_r * (c_a + c_l * n.dot(to_light)).max(Vec3::ZERO)
}

fn only_in_the_dark(c_r: Vec3, c_a: Vec3, c_l: Vec3, n: Vec3, to_light: Vec3) -> Vec3 {
    if n.dot(to_light) > 0.0 { c_r * c_l * n.dot(to_light) } else { c_r * c_a }
}

fn the_brighter_one(c_r: Vec3, c_a: Vec3, c_l: Vec3, n: Vec3, to_light: Vec3) -> Vec3 {
    c_r * (c_l * n.dot(to_light).max(0.0)).max(c_a)
}

fn without_the_maximum(c_r: Vec3, c_a: Vec3, c_l: Vec3, n: Vec3, to_light: Vec3) -> Vec3 {
    c_r * (c_a + c_l * n.dot(to_light))
}

fn clamped(c_r: Vec3, c_a: Vec3, c_l: Vec3, n: Vec3, to_light: Vec3) -> Vec3 {
    (c_r * (c_a + c_l * n.dot(to_light).max(0.0))).min(Vec3::ONE)
}
