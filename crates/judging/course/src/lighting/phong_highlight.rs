//! Phong's highlight: the light's mirror image, blurred (L31), where the light reaches the surface (E3).

use glam::{DVec3, Vec3, vec3};
use proptest::prelude::*;
use testkit::by_hand::{coordinate, exponent, light_colour, normal_and_direction, unit_vector_above};

use crate::exercise::{arguments, signature};
use crate::{Concept, Example, Exercise, Law, Misconception, Title, close};

const STUB: &str = r#"//! Phong's highlight (L31, Figs 10.5 and 10.6).
//!
//! Give the colour of the highlight alone, without ambient light and diffuse reflection:
//!
//!     c = c_l · max(0, e·r)^p        where r = 2 (n·l) n − l
//!
//! - `c_l`: the light's colour, linear RGB; the highlight takes it whatever the surface's colour is (L29).
//! - `p`: the exponent, at least 1; not always a whole number.
//! - `n`, `to_light`, `to_eye`: unit vectors; the normal, l and e, both starting at the surface.
//! - The slide forgets: where the light stands behind the surface, n·l ≤ 0, there is no highlight at all (E3).
//!
//! glam: `a.dot(b)`; std: `f32::powf`, `f32::max`.

use glam::Vec3;

pub fn phong_highlight(c_l: Vec3, p: f32, n: Vec3, to_light: Vec3, to_eye: Vec3) -> Vec3 {
    todo!()
}
"#;

signature!((c_l: Vec3, p: f32, n: Vec3, to_light: Vec3, to_eye: Vec3) -> Vec3);

/// e·r is off by at most 2⁻²⁰: r by 3 · 2⁻²² a coordinate, the product of two vectors by the sum of its three. The p-th power of
/// a number that is not above 1 is off by p times that, and p is at most 64 where two exponents are added: 64 · 2⁻²⁰ ≈ 6e-5,
/// times a c_l of at most 3. Differences count relative to what is above 1.
const TOLERANCE: f32 = 2e-4;

pub(super) fn exercise() -> Exercise {
    Exercise {
        name: "phong_highlight",
        concept: Concept::Lighting,
        items: "L31, E3, L29, L30",
        title: Title { english: "Phong's highlight", dutch: "Spiegelreflectie: Phong model" },
        prerequisites: &["reflection"],
        stub: STUB,
        signature: SIGNATURE,
        hints: [
            "Where must the eye stand to see the light as in a mirror? How do you measure how far away from there it stands?",
            "e·r is 1 in the mirror direction and falls off around it; the power makes it fall faster. Two things can go wrong: \
                e·r below 0, and a light below the horizon.",
            "If n.dot(to_light) <= 0.0 the answer is Vec3::ZERO. Otherwise it is c_l * to_eye.dot(r).max(0.0).powf(p).",
        ],
        examples: examples(),
        laws: laws(),
        reference: program!(slide),
        variants: vec![program!(by_the_eye_reflected), program!(by_logarithms)],
        misconceptions: misconceptions(),
        explanation: "max(0, e·r) is not enough: a lamp just below the horizon has its mirror direction just below it too, and an eye just \
            above the surface is close to that: at n·l = −0.17, e·r may be 0.97 (E3). A surface that no light reaches has nothing to \
            reflect. The exponent is not physics, only a knob for the width.",
        draw: super::drawing::phong_highlight,
        source: include_str!("phong_highlight.rs"),
    }
}

fn examples() -> Vec<Example> {
    let (to_light, mirrored) = (vec3(0.6, 0.0, 0.8), vec3(-0.6, 0.0, 0.8));
    vec![
        Example::new(
            "the eye in the mirror direction: σ = 0",
            arguments![vec3(1.0, 0.75, 0.5), 32.0_f32, Vec3::Z, to_light, mirrored],
            vec3(1.0, 0.75, 0.5),
            TOLERANCE,
        ),
        // σ = 60°: cos σ = ½.
        Example::new(
            "light from above, the eye 60° beside it, p = 2",
            arguments![vec3(1.0, 2.0, 3.0), 2.0_f32, Vec3::Z, Vec3::Z, vec3(0.75_f32.sqrt(), 0.0, 0.5)],
            vec3(0.25, 0.5, 0.75),
            TOLERANCE,
        ),
        Example::new(
            "the light below the horizon, n·l = −0.17, though e·r = 0.97 (E3)",
            arguments![
                Vec3::ONE,
                8.0_f32,
                Vec3::Z,
                vec3(-0.985_444, 0.0, -0.17),
                vec3(0.996_992, 0.0, 0.077_499)
            ],
            Vec3::ZERO,
            TOLERANCE,
        ),
        Example::new(
            "the light on the horizon itself, n·l = 0, the eye in the mirror direction: nothing either",
            arguments![vec3(1.0, 0.75, 0.5), 8.0_f32, Vec3::Z, Vec3::X, Vec3::NEG_X],
            Vec3::ZERO,
            TOLERANCE,
        ),
    ]
}

/// A normal, the light above it, and the eye above it too.
fn all_above() -> impl Strategy<Value = [Vec3; 3]> + Clone {
    normal_and_direction().prop_flat_map(|(n, light)| {
        let to_light = if n.dot(light) < 0.0 { -light } else { light };
        (Just(n), Just(to_light), unit_vector_above(n)).prop_map(|(n, l, e)| [n, l, e])
    })
}

/// A normal, the light anywhere, and the eye above the surface, not far from where r is or would be.
fn near_the_mirror_direction() -> impl Strategy<Value = [Vec3; 3]> + Clone {
    let aside = (coordinate(1), coordinate(1), coordinate(1));
    (normal_and_direction(), aside)
        .prop_map(|((n, l), (x, y, z))| {
            let r = mirrored(n.as_dvec3(), l.as_dvec3()).as_vec3();
            // Lifted out of the surface where r lies below it: as a lamp that has just set would be seen.
            let above = r - n * (r.dot(n) - 0.1).min(0.0);
            [n, l, (above + 0.3 * vec3(x, y, z)).normalize_or_zero()]
        })
        .prop_filter("the eye below the surface", |[n, _, e]| e.dot(*n) > 0.01)
}

fn mirrored(n: DVec3, l: DVec3) -> DVec3 {
    2.0 * n.dot(l) * n - l
}

fn laws() -> Vec<Law> {
    vec![
        Law::of(
            "brightest_in_the_mirror_direction",
            2,
            "An eye in the direction r sees the light itself: c = c_l.",
            "From the mirror direction the lamp should look as bright as it is: what is e·r there, and what else is multiplied?",
        )
        .over((light_colour(), exponent(), all_above()), |&(c_l, p, [n, to_light, _]), program| {
            let r = mirrored(n.as_dvec3(), to_light.as_dvec3()).as_vec3();
            let c: Vec3 = program.ask(arguments![c_l, p, n, to_light, r])?;
            close("c", c, c_l, TOLERANCE)
        }),
        Law::of(
            "nothing_from_behind",
            2,
            "Where the light stands behind the surface, there is no highlight.",
            "A surface that faces away from the light shines: which condition does the slide forget?",
        )
        .over(
            (light_colour(), exponent(), near_the_mirror_direction()),
            |&(c_l, p, [n, to_light, to_eye]), program| {
                let below = if n.dot(to_light) > 0.0 { to_light - 2.0 * n.dot(to_light) * n } else { to_light };
                let c: Vec3 = program.ask(arguments![c_l, p, n, below, to_eye])?;
                close("c", c, Vec3::ZERO, TOLERANCE)
            },
        ),
        Law::of(
            "never_negative_never_above_the_light",
            1,
            "Each channel of c lies between 0 and that of c_l.",
            "A highlight took light away, or was brighter than the lamp: what becomes of e·r below 0, and where does p stand?",
        )
        .over((light_colour(), exponent(), all_above()), |&(c_l, p, [n, to_light, to_eye]), program| {
            let c: Vec3 = program.ask(arguments![c_l, p, n, to_light, to_eye])?;
            close("c, brought between 0 and c_l,", c, c.clamp(Vec3::ZERO, c_l), TOLERANCE)
        }),
        Law::of(
            "exponents_add_up",
            2,
            "With white light, the highlight for p + q is the product of those for p and for q.",
            "The width does not follow the exponent as a power does.",
        )
        .over((exponent(), exponent(), all_above()), |&(p, q, [n, to_light, to_eye]), program| {
            let one: Vec3 = program.ask(arguments![Vec3::ONE, p, n, to_light, to_eye])?;
            let other: Vec3 = program.ask(arguments![Vec3::ONE, q, n, to_light, to_eye])?;
            let both: Vec3 = program.ask(arguments![Vec3::ONE, p + q, n, to_light, to_eye])?;
            close("c for p + q", both, one * other, TOLERANCE)
        }),
        Law::of(
            "falls_off_around_the_mirror_direction",
            2,
            "On the lit side c = c_l·max(0, e·r)^p.",
            "The highlight lies elsewhere or has another width: which direction is compared with e?",
        )
        .over(
            (light_colour(), exponent(), near_the_mirror_direction()),
            |&(c_l, p, [n, to_light, to_eye]), program| {
                let to_light = if n.dot(to_light) > 0.0 { to_light } else { to_light - 2.0 * n.dot(to_light) * n };
                let c: Vec3 = program.ask(arguments![c_l, p, n, to_light, to_eye])?;
                let r = mirrored(n.as_dvec3(), to_light.as_dvec3());
                let brightness = to_eye.as_dvec3().dot(r).max(0.0).powf(p.into());
                close("c", c, (c_l.as_dvec3() * brightness).as_vec3(), TOLERANCE)
            },
        ),
    ]
}

fn slide(c_l: Vec3, p: f32, n: Vec3, to_light: Vec3, to_eye: Vec3) -> Vec3 {
    if n.dot(to_light) <= 0.0 {
        return Vec3::ZERO;
    }
    let r = 2.0 * n.dot(to_light) * n - to_light;
    c_l * to_eye.dot(r).max(0.0).powf(p)
}

/// σ is also the angle between l and the eye's mirror image.
fn by_the_eye_reflected(c_l: Vec3, p: f32, n: Vec3, to_light: Vec3, to_eye: Vec3) -> Vec3 {
    let gate = if n.dot(to_light) > 0.0 { 1.0 } else { 0.0 };
    let eye_mirrored = -to_eye.reflect(n);
    gate * eye_mirrored.dot(to_light).max(0.0).powf(p) * c_l
}

fn by_logarithms(c_l: Vec3, p: f32, n: Vec3, to_light: Vec3, to_eye: Vec3) -> Vec3 {
    let cosine = 2.0 * n.dot(to_light) * n.dot(to_eye) - to_light.dot(to_eye);
    if n.dot(to_light) > 0.0 && cosine > 0.0 { (p * cosine.ln()).exp() * c_l } else { Vec3::ZERO }
}

fn misconceptions() -> Vec<Misconception> {
    vec![
        Misconception {
            program: program!(without_the_gate),
            looks_like: "a light behind the surface gives a highlight",
            help: "max(0, e·r) does not ask where the light stands. Without n·l > 0 its rays go through the surface (E3).",
        },
        Misconception {
            program: program!(without_the_maximum),
            looks_like: "e·r is used where it is negative",
            help: "With an even p a negative e·r shines, with an odd one it takes light away, otherwise it is NaN: max(0, e·r) first.",
        },
        Misconception {
            program: program!(the_first_attempt),
            looks_like: "the exponent is not used",
            help: "c_l·max(0, e·r) is the slide's first attempt (L30): much too wide. The p-th power makes it narrow.",
        },
        Misconception {
            program: program!(multiplied_by_the_exponent),
            looks_like: "e·r is multiplied by p",
            help: "p is an exponent: `powf(p)`.",
        },
        Misconception {
            program: program!(the_halfway_form),
            looks_like: "this is the halfway form, (h·n)^p",
            help: "The slide's ⇒ joins two different highlights (E4): with the same p the one of h is about twice as wide.",
        },
        Misconception {
            program: program!(dimmed_by_the_cosine),
            looks_like: "the highlight is multiplied by n·l",
            help: "The cosine n·l belongs to diffuse light. A mirror shows a low lamp as bright as a high one; n·l only opens the gate.",
        },
        Misconception {
            program: program!(reflected_into_the_surface),
            looks_like: "r points into the surface",
            help: "r = 2(n·l)n − l starts at the surface, as l does: glam's `reflect` gives −r.",
        },
        Misconception {
            program: program!(without_the_eye),
            looks_like: "n·l is raised to the power, not e·r",
            help: "A highlight moves with the eye: compare e with the mirror direction.",
        },
    ]
}

fn without_the_gate(c_l: Vec3, p: f32, n: Vec3, to_light: Vec3, to_eye: Vec3) -> Vec3 {
    let r = 2.0 * n.dot(to_light) * n - to_light;
    c_l * to_eye.dot(r).max(0.0).powf(p)
}

fn without_the_maximum(c_l: Vec3, p: f32, n: Vec3, to_light: Vec3, to_eye: Vec3) -> Vec3 {
    if n.dot(to_light) <= 0.0 {
        return Vec3::ZERO;
    }
    let r = 2.0 * n.dot(to_light) * n - to_light;
    c_l * to_eye.dot(r).powf(p)
}

fn the_first_attempt(c_l: Vec3, _p: f32, n: Vec3, to_light: Vec3, to_eye: Vec3) -> Vec3 {
    let r = 2.0 * n.dot(to_light) * n - to_light;
    if n.dot(to_light) > 0.0 { c_l * to_eye.dot(r).max(0.0) } else { Vec3::ZERO }
}

fn multiplied_by_the_exponent(c_l: Vec3, p: f32, n: Vec3, to_light: Vec3, to_eye: Vec3) -> Vec3 {
    let r = 2.0 * n.dot(to_light) * n - to_light;
    if n.dot(to_light) > 0.0 { c_l * p * to_eye.dot(r).max(0.0) } else { Vec3::ZERO }
}

fn the_halfway_form(c_l: Vec3, p: f32, n: Vec3, to_light: Vec3, to_eye: Vec3) -> Vec3 {
    if n.dot(to_light) <= 0.0 {
        return Vec3::ZERO;
    }
    c_l * (to_eye + to_light).normalize_or_zero().dot(n).max(0.0).powf(p)
}

fn dimmed_by_the_cosine(c_l: Vec3, p: f32, n: Vec3, to_light: Vec3, to_eye: Vec3) -> Vec3 {
    let r = 2.0 * n.dot(to_light) * n - to_light;
    c_l * n.dot(to_light).max(0.0) * to_eye.dot(r).max(0.0).powf(p)
}

fn reflected_into_the_surface(c_l: Vec3, p: f32, n: Vec3, to_light: Vec3, to_eye: Vec3) -> Vec3 {
    if n.dot(to_light) <= 0.0 {
        return Vec3::ZERO;
    }
    c_l * to_eye.dot(to_light.reflect(n)).max(0.0).powf(p)
}

fn without_the_eye(c_l: Vec3, p: f32, n: Vec3, to_light: Vec3, _to_eye: Vec3) -> Vec3 {
    c_l * n.dot(to_light).max(0.0).powf(p)
}
