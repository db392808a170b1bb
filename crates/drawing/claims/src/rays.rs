//! What does a ray meet, and what follows from it? (L43, L44, L46, L47, L50–L54)

use std::hint::black_box;
use std::time::Instant;

use geometry::{Ray, Sphere, Triangle};
use glam::{Mat4, Vec3, vec3};
use raytrace::triangle::{Solution, System, cramer, elimination, inverse, raytri, system};
use raytrace::{Object, Shape, Surface, World, nearest, pick};

use crate::sample::{Sequence, pipeline, short, trials};
use crate::{Claim, Examination, Trial, Verdict, judge, text};

/// Balls here and there, and a world of them.
fn balls(random: &mut Sequence, count: usize) -> (Vec<Sphere>, World) {
    let spheres: Vec<Sphere> =
        (0..count).map(|_| Sphere::new(random.point(3.0), random.between(0.3, 1.0))).collect();
    let objects = spheres.iter().map(|sphere| {
        Object::new(Shape::Sphere(*sphere), Mat4::IDENTITY, vec![Surface::default()]).expect("a ball")
    });
    let world = World::new(objects.collect(), Vec::new());
    (spheres, world)
}

pub(super) static FIRST_HIT: Claim = Claim {
    number: "L43",
    name: "first-object-hit",
    quote: "the first object hit is the one seen through the pixel.",
    translation: "the first object hit is the one seen through the pixel",
    truth: text(
        "The smallest t of all objects: found by asking each one alone.",
        "De kleinste t van alle objecten: gevonden door ze één voor één te vragen.",
    ),
    expected: Verdict::Holds,
    code: &["raytrace::nearest", "raytrace::sphere::intersect"],
    examine: || {
        let trials = trials(300, 101, |random| {
            let (spheres, world) = balls(random, 6);
            let ray = Ray::through(vec3(0.0, 0.0, 9.0), random.point(2.0));
            let alone = spheres.iter().enumerate().filter_map(|(k, sphere)| {
                Some((raytrace::sphere::intersect(&ray, sphere, 0.0, f32::INFINITY)?, k))
            });
            let first = alone.min_by(|a, b| a.0.total_cmp(&b.0));
            let found = nearest(&world, &ray, 0.0, f32::INFINITY).map(|hit| (hit.t, hit.object));
            Trial::new(first == found, format!("{found:?} instead of {first:?}"))
        });
        judge("the hit is the one with the smallest t", None, &trials)
    },
    pictures: None,
    versions: None,
};

const NOTHING_NEARER: &str = "nothing nearer lies in the way";

pub(super) static PICKING: Claim = Claim {
    number: "L44",
    name: "picking",
    quote: "Ray tracing ook gebruikt voor visible surface detection en interactie met objecten",
    translation: "ray tracing is also used for visible surface detection and interaction with objects",
    truth: text(
        "A ray through the mouse finds the object under it: the one whose middle is projected there, unless another hides it.",
        "Een straal door de muis vindt het object eronder: dat waarvan het midden daar geprojecteerd wordt, tenzij een ander het bedekt.",
    ),
    expected: Verdict::HoldsIf(NOTHING_NEARER),
    code: &["raytrace::pick", "transforms::Pipeline::trace"],
    examine: || {
        let pipeline = pipeline((vec3(0.0, 0.0, 9.0), Vec3::ZERO), 1.0, (-1.0, -30.0), (64, 64));
        let trials = trials(200, 102, |random| {
            let (spheres, world) = balls(random, 4);
            let center = spheres[0].center;
            let Some(mouse) = pipeline.trace(center).screen else { return Trial::new(false, "no pixel") };
            let ray = Ray::through(pipeline.camera().eye(), center);
            let reach = |sphere: &Sphere| raytrace::sphere::intersect(&ray, sphere, 0.0, f32::INFINITY);
            let t = reach(&spheres[0]).unwrap_or(f32::INFINITY);
            let hidden = spheres[1..].iter().filter_map(reach).any(|other| other < t);
            let picked = pick(&world, &pipeline, mouse.x, mouse.y).map(|hit| hit.object);
            Trial::under(
                !hidden,
                picked == Some(0),
                format!("mouse at ({:.1}, {:.1}): {picked:?}", mouse.x, mouse.y),
            )
        });
        judge("the ray under the mouse finds the object projected there", Some(NOTHING_NEARER), &trials)
    },
    pictures: None,
    versions: None,
};

pub(super) static RAY_ENDS: Claim = Claim {
    number: "L46",
    name: "ray-from-eye-to-window",
    quote: "p(t) = e + t(s − e), p(0) = e en p(1) = s",
    translation: "p(t) = e + t(s − e), p(0) = e and p(1) = s",
    truth: text(
        "So t counts in steps from the eye to the window.",
        "Dus t telt in stappen van oog tot venster.",
    ),
    expected: Verdict::Holds,
    code: &["geometry::Ray::through"],
    examine: || {
        let trials = trials(200, 103, |random| {
            let (e, s) = (random.point(9.0), random.point(9.0));
            let ray = Ray::through(e, s);
            // s − e and back: one rounding of 18 each.
            let holds = ray.at(0.0) == e && ray.at(1.0).abs_diff_eq(s, 4e-6);
            Trial::new(holds, format!("p(1) = {}, s = {}", short(ray.at(1.0)), short(s)))
        });
        judge("p(0) = e and p(1) = s", None, &trials)
    },
    pictures: None,
    versions: None,
};

pub(super) static NEARER_AND_BEHIND: Claim = Claim {
    number: "L47",
    name: "nearer-and-behind",
    quote: "als t ≥ 0 met t₁ < t₂ dan p(t₁) dichterbij oog dan p(t₂); als t < 0 dan is p(t) achter oog",
    translation: "if t ≥ 0 and t₁ < t₂ then p(t₁) is nearer to the eye than p(t₂); if t < 0 then p(t) is behind it",
    truth: text(
        "Both: distance grows with t, and t < 0 lies on the other side of the eye's plane.",
        "Allebei: de afstand groeit met t, en t < 0 ligt aan de andere kant van het vlak door het oog.",
    ),
    expected: Verdict::Holds,
    code: &["raytrace::viewing_ray", "geometry::Ray::at"],
    examine: || {
        let pipeline = pipeline((vec3(2.0, 1.0, 5.0), Vec3::ZERO), 1.0, (-1.0, -30.0), (64, 64));
        let eye = pipeline.camera().eye();
        let trials = trials(300, 104, |random| {
            let ray = raytrace::viewing_ray(&pipeline, random.between(0.0, 63.0), random.between(0.0, 63.0));
            let t_1 = random.between(0.0, 9.0);
            let t_2 = t_1 + random.between(0.01, 9.0);
            let nearer = ray.at(t_1).distance(eye) < ray.at(t_2).distance(eye);
            let behind = pipeline.trace(ray.at(-t_2)).camera.z > 0.0;
            Trial::new(nearer && behind, format!("t₁ = {t_1:.3}, t₂ = {t_2:.3}"))
        });
        judge("p(t₁) is nearer than p(t₂), and p(−t₂) lies behind the eye", None, &trials)
    },
    pictures: None,
    versions: None,
};

pub(super) static THE_SYSTEM: Claim = Claim {
    number: "L50",
    name: "three-equations",
    quote: "e + td = a + β(b − a) + γ(c − a)",
    translation: "e + td = a + β(b − a) + γ(c − a)",
    truth: text(
        "Three equations, one a coordinate: with β, γ and t from the system, both sides are one point.",
        "Drie vergelijkingen, één per coördinaat: met β, γ en t uit het stelsel zijn beide kanten één punt.",
    ),
    expected: Verdict::Holds,
    code: &["raytrace::triangle::system", "geometry::Triangle::point"],
    examine: || {
        let trials = trials(300, 108, |random| {
            let (triangle, ray) = steep(random);
            let Some(x) = cramer(&system(&ray, &triangle)) else { return Trial::new(false, "no solution") };
            let (on_ray, on_plane) = (ray.at(x.t), triangle.point(x.weights()));
            // As for the solvers: condition numbers up to some hundred.
            let holds = on_ray.abs_diff_eq(on_plane, 1e-3 * (1.0 + x.t.abs()));
            Trial::new(holds, format!("{} on the ray, {} on the plane", short(on_ray), short(on_plane)))
        });
        judge("the point on the ray is the point on the plane", None, &trials)
    },
    pictures: None,
    versions: None,
};

pub(super) static THREE_SOLVERS: Claim = Claim {
    number: "L51",
    name: "three-solvers",
    quote: "1. Regel van Cramer 2. matrix-inverse x = A⁻¹b 3. eliminatie",
    translation: "1. Cramer's rule 2. the inverse x = A⁻¹b 3. elimination",
    truth: text(
        "All three solve the 3×3 system and agree; they differ in cost.",
        "Alle drie lossen het 3×3-stelsel op en zijn het eens; ze verschillen in kosten.",
    ),
    expected: Verdict::Holds,
    code: &["raytrace::triangle::cramer", "raytrace::triangle::inverse", "raytrace::triangle::elimination"],
    examine: || {
        let mut systems = Vec::new();
        let trials = trials(300, 105, |random| {
            let (triangle, ray) = steep(random);
            let system = system(&ray, &triangle);
            systems.push(system);
            let [a, b, c] = [cramer, inverse, elimination].map(|solve| solve(&system).map(as_vec3));
            let (Some(a), Some(b), Some(c)) = (a, b, c) else { return Trial::new(false, "no solution") };
            let back = system.matrix * a;
            // Condition numbers up to some hundred, solutions up to some hundred.
            let slack = 1e-3 * (1.0 + a.length());
            let holds = a.abs_diff_eq(b, slack)
                && a.abs_diff_eq(c, slack)
                && back.abs_diff_eq(system.rhs, 10.0 * slack);
            Trial::new(holds, format!("{}, {}, {}", short(a), short(b), short(c)))
        });
        let cost =
            [cramer as fn(&System) -> _, inverse, elimination].map(|solve| nanoseconds_each(&systems, solve));
        judge("the three solutions are one and solve the system (L50)", None, &trials)
            .noted(format!("{:.0}, {:.0} and {:.0} ns each on this machine", cost[0], cost[1], cost[2]))
    },
    pictures: None,
    versions: None,
};

/// A triangle and a ray that meets its plane at more than some degrees.
fn steep(random: &mut Sequence) -> (Triangle, Ray) {
    loop {
        let (triangle, ray) = (random.triangle(3.0), Ray::new(random.point(5.0), random.direction()));
        let n = triangle.normal().unwrap_or(Vec3::ZERO);
        if n.dot(ray.direction).abs() > 0.2 {
            return (triangle, ray);
        }
    }
}

fn as_vec3(x: Solution) -> Vec3 {
    vec3(x.beta, x.gamma, x.t)
}

fn nanoseconds_each(systems: &[System], solve: fn(&System) -> Option<Solution>) -> f64 {
    let round = || {
        let start = Instant::now();
        for system in systems {
            black_box(solve(black_box(system)));
        }
        start.elapsed().as_nanos() as f64 / systems.len() as f64
    };
    // The best of many rounds: what disturbs makes it longer only.
    (0..15).map(|_| round()).fold(f64::INFINITY, f64::min)
}

pub(super) static VIEW_VOLUME: Claim = Claim {
    number: "L52",
    name: "t-in-the-interval",
    quote: "t in interval (t₀, t₁) dan punt in view volume",
    translation: "t in the interval (t₀, t₁), then the point is in the view volume",
    truth: text(
        "With t₀ = 1 at the near plane and t₁ = f/n at the far plane, for the rays of the pixels.",
        "Met t₀ = 1 bij het near-vlak en t₁ = f/n bij het far-vlak, voor de stralen van de pixels.",
    ),
    expected: Verdict::Holds,
    code: &["raytrace::visible_interval", "transforms::Pipeline::trace"],
    examine: || {
        let pipeline = pipeline((vec3(2.0, 1.0, 5.0), Vec3::ZERO), 1.0, (-1.0, -12.0), (64, 64));
        let (t0, t1) = raytrace::visible_interval(&pipeline.volume());
        let trials = trials(300, 106, |random| {
            let ray = raytrace::viewing_ray(&pipeline, random.between(0.0, 63.0), random.between(0.0, 63.0));
            let t = random.between(0.2, 20.0);
            let in_cube = pipeline.trace(ray.at(t)).canonical.is_some_and(|p| p.abs().max_element() <= 1.0);
            Trial::new(in_cube == (t0 < t && t < t1), format!("t = {t}, in the volume: {in_cube}"))
        });
        judge("a point of a viewing ray is in the volume just where t₀ < t < t₁", None, &trials)
    },
    pictures: None,
    versions: None,
};

pub(super) static EARLY_EXITS: Claim = Claim {
    number: "L53",
    name: "early-exits",
    quote: "als (t < t0 of t > t1) return false; bereken gamma …",
    translation: "if (t < t0 or t > t1) return false; compute gamma …",
    truth: text(
        "With exits after t, γ and β the answer is that of the whole system; E11 has what is missing.",
        "Met uitgangen na t, γ en β is het antwoord dat van het hele stelsel; wat ontbreekt staat bij E11.",
    ),
    expected: Verdict::Holds,
    code: &["raytrace::triangle::raytri", "raytrace::triangle::cramer"],
    examine: || {
        let trials = trials(500, 107, |random| {
            let triangle = random.triangle(3.0);
            let ray = Ray::through(random.point(5.0), random.point(2.0));
            let whole = cramer(&system(&ray, &triangle)).is_some_and(|x| {
                0.0 <= x.t && x.t <= 9.0 && 0.0 <= x.beta && 0.0 <= x.gamma && x.beta + x.gamma <= 1.0
            });
            let early = raytri(&ray, &triangle, 0.0, 9.0);
            Trial::new(early.is_some() == whole, format!("{early:?}"))
        });
        judge("raytri hits where the solution of the system lies inside", None, &trials)
    },
    pictures: None,
    versions: None,
};

pub(super) static WORKED_EXAMPLE: Claim = Claim {
    number: "L54",
    name: "worked-example",
    quote: "γ = 1/3 en t = β + γ = 2/3 en α = 1 − β − γ = 1/3",
    translation: "γ = 1/3 and t = β + γ = 2/3 and α = 1 − β − γ = 1/3",
    truth: text(
        "The ray meets the triangle at (⅓, ⅓, ⅓), with equal weights, two thirds of the way.",
        "De straal raakt de driehoek in (⅓, ⅓, ⅓), met gelijke gewichten, op twee derde van de weg.",
    ),
    expected: Verdict::Holds,
    code: &["raytrace::triangle::system", "raytrace::triangle::cramer"],
    examine: worked_example,
    pictures: None,
    versions: None,
};

fn worked_example() -> Examination {
    let (ray, triangle) = (Ray::new(Vec3::ONE, Vec3::NEG_ONE), Triangle::new(Vec3::X, Vec3::Y, Vec3::Z));
    let trials: Vec<Trial> = [cramer, inverse, elimination]
        .into_iter()
        .map(|solve| {
            let Some(x) = solve(&system(&ray, &triangle)) else { return Trial::new(false, "parallel") };
            let (weights, p) = (x.weights().to_vec3(), ray.at(x.t));
            // Thirds, to a few roundings.
            let third = Vec3::splat(1.0 / 3.0);
            let holds = weights.abs_diff_eq(third, 1e-6)
                && p.abs_diff_eq(third, 1e-6)
                && (x.t - 2.0 / 3.0).abs() < 1e-6;
            Trial::new(holds, format!("(α, β, γ) = {}, t = {:.3}, p = {}", short(weights), x.t, short(p)))
        })
        .collect();
    let found = trials[0].numbers.clone();
    judge("α = β = γ = ⅓, t = ⅔, p = (⅓, ⅓, ⅓), by all three solvers", None, &trials).noted(found)
}
