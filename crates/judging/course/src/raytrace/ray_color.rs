//! The slide's `raycolor`: ambient light, and the lamp's where no ball hides it (L55, L57).

use glam::{DVec3, Vec3, vec3};
use proptest::prelude::*;
use proptest::sample::select;
use testkit::by_hand::point3;
use vocabulary::{Ball, Lamp, Ray, Sphere};

use super::drawing;
use super::inputs::{at, colour, crossings, decided, height, is_clear, sphere, within};
use crate::exercise::{arguments, signature};
use crate::{Concept, Example, Exercise, Law, Misconception, Title, close};

const STUB: &str = r#"//! The colour that a ray sees (L55, L57).
//!
//! The slide's raycolor, for balls and one lamp:
//!
//!     if the ray hits a ball at the point p (the nearest, t > 0):
//!         c = c_r c_a                                              ambient
//!         if p's shadow ray to the lamp crosses no ball:
//!             c = c + c_r c_l max(0, n·l) + c_l max(0, h·n)^p
//!         return c
//!     otherwise return the background
//!
//! - `ray`: origin and direction, the direction of any length. `balls`: sphere, colour c_r and exponent p of each.
//! - `lamp`: its position and its light c_l. `ambient`: c_a. `background`: what a ray sees that hits nothing.
//! - n: the ball's unit normal at p; l: unit vector from p to the lamp; e: unit vector from p to the ray's origin;
//!   h = (e + l)/|e + l|. Colours are multiplied channel by channel; nothing is clamped.
//! - The shadow ray counts crossings with 0.001 < t < 1, where t = 0 is p and t = 1 the lamp.
//! - The ray's origin and the lamp are outside all balls. Rays that only touch, and ties, do not occur.
//!
//! What you wrote for `nearest_hit` and `in_shadow` helps: copy it into this file.

use glam::Vec3;
use vocabulary::{Ball, Lamp, Ray};

pub fn ray_color(ray: Ray, balls: &[Ball], lamp: Lamp, ambient: Vec3, background: Vec3) -> Vec3 {
    todo!()
}
"#;

signature!((ray: Ray, balls: &[Ball], lamp: Lamp, ambient: Vec3, background: Vec3) -> Vec3);

/// A hit is at most 12 away: the discriminant's terms, below 12⁴, are off by 12⁴ · 4 · 2⁻²⁴ = 5e-3, its root, at least 0.3 · 12 · ½,
/// by 1.4e-3, and the point by a twelfth of that, 1.2e-4. The normal is off by twice that, as r ≥ ½. The highlight grows at most by
/// √16 · e^−½ = 2.4 for 1 of the angle, and is c_l ≤ 2 bright: 2 · 2.4 · 2.4e-4 = 1.2e-3, and the diffuse light adds 5e-4.
const TOLERANCE: f32 = 2e-3;

pub(super) fn exercise() -> Exercise {
    Exercise {
        name: "ray_color",
        concept: Concept::Raytrace,
        items: "L55, L57",
        title: Title { english: "The colour that a ray sees", dutch: "Raycolor met schaduwen" },
        prerequisites: &["nearest_hit", "in_shadow", "blinn_phong"],
        stub: STUB,
        signature: SIGNATURE,
        hints: [
            "Four questions, in this order: what is hit first, where is that point, is it in shadow, and how bright is it there?",
            "p = origin + t · direction, n = (p − centre)/r, l = (lamp − p) normalized, e = −direction normalized. The ambient part comes always.",
            "c = colour * ambient; if not in shadow: c += colour * lamp.colour * n·l + lamp.colour * (h·n)^exponent. Only the first two have the ball's colour.",
        ],
        examples: examples(),
        laws: laws(),
        reference: program!(slide),
        variants: vec![program!(in_small_functions), program!(in_double_precision)],
        misconceptions: misconceptions(),
        explanation: "This is a whole ray tracer: called for the viewing ray of each pixel it makes a picture, with shadows. The slide's (h·n)^p \
            needs n·l > 0 beside it, or it lights points that face away from the lamp. Here the shadow ray sees to that: such a point lies \
            behind its own ball.",
        draw: drawing::shadow_pictures,
        source: include_str!("ray_color.rs"),
    }
}

fn examples() -> Vec<Example> {
    let ball = |center: Vec3, radius: f32, colour: Vec3| Ball {
        sphere: Sphere { center, radius },
        colour,
        exponent: 2.0,
    };
    let red = ball(vec3(0.0, 0.0, -3.0), 1.0, vec3(0.5, 0.25, 0.0));
    let shade = ball(vec3(0.0, 2.0, -2.0), 0.75, vec3(0.0, 0.5, 1.0));
    // The ray meets the red ball at (0, 0, −2); its normal there is z. The lamp is at 3 z + 4 y from there: n·l = 0.6.
    let ray = Ray { origin: vec3(0.0, 0.0, 2.0), direction: vec3(0.0, 0.0, -2.0) };
    let lamp = Lamp { position: vec3(0.0, 4.0, 1.0), colour: vec3(1.0, 0.5, 1.0) };
    let between = Lamp { position: vec3(0.0, 4.0, -1.5), ..lamp };
    let (ambient, background) = (vec3(0.5, 1.0, 0.25), vec3(0.25, 0.5, 0.75));
    // h = (y 0.8 + z 1.6)/√3.2, so (h·n)² = 0.8.
    let lit = vec3(0.25 + 0.3 + 0.8, 0.25 + 0.075 + 0.4, 0.0 + 0.0 + 0.8);
    vec![
        Example::new(
            "lit: n·l = 0.6, (h·n)² = 0.8",
            arguments![ray, vec![red], lamp, ambient, background],
            lit,
            TOLERANCE,
        ),
        Example::new(
            "the second ball stands before the lamp",
            arguments![ray, vec![red, shade], between, ambient, background],
            vec3(0.25, 0.25, 0.0),
            TOLERANCE,
        ),
        Example::new(
            "nothing is hit",
            arguments![
                Ray { direction: vec3(2.0, 0.0, 1.0), ..ray },
                vec![red, shade],
                lamp,
                ambient,
                background
            ],
            background,
            TOLERANCE,
        ),
    ]
}

/// A ray and what there is to see.
#[derive(Clone, Debug)]
struct Scene {
    ray: Ray,
    balls: Vec<Ball>,
    lamp: Lamp,
    ambient: Vec3,
    background: Vec3,
}

impl Scene {
    fn arguments(&self) -> Vec<crate::Value> {
        arguments![self.ray, self.balls.clone(), self.lamp, self.ambient, self.background]
    }

    fn spheres(&self) -> Vec<Sphere> {
        self.balls.iter().map(|ball| ball.sphere).collect()
    }

    /// The ball that the ray hits, and where; in f64.
    fn hit(&self) -> Option<(&Ball, DVec3)> {
        let hits = self.balls.iter().filter_map(|ball| {
            let t = crossings(&self.ray, &ball.sphere)?.into_iter().find(|t| *t > 0.0)?;
            Some((ball, t))
        });
        let (ball, t) = hits.min_by(|(_, s), (_, t)| s.total_cmp(t))?;
        Some((ball, at(&self.ray, t)))
    }

    /// Whether a point is in shadow.
    fn is_dark(&self, p: DVec3) -> bool {
        let way = Ray { origin: p.as_vec3(), direction: self.lamp.position - p.as_vec3() };
        let crossed =
            |ball: &Ball| crossings(&way, &ball.sphere).into_iter().flatten().any(|t| 0.001 < t && t < 1.0);
        self.balls.iter().any(crossed)
    }

    /// Whether rounding decides nothing here.
    fn is_decided(&self) -> bool {
        let (eye, spheres) = (at(&self.ray, 0.0), self.spheres());
        let mut all: Vec<f64> =
            spheres.iter().filter_map(|sphere| crossings(&self.ray, sphere)).flatten().collect();
        all.sort_by(f64::total_cmp);
        let length = f64::from(self.ray.direction.length());
        let apart = all.windows(2).all(|pair| (pair[1] - pair[0]) * length > 0.05);
        let open = spheres.iter().all(|sphere| height(eye, sphere) > 0.1 && is_clear(&self.ray, sphere));
        apart
            && open
            && self.hit().is_none_or(|(ball, p)| {
                let way = self.lamp.position.as_dvec3() - p;
                let cosine = (p - ball.sphere.center.as_dvec3()).dot(way)
                    / (way.length() * f64::from(ball.sphere.radius));
                way.length() > 2.0 && cosine.abs() > 0.2 && decided(p.as_vec3(), self.lamp.position, &spheres)
            })
    }

    /// The lighting equation at a lit point.
    fn lit(&self, ball: &Ball, p: DVec3) -> Vec3 {
        let n = (p - ball.sphere.center.as_dvec3()).normalize();
        let l = (self.lamp.position.as_dvec3() - p).normalize();
        let e = -self.ray.direction.as_dvec3().normalize();
        let h = (e + l).normalize();
        let diffuse = n.dot(l).max(0.0) as f32 * self.lamp.colour;
        ball.colour * (self.ambient + diffuse)
            + h.dot(n).powf(f64::from(ball.exponent)) as f32 * self.lamp.colour
    }
}

fn ball(extent: i32) -> impl Strategy<Value = Ball> + Clone {
    (sphere(extent), colour([8, 4, 2]), select(vec![1.0_f32, 2.0, 4.0, 8.0, 16.0]))
        .prop_map(|(sphere, colour, exponent)| Ball { sphere, colour, exponent })
}

/// A ray aimed at one of one to three balls, the second of which may be on the lamp's way or behind the lamp; everything is decided.
fn scene() -> impl Strategy<Value = Scene> + Clone {
    let lamp =
        (point3(6), colour([4, 4, 4])).prop_map(|(position, colour)| Lamp { position, colour: 2.0 * colour });
    let others = (
        proptest::collection::vec(ball(3), 0..=2),
        prop_oneof![Just(None), (3..=6).prop_map(Some), (11..=14).prop_map(Some)],
    );
    let placed =
        (ball(2), others, any::<bool>(), lamp, point3(4), within(), colour([2, 2, 2]), colour([1, 2, 4]));
    placed
        .prop_map(|(seen, (mut balls, between), last, lamp, eye, within, ambient, background)| {
            if let (Some(eighths), Some(ball)) = (between, balls.first_mut()) {
                ball.sphere.center = seen.sphere.center.lerp(lamp.position, eighths as f32 / 8.0);
            }
            let place = if last { balls.len() } else { 0 };
            balls.insert(place, seen);
            let target = seen.sphere.center + seen.sphere.radius * within;
            Scene { ray: Ray { origin: eye, direction: target - eye }, balls, lamp, ambient, background }
        })
        .prop_filter("close to a tie", Scene::is_decided)
}

/// Of [`scene`] those whose ray sees a point that the lamp reaches, or that it does not reach.
fn seen(lit: bool) -> impl Strategy<Value = Scene> + Clone {
    scene().prop_filter("other light", move |scene| scene.hit().is_some_and(|(_, p)| scene.is_dark(p) != lit))
}

fn laws() -> Vec<Law> {
    vec![
        Law::of(
            "nothing_hit_is_the_background",
            1,
            "A ray that hits nothing sees the background.",
            "No ball stands on this ray, only behind its origin or elsewhere. What does it see?",
        )
        .over(
            scene()
                .prop_map(|scene| Scene { ray: Ray { direction: -scene.ray.direction, ..scene.ray }, ..scene })
                .prop_filter("a hit", |scene| scene.hit().is_none()),
            |scene, program| close("the colour", program.ask(scene.arguments())?, scene.background, TOLERANCE),
        ),
        Law::of(
            "shadow_is_ambient",
            2,
            "A point in shadow has ambient light only: c = c_r c_a.",
            "The lamp does not reach this point. What light is left there, and what becomes of it?",
        )
        .over(seen(false), |scene, program| {
            let Some((ball, _)) = scene.hit() else { return Ok(()) };
            close("the colour", program.ask(scene.arguments())?, ball.colour * scene.ambient, TOLERANCE)
        }),
        Law::of(
            "lit_is_the_lighting_equation",
            3,
            "Where the lamp shines, the lighting equation holds: c = c_r (c_a + c_l max(0, n·l)) + c_l (h·n)^p.",
            "Compute n, l, e and h for this hit by hand: each has length 1. Then the three terms, one after the other.",
        )
        .over(seen(true), |scene, program| {
            let Some((ball, p)) = scene.hit() else { return Ok(()) };
            close("the colour", program.ask(scene.arguments())?, scene.lit(ball, p), TOLERANCE)
        }),
        Law::of(
            "the_lamp_s_light_adds_up",
            2,
            "Light adds up: a lamp twice as bright adds twice as much to what is there without it.",
            "The colour does not grow in step with the lamp. What is done to it besides adding and multiplying?",
        )
        .over(seen(true), |scene, program| {
            let with = |factor: f32| {
                let lamp = Lamp { colour: factor * scene.lamp.colour, ..scene.lamp };
                Scene { lamp, ..scene.clone() }.arguments()
            };
            let [dark, once, twice]: [Vec3; 3] = [program.ask(with(0.0))?, program.ask(with(1.0))?, program.ask(with(2.0))?];
            close("what twice the light adds", twice - dark, 2.0 * (once - dark), 2.0 * TOLERANCE)
        }),
        Law::of(
            "the_order_of_the_list_does_not_matter",
            1,
            "With the list of balls reversed the colour is the same.",
            "The colour depends on the order in which the balls are listed. Which of those hit is seen?",
        )
        .over(scene(), |scene, program| {
            let reversed = Scene { balls: scene.balls.iter().rev().copied().collect(), ..scene.clone() };
            let given: Vec3 = program.ask(scene.arguments())?;
            close("the colour with the list reversed", program.ask(reversed.arguments())?, given, TOLERANCE)
        }),
    ]
}

fn slide(ray: Ray, balls: &[Ball], lamp: Lamp, ambient: Vec3, background: Vec3) -> Vec3 {
    // The two t, smaller first; NaN, which lies in no interval, where the ray passes by.
    let crossings = |ray: Ray, ball: &Ball| {
        let f = ray.origin - ball.sphere.center;
        let (a, b) = (ray.direction.length_squared(), ray.direction.dot(f));
        let root = (b * b - a * (f.length_squared() - ball.sphere.radius.powi(2))).sqrt();
        [(-b - root) / a, (-b + root) / a]
    };
    let hits =
        balls.iter().filter_map(|ball| Some((ball, crossings(ray, ball).into_iter().find(|t| *t > 0.0)?)));
    let Some((ball, t)) = hits.min_by(|(_, s), (_, t)| s.total_cmp(t)) else {
        return background;
    };
    let p = ray.origin + t * ray.direction;
    let shadow_ray = Ray { origin: p, direction: lamp.position - p };
    let dark = balls.iter().any(|ball| crossings(shadow_ray, ball).into_iter().any(|t| 0.001 < t && t < 1.0));
    if dark {
        return ball.colour * ambient;
    }
    let n = (p - ball.sphere.center) / ball.sphere.radius;
    let to_light = (lamp.position - p).normalize();
    let to_eye = -ray.direction.normalize();
    let h = (to_eye + to_light).normalize();
    let diffuse = ball.colour * lamp.colour * n.dot(to_light).max(0.0);
    let highlight = lamp.colour * h.dot(n).max(0.0).powf(ball.exponent);
    ball.colour * ambient + diffuse + highlight
}

fn in_small_functions(ray: Ray, balls: &[Ball], lamp: Lamp, ambient: Vec3, background: Vec3) -> Vec3 {
    /// The nearest ball with t0 < t < t1, and t.
    fn nearest(balls: &[Ball], ray: Ray, t0: f32, mut t1: f32) -> Option<(Ball, f32)> {
        let mut found = None;
        let length = ray.direction.length();
        let d = ray.direction / length;
        for ball in balls {
            let middle = d.dot(ball.sphere.center - ray.origin);
            let distance = (ray.origin + middle * d).distance(ball.sphere.center);
            let half = ((ball.sphere.radius - distance) * (ball.sphere.radius + distance)).sqrt();
            for t in [(middle - half) / length, (middle + half) / length] {
                if t0 < t && t < t1 {
                    (found, t1) = (Some((*ball, t)), t);
                }
            }
        }
        found
    }
    /// c_r (c_a + c_l n·l) + c_l (h·n)^p.
    fn lighting(ball: Ball, lamp: Lamp, [ambient, n, to_light, to_eye]: [Vec3; 4]) -> Vec3 {
        let cosine = n.dot(to_light);
        let halfway = (cosine + n.dot(to_eye)) / (to_light + to_eye).length();
        ball.colour * (ambient + lamp.colour * cosine) + lamp.colour * halfway.powf(ball.exponent)
    }
    nearest(balls, ray, 0.0, f32::INFINITY).map_or(background, |(ball, t)| {
        let p = ray.origin + t * ray.direction;
        let n = (p - ball.sphere.center).normalize();
        let way = lamp.position - p;
        let shadow_ray = Ray { origin: p, direction: way };
        if n.dot(way) <= 0.0 || nearest(balls, shadow_ray, 0.001, 1.0).is_some() {
            return ball.colour * ambient;
        }
        lighting(ball, lamp, [ambient, n, way.normalize(), (ray.origin - p).normalize()])
    })
}

fn in_double_precision(ray: Ray, balls: &[Ball], lamp: Lamp, ambient: Vec3, background: Vec3) -> Vec3 {
    use glam::DVec3;
    let crossings = |e: DVec3, d: DVec3, ball: &Ball| {
        let f = e - ball.sphere.center.as_dvec3();
        let (a, b) = (d.length_squared(), f.dot(d));
        let root = (b * b - a * (f.length_squared() - f64::from(ball.sphere.radius).powi(2))).sqrt();
        [-(b + root) / a, (root - b) / a]
    };
    let (e, d) = (ray.origin.as_dvec3(), ray.direction.as_dvec3());
    let mut best: Option<(f64, &Ball)> = None;
    for ball in balls {
        // The origin is outside: the entry is the first of the two.
        let t = crossings(e, d, ball)[0];
        if t > 0.0 && best.is_none_or(|(nearest, _)| t < nearest) {
            best = Some((t, ball));
        }
    }
    let Some((t, ball)) = best else { return background };
    let p = e + t * d;
    let way = lamp.position.as_dvec3() - p;
    let on_the_way = |t: f64| (0.001..1.0).contains(&t);
    let free = balls.iter().all(|ball| !crossings(p, way, ball).into_iter().any(on_the_way));
    let mut colour = ball.colour * ambient;
    if free {
        let n = (p - ball.sphere.center.as_dvec3()).normalize();
        let h = (way.normalize() - d.normalize()).normalize();
        colour += ball.colour * lamp.colour * n.dot(way.normalize()).max(0.0) as f32;
        colour += lamp.colour * n.dot(h).powf(f64::from(ball.exponent)) as f32;
    }
    colour
}

fn misconceptions() -> Vec<Misconception> {
    vec![
        Misconception {
            program: program!(without_shadows),
            looks_like: "nothing casts a shadow",
            help: "Before the lamp's two terms, ask whether its way to p is free.",
        },
        Misconception {
            program: program!(black_shadows),
            looks_like: "shadows are black",
            help: "The lamp does not reach a point in shadow, but the ambient light does: c_r c_a remains.",
        },
        Misconception {
            program: program!(first_in_the_list),
            looks_like: "the first ball of the list that is hit is seen",
            help: "Of all balls that are hit, the one with the smallest t is seen.",
        },
        Misconception {
            program: program!(highlight_in_the_ball_s_colour),
            looks_like: "the highlight has the ball's colour",
            help: "A highlight is the mirrored lamp: it has the lamp's colour, without c_r.",
        },
        Misconception {
            program: program!(ambient_without_the_ball_s_colour),
            looks_like: "the ambient light is not multiplied by the ball's colour",
            help: "The ball reflects ambient light as it does the lamp's: c_r c_a.",
        },
        Misconception {
            program: program!(clamped),
            looks_like: "the colour is clamped to 1",
            help: "Light adds up without limit. Clamp once, when the picture is written, not here.",
        },
        Misconception {
            program: program!(to_light_of_any_length),
            looks_like: "the vector to the lamp is not normalized",
            help: "n·l is a cosine only if both have length 1. The shadow ray may keep its length, l may not.",
        },
        Misconception {
            program: program!(normal_of_any_length),
            looks_like: "the normal is not normalized",
            help: "p − centre is r long. Divide by r.",
        },
        Misconception {
            program: program!(towards_the_point_for_towards_the_eye),
            looks_like: "e points from the eye to the surface",
            help: "e points from p to the eye: against the ray's direction.",
        },
        Misconception {
            program: program!(reflection_for_halfway),
            looks_like: "the highlight is that of e·r",
            help: "The slide's two highlights differ with the same p: this one asks for h·n.",
        },
        Misconception {
            program: program!(black_background),
            looks_like: "a ray that hits nothing sees black",
            help: "What is hit by no ray has the background's colour; it is an argument here.",
        },
    ]
}

// Each of the wrong programs differs from the slide's in one place. What they have in common stands here once, so that the place is seen.

/// The two t, smaller first; NaN, which lies in no interval, where the ray passes by.
fn both_t(ray: Ray, ball: &Ball) -> [f32; 2] {
    let f = ray.origin - ball.sphere.center;
    let (a, b) = (ray.direction.length_squared(), ray.direction.dot(f));
    let root = (b * b - a * (f.length_squared() - ball.sphere.radius.powi(2))).sqrt();
    [(-b - root) / a, (-b + root) / a]
}

/// The balls that the ray hits, in the order of the list, with the point.
fn hits(ray: Ray, balls: &[Ball]) -> impl Iterator<Item = (f32, Ball, Vec3)> {
    balls.iter().filter_map(move |ball| {
        let t = both_t(ray, ball).into_iter().find(|t| *t > 0.0)?;
        Some((t, *ball, ray.origin + t * ray.direction))
    })
}

/// The nearest of them.
fn seen_ball(ray: Ray, balls: &[Ball]) -> Option<(Ball, Vec3)> {
    hits(ray, balls).min_by(|(s, ..), (t, ..)| s.total_cmp(t)).map(|(_, ball, p)| (ball, p))
}

/// Whether a ball stands between p and the lamp.
fn is_dark(p: Vec3, balls: &[Ball], lamp: Lamp) -> bool {
    let shadow_ray = Ray { origin: p, direction: lamp.position - p };
    balls.iter().any(|ball| both_t(shadow_ray, ball).into_iter().any(|t| 0.001 < t && t < 1.0))
}

/// n, to_light and to_eye at p.
fn directions(ray: Ray, ball: Ball, p: Vec3, lamp: Lamp) -> [Vec3; 3] {
    let n = (p - ball.sphere.center) / ball.sphere.radius;
    [n, (lamp.position - p).normalize(), -ray.direction.normalize()]
}

/// What the surface scatters of the lamp's light.
fn scattered(ball: Ball, lamp: Lamp, [n, to_light, _]: [Vec3; 3]) -> Vec3 {
    ball.colour * lamp.colour * n.dot(to_light).max(0.0)
}

/// What it mirrors of it.
fn mirrored(ball: Ball, lamp: Lamp, [n, to_light, to_eye]: [Vec3; 3]) -> Vec3 {
    let h = (to_eye + to_light).normalize();
    lamp.colour * h.dot(n).max(0.0).powf(ball.exponent)
}

/// The colour of p: ambient light, and where the lamp reaches it, the lamp's.
fn lit(at: (Ball, Vec3), balls: &[Ball], lamp: Lamp, ambient: Vec3, directions: [Vec3; 3]) -> Vec3 {
    let (ball, p) = at;
    let dark = ball.colour * ambient;
    if is_dark(p, balls, lamp) {
        return dark;
    }
    dark + scattered(ball, lamp, directions) + mirrored(ball, lamp, directions)
}

fn without_shadows(ray: Ray, balls: &[Ball], lamp: Lamp, ambient: Vec3, background: Vec3) -> Vec3 {
    let Some((ball, p)) = seen_ball(ray, balls) else { return background };
    let directions = directions(ray, ball, p, lamp);
    ball.colour * ambient + scattered(ball, lamp, directions) + mirrored(ball, lamp, directions)
}

fn black_shadows(ray: Ray, balls: &[Ball], lamp: Lamp, ambient: Vec3, background: Vec3) -> Vec3 {
    let Some((ball, p)) = seen_ball(ray, balls) else { return background };
    if is_dark(p, balls, lamp) {
        return Vec3::ZERO;
    }
    lit((ball, p), balls, lamp, ambient, directions(ray, ball, p, lamp))
}

fn first_in_the_list(ray: Ray, balls: &[Ball], lamp: Lamp, ambient: Vec3, background: Vec3) -> Vec3 {
    let Some((_, ball, p)) = hits(ray, balls).next() else { return background };
    lit((ball, p), balls, lamp, ambient, directions(ray, ball, p, lamp))
}

fn highlight_in_the_ball_s_colour(
    ray: Ray,
    balls: &[Ball],
    lamp: Lamp,
    ambient: Vec3,
    background: Vec3,
) -> Vec3 {
    let Some((ball, p)) = seen_ball(ray, balls) else { return background };
    let dark = ball.colour * ambient;
    if is_dark(p, balls, lamp) {
        return dark;
    }
    let directions = directions(ray, ball, p, lamp);
    let coloured = Lamp { colour: ball.colour * lamp.colour, ..lamp };
    dark + scattered(ball, lamp, directions) + mirrored(ball, coloured, directions)
}

fn ambient_without_the_ball_s_colour(
    ray: Ray,
    balls: &[Ball],
    lamp: Lamp,
    ambient: Vec3,
    background: Vec3,
) -> Vec3 {
    let Some((ball, p)) = seen_ball(ray, balls) else { return background };
    if is_dark(p, balls, lamp) {
        return ambient;
    }
    let directions = directions(ray, ball, p, lamp);
    ambient + scattered(ball, lamp, directions) + mirrored(ball, lamp, directions)
}

fn clamped(ray: Ray, balls: &[Ball], lamp: Lamp, ambient: Vec3, background: Vec3) -> Vec3 {
    let Some((ball, p)) = seen_ball(ray, balls) else { return background };
    if is_dark(p, balls, lamp) {
        return ball.colour * ambient;
    }
    lit((ball, p), balls, lamp, ambient, directions(ray, ball, p, lamp)).min(Vec3::ONE)
}

fn to_light_of_any_length(ray: Ray, balls: &[Ball], lamp: Lamp, ambient: Vec3, background: Vec3) -> Vec3 {
    let Some((ball, p)) = seen_ball(ray, balls) else { return background };
    let [n, _, to_eye] = directions(ray, ball, p, lamp);
    lit((ball, p), balls, lamp, ambient, [n, lamp.position - p, to_eye])
}

fn normal_of_any_length(ray: Ray, balls: &[Ball], lamp: Lamp, ambient: Vec3, background: Vec3) -> Vec3 {
    let Some((ball, p)) = seen_ball(ray, balls) else { return background };
    let [_, to_light, to_eye] = directions(ray, ball, p, lamp);
    lit((ball, p), balls, lamp, ambient, [p - ball.sphere.center, to_light, to_eye])
}

fn towards_the_point_for_towards_the_eye(
    ray: Ray,
    balls: &[Ball],
    lamp: Lamp,
    ambient: Vec3,
    background: Vec3,
) -> Vec3 {
    let Some((ball, p)) = seen_ball(ray, balls) else { return background };
    let [n, to_light, to_eye] = directions(ray, ball, p, lamp);
    lit((ball, p), balls, lamp, ambient, [n, to_light, -to_eye])
}

fn reflection_for_halfway(ray: Ray, balls: &[Ball], lamp: Lamp, ambient: Vec3, background: Vec3) -> Vec3 {
    let Some((ball, p)) = seen_ball(ray, balls) else { return background };
    let dark = ball.colour * ambient;
    if is_dark(p, balls, lamp) {
        return dark;
    }
    let [n, to_light, to_eye] = directions(ray, ball, p, lamp);
    let r = 2.0 * n.dot(to_light) * n - to_light;
    let highlight = lamp.colour * to_eye.dot(r).max(0.0).powf(ball.exponent);
    dark + scattered(ball, lamp, [n, to_light, to_eye]) + highlight
}

fn black_background(ray: Ray, balls: &[Ball], lamp: Lamp, ambient: Vec3, _background: Vec3) -> Vec3 {
    let Some((ball, p)) = seen_ball(ray, balls) else { return Vec3::ZERO };
    lit((ball, p), balls, lamp, ambient, directions(ray, ball, p, lamp))
}
