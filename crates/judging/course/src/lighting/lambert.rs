//! Diffuse reflection: as much light as falls on the surface (L26, L27).

use glam::{Vec3, vec3};
use testkit::by_hand::{colour, light_colour, normal_and_direction, unit_vector};

use crate::exercise::{arguments, signature};
use crate::{Concept, Example, Exercise, Law, Misconception, Title, close};

const STUB: &str = r#"//! Diffuse or Lambertian reflection (L26, L27).
//!
//! Give the colour of a matt surface in the light of one lamp:
//!
//!     c = c_r · c_l · max(0, n·l)
//!
//! - `c_r`: what share of light the surface scatters, for red, green and blue; each between 0 and 1.
//! - `c_l`: the colour of the light, linear RGB; it may be brighter than 1.
//! - `n`, `to_light`: unit vectors; the normal, and l, from the surface towards the light.
//! - A surface that faces away from the light, n·l ≤ 0, is black. Colours have no upper end: do not clamp the result.
//!
//! glam: `a.dot(b)`, `f32::max`; `a * b` of two vectors multiplies channel by channel.

use glam::Vec3;

pub fn lambert(c_r: Vec3, c_l: Vec3, n: Vec3, to_light: Vec3) -> Vec3 {
    todo!()
}
"#;

signature!((c_r: Vec3, c_l: Vec3, n: Vec3, to_light: Vec3) -> Vec3);

/// A product of unit vectors is off by at most 2⁻²² (three products and two sums, and the vectors' own rounding), and is
/// multiplied by a c_r of at most 1 and a c_l of at most 6: 6 · 2⁻²² ≈ 1.5e-6. Other orders of the same steps get four times
/// as much room, a detour through the angle included: away from 0° its rounding is as small.
const TOLERANCE: f32 = 1e-5;

pub(super) fn exercise() -> Exercise {
    Exercise {
        name: "lambert",
        concept: Concept::Lighting,
        items: "L26, L27, E6",
        title: Title { english: "Diffuse reflection", dutch: "Diffuse of Lambertian reflectie" },
        prerequisites: &[],
        stub: STUB,
        signature: SIGNATURE,
        hints: [
            "How much light falls on a square metre that is tilted away from the lamp? The cosine of the angle between n and l says it.",
            "For unit vectors n·l is that cosine. It is negative where the surface faces away, and a surface cannot give less than no light.",
            "c_r * c_l multiplies channel by channel; that colour times n.dot(to_light).max(0.0) is the answer.",
        ],
        examples: examples(),
        laws: laws(),
        reference: program!(slide),
        variants: vec![program!(channel_by_channel), program!(by_the_angle), program!(dark_side_first)],
        misconceptions: misconceptions(),
        explanation: "The eye does not occur in the formula: a matt surface looks equally bright from everywhere. The slide says that the \
            colour is proportional to the angle (E6); it is to the cosine. At 60° half of the light is left, not a third.",
        draw: super::drawing::lambert,
        source: include_str!("lambert.rs"),
    }
}

fn examples() -> Vec<Example> {
    let c_r = vec3(0.5, 0.25, 1.0);
    let tilted = vec3(0.6, 0.0, 0.8);
    vec![
        Example::new(
            "white light straight from above",
            arguments![c_r, Vec3::ONE, Vec3::Z, Vec3::Z],
            c_r,
            TOLERANCE,
        ),
        Example::new(
            "n·l = 0.8",
            arguments![c_r, vec3(1.0, 2.0, 0.5), Vec3::Z, tilted],
            vec3(0.4, 0.4, 0.4),
            TOLERANCE,
        ),
        Example::new(
            "the surface faces away (Fig 10.2)",
            arguments![c_r, Vec3::ONE, Vec3::NEG_Z, tilted],
            Vec3::ZERO,
            TOLERANCE,
        ),
    ]
}

fn laws() -> Vec<Law> {
    vec![
        Law::of(
            "the_cosine_of_the_angle",
            3,
            "The colour is c_r·c_l times the cosine of the angle between n and l, where that is positive.",
            "The colour is another one: what is multiplied, and by which function of the angle?",
        )
        .over((colour(), light_colour(), normal_and_direction()), |&(c_r, c_l, (n, to_light)), program| {
            let c: Vec3 = program.ask(arguments![c_r, c_l, n, to_light])?;
            let cosine = n.as_dvec3().dot(to_light.as_dvec3()).max(0.0);
            close("c", c, (c_r.as_dvec3() * c_l.as_dvec3() * cosine).as_vec3(), TOLERANCE)
        }),
        Law::of(
            "black_when_facing_away",
            2,
            "A surface that faces away from the light is black.",
            "Light came through from behind, or less than none: what is n·l there, and what should become of it?",
        )
        .over((colour(), light_colour(), normal_and_direction()), |&(c_r, c_l, (n, to_light)), program| {
            let n = if n.dot(to_light) > 0.0 { -n } else { n };
            let c: Vec3 = program.ask(arguments![c_r, c_l, n, to_light])?;
            close("c", c, Vec3::ZERO, TOLERANCE)
        }),
        Law::of(
            "light_adds_up",
            2,
            "Two lamps in the same place give what each gives alone, added.",
            "Light was lost or found: is the light multiplied with the surface's colour, and is anything cut off at 1?",
        )
        .over(
            (colour(), light_colour(), light_colour(), normal_and_direction()),
            |&(c_r, c_1, c_2, (n, to_light)), program| {
                let n = if n.dot(to_light) < 0.0 { -n } else { n };
                let one: Vec3 = program.ask(arguments![c_r, c_1, n, to_light])?;
                let other: Vec3 = program.ask(arguments![c_r, c_2, n, to_light])?;
                let both: Vec3 = program.ask(arguments![c_r, c_1 + c_2, n, to_light])?;
                close("the colour in both lights", both, one + other, TOLERANCE)
            },
        ),
        Law::of(
            "head_on_nothing_is_lost",
            1,
            "Light that falls straight onto the surface gives c = c_r·c_l.",
            "With l = n the angle is 0 and its cosine 1: what does your factor become there?",
        )
        .over((colour(), light_colour(), unit_vector()), |&(c_r, c_l, n), program| {
            let c: Vec3 = program.ask(arguments![c_r, c_l, n, n])?;
            close("c", c, c_r * c_l, TOLERANCE)
        }),
    ]
}

fn slide(c_r: Vec3, c_l: Vec3, n: Vec3, to_light: Vec3) -> Vec3 {
    c_r * c_l * n.dot(to_light).max(0.0)
}

fn channel_by_channel(c_r: Vec3, c_l: Vec3, n: Vec3, to_light: Vec3) -> Vec3 {
    let mut c = [0.0; 3];
    for k in 0..3 {
        c[k] = (n.x * to_light.x + n.y * to_light.y + n.z * to_light.z) * c_l[k] * c_r[k];
        if c[k] < 0.0 {
            c[k] = 0.0;
        }
    }
    c.into()
}

/// From the chord between the two unit vectors: |n − l|² = 2 − 2 cos θ.
fn by_the_angle(c_r: Vec3, c_l: Vec3, n: Vec3, to_light: Vec3) -> Vec3 {
    let half = (0.5 * (n - to_light).length()).min(1.0).asin();
    c_r * (2.0 * half).cos().max(0.0) * c_l
}

fn dark_side_first(c_r: Vec3, c_l: Vec3, n: Vec3, to_light: Vec3) -> Vec3 {
    let cosine = n.dot(to_light);
    if cosine <= 0.0 {
        return Vec3::ZERO;
    }
    cosine * (c_l * c_r)
}

fn misconceptions() -> Vec<Misconception> {
    vec![
        Misconception {
            program: program!(without_the_maximum),
            looks_like: "n·l is used where it is negative",
            help: "Where the surface faces away, n·l is below 0 and takes light away. max(0, n·l) gives none instead.",
        },
        Misconception {
            program: program!(lit_from_both_sides),
            looks_like: "the surface is lit from behind too",
            help: "The sign of n·l says on which side the light is; the absolute value forgets it.",
        },
        Misconception {
            program: program!(by_the_angle_itself),
            looks_like: "the colour falls off with the angle, not with its cosine",
            help: "The slide speaks of the angle (E6), its formula of the cosine: n·l itself, without acos.",
        },
        Misconception {
            program: program!(the_other_way),
            looks_like: "l points from the light to the surface",
            help: "`to_light` points from the surface to the light, as n points away from the surface: no minus is needed.",
        },
        Misconception {
            program: program!(clamped),
            looks_like: "the colour is clamped to 1",
            help: "Linear colours have no upper end (E8): clamping happens once, when the picture is written.",
        },
        Misconception {
            program: program!(colours_added),
            looks_like: "the colours of surface and light are added",
            help: "c_r is a share of the light: a red surface in green light is black. That is a product.",
        },
        Misconception {
            program: program!(the_sine),
            looks_like: "the cross product stands where the dot product should",
            help: "The length of n×l is the sine: greatest where the light only grazes. The dot product is the cosine.",
        },
    ]
}

fn without_the_maximum(c_r: Vec3, c_l: Vec3, n: Vec3, to_light: Vec3) -> Vec3 {
    c_r * c_l * n.dot(to_light)
}

fn lit_from_both_sides(c_r: Vec3, c_l: Vec3, n: Vec3, to_light: Vec3) -> Vec3 {
    c_r * c_l * n.dot(to_light).abs()
}

fn by_the_angle_itself(c_r: Vec3, c_l: Vec3, n: Vec3, to_light: Vec3) -> Vec3 {
    let angle = n.dot(to_light).clamp(-1.0, 1.0).acos();
    c_r * c_l * (1.0 - angle / std::f32::consts::FRAC_PI_2).max(0.0)
}

fn the_other_way(c_r: Vec3, c_l: Vec3, n: Vec3, to_light: Vec3) -> Vec3 {
    c_r * c_l * n.dot(-to_light).max(0.0)
}

fn clamped(c_r: Vec3, c_l: Vec3, n: Vec3, to_light: Vec3) -> Vec3 {
    (c_r * c_l * n.dot(to_light).max(0.0)).min(Vec3::ONE)
}

fn colours_added(c_r: Vec3, c_l: Vec3, n: Vec3, to_light: Vec3) -> Vec3 {
    (c_r + c_l) * n.dot(to_light).max(0.0)
}

fn the_sine(c_r: Vec3, c_l: Vec3, n: Vec3, to_light: Vec3) -> Vec3 {
    c_r * c_l * n.cross(to_light).length()
}
