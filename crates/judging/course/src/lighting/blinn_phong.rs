//! The whole colour of a point with the halfway form of the highlight (L34), clamped and gated (E3).

use glam::{DVec3, Vec3, vec3};
use proptest::prelude::*;
use testkit::by_hand::{colour, coordinate, exponent, light_colour, normal_and_direction, unit_vector_above};
use vocabulary::Material;

use crate::exercise::{arguments, signature};
use crate::{Concept, Example, Exercise, Law, Misconception, Title, close};

const STUB: &str = r#"//! The Blinn-Phong lighting model (L34).
//!
//! Give the colour of a point in ambient light and the light of one lamp:
//!
//!     c = c_r · (c_a + c_l · max(0, n·l)) + c_l · (h·n)^p        where h = (e + l) / |e + l|
//!
//! - `material`: c_r is `material.diffuse`, p is `material.exponent`, at least 1.
//! - `c_a`, `c_l`: the colours of the ambient light and of the lamp, linear RGB.
//! - `n`, `to_light`, `to_eye`: unit vectors; the normal, l and e, both starting at the surface.
//! - The slide says that h·n is always positive. It is not (E3): use max(0, h·n), and no highlight at all where the light
//!   stands behind the surface, n·l ≤ 0. Where e = −l there is no h and no highlight.
//! - Colours have no upper end: do not clamp the result.
//!
//! glam: `a.dot(b)`, `v.normalize_or_zero()`; std: `f32::powf`, `f32::max`.

use glam::Vec3;
use vocabulary::Material;

pub fn blinn_phong(material: Material, c_a: Vec3, c_l: Vec3, n: Vec3, to_light: Vec3, to_eye: Vec3) -> Vec3 {
    todo!()
}
"#;

signature!((material: Material, c_a: Vec3, c_l: Vec3, n: Vec3, to_light: Vec3, to_eye: Vec3) -> Vec3);

/// h·n is off by at most 2⁻²⁰ where e + l is at least ½ long (dividing by the length doubles the rounding of the sum), its p-th
/// power by p times that, p at most 32: 32 · 2⁻²⁰ ≈ 3e-5, times a c_l of at most 3: 1e-4. The rest of the sum is off by 1e-5.
const TOLERANCE: f32 = 2e-4;

pub(super) fn exercise() -> Exercise {
    Exercise {
        name: "blinn_phong",
        concept: Concept::Lighting,
        items: "L34, E3, E4, E8",
        title: Title {
            english: "The Blinn–Phong model", dutch: "Phong belichtingsmodel met halfway vector"
        },
        prerequisites: &["ambient_and_diffuse", "phong_highlight", "halfway"],
        stub: STUB,
        signature: SIGNATURE,
        hints: [
            "Two sums: what the surface scatters, which you have from `ambient_and_diffuse`, and the highlight, which takes the \
                light's colour and not the surface's.",
            "The highlight needs three precautions: a light above the horizon, an h that exists, and an h·n that is not negative.",
            "Start with material.diffuse * (c_a + c_l * facing), facing = n.dot(to_light).max(0.0). If facing > 0, add \
                c_l * (to_eye + to_light).normalize_or_zero().dot(n).max(0.0).powf(material.exponent).",
        ],
        examples: examples(),
        laws: laws(),
        reference: program!(slide),
        variants: vec![program!(by_its_parts), program!(by_the_square_of_the_cosine)],
        misconceptions: misconceptions(),
        explanation: "As the slide prints it, the formula lights a point from behind: with h·n = −0.971 and p = 10 it adds 0.75 (E3), with \
            p = 11 it subtracts, with p = 10.5 it is NaN. And it is not the highlight of e·r: for one as narrow, h·n needs about four \
            times the exponent (E4).",
        draw: super::drawing::blinn_phong,
        source: include_str!("blinn_phong.rs"),
    }
}

fn examples() -> Vec<Example> {
    let grey = Material { diffuse: Vec3::splat(0.8), exponent: 32.0 };
    let c_a = Vec3::splat(0.2);
    // The slide's witness against `h·n is always positive`.
    let behind = vec3(-0.5, 0.0, -0.2).normalize();
    let eye = vec3(1.0, 0.0, 0.1).normalize();
    let even = Material { diffuse: vec3(0.5, 0.25, 1.0), exponent: 10.0 };
    vec![
        Example::new(
            "the lecture's numbers, all head-on: 0.8·(0.2 + 1) + 1, above 1 (E8)",
            arguments![grey, c_a, Vec3::ONE, Vec3::Z, Vec3::Z, Vec3::Z],
            Vec3::splat(1.96),
            TOLERANCE,
        ),
        Example::new(
            "the eye in the mirror direction of red light, n·l = 0.8",
            arguments![even, Vec3::ZERO, Vec3::X, Vec3::Z, vec3(0.6, 0.0, 0.8), vec3(-0.6, 0.0, 0.8)],
            vec3(1.4, 0.0, 0.0),
            TOLERANCE,
        ),
        Example::new(
            "the light behind the surface, h·n = −0.971, p = 10 (E3)",
            arguments![even, c_a, Vec3::ONE, Vec3::Z, behind, eye],
            vec3(0.1, 0.05, 0.2),
            TOLERANCE,
        ),
    ]
}

/// A normal, and light and eye on either side of it, so that h has a direction or does not exist.
fn directions() -> impl Strategy<Value = [Vec3; 3]> + Clone {
    let anywhere =
        (normal_and_direction(), testkit::by_hand::unit_vector()).prop_map(|((n, l), e)| [n, l, e]);
    let opposite = normal_and_direction().prop_map(|(n, l)| [n, l, -l]);
    prop_oneof![8 => anywhere, 1 => opposite]
        .prop_filter("h is all rounding", |[_, l, e]| *l == -*e || (*e + *l).length() > 0.5)
}

/// A normal, the light above it, and the eye above it, not far from the mirror direction.
fn near_the_mirror_direction() -> impl Strategy<Value = [Vec3; 3]> + Clone {
    let aside = (coordinate(1), coordinate(1), coordinate(1));
    (normal_and_direction(), aside)
        .prop_map(|((n, v), (x, y, z))| {
            let l = if n.dot(v) < 0.0 { -v } else { v };
            let r = 2.0 * n.dot(l) * n - l;
            [n, l, (r + 0.3 * vec3(x, y, z)).normalize_or_zero()]
        })
        .prop_filter("the eye below the surface", |[n, l, e]| e.dot(*n) > 0.01 && (*e + *l).length() > 0.5)
}

fn material() -> impl Strategy<Value = Material> + Clone {
    (colour(), exponent()).prop_map(|(diffuse, exponent)| Material { diffuse, exponent })
}

/// max(0, h·n)^p on the lit side, in twice as many digits.
fn highlight(p: f32, [n, l, e]: [DVec3; 3]) -> f64 {
    let cosine = if e + l == DVec3::ZERO { 0.0 } else { (e + l).normalize().dot(n) };
    if n.dot(l) > 0.0 { cosine.max(0.0).powf(p.into()) } else { 0.0 }
}

fn laws() -> Vec<Law> {
    vec![
        Law::of(
            "scattered_light_as_before",
            2,
            "What the surface's colour adds is c_r·(c_a + c_l·max(0, n·l)), as without a highlight.",
            "Compare with a black surface: what c_r adds is not ambient and diffuse light. What is multiplied by c_r?",
        )
        .over((material(), colour(), light_colour(), directions()), |&(material, c_a, c_l, [n, l, e]), program| {
            let black = Material { diffuse: Vec3::ZERO, ..material };
            let with: Vec3 = program.ask(arguments![material, c_a, c_l, n, l, e])?;
            let without: Vec3 = program.ask(arguments![black, c_a, c_l, n, l, e])?;
            let scattered = material.diffuse * (c_a + c_l * n.dot(l).max(0.0));
            close("what c_r adds", with - without, scattered, TOLERANCE)
        }),
        Law::of(
            "only_ambient_light_from_behind",
            2,
            "Where the light stands behind the surface, c = c_r·c_a.",
            "A light behind the surface gives a highlight, or takes light away: the slide forgets a condition.",
        )
        .over((material(), colour(), light_colour(), directions()), |&(material, c_a, c_l, [n, l, e]), program| {
            let n = if n.dot(l) > 0.0 { -n } else { n };
            let c: Vec3 = program.ask(arguments![material, c_a, c_l, n, l, e])?;
            close("c", c, material.diffuse * c_a, TOLERANCE)
        }),
        Law::of(
            "brightest_in_the_mirror_direction",
            1,
            "Where h = n, the highlight is c_l itself.",
            "From the mirror direction h is n and h·n is 1: the lamp should look as bright as it is.",
        )
        .over((exponent(), light_colour(), directions()), |&(exponent, c_l, [n, l, _]), program| {
            let l = if n.dot(l) < 0.0 { -l } else { l };
            let r = 2.0 * n.as_dvec3().dot(l.as_dvec3()) * n.as_dvec3() - l.as_dvec3();
            let black = Material { diffuse: Vec3::ZERO, exponent };
            // Where n·l is small, e + l is short and h all rounding.
            let r = if n.dot(l) > 0.25 { r.as_vec3() } else { n };
            let l = if n.dot(l) > 0.25 { l } else { n };
            let c: Vec3 = program.ask(arguments![black, Vec3::ZERO, c_l, n, l, r])?;
            close("c of a black surface", c, c_l, TOLERANCE)
        }),
        Law::of(
            "falls_off_around_it",
            3,
            "On a black surface c = c_l·max(0, h·n)^p where n·l > 0, and 0 elsewhere.",
            "The highlight lies elsewhere or has another width: which two directions are compared, and are both 1 long?",
        )
        .over(
            (exponent(), light_colour(), prop_oneof![2 => near_the_mirror_direction(), 1 => directions()]),
            |&(exponent, c_l, [n, l, e]), program| {
                let black = Material { diffuse: Vec3::ZERO, exponent };
                let c: Vec3 = program.ask(arguments![black, Vec3::ZERO, c_l, n, l, e])?;
                let brightness = highlight(exponent, [n, l, e].map(|v| v.as_dvec3()));
                close("c of a black surface", c, (c_l.as_dvec3() * brightness).as_vec3(), TOLERANCE)
            },
        ),
        Law::of(
            "eye_and_light_change_places",
            1,
            "On a black surface, exchanging eye and light leaves the colour, where both are above the surface.",
            "h does not change when eye and light do: what else is the highlight multiplied by?",
        )
        .over((exponent(), light_colour(), both_above()), |&(exponent, c_l, [n, l, e]), program| {
            let black = Material { diffuse: Vec3::ZERO, exponent };
            let one: Vec3 = program.ask(arguments![black, Vec3::ZERO, c_l, n, l, e])?;
            let other: Vec3 = program.ask(arguments![black, Vec3::ZERO, c_l, n, e, l])?;
            close("c with eye and light exchanged", other, one, TOLERANCE)
        }),
    ]
}

fn both_above() -> impl Strategy<Value = [Vec3; 3]> + Clone {
    testkit::by_hand::unit_vector()
        .prop_flat_map(|n| (Just(n), unit_vector_above(n), unit_vector_above(n)))
        .prop_map(|(n, l, e)| [n, l, e])
        .prop_filter("h is all rounding", |[_, l, e]| (*e + *l).length() > 0.5)
}

fn slide(material: Material, c_a: Vec3, c_l: Vec3, n: Vec3, to_light: Vec3, to_eye: Vec3) -> Vec3 {
    let facing = n.dot(to_light).max(0.0);
    let scattered = material.diffuse * (c_a + c_l * facing);
    if facing == 0.0 {
        return scattered;
    }
    let h = (to_eye + to_light).normalize_or_zero();
    scattered + c_l * h.dot(n).max(0.0).powf(material.exponent)
}

fn by_its_parts(material: Material, c_a: Vec3, c_l: Vec3, n: Vec3, to_light: Vec3, to_eye: Vec3) -> Vec3 {
    let ambient = material.diffuse * c_a;
    let diffuse = material.diffuse * c_l * n.dot(to_light).max(0.0);
    let specular = match (to_eye + to_light).try_normalize() {
        Some(h) if n.dot(to_light) > 0.0 && h.dot(n) > 0.0 => c_l * h.dot(n).powf(material.exponent),
        _ => Vec3::ZERO,
    };
    ambient + diffuse + specular
}

/// Without h: (h·n)² = (e·n + l·n)² / (2 + 2 e·l), raised to p/2.
fn by_the_square_of_the_cosine(
    material: Material,
    c_a: Vec3,
    c_l: Vec3,
    n: Vec3,
    to_light: Vec3,
    to_eye: Vec3,
) -> Vec3 {
    let (facing, up) = (n.dot(to_light), n.dot(to_eye) + n.dot(to_light));
    let square = 2.0 + 2.0 * to_eye.dot(to_light);
    let lit = facing > 0.0 && up > 0.0 && square > 1e-6;
    let highlight = if lit { (up * up / square).powf(0.5 * material.exponent) } else { 0.0 };
    material.diffuse * c_a + (material.diffuse * facing.max(0.0) + highlight) * c_l
}

fn misconceptions() -> Vec<Misconception> {
    vec![
        Misconception {
            program: program!(as_printed),
            looks_like: "this is the slide's formula as it is printed",
            help: "h·n can be negative, and a light behind the surface must not shine (E3): a maximum and a condition are missing.",
        },
        Misconception {
            program: program!(without_the_gate),
            looks_like: "a light behind the surface gives a highlight",
            help: "max(0, h·n) does not ask where the light stands: with the eye high enough, h is above the surface though l is below.",
        },
        Misconception {
            program: program!(highlight_in_the_surfaces_colour),
            looks_like: "the highlight is multiplied by c_r",
            help: "A highlight is the light's mirror image and has its colour: white on a red apple (L29).",
        },
        Misconception {
            program: program!(with_the_mirror_direction),
            looks_like: "this is the form with e·r",
            help: "The ⇒ on the slide joins two different highlights (E4). Here h·n is asked for.",
        },
        Misconception {
            program: program!(h_not_of_unit_length),
            looks_like: "e + l is not brought to unit length",
            help: "|e + l| is up to 2, and 2 to the power p is a very bright highlight. h is a unit vector.",
        },
        Misconception {
            program: program!(half_the_sum),
            looks_like: "e + l is divided by 2, not by its length",
            help: "(e + l)/2 is a unit vector only where e = l: the highlight is too dim everywhere else.",
        },
        Misconception {
            program: program!(dimmed_by_the_cosine),
            looks_like: "the highlight is multiplied by n·l",
            help: "The cosine n·l belongs to the light that is scattered. For the highlight it is only a condition.",
        },
        Misconception {
            program: program!(without_ambient_light),
            looks_like: "ambient light is missing",
            help: "c_a shines everywhere and is scattered as the lamp's light is: c_r·(c_a + …).",
        },
        Misconception {
            program: program!(clamped),
            looks_like: "the colour is clamped to 1",
            help: "Linear colours have no upper end (E8): clamping happens once, when the picture is written.",
        },
    ]
}

fn as_printed(material: Material, c_a: Vec3, c_l: Vec3, n: Vec3, to_light: Vec3, to_eye: Vec3) -> Vec3 {
    let h = (to_eye + to_light).normalize_or_zero();
    material.diffuse * (c_a + c_l * n.dot(to_light).max(0.0)) + c_l * h.dot(n).powf(material.exponent)
}

fn without_the_gate(material: Material, c_a: Vec3, c_l: Vec3, n: Vec3, to_light: Vec3, to_eye: Vec3) -> Vec3 {
    let h = (to_eye + to_light).normalize_or_zero();
    material.diffuse * (c_a + c_l * n.dot(to_light).max(0.0))
        + c_l * h.dot(n).max(0.0).powf(material.exponent)
}

fn highlight_in_the_surfaces_colour(
    material: Material,
    c_a: Vec3,
    c_l: Vec3,
    n: Vec3,
    to_light: Vec3,
    to_eye: Vec3,
) -> Vec3 {
    let facing = n.dot(to_light).max(0.0);
    let h = (to_eye + to_light).normalize_or_zero();
    let highlight = if facing > 0.0 { h.dot(n).max(0.0).powf(material.exponent) } else { 0.0 };
    material.diffuse * (c_a + c_l * (facing + highlight))
}

fn with_the_mirror_direction(
    material: Material,
    c_a: Vec3,
    c_l: Vec3,
    n: Vec3,
    to_light: Vec3,
    to_eye: Vec3,
) -> Vec3 {
    let facing = n.dot(to_light).max(0.0);
    let r = 2.0 * facing * n - to_light;
    let highlight = if facing > 0.0 { to_eye.dot(r).max(0.0).powf(material.exponent) } else { 0.0 };
    material.diffuse * (c_a + c_l * facing) + c_l * highlight
}

fn h_not_of_unit_length(
    material: Material,
    c_a: Vec3,
    c_l: Vec3,
    n: Vec3,
    to_light: Vec3,
    to_eye: Vec3,
) -> Vec3 {
    let facing = n.dot(to_light).max(0.0);
    let h = to_eye + to_light;
    let highlight = if facing > 0.0 { h.dot(n).max(0.0).powf(material.exponent) } else { 0.0 };
    material.diffuse * (c_a + c_l * facing) + c_l * highlight
}

fn half_the_sum(material: Material, c_a: Vec3, c_l: Vec3, n: Vec3, to_light: Vec3, to_eye: Vec3) -> Vec3 {
    let facing = n.dot(to_light).max(0.0);
    let h = 0.5 * (to_eye + to_light);
    let highlight = if facing > 0.0 { h.dot(n).max(0.0).powf(material.exponent) } else { 0.0 };
    material.diffuse * (c_a + c_l * facing) + c_l * highlight
}

fn dimmed_by_the_cosine(
    material: Material,
    c_a: Vec3,
    c_l: Vec3,
    n: Vec3,
    to_light: Vec3,
    to_eye: Vec3,
) -> Vec3 {
    let h = (to_eye + to_light).normalize_or_zero();
    let highlight = h.dot(n).max(0.0).powf(material.exponent);
    material.diffuse * c_a + (material.diffuse + highlight) * c_l * n.dot(to_light).max(0.0)
}

fn without_ambient_light(
    material: Material,
    _c_a: Vec3,
    c_l: Vec3,
    n: Vec3,
    to_light: Vec3,
    to_eye: Vec3,
) -> Vec3 {
    let facing = n.dot(to_light).max(0.0);
    let h = (to_eye + to_light).normalize_or_zero();
    let highlight = if facing > 0.0 { h.dot(n).max(0.0).powf(material.exponent) } else { 0.0 };
    c_l * (material.diffuse * facing + highlight)
}

fn clamped(material: Material, c_a: Vec3, c_l: Vec3, n: Vec3, to_light: Vec3, to_eye: Vec3) -> Vec3 {
    let facing = n.dot(to_light).max(0.0);
    let h = (to_eye + to_light).normalize_or_zero();
    let highlight = if facing > 0.0 { h.dot(n).max(0.0).powf(material.exponent) } else { 0.0 };
    (material.diffuse * (c_a + c_l * facing) + c_l * highlight).min(Vec3::ONE)
}
