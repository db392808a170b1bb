//! Gouraud shading: light the corners, interpolate the colours (L38).

use glam::{Vec3, vec3};
use proptest::prelude::*;
use testkit::by_hand::{colour, light_colour, unit_vector, weights};
use vocabulary::Barycentric;

use super::inputs::around;
use crate::exercise::{arguments, signature};
use crate::{Concept, Example, Exercise, Law, Misconception, Title, close};

const STUB: &str = r#"//! Gouraud shading (L38).
//!
//! Give the colour of one pixel of a triangle. Step 2: the colour of each corner, with that corner's own normal, by the
//! lighting model (here ambient and diffuse light, L28). Step 3: interpolate these three colours.
//!
//!     c_k = c_r · (c_a + c_l · max(0, n_k·l))        c = α c_0 + β c_1 + γ c_2
//!
//! - `c_r`: what share of light the surface scatters. `c_a`, `c_l`: the colours of ambient light and lamp, linear RGB.
//! - `to_light`: l, unit vector, the same for the whole triangle.
//! - `normals`: n_0, n_1, n_2, the unit normals at the corners a, b, c.
//! - `at`: where in the triangle the pixel lies; α + β + γ = 1, none negative.
//!
//! glam: `a.dot(b)`; std: `f32::max`, `normals.map(|n| …)`.

use glam::Vec3;
use vocabulary::Barycentric;

pub fn gouraud(c_r: Vec3, c_a: Vec3, c_l: Vec3, to_light: Vec3, normals: [Vec3; 3], at: Barycentric) -> Vec3 {
    todo!()
}
"#;

signature!((c_r: Vec3, c_a: Vec3, c_l: Vec3, to_light: Vec3, normals: [Vec3; 3], at: Barycentric) -> Vec3);

/// A corner's colour is off by at most 1.5e-6: n·l by 2⁻²², times a c_l of at most 3, added to a c_a of at most 1. A sum of three
/// with weights that add up to 1 is off by no more, and by three roundings of numbers below 4. Other orders get room for both.
const TOLERANCE: f32 = 1e-5;

pub(super) fn exercise() -> Exercise {
    Exercise {
        name: "gouraud",
        concept: Concept::Shading,
        items: "L38, L28",
        title: Title { english: "Gouraud shading", dutch: "Gouraud shading" },
        prerequisites: &["ambient_and_diffuse", "vertex_normals"],
        stub: STUB,
        signature: SIGNATURE,
        hints: [
            "What is interpolated between the corners: normals or colours? And how often is the lighting model asked, for a whole triangle?",
            "Three corners, three colours, each with its own max(0, n·l). After that light and normals are no longer needed.",
            "let [c_0, c_1, c_2] = normals.map(|n| c_r * (c_a + c_l * n.dot(to_light).max(0.0))); then weigh them with at.alpha, at.beta, at.gamma.",
        ],
        examples: examples(),
        laws: laws(),
        reference: program!(slide),
        variants: vec![program!(from_corner_a), program!(channel_by_channel)],
        misconceptions: misconceptions(),
        explanation: "The colour is affine between the corners, so it is never brighter than the brightest of them: a highlight in the \
            middle of a triangle is lost, and as the mesh turns it flickers from corner to corner. Phong shading asks the lighting model in \
            every pixel instead.",
        draw: super::drawing::shaded,
        source: include_str!("gouraud.rs"),
    }
}

fn examples() -> Vec<Example> {
    let middle = Barycentric { alpha: 0.5, beta: 0.25, gamma: 0.25 };
    let normals = [Vec3::Z, vec3(0.6, 0.0, 0.8), Vec3::NEG_Z];
    vec![
        Example::new(
            "corners with n·l = 1, 0.8 and −1: colours 1, 0.8 and 0",
            arguments![Vec3::ONE, Vec3::ZERO, Vec3::ONE, Vec3::Z, normals, middle],
            Vec3::splat(0.7),
            TOLERANCE,
        ),
        Example::new(
            "halfway between normals 45° left and right of the light: as bright as the corners, not brighter",
            arguments![
                Vec3::splat(0.8),
                Vec3::splat(0.25),
                Vec3::ONE,
                Vec3::Z,
                [vec3(1.0, 0.0, 1.0).normalize(), vec3(-1.0, 0.0, 1.0).normalize(), Vec3::Z],
                Barycentric { alpha: 0.5, beta: 0.5, gamma: 0.0 }
            ],
            Vec3::splat(0.8 * (0.25 + 0.5_f32.sqrt())),
            TOLERANCE,
        ),
    ]
}

/// Everything but the place in the triangle: c_r, c_a, c_l, l and the normals, around a direction of their own.
type Surface = (Vec3, Vec3, Vec3, Vec3, [Vec3; 3]);

fn surface() -> impl Strategy<Value = Surface> + Clone {
    (colour(), colour(), light_colour(), unit_vector(), around(unit_vector()))
}

fn place() -> impl Strategy<Value = Barycentric> + Clone {
    weights(0).prop_map(|[alpha, beta, gamma]| Barycentric { alpha, beta, gamma })
}

const CORNERS: [Barycentric; 3] = [
    Barycentric { alpha: 1.0, beta: 0.0, gamma: 0.0 },
    Barycentric { alpha: 0.0, beta: 1.0, gamma: 0.0 },
    Barycentric { alpha: 0.0, beta: 0.0, gamma: 1.0 },
];

fn laws() -> Vec<Law> {
    vec![
        Law::of(
            "at_a_corner_its_own_light",
            3,
            "At a corner the colour is that of the lighting model with the corner's normal.",
            "At a corner, one weight is 1 and the others 0: which normal should count there, and what does the lighting model say?",
        )
        .over((surface(), 0..3_usize), |&((c_r, c_a, c_l, l, normals), k), program| {
            let c: Vec3 = program.ask(arguments![c_r, c_a, c_l, l, normals, CORNERS[k]])?;
            let facing = normals[k].as_dvec3().dot(l.as_dvec3()).max(0.0);
            let lit = c_r.as_dvec3() * (c_a.as_dvec3() + c_l.as_dvec3() * facing);
            close("c at the corner", c, lit.as_vec3(), TOLERANCE)
        }),
        Law::of(
            "affine_between",
            3,
            "Halfway between two places the colour is halfway between theirs.",
            "Between the corners the colour does not run straight: something is lit or cut off after the interpolation.",
        )
        .over((surface(), place(), place()), |&((c_r, c_a, c_l, l, normals), one, other), program| {
            let middle = Barycentric {
                alpha: 0.5 * (one.alpha + other.alpha),
                beta: 0.5 * (one.beta + other.beta),
                gamma: 0.5 * (one.gamma + other.gamma),
            };
            let c_1: Vec3 = program.ask(arguments![c_r, c_a, c_l, l, normals, one])?;
            let c_2: Vec3 = program.ask(arguments![c_r, c_a, c_l, l, normals, other])?;
            let c: Vec3 = program.ask(arguments![c_r, c_a, c_l, l, normals, middle])?;
            close("c halfway", c, 0.5 * (c_1 + c_2), TOLERANCE)
        }),
        Law::of(
            "between_the_corners_colours",
            1,
            "No pixel is brighter than the brightest corner, or darker than the darkest.",
            "A pixel's colour left the range of its corners: do the weights belong to colours, and to the right ones?",
        )
        .over((surface(), place()), |&((c_r, c_a, c_l, l, normals), at), program| {
            let mut corners = [Vec3::ZERO; 3];
            for (corner, place) in corners.iter_mut().zip(CORNERS) {
                *corner = program.ask(arguments![c_r, c_a, c_l, l, normals, place])?;
            }
            let [c_0, c_1, c_2] = corners;
            let (least, greatest) = (c_0.min(c_1).min(c_2), c_0.max(c_1).max(c_2));
            let c: Vec3 = program.ask(arguments![c_r, c_a, c_l, l, normals, at])?;
            close("c, brought between the corners' colours,", c, c.max(least).min(greatest), TOLERANCE)
        }),
        Law::of(
            "corners_by_another_name",
            1,
            "Calling the corners b, c, a instead of a, b, c changes nothing.",
            "The corners are not treated alike: does each weight go with its own normal?",
        )
        .over((surface(), place()), |&((c_r, c_a, c_l, l, [n_0, n_1, n_2]), at), program| {
            let renamed = Barycentric { alpha: at.beta, beta: at.gamma, gamma: at.alpha };
            let one: Vec3 = program.ask(arguments![c_r, c_a, c_l, l, [n_0, n_1, n_2], at])?;
            let other: Vec3 = program.ask(arguments![c_r, c_a, c_l, l, [n_1, n_2, n_0], renamed])?;
            close("c with corners renamed", other, one, TOLERANCE)
        }),
    ]
}

fn slide(c_r: Vec3, c_a: Vec3, c_l: Vec3, to_light: Vec3, normals: [Vec3; 3], at: Barycentric) -> Vec3 {
    let [c_0, c_1, c_2] = normals.map(|n| c_r * (c_a + c_l * n.dot(to_light).max(0.0)));
    at.alpha * c_0 + at.beta * c_1 + at.gamma * c_2
}

/// a + β(b − a) + γ(c − a), with colours for points.
fn from_corner_a(
    c_r: Vec3,
    c_a: Vec3,
    c_l: Vec3,
    to_light: Vec3,
    normals: [Vec3; 3],
    at: Barycentric,
) -> Vec3 {
    let lit = |n: Vec3| {
        let facing = n.dot(to_light);
        if facing > 0.0 { c_r * c_a + facing * c_r * c_l } else { c_r * c_a }
    };
    let start = lit(normals[0]);
    start + at.beta * (lit(normals[1]) - start) + at.gamma * (lit(normals[2]) - start)
}

/// c_r, c_a and c_l are the same at all corners: only max(0, n·l) needs to be interpolated.
fn channel_by_channel(
    c_r: Vec3,
    c_a: Vec3,
    c_l: Vec3,
    to_light: Vec3,
    normals: [Vec3; 3],
    at: Barycentric,
) -> Vec3 {
    let shares = [at.alpha, at.beta, at.gamma];
    let facing: f32 = normals.iter().zip(shares).map(|(n, share)| share * n.dot(to_light).max(0.0)).sum();
    Vec3::from_array(std::array::from_fn(|k| (c_a[k] + facing * c_l[k]) * c_r[k]))
}

fn misconceptions() -> Vec<Misconception> {
    vec![
        Misconception {
            program: program!(phong_shading),
            looks_like: "normals are interpolated: this is Phong shading",
            help: "That is step 2 of Phong shading (L40). Gouraud lights the three corners first and interpolates their colours.",
        },
        Misconception {
            program: program!(maximum_too_late),
            looks_like: "max(0, …) is taken after the interpolation",
            help: "A corner that faces away is dark, not darker than dark: each corner has its own max(0, n·l), before anything is mixed.",
        },
        Misconception {
            program: program!(flat),
            looks_like: "the whole triangle has one colour",
            help: "One normal for all pixels is flat shading (L37). The weights α, β, γ say where the pixel lies.",
        },
        Misconception {
            program: program!(weights_exchanged),
            looks_like: "the weights go with the wrong corners",
            help: "α belongs to corner a, and so to normals[0]; β to b, γ to c.",
        },
        Misconception {
            program: program!(without_corner_a),
            looks_like: "the weight α is left out",
            help: "The point is αa + βb + γc: with β and γ alone it would have to start from c_0.",
        },
        Misconception {
            program: program!(without_the_maximum),
            looks_like: "n·l is used where it is negative",
            help: "A corner that faces away from the light gets max(0, n·l) = 0 of it.",
        },
    ]
}

fn phong_shading(
    c_r: Vec3,
    c_a: Vec3,
    c_l: Vec3,
    to_light: Vec3,
    normals: [Vec3; 3],
    at: Barycentric,
) -> Vec3 {
    let n = (at.alpha * normals[0] + at.beta * normals[1] + at.gamma * normals[2]).normalize_or_zero();
    c_r * (c_a + c_l * n.dot(to_light).max(0.0))
}

fn maximum_too_late(
    c_r: Vec3,
    c_a: Vec3,
    c_l: Vec3,
    to_light: Vec3,
    normals: [Vec3; 3],
    at: Barycentric,
) -> Vec3 {
    let n = at.alpha * normals[0] + at.beta * normals[1] + at.gamma * normals[2];
    c_r * (c_a + c_l * n.dot(to_light).max(0.0))
}

fn flat(c_r: Vec3, c_a: Vec3, c_l: Vec3, to_light: Vec3, normals: [Vec3; 3], _at: Barycentric) -> Vec3 {
    let n = (normals[0] + normals[1] + normals[2]).normalize_or_zero();
    c_r * (c_a + c_l * n.dot(to_light).max(0.0))
}

fn weights_exchanged(
    c_r: Vec3,
    c_a: Vec3,
    c_l: Vec3,
    to_light: Vec3,
    normals: [Vec3; 3],
    at: Barycentric,
) -> Vec3 {
    let [c_0, c_1, c_2] = normals.map(|n| c_r * (c_a + c_l * n.dot(to_light).max(0.0)));
    at.beta * c_0 + at.alpha * c_1 + at.gamma * c_2
}

fn without_corner_a(
    c_r: Vec3,
    c_a: Vec3,
    c_l: Vec3,
    to_light: Vec3,
    normals: [Vec3; 3],
    at: Barycentric,
) -> Vec3 {
    let [_, c_1, c_2] = normals.map(|n| c_r * (c_a + c_l * n.dot(to_light).max(0.0)));
    at.beta * c_1 + at.gamma * c_2
}

fn without_the_maximum(
    c_r: Vec3,
    c_a: Vec3,
    c_l: Vec3,
    to_light: Vec3,
    normals: [Vec3; 3],
    at: Barycentric,
) -> Vec3 {
    let n = at.alpha * normals[0] + at.beta * normals[1] + at.gamma * normals[2];
    c_r * (c_a + c_l * n.dot(to_light))
}
