//! What a mirror shows: the colour that the reflected ray sees, and so on (L58).

use glam::{DVec3, Vec3, vec3};
use proptest::prelude::*;
use proptest::sample::select;
use testkit::by_hand::point3;
use vocabulary::{MirrorBall, Ray, Sphere};

use super::drawing;
use super::inputs::{at, colour, crossings, height, sphere, step, within};
use crate::exercise::{arguments, signature};
use crate::{Concept, Example, Exercise, Law, Misconception, Title, close};

const STUB: &str = r#"//! Recursive ray tracing: mirrors that show mirrors (L58).
//!
//! Each ball has a colour and mirrors a share of what is around it. A ray sees
//!
//!     the background                                    if it hits nothing
//!     colour + mirror · (what the reflected ray sees)    of the nearest ball that it hits
//!
//! The reflected ray starts where the ray hit, in the direction r = d − 2(d·n)n, n being the unit normal there.
//!
//! - `ray`: origin outside all balls, direction d of any length. `balls`: sphere, colour and mirror (0 to 1) of each.
//! - `depth`: how many reflections are followed. With depth 0 the reflected ray sees the background, whatever stands there;
//!   with depth 1 it may hit a ball, whose own reflected ray sees the background; and so on.
//! - Count only hits with t > 0.001: the reflected ray must not hit the point that it starts from.
//! - Rays that only touch, and ties, do not occur. Colours are not clamped.
//!
//! What you wrote for `nearest_hit` helps: copy it into this file.

use glam::Vec3;
use vocabulary::{MirrorBall, Ray};

pub fn ray_color_recursive(ray: Ray, balls: &[MirrorBall], background: Vec3, depth: u32) -> Vec3 {
    todo!()
}
"#;

signature!((ray: Ray, balls: &[MirrorBall], background: Vec3, depth: u32) -> Vec3);

/// Which balls are hit is decided far from rounding; the colour then is a sum of at most six products below 2, each off by a few
/// 2⁻²⁴: 6 · 2 · 4 · 2⁻²⁴ = 3e-6.
const TOLERANCE: f32 = 1e-5;

/// So many reflections are followed, at most.
const DEEPEST: u32 = 3;

/// A ray that is moved by this much, or turned by this much, must hit the same balls. Rounding in f32 puts the first hit of a ray
/// from at most 10 away off by 1e-4 (as in `ray_color`); what that does to the later ones, this does more.
const UNSTEADY: f64 = 5e-4;

pub(super) fn exercise() -> Exercise {
    Exercise {
        name: "ray_color_recursive",
        concept: Concept::Raytrace,
        items: "L58",
        title: Title { english: "Mirrors", dutch: "Recursieve ray tracing" },
        prerequisites: &["ray_color", "reflection"],
        stub: STUB,
        signature: SIGNATURE,
        hints: [
            "What the reflected ray sees is the same question again, asked with another ray. What must become smaller, so that it ends?",
            "Hit nothing: background. Otherwise find p, n and r. With depth 0 the mirror shows the background, else your function's own answer for (p, r) and depth − 1.",
            "let mirrored = if depth == 0 { background } else { ray_color_recursive(reflected, balls, background, depth - 1) }; colour + mirror * mirrored.",
        ],
        examples: examples(),
        laws: laws(),
        reference: program!(slide),
        variants: vec![program!(round_by_round), program!(from_the_last_to_the_first)],
        misconceptions: misconceptions(),
        explanation: "Each mirror takes its share of what is left, so after k reflections only mirror^k counts: a few are enough, and the limit \
            keeps two facing mirrors from asking each other for ever. Glass is the same with two rays, reflected and refracted. What \
            this leaves out is light that comes from mirrors and lights matte things.",
        draw: drawing::mirror_pictures,
        source: include_str!("ray_color_recursive.rs"),
    }
}

fn examples() -> Vec<Example> {
    let ball = |z: f32, colour: Vec3, mirror: f32| MirrorBall {
        sphere: Sphere { center: vec3(1.0, 2.0, z), radius: 1.0 },
        colour,
        mirror,
    };
    let facing = vec![ball(-3.0, vec3(0.5, 0.25, 0.0), 0.5), ball(5.0, vec3(0.0, 0.5, 1.0), 0.25)];
    let ray = Ray { origin: vec3(1.0, 2.0, 0.0), direction: vec3(0.0, 0.0, -2.0) };
    let background = vec3(0.5, 0.5, 1.0);
    let up = Ray { direction: Vec3::Y, ..ray };
    vec![
        Example::new(
            "a mirror that shows the background",
            arguments![ray, facing.clone(), background, 0_u32],
            vec3(0.75, 0.5, 0.5),
            TOLERANCE,
        ),
        Example::new(
            "two mirrors that face each other: (1) + ½ ((2) + ¼ (background))",
            arguments![ray, facing.clone(), background, 1_u32],
            vec3(0.5625, 0.5625, 0.625),
            TOLERANCE,
        ),
        Example::new("nothing is hit", arguments![up, facing, background, 2_u32], background, TOLERANCE),
    ]
}

/// The balls that a ray hits one after the other, by index, and the ray that leaves the first; in f64. The path ends with the ball
/// whose reflected ray nobody follows.
fn path(
    start: DVec3,
    direction: DVec3,
    balls: &[MirrorBall],
    depth: u32,
) -> (Vec<usize>, Option<(DVec3, DVec3)>) {
    let (mut e, mut d) = (start, direction);
    let (mut hits, mut left) = (Vec::new(), None);
    for _ in 0..=depth {
        let entry = |(index, ball): (usize, &MirrorBall)| {
            let f = e - ball.sphere.center.as_dvec3();
            let radius = f64::from(ball.sphere.radius);
            let (a, b, c) = (d.length_squared(), f.dot(d), f.length_squared() - radius * radius);
            let t = (-b - (b * b - a * c).sqrt()) / a;
            (t * a.sqrt() > 0.01).then_some((index, t))
        };
        let nearest = balls.iter().enumerate().filter_map(entry).min_by(|(_, s), (_, t)| s.total_cmp(t));
        let Some((index, t)) = nearest else { break };
        e += t * d;
        let n = (e - balls[index].sphere.center.as_dvec3()).normalize();
        d -= 2.0 * d.dot(n) * n;
        hits.push(index);
        left.get_or_insert((e, d));
    }
    (hits, left)
}

/// Whether the same balls are hit by all rays close to this one, and the ray starts in the open.
fn is_steady(ray: &Ray, balls: &[MirrorBall]) -> bool {
    let (e, d) = (at(ray, 0.0), ray.direction.as_dvec3());
    let (wanted, _) = path(e, d, balls, DEEPEST);
    let pushes =
        [DVec3::X, DVec3::Y, DVec3::Z].into_iter().flat_map(|axis| [UNSTEADY * axis, -UNSTEADY * axis]);
    let mut near = pushes.flat_map(|push| [(e + push, d), (e, d + d.length() * push)]);
    near.all(|(e, d)| path(e, d, balls, DEEPEST).0 == wanted)
        && balls.iter().all(|ball| height(e, &ball.sphere) > 0.1)
}

/// Whether no two of the balls are close to touching.
fn are_apart(balls: &[MirrorBall]) -> bool {
    balls.iter().enumerate().all(|(k, ball)| {
        balls[..k].iter().all(|other| {
            height(other.sphere.center.as_dvec3(), &ball.sphere) > f64::from(other.sphere.radius) + 0.1
        })
    })
}

fn surface() -> impl Strategy<Value = (Vec3, f32)> + Clone {
    (colour([4, 2, 1]), select(vec![0.25_f32, 0.5, 0.75, 1.0]))
}

/// A ray, two or three balls apart from each other, and a background: the ray meets the first at a place from which the second is
/// seen in the mirror.
fn mirrored() -> impl Strategy<Value = (Ray, Vec<MirrorBall>, Vec3)> + Clone {
    let balls = proptest::collection::vec((sphere(3), surface()), 2..=3).prop_map(|balls| {
        let ball = |(sphere, (colour, mirror))| MirrorBall { sphere, colour, mirror };
        balls.into_iter().map(ball).collect::<Vec<_>>()
    });
    let balls = balls.prop_filter("too close", |balls| are_apart(balls));
    (balls, within(), 2..=8, colour([1, 2, 4]), any::<bool>())
        .prop_map(|(mut balls, slant, quarters, background, last)| {
            let (first, second) = (balls[0].sphere, balls[1].sphere);
            // Backwards: from the second ball to a point of the first that faces it, and from there to the eye.
            let facing = (second.center - first.center).normalize();
            let n = (facing + slant).normalize();
            let p = first.center + first.radius * n;
            let out = (second.center - p).normalize();
            let direction = out - 2.0 * out.dot(n) * n;
            // Whole sixteenths are easier to read, and aim well enough.
            let rounded = |v: Vec3| (16.0 * v).round() / 16.0;
            let origin = rounded(p - quarters as f32 / 4.0 * direction);
            if last {
                balls.reverse();
            }
            (Ray { origin, direction: rounded(p - origin) }, balls, background)
        })
        .prop_filter("unsteady", |(ray, balls, _)| {
            ray.direction != Vec3::ZERO
                && is_steady(ray, balls)
                && path(at(ray, 0.0), ray.direction.as_dvec3(), balls, 1).0.len() == 2
        })
}

/// One ball, and a ray that is aimed at it.
fn alone() -> impl Strategy<Value = (Ray, Vec<MirrorBall>, Vec3)> + Clone {
    (sphere(2), surface(), within(), point3(4), colour([1, 2, 4]))
        .prop_map(|(sphere, (colour, mirror), within, origin, background)| {
            let direction = sphere.center + sphere.radius * within - origin;
            (Ray { origin, direction }, vec![MirrorBall { sphere, colour, mirror }], background)
        })
        .prop_filter("inside", |(ray, balls, _)| {
            is_steady(ray, balls) && crossings(ray, &balls[0].sphere).is_some()
        })
}

/// Two balls on one line, a ray between them along it, and a background.
fn facing() -> impl Strategy<Value = (Ray, Vec<MirrorBall>, Vec3)> + Clone {
    (point3(3), step(), [surface(), surface()], [2..=6, 2..=6], colour([1, 2, 4])).prop_map(
        |(origin, direction, surfaces, places, background)| {
            // The direction is at least 1 long, the balls' surfaces at least ½ of it away.
            let place = |k: usize, side: f32| {
                let (colour, mirror) = surfaces[k];
                let center = origin + side * places[k] as f32 / 2.0 * direction;
                MirrorBall { sphere: Sphere { center, radius: 0.5 }, colour, mirror }
            };
            (Ray { origin, direction }, vec![place(0, 1.0), place(1, -1.0)], background)
        },
    )
}

fn laws() -> Vec<Law> {
    vec![
        Law::of(
            "depth_0_mirrors_the_background",
            2,
            "With depth 0 a ball shows its colour and its share of the background: colour + mirror · background.",
            "No reflection is followed here. What does a mirror show whose reflected ray is not followed, and how much of it?",
        )
        .over(mirrored(), |(ray, balls, background), program| {
            let given: Vec3 = program.ask(arguments![*ray, balls.clone(), *background, 0_u32])?;
            let (hits, _) = path(at(ray, 0.0), ray.direction.as_dvec3(), balls, 0);
            let wanted = hits.first().map_or(*background, |k| balls[*k].colour + balls[*k].mirror * *background);
            close("the colour", given, wanted, TOLERANCE)
        }),
        Law::of(
            "alone_it_mirrors_the_background_too",
            2,
            "A ball bulges outwards: it never sees itself. Alone, it shows colour + mirror · background at every depth.",
            "The ball sees itself. Where does the reflected ray start, and does it lead away from the ball?",
        )
        .over((alone(), 1..=DEEPEST), |((ray, balls, background), depth), program| {
            let given: Vec3 = program.ask(arguments![*ray, balls.clone(), *background, *depth])?;
            let wanted = balls[0].colour + balls[0].mirror * *background;
            close("the colour", given, wanted, TOLERANCE)
        }),
        Law::of(
            "one_reflection_further",
            3,
            "What a ray sees is the ball's colour and its share of what the reflected ray sees, with one reflection less to follow.",
            "Trace the reflected ray by itself, with depth − 1: its colour is not in your answer. Which direction has it?",
        )
        .over((mirrored(), 1..=DEEPEST), |((ray, balls, background), depth), program| {
            let given: Vec3 = program.ask(arguments![*ray, balls.clone(), *background, *depth])?;
            let (hits, left) = path(at(ray, 0.0), ray.direction.as_dvec3(), balls, 0);
            let (Some(k), Some((p, d))) = (hits.first(), left) else { return Ok(()) };
            // A hundredth of a unit along its way, where it is clear of the ball.
            let reflected = Ray { origin: (p + 0.01 * d.normalize()).as_vec3(), direction: d.as_vec3() };
            let seen: Vec3 = program.ask(arguments![reflected, balls.clone(), *background, *depth - 1])?;
            close("the colour", given, balls[*k].colour + balls[*k].mirror * seen, TOLERANCE)
        }),
        Law::of(
            "facing_mirrors_take_turns",
            2,
            "Between two mirrors that face each other the ray goes to and fro, depth times, and then sees the background.",
            "The ray is reflected too often or too rarely. What becomes of depth from one reflection to the next?",
        )
        .over((facing(), 0..=DEEPEST), |((ray, balls, background), depth), program| {
            let given: Vec3 = program.ask(arguments![*ray, balls.clone(), *background, *depth])?;
            let turn = |seen: Vec3, k: u32| {
                let ball = balls[(k % 2) as usize];
                ball.colour + ball.mirror * seen
            };
            close("the colour", given, (0..=*depth).rev().fold(*background, turn), TOLERANCE)
        }),
        Law::of(
            "without_mirrors_depth_does_not_matter",
            1,
            "If no ball mirrors anything, a ray sees the colour of the nearest one.",
            "These balls mirror nothing: mirror is 0. What is it multiplied with?",
        )
        .over((mirrored(), 0..=DEEPEST), |((ray, balls, background), depth), program| {
            let matte: Vec<MirrorBall> = balls.iter().map(|ball| MirrorBall { mirror: 0.0, ..*ball }).collect();
            let given: Vec3 = program.ask(arguments![*ray, matte.clone(), *background, *depth])?;
            let (hits, _) = path(at(ray, 0.0), ray.direction.as_dvec3(), &matte, 0);
            close("the colour", given, hits.first().map_or(*background, |k| matte[*k].colour), TOLERANCE)
        }),
    ]
}

fn slide(ray: Ray, balls: &[MirrorBall], background: Vec3, depth: u32) -> Vec3 {
    fn trace(ray: Ray, balls: &[MirrorBall], background: Vec3, depth: u32) -> Vec3 {
        let hits = balls.iter().flat_map(|ball| {
            let f = ray.origin - ball.sphere.center;
            let (a, b) = (ray.direction.length_squared(), ray.direction.dot(f));
            let root = (b * b - a * (f.length_squared() - ball.sphere.radius.powi(2))).sqrt();
            [(ball, (-b - root) / a), (ball, (-b + root) / a)]
        });
        let nearest = hits.filter(|(_, t)| *t > 0.001).min_by(|(_, s), (_, t)| s.total_cmp(t));
        let Some((ball, t)) = nearest else { return background };
        let p = ray.origin + t * ray.direction;
        let n = (p - ball.sphere.center) / ball.sphere.radius;
        let direction = ray.direction - 2.0 * ray.direction.dot(n) * n;
        let mirrored = if depth == 0 {
            background
        } else {
            trace(Ray { origin: p, direction }, balls, background, depth - 1)
        };
        ball.colour + ball.mirror * mirrored
    }
    trace(ray, balls, background, depth)
}

fn round_by_round(mut ray: Ray, balls: &[MirrorBall], background: Vec3, depth: u32) -> Vec3 {
    // Without recursion: what is seen so far, and the share of what is still to come.
    let (mut seen, mut share) = (Vec3::ZERO, 1.0);
    for _ in 0..=depth {
        let length = ray.direction.length();
        let d = ray.direction / length;
        let mut nearest: Option<(f32, &MirrorBall)> = None;
        for ball in balls {
            let middle = d.dot(ball.sphere.center - ray.origin);
            let away = (ray.origin + middle * d).distance(ball.sphere.center);
            if away < ball.sphere.radius {
                let s = middle - (ball.sphere.radius.powi(2) - away * away).sqrt();
                if s > 0.001 * length && nearest.is_none_or(|(best, _)| s < best) {
                    nearest = Some((s, ball));
                }
            }
        }
        let Some((s, ball)) = nearest else { break };
        seen += share * ball.colour;
        share *= ball.mirror;
        let p = ray.origin + s * d;
        ray = Ray { origin: p, direction: d.reflect((p - ball.sphere.center).normalize()) };
    }
    seen + share * background
}

fn from_the_last_to_the_first(ray: Ray, balls: &[MirrorBall], background: Vec3, depth: u32) -> Vec3 {
    // First the way, in f64, then the colours, from its end back to the eye.
    let (mut e, mut d) = (ray.origin.as_dvec3(), ray.direction.as_dvec3());
    let mut way: Vec<&MirrorBall> = Vec::new();
    while way.len() <= depth as usize {
        let entry = |ball: &MirrorBall| {
            let f = e - ball.sphere.center.as_dvec3();
            let b = f.dot(d);
            let c = f.length_squared() - f64::from(ball.sphere.radius).powi(2);
            (-b - (b * b - d.length_squared() * c).sqrt()) / d.length_squared()
        };
        let ahead = balls.iter().filter(|ball| entry(ball) > 0.001);
        let Some(ball) = ahead.min_by(|a, b| entry(a).total_cmp(&entry(b))) else { break };
        e += entry(ball) * d;
        let n = (e - ball.sphere.center.as_dvec3()) / f64::from(ball.sphere.radius);
        d -= 2.0 * d.dot(n) * n;
        way.push(ball);
    }
    way.iter().rev().fold(background, |seen, ball| ball.colour + ball.mirror * seen)
}

fn misconceptions() -> Vec<Misconception> {
    vec![
        Misconception {
            program: program!(no_offset),
            looks_like: "the reflected ray hits the point that it starts from",
            help: "Rounding leaves a crossing at a tiny t > 0. Count only those with t > 0.001.",
        },
        Misconception {
            program: program!(reflected_into_the_ball),
            looks_like: "the reflected direction has the wrong sign, and leads into the ball",
            help: "2(l·n)n − l is for a vector that points away from the surface. d points towards it: r = d − 2(d·n)n.",
        },
        Misconception {
            program: program!(normal_of_any_length),
            looks_like: "the normal is not normalized",
            help: "d − 2(d·n)n mirrors only with |n| = 1: divide p − centre by r.",
        },
        Misconception {
            program: program!(one_reflection_only),
            looks_like: "at most one reflection is followed",
            help: "The reflected ray's hit mirrors as well, until depth is used up: pass depth − 1 on, and ask anew.",
        },
        Misconception {
            program: program!(all_is_mirrored),
            looks_like: "all of what the reflected ray sees is added, whatever the mirror's share",
            help: "Multiply what comes back by the ball's mirror.",
        },
        Misconception {
            program: program!(blended),
            looks_like: "colour and mirror image are blended, (1 − mirror)·colour + mirror·…",
            help: "Light adds up here: colour stays whole, and the mirror's share comes on top.",
        },
        Misconception {
            program: program!(black_at_the_limit),
            looks_like: "a mirror shows black where no reflection is followed any more",
            help: "With depth 0 the reflected ray sees the background, as if nothing stood in its way.",
        },
    ]
}

// Each of the wrong programs differs from the slide's in one place. What they have in common stands here once, so that the place is seen.

/// The nearest ball that the ray meets after t, the point, and the normal there.
fn met(ray: Ray, balls: &[MirrorBall], after: f32) -> Option<(MirrorBall, Vec3, Vec3)> {
    let hits = balls.iter().flat_map(|ball| {
        let f = ray.origin - ball.sphere.center;
        let (a, b) = (ray.direction.length_squared(), ray.direction.dot(f));
        let root = (b * b - a * (f.length_squared() - ball.sphere.radius.powi(2))).sqrt();
        [(ball, (-b - root) / a), (ball, (-b + root) / a)]
    });
    let (ball, t) = hits.filter(|(_, t)| *t > after).min_by(|(_, s), (_, t)| s.total_cmp(t))?;
    let p = ray.origin + t * ray.direction;
    Some((*ball, p, (p - ball.sphere.center) / ball.sphere.radius))
}

/// The direction of the reflected ray: d − 2(d·n)n.
fn reflected(d: Vec3, n: Vec3) -> Vec3 {
    d - 2.0 * d.dot(n) * n
}

fn no_offset(ray: Ray, balls: &[MirrorBall], background: Vec3, depth: u32) -> Vec3 {
    fn trace(ray: Ray, balls: &[MirrorBall], background: Vec3, depth: u32) -> Vec3 {
        let Some((ball, p, n)) = met(ray, balls, 0.0) else { return background };
        let direction = reflected(ray.direction, n);
        let onwards = Ray { origin: p, direction };
        let mirrored = if depth == 0 { background } else { trace(onwards, balls, background, depth - 1) };
        ball.colour + ball.mirror * mirrored
    }
    trace(ray, balls, background, depth)
}

fn reflected_into_the_ball(ray: Ray, balls: &[MirrorBall], background: Vec3, depth: u32) -> Vec3 {
    fn trace(ray: Ray, balls: &[MirrorBall], background: Vec3, depth: u32) -> Vec3 {
        let Some((ball, p, n)) = met(ray, balls, 0.001) else { return background };
        let direction = 2.0 * ray.direction.dot(n) * n - ray.direction;
        let onwards = Ray { origin: p, direction };
        let mirrored = if depth == 0 { background } else { trace(onwards, balls, background, depth - 1) };
        ball.colour + ball.mirror * mirrored
    }
    trace(ray, balls, background, depth)
}

fn normal_of_any_length(ray: Ray, balls: &[MirrorBall], background: Vec3, depth: u32) -> Vec3 {
    fn trace(ray: Ray, balls: &[MirrorBall], background: Vec3, depth: u32) -> Vec3 {
        let Some((ball, p, _)) = met(ray, balls, 0.001) else { return background };
        let direction = reflected(ray.direction, p - ball.sphere.center);
        let onwards = Ray { origin: p, direction };
        let mirrored = if depth == 0 { background } else { trace(onwards, balls, background, depth - 1) };
        ball.colour + ball.mirror * mirrored
    }
    trace(ray, balls, background, depth)
}

fn one_reflection_only(ray: Ray, balls: &[MirrorBall], background: Vec3, depth: u32) -> Vec3 {
    fn trace(ray: Ray, balls: &[MirrorBall], background: Vec3, depth: u32) -> Vec3 {
        let Some((ball, p, n)) = met(ray, balls, 0.001) else { return background };
        let direction = reflected(ray.direction, n);
        let onwards = Ray { origin: p, direction };
        let mirrored = if depth == 0 { background } else { trace(onwards, balls, background, depth - 1) };
        ball.colour + ball.mirror * mirrored
    }
    trace(ray, balls, background, depth.min(1))
}

fn all_is_mirrored(ray: Ray, balls: &[MirrorBall], background: Vec3, depth: u32) -> Vec3 {
    fn trace(ray: Ray, balls: &[MirrorBall], background: Vec3, depth: u32) -> Vec3 {
        let Some((ball, p, n)) = met(ray, balls, 0.001) else { return background };
        let direction = reflected(ray.direction, n);
        let onwards = Ray { origin: p, direction };
        let mirrored = if depth == 0 { background } else { trace(onwards, balls, background, depth - 1) };
        ball.colour + mirrored
    }
    trace(ray, balls, background, depth)
}

fn blended(ray: Ray, balls: &[MirrorBall], background: Vec3, depth: u32) -> Vec3 {
    fn trace(ray: Ray, balls: &[MirrorBall], background: Vec3, depth: u32) -> Vec3 {
        let Some((ball, p, n)) = met(ray, balls, 0.001) else { return background };
        let direction = reflected(ray.direction, n);
        let onwards = Ray { origin: p, direction };
        let mirrored = if depth == 0 { background } else { trace(onwards, balls, background, depth - 1) };
        ball.colour.lerp(mirrored, ball.mirror)
    }
    trace(ray, balls, background, depth)
}

fn black_at_the_limit(ray: Ray, balls: &[MirrorBall], background: Vec3, depth: u32) -> Vec3 {
    fn trace(ray: Ray, balls: &[MirrorBall], background: Vec3, depth: u32) -> Vec3 {
        let Some((ball, p, n)) = met(ray, balls, 0.001) else { return background };
        let direction = reflected(ray.direction, n);
        let onwards = Ray { origin: p, direction };
        let mirrored = if depth == 0 { Vec3::ZERO } else { trace(onwards, balls, background, depth - 1) };
        ball.colour + ball.mirror * mirrored
    }
    trace(ray, balls, background, depth)
}
