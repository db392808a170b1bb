//! How does a function of the ray tracer look? Each pixel's ray is its question.

use canvas::Rgb;
use course::arguments;
use glam::{Mat3, Vec2, Vec3, vec2, vec3};
use vocabulary::{Ball, Basis, Lamp, MirrorBall, Ray, Sphere, Triangle, TriangleHit, ViewVolume};

use super::knobs::Knobs;
use super::light::direction;
use super::panel::Panel;

/// Pixels along each side of a picture; odd, so that one row of rays is level.
const SIDE: u32 = 51;

/// A picture of three beside each other.
const THIRD: u32 = 39;

/// Directions are not of length 1: who takes them for it is seen.
const STEP: f32 = 1.5;

/// Where a picture ends to the right and above, one unit before the eye, if what is seen is near.
const REACH: f32 = 0.75;

/// The same, if it is farther than this.
const FAR: f32 = 3.0;
const FAR_REACH: f32 = 0.42;

/// What a ray sees that hits nothing.
const SKY: Rgb = Rgb::new(0.12, 0.18, 0.3);

/// The place of a pixel, from −1 to 1; 0 to the bit in the middle.
fn place(side: u32, i: u32, j: u32) -> Vec2 {
    let middle = (side / 2) as f32;
    vec2(i as f32 - middle, j as f32 - middle) / middle
}

/// The ray of a pixel, looking along −z from an eye on the z axis.
fn ray(side: u32, i: u32, j: u32, eye: Vec3) -> Ray {
    let reach = if eye.z > FAR { FAR_REACH } else { REACH };
    Ray { origin: eye, direction: STEP * (reach * place(side, i, j)).extend(-1.0) }
}

/// Where a ray is after t steps.
fn at(ray: &Ray, t: f32) -> Vec3 {
    ray.origin + t * ray.direction
}

/// Brighter where it is nearer.
fn nearer(t: f32) -> f32 {
    (1.2 - 0.18 * t).clamp(0.05, 1.0)
}

fn sphere(center: Vec3, radius: f32) -> Sphere {
    Sphere { center, radius }
}

/// A sphere from outside, from inside, and one behind the eye: each point in the colour of its place on the sphere.
pub(super) fn ray_sphere(_: &Knobs<'_>) -> Vec<Panel> {
    let centers = [vec3(0.3, 0.2, -3.2), vec3(0.2, -0.1, -0.3), vec3(0.3, 0.2, 3.2)];
    let panel = |center: Vec3| {
        let sphere = sphere(center, 1.4);
        let question = move |i, j| Some(arguments![ray(THIRD, i, j, Vec3::ZERO), sphere]);
        let color = move |i, j, t: Option<f32>| {
            let Some(t) = t else { return Some(SKY) };
            Some(direction((at(&ray(THIRD, i, j, Vec3::ZERO), t) - center) / 1.4))
        };
        Panel::of_pixels((THIRD, THIRD), question, color)
    };
    centers.into_iter().map(panel).collect()
}

/// The triangle in the colours of its weights, darker farther off: seen from its front, from its back, behind the eye, and in the plane of the eye.
pub(super) fn ray_triangle(knobs: &Knobs<'_>) -> Vec<Panel> {
    // The figure's eye moves about the middle of its range.
    let eye = vec3(knobs.or("x", 1.0) - 1.0, knobs.or("y", 1.0) - 1.0, 0.4 * (knobs.or("z", 1.0) - 1.0));
    let front =
        Triangle { a: vec3(-1.1, -0.83, -2.0), b: vec3(1.24, -0.57, -2.4), c: vec3(0.11, 1.13, -2.9) };
    let back = Triangle { b: front.c, c: front.b, ..front };
    let behind = Triangle { a: -front.a, b: -front.b, c: -front.c };
    let level = Triangle { a: vec3(-1.0, 0.0, -2.0), b: vec3(1.0, 0.0, -2.0), c: vec3(0.0, 0.0, -4.0) };
    let panel = |(triangle, eye): (Triangle, Vec3)| {
        let question = move |i, j| Some(arguments![ray(THIRD, i, j, eye), triangle]);
        let color = |_, _, hit: Option<TriangleHit>| {
            let Some(TriangleHit { t, beta, gamma }) = hit else { return Some(SKY) };
            Some(nearer(t) * vec3(1.0 - beta - gamma, beta, gamma))
        };
        Panel::of_pixels((THIRD, THIRD), question, color)
    };
    [(front, eye), (back, eye), (behind, eye), (level, Vec3::ZERO)].into_iter().map(panel).collect()
}

/// The same triangle, if each pixel's system is the given one, which we solve: where β, γ and t say that it is hit.
pub(super) fn ray_triangle_system(knobs: &Knobs<'_>) -> Vec<Panel> {
    // Not the origin: there a point and a direction are the same numbers.
    let moved = vec3(knobs.or("x", 1.0), knobs.or("y", 1.0), 0.4 * knobs.or("z", 1.0)) - 1.0;
    let eye = moved + vec3(0.2, -0.1, 0.7);
    let triangle =
        Triangle { a: vec3(-1.1, -0.83, -2.0), b: vec3(1.24, -0.57, -2.4), c: vec3(0.11, 1.13, -2.9) };
    let question = move |i, j| Some(arguments![ray(SIDE, i, j, eye), triangle]);
    let color = |_, _, (a, b): (Mat3, Vec3)| {
        let Vec3 { x: beta, y: gamma, z: t } = a.inverse() * b;
        let is_hit = t > 0.0 && beta >= 0.0 && gamma >= 0.0 && beta + gamma <= 1.0;
        Some(if is_hit { nearer(t) * vec3(1.0 - beta - gamma, beta, gamma) } else { SKY })
    };
    vec![Panel::of_pixels((SIDE, SIDE), question, color)]
}

/// Some spheres before the eye, one through the other.
fn spheres() -> Vec<Sphere> {
    vec![
        sphere(vec3(0.9, 0.3, -5.0), 1.2),
        sphere(vec3(-0.6, -0.2, -3.1), 0.9),
        sphere(vec3(0.35, 0.55, -2.6), 0.45),
        sphere(vec3(-1.6, 1.3, -6.0), 1.0),
    ]
}

/// The nearest sphere, each in its own colour, darker farther off: all of space; and a slice that begins within a sphere and ends before the last one.
pub(super) fn nearest_hit(_: &Knobs<'_>) -> Vec<Panel> {
    let panel = |(t0, t1): (f32, f32)| {
        let question = move |i, j| Some(arguments![ray(SIDE, i, j, Vec3::ZERO), spheres(), t0, t1]);
        let color = |_, _, hit: Option<(usize, f32)>| {
            let Some((index, t)) = hit else { return Some(SKY) };
            Some(nearer(t) * tint(index))
        };
        Panel::of_pixels((SIDE, SIDE), question, color)
    };
    [(0.001, f32::INFINITY), (3.1 / STEP, 4.9 / STEP)].into_iter().map(panel).collect()
}

/// A colour for each of some things.
pub(super) fn tint(index: usize) -> Rgb {
    const TINTS: [Rgb; 5] = [
        Rgb::new(0.9, 0.3, 0.15),
        Rgb::new(0.2, 0.7, 0.3),
        Rgb::new(0.25, 0.4, 0.95),
        Rgb::new(0.9, 0.75, 0.2),
        Rgb::new(0.6, 0.25, 0.75),
    ];
    TINTS[index % TINTS.len()]
}

/// The point that a pixel sees of some spheres and of a floor below them.
fn seen(ray: &Ray, spheres: &[Sphere], floor: f32) -> Option<Vec3> {
    let ours = geometry::Ray::new(ray.origin, ray.direction);
    let hit = |s: &Sphere| {
        raytrace::sphere::intersect(&ours, &geometry::Sphere::new(s.center, s.radius), 0.001, f32::INFINITY)
    };
    let below = (floor - ray.origin.y) / ray.direction.y;
    let hits = spheres.iter().filter_map(hit).chain((below > 0.0 && below < 12.0).then_some(below));
    hits.min_by(f32::total_cmp).map(|t| at(ray, t))
}

/// Whether the way to the lamp neither touches a sphere nor almost does: the exercise asks of no such point, as rounding decides there.
fn is_decided(point: Vec3, lamp: Vec3, sphere: &Sphere) -> bool {
    let way = (lamp - point).normalize();
    let to_center = sphere.center - point;
    let beside = (to_center - to_center.dot(way) * way).length();
    (beside - sphere.radius).abs() > 0.01 * sphere.radius
}

/// Balls on a floor, light where the lamp is seen.
pub(super) fn in_shadow(knobs: &Knobs<'_>) -> Vec<Panel> {
    const EYE: Vec3 = vec3(0.0, 1.2, 6.5);
    let lamp = knobs.lamp();
    let spheres = vec![
        sphere(vec3(-0.9, 0.0, 0.0), 0.9),
        sphere(vec3(0.9, -0.3, 1.1), 0.6),
        sphere(vec3(0.5, 1.4, 0.2), 0.4),
        // Beyond the lamp: it hides nothing from the lamp.
        sphere(2.0 * lamp, 0.9),
    ];
    let question = |i, j| {
        let point = seen(&ray(SIDE, i, j, EYE), &spheres, -0.9)?;
        let is_asked = spheres.iter().all(|sphere| is_decided(point, lamp, sphere));
        is_asked.then(|| arguments![point, lamp, spheres.clone()])
    };
    let color = |_, _, dark: bool| Some(if dark { Rgb::splat(0.03) } else { Rgb::new(0.85, 0.78, 0.6) });
    vec![Panel::of_pixels((SIDE, SIDE), question, color)]
}

/// Balls in the light of a lamp, the last one large and below the others.
pub(super) fn ray_color(knobs: &Knobs<'_>) -> Vec<Panel> {
    const EYE: Vec3 = vec3(0.0, 0.6, 5.0);
    let p = knobs.exponents()[0];
    let ball = |center, radius, colour| Ball { sphere: sphere(center, radius), colour, exponent: p };
    // The one that is farthest away comes first in the list.
    let balls = vec![
        ball(vec3(0.4, -4.0, -0.5), 3.2, vec3(0.35, 0.4, 0.45)),
        ball(vec3(1.1, 0.3, -0.6), 0.8, vec3(0.3, 0.35, 0.9)),
        ball(vec3(-0.8, 0.1, 0.2), 0.85, vec3(0.9, 0.25, 0.15)),
        ball(vec3(0.15, -0.2, 1.3), 0.35, vec3(0.2, 0.7, 0.3)),
    ];
    let lamp = Lamp { position: knobs.lamp(), colour: vec3(1.5, 1.4, 1.2) };
    let question = |i, j| Some(arguments![ray(SIDE, i, j, EYE), balls.clone(), lamp, Vec3::splat(0.25), SKY]);
    vec![Panel::of_pixels((SIDE, SIDE), question, |_, _, c: Vec3| Some(c))]
}

/// Balls that mirror each other, as often as the figure says, and once.
pub(super) fn ray_color_recursive(knobs: &Knobs<'_>) -> Vec<Panel> {
    const EYE: Vec3 = vec3(0.0, 0.4, 5.0);
    let ball = |center, radius, colour, mirror| MirrorBall { sphere: sphere(center, radius), colour, mirror };
    let balls = vec![
        ball(vec3(0.4, -4.0, -0.5), 3.2, vec3(0.1, 0.12, 0.1), 0.5),
        ball(vec3(0.95, 0.1, 0.0), 0.8, vec3(0.05, 0.05, 0.2), 0.8),
        ball(vec3(-0.95, 0.1, 0.0), 0.8, vec3(0.4, 0.08, 0.05), 0.6),
        ball(vec3(0.0, 1.4, -0.4), 0.45, vec3(0.5, 0.4, 0.05), 0.3),
    ];
    let depth = knobs.or("depth", 4.0).clamp(0.0, 12.0) as u32;
    // After one reflection all see the sky, which is where a wrong end of the recursion shows most.
    let panel = |depth: u32| {
        let question = |i, j| Some(arguments![ray(SIDE, i, j, EYE), balls.clone(), SKY, depth]);
        Panel::of_pixels((SIDE, SIDE), question, |_, _, c: Vec3| Some(c))
    };
    vec![panel(depth), panel(1)]
}

/// What the rays of the window meet, a ball on a chequered floor; and where each is at t = 1, as a colour: there the pixel's centre should be.
pub(super) fn viewing_ray(_: &Knobs<'_>) -> Vec<Panel> {
    let eye = vec3(0.6, 0.5, 4.0);
    let w = vec3(0.15, 0.1, 1.0).normalize();
    let u = Vec3::Y.cross(w).normalize();
    let basis = Basis { u, v: w.cross(u), w };
    let volume = ViewVolume { left: -0.8, right: 1.0, bottom: -0.7, top: 0.9, near: -1.3, far: -20.0 };
    let question = move |i, j| Some(arguments![eye, basis, volume, SIDE, SIDE, i, j]);
    let ball = sphere(vec3(0.2, 0.0, 0.0), 0.9);
    let met = move |_, _, ray: Ray| {
        let Some(p) = seen(&ray, &[ball], -0.9) else { return Some(SKY) };
        if p.distance(ball.center) < 0.901 {
            return Some(direction((p - ball.center) / 0.9));
        }
        let is_even = (p.x.floor() + p.z.floor()).rem_euclid(2.0) == 0.0;
        Some(if is_even { Rgb::splat(0.7) } else { Rgb::splat(0.25) })
    };
    let reached = move |_, _, ray: Ray| {
        let s = at(&ray, 1.0) - eye;
        let window = vec3((s.dot(u) + 0.8) / 1.8, (s.dot(basis.v) + 0.7) / 1.6, (-s.dot(w) - 0.8) / 1.0);
        // At the eye all is as it is in the window, but shifted; the ray's beginning tells.
        Some(window + 0.3 * (ray.origin - eye).length())
    };
    vec![Panel::of_pixels((SIDE, SIDE), question, met), Panel::of_pixels((SIDE, SIDE), question, reached)]
}
