//! Phong shading: interpolate the normals, light every pixel (L40), with normals of unit length (E7).

use glam::{Vec3, vec3};
use proptest::prelude::*;
use testkit::by_hand::{colour, exponent, light_colour, unit_vector, unit_vector_above, weights};
use vocabulary::{Barycentric, Material};

use super::inputs::around;
use crate::exercise::{arguments, signature};
use crate::{Concept, Example, Exercise, Law, Misconception, Title, close};

const STUB: &str = r#"//! Phong shading (L40).
//!
//! Give the colour of one pixel of a triangle. Step 2: interpolate the corners' normals. Step 3: the colour of the pixel by
//! the lighting model, with that normal (here diffuse light and highlight of one lamp, L32 without ambient light).
//!
//!     n = α n_0 + β n_1 + γ n_2, brought back to unit length
//!     c = c_r · c_l · max(0, n·l) + c_l · max(0, e·r)^p        where r = 2 (n·l) n − l
//!
//! - `material`: c_r is `material.diffuse`, p is `material.exponent`, at least 1.
//! - `c_l`: the lamp's colour, linear RGB. `to_light`, `to_eye`: l and e, unit vectors, the same for the whole triangle.
//! - `normals`: n_0, n_1, n_2, the unit normals at the corners a, b, c. They never cancel out.
//! - `at`: where in the triangle the pixel lies; α + β + γ = 1, none negative.
//! - The slide forgets: the mean of unit vectors is shorter than 1 (E7). And n·l ≤ 0 means no light and no highlight (E3).
//!
//! glam: `a.dot(b)`, `v.normalize()`; std: `f32::powf`, `f32::max`.

use glam::Vec3;
use vocabulary::{Barycentric, Material};

pub fn phong_shading(
    material: Material,
    c_l: Vec3,
    to_light: Vec3,
    to_eye: Vec3,
    normals: [Vec3; 3],
    at: Barycentric,
) -> Vec3 {
    todo!()
}
"#;

signature!((material: Material, c_l: Vec3, to_light: Vec3, to_eye: Vec3, normals: [Vec3; 3], at: Barycentric) -> Vec3);

/// n is off by 2⁻²¹ (a sum of three, at least 0.6 long, divided by its length), r by four times that, e·r by 2⁻¹⁸ in all; the p-th
/// power, p ≤ 32, by 32 · 2⁻¹⁸ ≈ 1.2e-4; c_l is at most 3, and differences count relative to what is above 1.
const TOLERANCE: f32 = 4e-4;

pub(super) fn exercise() -> Exercise {
    Exercise {
        name: "phong_shading",
        concept: Concept::Shading,
        items: "L40, E7, E3, L42",
        title: Title { english: "Phong shading", dutch: "Phong shading" },
        prerequisites: &["gouraud", "phong_highlight"],
        stub: STUB,
        signature: SIGNATURE,
        hints: [
            "What is interpolated now, and how often is the lighting model asked?",
            "How long is the mean of two unit vectors at right angles to each other? What does that do to a 32nd power?",
            "let n = (at.alpha * normals[0] + at.beta * normals[1] + at.gamma * normals[2]).normalize(); and then diffuse light and highlight \
                as in the exercises on lighting, both only if n.dot(to_light) > 0.0.",
        ],
        examples: examples(),
        laws: laws(),
        reference: program!(slide),
        variants: vec![program!(turned_step_by_step), program!(divided_at_the_end)],
        misconceptions: misconceptions(),
        explanation: "Normals ±45° from the middle meet at length 0.707, and 0.707³² = 1.5e-5: used as it is, the slide's normal puts the \
            highlight out exactly where Phong shading should show it (E7). This is the Phong shading; the formula for c is the Phong lighting \
            model, and each goes with others too (L42).",
        draw: super::drawing::shaded,
        source: include_str!("phong_shading.rs"),
    }
}

fn examples() -> Vec<Example> {
    let shiny = Material { diffuse: Vec3::splat(0.5), exponent: 32.0 };
    let slopes = [vec3(1.0, 0.0, 1.0).normalize(), vec3(-1.0, 0.0, 1.0).normalize(), Vec3::Y];
    let halfway = Barycentric { alpha: 0.5, beta: 0.5, gamma: 0.0 };
    vec![
        Example::new(
            "halfway between normals ±45° from the light, the eye at the light: all of it (E7)",
            arguments![shiny, Vec3::ONE, Vec3::Z, Vec3::Z, slopes, halfway],
            Vec3::splat(1.5),
            TOLERANCE,
        ),
        Example::new(
            "at corner a, 45° from the light: the eye at the light sees no highlight",
            arguments![shiny, vec3(1.0, 2.0, 0.5), Vec3::Z, Vec3::Z, slopes, CORNER_A],
            0.5 * 0.5_f32.sqrt() * vec3(1.0, 2.0, 0.5),
            TOLERANCE,
        ),
        Example::new(
            "the light on the horizon, n·l = 0, the eye in the mirror direction: black (E3)",
            arguments![shiny, Vec3::ONE, Vec3::X, Vec3::NEG_X, [Vec3::Z; 3], halfway],
            Vec3::ZERO,
            TOLERANCE,
        ),
    ]
}

const CORNER_A: Barycentric = Barycentric { alpha: 1.0, beta: 0.0, gamma: 0.0 };

/// l, e and the three normals. Light and eye stand above the surface, or light comes from anywhere.
type Directions = (Vec3, Vec3, [Vec3; 3]);

fn directions() -> impl Strategy<Value = Directions> + Clone {
    unit_vector().prop_flat_map(|middle| {
        let light = prop_oneof![2 => unit_vector_above(middle), 1 => unit_vector()];
        let mirrored = (light, unit_vector()).prop_map(move |(l, aside)| {
            let l_above = if l.dot(middle) < 0.0 { -l } else { l };
            let r = 2.0 * middle.dot(l_above) * middle - l_above;
            (l, (r + 0.3 * aside).normalize())
        });
        (mirrored, around(Just(middle))).prop_map(|((l, e), normals)| (l, e, normals))
    })
}

/// Where no interpolated normal is so nearly at right angles to the light that rounding decides whether it is lit.
fn decided((l, _, [n_0, n_1, n_2]): &Directions, at: &Barycentric) -> bool {
    let n = at.alpha * *n_0 + at.beta * *n_1 + at.gamma * *n_2;
    n.dot(*l).abs() > 0.01
}

fn pixel() -> impl Strategy<Value = (Directions, Barycentric)> + Clone {
    (directions(), place()).prop_filter("grazing", |(directions, at)| decided(directions, at))
}

fn place() -> impl Strategy<Value = Barycentric> + Clone {
    weights(0).prop_map(|[alpha, beta, gamma]| Barycentric { alpha, beta, gamma })
}

fn material() -> impl Strategy<Value = Material> + Clone {
    (colour(), exponent()).prop_map(|(diffuse, exponent)| Material { diffuse, exponent })
}

/// L32 without ambient light, in twice as many digits.
fn phong(material: Material, c_l: Vec3, [n, l, e]: [Vec3; 3]) -> Vec3 {
    let [n, l, e] = [n, l, e].map(|v| v.as_dvec3());
    let facing = n.dot(l);
    if facing <= 0.0 {
        return Vec3::ZERO;
    }
    let highlight = e.dot(2.0 * facing * n - l).max(0.0).powf(material.exponent.into());
    (c_l.as_dvec3() * (material.diffuse.as_dvec3() * facing + highlight)).as_vec3()
}

fn laws() -> Vec<Law> {
    vec![
        Law::of(
            "at_a_corner_its_own_normal",
            2,
            "At corner a the colour is that of the lighting model with n_0.",
            "At a corner nothing is interpolated: is the lighting model that of the formula, and does α belong to n_0?",
        )
        .over(
            (material(), light_colour(), directions().prop_filter("grazing", |d| decided(d, &CORNER_A))),
            |&(material, c_l, (l, e, normals)), program| {
                let c: Vec3 = program.ask(arguments![material, c_l, l, e, normals, CORNER_A])?;
                close("c at corner a", c, phong(material, c_l, [normals[0], l, e]), TOLERANCE)
            },
        ),
        Law::of(
            "only_the_normal_matters",
            4,
            "A pixel has the colour of a triangle whose three normals are the unit vector along αn_0 + βn_1 + γn_2.",
            "The pixel is not lit with the interpolated unit normal: what is interpolated, and how long is it?",
        )
        .over((material(), light_colour(), pixel()), |&(material, c_l, ((l, e, normals), at)), program| {
            let [n_0, n_1, n_2] = normals.map(|n| n.as_dvec3());
            let sum = f64::from(at.alpha) * n_0 + f64::from(at.beta) * n_1 + f64::from(at.gamma) * n_2;
            let n = sum.normalize().as_vec3();
            let same: Vec3 = program.ask(arguments![material, c_l, l, e, [n; 3], CORNER_A])?;
            let c: Vec3 = program.ask(arguments![material, c_l, l, e, normals, at])?;
            close("c", c, same, TOLERANCE)
        }),
        Law::of(
            "a_highlight_between_the_corners",
            2,
            "Light and eye over the place where two normals meet in the middle: the highlight there is all of c_l.",
            "The highlight between two corners is lost: how long is the mean of two unit vectors, and what does the p-th power make of it?",
        )
        .over(
            (material(), light_colour(), around(unit_vector())),
            |&(material, c_l, [n_0, n_1, n_2]), program| {
                let halfway = Barycentric { alpha: 0.5, beta: 0.5, gamma: 0.0 };
                let m = (n_0.as_dvec3() + n_1.as_dvec3()).normalize().as_vec3();
                let c: Vec3 = program.ask(arguments![material, c_l, m, m, [n_0, n_1, n_2], halfway])?;
                close("c halfway", c, c_l * (material.diffuse + 1.0), TOLERANCE)
            },
        ),
        Law::of(
            "nothing_from_behind",
            1,
            "A pixel whose interpolated normal faces away from the light is black.",
            "A pixel shines though its normal faces away from the light: which condition do light and highlight need?",
        )
        .over((material(), light_colour(), pixel()), |&(material, c_l, ((_, e, normals), at)), program| {
            let n = (at.alpha * normals[0] + at.beta * normals[1] + at.gamma * normals[2]).normalize();
            let along = (e - n.dot(e) * n).try_normalize().unwrap_or_else(|| n.any_orthonormal_vector());
            // The light has just set behind the pixel's horizon, the eye stands low on the other side: e·r = 0.97.
            let (l, e) = ((-along - 0.1 * n).normalize(), (along + 0.15 * n).normalize());
            let c: Vec3 = program.ask(arguments![material, c_l, l, e, normals, at])?;
            close("c", c, Vec3::ZERO, TOLERANCE)
        }),
        Law::of(
            "corners_by_another_name",
            1,
            "Calling the corners b, c, a instead of a, b, c changes nothing.",
            "The corners are not treated alike: does each weight go with its own normal?",
        )
        .over((material(), light_colour(), pixel()), |&(material, c_l, ((l, e, [n_0, n_1, n_2]), at)), program| {
            let renamed = Barycentric { alpha: at.beta, beta: at.gamma, gamma: at.alpha };
            let one: Vec3 = program.ask(arguments![material, c_l, l, e, [n_0, n_1, n_2], at])?;
            let other: Vec3 = program.ask(arguments![material, c_l, l, e, [n_1, n_2, n_0], renamed])?;
            close("c with corners renamed", other, one, TOLERANCE)
        }),
    ]
}

fn slide(
    material: Material,
    c_l: Vec3,
    to_light: Vec3,
    to_eye: Vec3,
    normals: [Vec3; 3],
    at: Barycentric,
) -> Vec3 {
    let n = (at.alpha * normals[0] + at.beta * normals[1] + at.gamma * normals[2]).normalize();
    let facing = n.dot(to_light);
    if facing <= 0.0 {
        return Vec3::ZERO;
    }
    let r = 2.0 * facing * n - to_light;
    c_l * (material.diffuse * facing + to_eye.dot(r).max(0.0).powf(material.exponent))
}

/// First along the edge from a to b, then towards c.
fn turned_step_by_step(
    material: Material,
    c_l: Vec3,
    to_light: Vec3,
    to_eye: Vec3,
    normals: [Vec3; 3],
    at: Barycentric,
) -> Vec3 {
    let share = at.beta / (at.alpha + at.beta).max(1e-6);
    let n = normals[0].lerp(normals[1], share).lerp(normals[2], at.gamma).normalize_or_zero();
    let mirrored = -to_eye.reflect(n);
    let lit = n.dot(to_light) > 0.0;
    let diffuse = material.diffuse * c_l * n.dot(to_light).max(0.0);
    let specular = c_l * mirrored.dot(to_light).max(0.0).powf(material.exponent);
    if lit { diffuse + specular } else { Vec3::ZERO }
}

/// With N not yet of unit length: n·l = N·l/|N|, and e·r = 2 (N·l)(N·e)/|N|² − e·l.
fn divided_at_the_end(
    material: Material,
    c_l: Vec3,
    to_light: Vec3,
    to_eye: Vec3,
    normals: [Vec3; 3],
    at: Barycentric,
) -> Vec3 {
    let sum =
        glam::Mat3::from_cols(normals[0], normals[1], normals[2]) * glam::vec3(at.alpha, at.beta, at.gamma);
    let (along_light, along_eye) = (sum.dot(to_light), sum.dot(to_eye));
    if along_light <= 0.0 {
        return Vec3::ZERO;
    }
    let cosine = 2.0 * along_light * along_eye / sum.length_squared() - to_eye.dot(to_light);
    c_l * (material.diffuse * along_light / sum.length() + cosine.max(0.0).powf(material.exponent))
}

fn misconceptions() -> Vec<Misconception> {
    vec![
        Misconception {
            program: program!(not_brought_back),
            looks_like: "the interpolated normal is not brought back to unit length",
            help: "The mean of unit vectors is shorter than 1 (E7): the highlight dies between the corners. `normalize` n first.",
        },
        Misconception {
            program: program!(gouraud_shading),
            looks_like: "colours are interpolated: this is Gouraud shading",
            help: "Gouraud lights three corners and mixes the colours (L38). Here normals are mixed, and the lighting model comes last.",
        },
        Misconception {
            program: program!(flat),
            looks_like: "the whole triangle has one normal",
            help: "One normal for all pixels is flat shading (L37). The weights α, β, γ say where the pixel lies.",
        },
        Misconception {
            program: program!(weights_exchanged),
            looks_like: "the weights go with the wrong corners",
            help: "α belongs to corner a, and so to normals[0]; β to b, γ to c.",
        },
        Misconception {
            program: program!(without_the_gate),
            looks_like: "a light behind the surface gives a highlight",
            help: "Where n·l ≤ 0 there is no light to be reflected, neither diffusely nor as a highlight (E3).",
        },
        Misconception {
            program: program!(highlight_in_the_surfaces_colour),
            looks_like: "the highlight is multiplied by c_r",
            help: "A highlight is the light's mirror image and has its colour: white on a red apple (L29).",
        },
    ]
}

// Each of the wrong programs differs from the slide's in one place. What they have in common stands here once, so that the place is seen.

/// The normal between the corners', as long as it comes out.
fn between([n_0, n_1, n_2]: [Vec3; 3], at: Barycentric) -> Vec3 {
    at.alpha * n_0 + at.beta * n_1 + at.gamma * n_2
}

/// The lighting model for one normal.
fn lit(material: Material, c_l: Vec3, to_light: Vec3, to_eye: Vec3, n: Vec3) -> Vec3 {
    let facing = n.dot(to_light).max(0.0);
    let r = 2.0 * facing * n - to_light;
    let highlight = if facing > 0.0 { to_eye.dot(r).max(0.0).powf(material.exponent) } else { 0.0 };
    c_l * (material.diffuse * facing + highlight)
}

fn not_brought_back(
    material: Material,
    c_l: Vec3,
    to_light: Vec3,
    to_eye: Vec3,
    normals: [Vec3; 3],
    at: Barycentric,
) -> Vec3 {
    lit(material, c_l, to_light, to_eye, between(normals, at))
}

fn gouraud_shading(
    material: Material,
    c_l: Vec3,
    to_light: Vec3,
    to_eye: Vec3,
    normals: [Vec3; 3],
    at: Barycentric,
) -> Vec3 {
    between(normals.map(|n| lit(material, c_l, to_light, to_eye, n)), at)
}

fn flat(
    material: Material,
    c_l: Vec3,
    to_light: Vec3,
    to_eye: Vec3,
    normals: [Vec3; 3],
    _at: Barycentric,
) -> Vec3 {
    lit(material, c_l, to_light, to_eye, (normals[0] + normals[1] + normals[2]).normalize())
}

fn weights_exchanged(
    material: Material,
    c_l: Vec3,
    to_light: Vec3,
    to_eye: Vec3,
    normals: [Vec3; 3],
    at: Barycentric,
) -> Vec3 {
    let exchanged = Barycentric { alpha: at.beta, beta: at.alpha, ..at };
    lit(material, c_l, to_light, to_eye, between(normals, exchanged).normalize())
}

fn without_the_gate(
    material: Material,
    c_l: Vec3,
    to_light: Vec3,
    to_eye: Vec3,
    normals: [Vec3; 3],
    at: Barycentric,
) -> Vec3 {
    let n = between(normals, at).normalize();
    let r = 2.0 * n.dot(to_light) * n - to_light;
    c_l * (material.diffuse * n.dot(to_light).max(0.0) + to_eye.dot(r).max(0.0).powf(material.exponent))
}

fn highlight_in_the_surfaces_colour(
    material: Material,
    c_l: Vec3,
    to_light: Vec3,
    to_eye: Vec3,
    normals: [Vec3; 3],
    at: Barycentric,
) -> Vec3 {
    let white = Material { diffuse: Vec3::ONE, ..material };
    lit(white, material.diffuse * c_l, to_light, to_eye, between(normals, at).normalize())
}
