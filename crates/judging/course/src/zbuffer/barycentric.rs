//! Where in a triangle does a point lie? Its three weights (L48).

use glam::{Vec2, vec2};
use testkit::by_hand::point2;
use vocabulary::{Barycentric, Triangle2};

use super::drawing;
use super::inputs::{in_order, order, triangle, triangle_without_area};
use crate::exercise::{arguments, signature};
use crate::{Concept, Example, Exercise, Law, Misconception, Title, close, that};

const STUB: &str = r#"//! Barycentric coordinates on the screen (L48).
//!
//! Give the weights α, β, γ of the corners a, b, c that make the point p:
//!
//!     p = a + β (b − a) + γ (c − a),   α = 1 − β − γ
//!
//! - `triangle`: its corners on the screen, in pixels, y upwards; clockwise or anticlockwise.
//! - `p`: any point of the screen. Outside the triangle some weights are negative; that is right.
//! - `None` if the triangle has no area: its corners lie on one line, or in one point. All coordinates are
//!   multiples of ¼, so that products and differences of coordinates are exact.
//!
//! glam: `u.perp_dot(v)` is u.x · v.y − u.y · v.x: twice the signed area of the triangle that u and v span.

use glam::Vec2;
use vocabulary::{Barycentric, Triangle2};

pub fn barycentric(triangle: Triangle2, p: Vec2) -> Option<Barycentric> {
    todo!()
}
"#;

signature!((triangle: Triangle2, p: Vec2) -> Option<Barycentric>);

/// Coordinates are at most 4, differences at most 8, twice the area is at least 4: a weight is at most 2·8·8 / 4 = 32, its
/// product with a coordinate at most 128. A point made again is a sum of three such products; with the roundings of the weights
/// that is some 8 roundings of 2⁻²⁴ · 128: 6e-5. The slide's solution is off by less than 2e-5 against f64.
const TOLERANCE: f32 = 1e-4;

/// The least doubled area of a triangle that is not without area: see [`TOLERANCE`].
const LEAST_DOUBLED_AREA: f32 = 4.0;

pub(super) fn exercise() -> Exercise {
    Exercise {
        name: "barycentric",
        concept: Concept::Zbuffer,
        items: "L48",
        title: Title { english: "Barycentric coordinates", dutch: "Barycentrische coördinaten" },
        prerequisites: &[],
        stub: STUB,
        signature: SIGNATURE,
        hints: [
            "p − a = β (b − a) + γ (c − a) holds for x and for y: two equations, two unknowns.",
            "Cramer's rule: each unknown is a quotient of two determinants, and a 2×2 determinant is a `perp_dot`. The \
                denominator is the same for both: (b − a) × (c − a). When is it 0?",
            "β = (p − a) × (c − a) / d, γ = (b − a) × (p − a) / d with d = (b − a) × (c − a), × being `perp_dot`; α is what \
                is missing to 1.",
        ],
        examples: examples(),
        laws: laws(),
        reference: program!(by_cramers_rule),
        variants: vec![program!(as_shares_of_the_area), program!(by_dot_products), program!(by_the_inverse)],
        misconceptions: misconceptions(),
        explanation: "Each weight is a share of the area: α is the area of pbc through that of abc, signed. So α is 1 at a, \
            0 on the whole side bc and negative beyond it: the three signs say whether p is inside, the three values mix \
            whatever the corners carry. Quotients of areas do not care which way round the corners run: both signs flip.",
        draw: drawing::weights,
        source: include_str!("barycentric.rs"),
    }
}

fn examples() -> Vec<Example> {
    let triangle = Triangle2 { a: vec2(1.0, 1.0), b: vec2(5.0, 1.0), c: vec2(1.0, 3.0) };
    let weights = |alpha, beta, gamma| Some(Barycentric { alpha, beta, gamma });
    let on_a_line = Triangle2 { a: vec2(0.0, 0.0), b: vec2(1.0, 2.0), c: vec2(3.0, 6.0) };
    vec![
        Example::new(
            "a quarter of the way to b, half of the way to c",
            arguments![triangle, vec2(2.0, 2.0)],
            weights(0.25, 0.25, 0.5),
            TOLERANCE,
        ),
        Example::new(
            "beyond the side bc: the weight of a is negative",
            arguments![triangle, vec2(5.0, 2.0)],
            weights(-0.5, 1.0, 0.5),
            TOLERANCE,
        ),
        Example::new(
            "corners on one line",
            arguments![on_a_line, vec2(2.0, 1.0)],
            None::<Barycentric>,
            TOLERANCE,
        ),
    ]
}

fn laws() -> Vec<Law> {
    let triangles = || triangle(4, LEAST_DOUBLED_AREA);
    vec![
        Law::of(
            "weights_make_the_point",
            3,
            "The weighted corners make the point: αa + βb + γc = p.",
            "The weights make another point. Does each weight belong to its corner, is it divided by the right area, and \
                does it keep its sign outside?",
        )
        .over((triangles(), point2(4)), |&(triangle, p), program| {
            let weights = program.ask::<Option<Barycentric>>(arguments![triangle, p])?;
            let made = weights.map(|w| w.alpha * triangle.a + w.beta * triangle.b + w.gamma * triangle.c);
            close("αa + βb + γc", made, Some(p), TOLERANCE)
        }),
        Law::of(
            "weights_sum_to_one",
            1,
            "The weights sum to 1: α + β + γ = 1, inside and outside.",
            "Weights that do not sum to 1 make no mixture. What is divided by what, and do areas outside have a sign?",
        )
        .over((triangles(), point2(4)), |&(triangle, p), program| {
            let weights = program.ask::<Option<Barycentric>>(arguments![triangle, p])?;
            close("α + β + γ", weights.map(|w| w.alpha + w.beta + w.gamma), Some(1.0), TOLERANCE)
        }),
        Law::of(
            "a_corner_has_all_the_weight",
            2,
            "In a corner its own weight is 1 and the others are 0.",
            "At a only α is 1, at b only β, at c only γ. Which small triangle has its area 0 there, and which the whole area?",
        )
        .over((triangles(), 0..3_usize), |&(triangle, at), program| {
            let corner = [triangle.a, triangle.b, triangle.c][at];
            let weight = |of: usize| if of == at { 1.0 } else { 0.0 };
            let wanted = Barycentric { alpha: weight(0), beta: weight(1), gamma: weight(2) };
            let weights: Option<Barycentric> = program.ask(arguments![triangle, corner])?;
            close("the weights in a corner", weights, Some(wanted), TOLERANCE)
        }),
        Law::of(
            "weights_go_with_their_corners",
            2,
            "Corners taken in another order, clockwise or not, take their weights with them.",
            "The same corners in another order, and other weights: the area changes its sign when two corners change places.",
        )
        .over((triangles(), point2(4), order()), |&(triangle, p, order), program| {
            let first: Option<Barycentric> = program.ask(arguments![triangle, p])?;
            let [a, b, c] = [0.0, 1.0, 2.0].map(Vec2::splat);
            // The number of a corner stands in the place that the corner takes.
            let places = in_order([a, b, c], order);
            let other = in_order([triangle.a, triangle.b, triangle.c], order);
            let second: Option<Barycentric> = program.ask(arguments![other, p])?;
            let wanted = first.map(|w| {
                let weight = |place: Vec2| [w.alpha, w.beta, w.gamma][place.x as usize];
                Barycentric { alpha: weight(places.a), beta: weight(places.b), gamma: weight(places.c) }
            });
            close("the weights of the reordered corners", second, wanted, TOLERANCE)
        }),
        Law::of(
            "no_area_no_weights",
            1,
            "A triangle without area has no weights: None.",
            "Corners on one line make no plane: the determinant is 0, and nothing can be divided by it.",
        )
        .over((triangle_without_area(2), point2(4)), |&(triangle, p), program| {
            let weights: Option<Barycentric> = program.ask(arguments![triangle, p])?;
            that(weights.is_none(), || "weights come from a triangle without area".to_owned())
        }),
    ]
}

fn by_cramers_rule(triangle: Triangle2, p: Vec2) -> Option<Barycentric> {
    let Triangle2 { a, b, c } = triangle;
    let determinant = (b - a).perp_dot(c - a);
    if determinant == 0.0 {
        return None;
    }
    let beta = (p - a).perp_dot(c - a) / determinant;
    let gamma = (b - a).perp_dot(p - a) / determinant;
    Some(Barycentric { alpha: 1.0 - beta - gamma, beta, gamma })
}

fn as_shares_of_the_area(triangle: Triangle2, p: Vec2) -> Option<Barycentric> {
    let area = |a: Vec2, b: Vec2, c: Vec2| 0.5 * (a.perp_dot(b) + b.perp_dot(c) + c.perp_dot(a));
    let Triangle2 { a, b, c } = triangle;
    let whole = area(a, b, c);
    (whole != 0.0).then(|| Barycentric {
        alpha: area(p, b, c) / whole,
        beta: area(a, p, c) / whole,
        gamma: area(a, b, p) / whole,
    })
}

fn by_dot_products(triangle: Triangle2, p: Vec2) -> Option<Barycentric> {
    let (u, v, w) = (triangle.b - triangle.a, triangle.c - triangle.a, p - triangle.a);
    let (uu, uv, vv) = (u.dot(u), u.dot(v), v.dot(v));
    // The normal equations of least squares: their determinant is the square of the doubled area.
    let determinant = uu * vv - uv * uv;
    if determinant.abs() < 1e-6 {
        return None;
    }
    let beta = (vv * w.dot(u) - uv * w.dot(v)) / determinant;
    let gamma = (uu * w.dot(v) - uv * w.dot(u)) / determinant;
    Some(Barycentric { alpha: 1.0 - beta - gamma, beta, gamma })
}

fn by_the_inverse(triangle: Triangle2, p: Vec2) -> Option<Barycentric> {
    let sides =
        glam::DMat2::from_cols((triangle.b - triangle.a).as_dvec2(), (triangle.c - triangle.a).as_dvec2());
    if sides.determinant() == 0.0 {
        return None;
    }
    let weights = (sides.inverse() * (p - triangle.a).as_dvec2()).as_vec2();
    Some(Barycentric { alpha: 1.0 - weights.x - weights.y, beta: weights.x, gamma: weights.y })
}

fn misconceptions() -> Vec<Misconception> {
    vec![
        Misconception {
            program: program!(of_the_wrong_corners),
            looks_like: "each weight belongs to another corner",
            help: "α belongs to a, and it is the share of the triangle that does not touch a: pbc. At a itself that is all \
                of it.",
        },
        Misconception {
            program: program!(unsigned_areas),
            looks_like: "areas have lost their sign",
            help: "Outside, a small triangle is turned over and its area counts as negative: only then the three still sum \
                to the whole.",
        },
        Misconception {
            program: program!(not_divided),
            looks_like: "areas are not divided by the area of the triangle",
            help: "A weight is a share: the small area through the whole area.",
        },
        Misconception {
            program: program!(divided_by_half),
            looks_like: "a doubled area is divided by a single one",
            help: "`perp_dot` is twice an area. Above and below the line both must be doubled, or neither.",
        },
        Misconception {
            program: program!(none_outside),
            looks_like: "a point outside the triangle gets no weights",
            help: "Weights exist for every point of the plane; outside some are negative. Whether p is inside is another \
                question.",
        },
        Misconception {
            program: program!(none_clockwise),
            looks_like: "a clockwise triangle counts as one without area",
            help: "Twice the signed area is negative when the corners run clockwise. Only 0 means that there is none.",
        },
        Misconception {
            program: program!(dividing_by_nothing),
            looks_like: "it is divided by an area of 0",
            help: "x / 0 is infinity or NaN in floating point, not a panic: ask for the area before you divide by it.",
        },
    ]
}

fn of_the_wrong_corners(triangle: Triangle2, p: Vec2) -> Option<Barycentric> {
    let doubled_area = |a: Vec2, b: Vec2, c: Vec2| (b - a).perp_dot(c - a);
    let Triangle2 { a, b, c } = triangle;
    let whole = doubled_area(a, b, c);
    if whole == 0.0 {
        return None;
    }
    Some(Barycentric {
        alpha: doubled_area(a, b, p) / whole,
        beta: doubled_area(b, c, p) / whole,
        gamma: doubled_area(c, a, p) / whole,
    })
}

fn unsigned_areas(triangle: Triangle2, p: Vec2) -> Option<Barycentric> {
    let doubled_area = |a: Vec2, b: Vec2, c: Vec2| (b - a).perp_dot(c - a).abs();
    let Triangle2 { a, b, c } = triangle;
    let whole = doubled_area(a, b, c);
    if whole == 0.0 {
        return None;
    }
    Some(Barycentric {
        alpha: doubled_area(p, b, c) / whole,
        beta: doubled_area(a, p, c) / whole,
        gamma: doubled_area(a, b, p) / whole,
    })
}

fn not_divided(triangle: Triangle2, p: Vec2) -> Option<Barycentric> {
    let doubled_area = |a: Vec2, b: Vec2, c: Vec2| (b - a).perp_dot(c - a);
    let Triangle2 { a, b, c } = triangle;
    if doubled_area(a, b, c) == 0.0 {
        return None;
    }
    Some(Barycentric {
        alpha: doubled_area(p, b, c),
        beta: doubled_area(a, p, c),
        gamma: doubled_area(a, b, p),
    })
}

fn divided_by_half(triangle: Triangle2, p: Vec2) -> Option<Barycentric> {
    let doubled_area = |a: Vec2, b: Vec2, c: Vec2| (b - a).perp_dot(c - a);
    let Triangle2 { a, b, c } = triangle;
    let area = 0.5 * doubled_area(a, b, c);
    if area == 0.0 {
        return None;
    }
    Some(Barycentric {
        alpha: doubled_area(p, b, c) / area,
        beta: doubled_area(a, p, c) / area,
        gamma: doubled_area(a, b, p) / area,
    })
}

fn none_outside(triangle: Triangle2, p: Vec2) -> Option<Barycentric> {
    let Triangle2 { a, b, c } = triangle;
    let determinant = (b - a).perp_dot(c - a);
    if determinant == 0.0 {
        return None;
    }
    let beta = (p - a).perp_dot(c - a) / determinant;
    let gamma = (b - a).perp_dot(p - a) / determinant;
    let inside = beta >= 0.0 && gamma >= 0.0 && beta + gamma <= 1.0;
    inside.then_some(Barycentric { alpha: 1.0 - beta - gamma, beta, gamma })
}

fn none_clockwise(triangle: Triangle2, p: Vec2) -> Option<Barycentric> {
    let Triangle2 { a, b, c } = triangle;
    let determinant = (b - a).perp_dot(c - a);
    if determinant <= 0.0 {
        return None;
    }
    let beta = (p - a).perp_dot(c - a) / determinant;
    let gamma = (b - a).perp_dot(p - a) / determinant;
    Some(Barycentric { alpha: 1.0 - beta - gamma, beta, gamma })
}

fn dividing_by_nothing(triangle: Triangle2, p: Vec2) -> Option<Barycentric> {
    let Triangle2 { a, b, c } = triangle;
    let determinant = (b - a).perp_dot(c - a);
    let beta = (p - a).perp_dot(c - a) / determinant;
    let gamma = (b - a).perp_dot(p - a) / determinant;
    Some(Barycentric { alpha: 1.0 - beta - gamma, beta, gamma })
}
