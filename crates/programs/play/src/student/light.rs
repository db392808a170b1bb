//! How does a lighting function look? As a ball in its light: once with the light before it, once with the light behind.

use std::f32::consts::PI;

use canvas::Rgb;
use course::{Plain, Value, arguments};
use glam::{Vec3, vec3};
use vocabulary::{Light, Material, SurfacePoint};

use super::knobs::Knobs;
use super::panel::Panel;

/// Pixels along each side of a ball.
const SIDE: u32 = 56;

/// The same in a row of them.
const SMALL: u32 = 36;

/// What the surface scatters.
const C_R: Vec3 = vec3(0.8, 0.35, 0.2);

/// Light brighter than white: who clamps a colour too early is seen.
const C_L: Vec3 = vec3(1.5, 1.4, 1.1);

/// Ambient light.
const C_A: Vec3 = vec3(0.25, 0.3, 0.45);

/// All balls are seen from here.
const TO_EYE: Vec3 = Vec3::Z;

/// The direction to a light at this angle from the gaze.
fn to_light(angle: f32) -> Vec3 {
    vec3(-0.8 * angle.sin(), 0.6 * angle.sin(), angle.cos())
}

/// The light of the figure, and the one as far behind the ball as that one is before it.
fn lights(knobs: &Knobs<'_>) -> [Vec3; 2] {
    let angle = knobs.angle();
    [angle, PI - angle].map(to_light)
}

/// A ball, each of its points asked with its normal.
fn ball<T: Plain>(
    side: u32,
    question: impl Fn(Vec3) -> Vec<Value>,
    color: impl Fn(Vec3, T) -> Option<Rgb> + Send + Sync + 'static,
) -> Panel {
    let colored = move |i, j, answer| color(normal(side, i, j)?, answer);
    Panel::of_pixels((side, side), |i, j| Some(question(normal(side, i, j)?)), colored)
}

/// The normal of a ball that fills a square, at a pixel; `None` beside it.
fn normal(side: u32, i: u32, j: u32) -> Option<Vec3> {
    let place = |k: u32| 1.04 * ((2 * k + 1) as f32 / side as f32 - 1.0);
    let (x, y) = (place(i), place(j));
    let depth = 1.0 - x * x - y * y;
    (depth > 0.0).then(|| vec3(x, y, depth.sqrt()).normalize())
}

/// A ball whose colour the function itself gives, in both lights.
fn colored(knobs: &Knobs<'_>, question: impl Fn(Vec3, Vec3) -> Vec<Value>) -> Vec<Panel> {
    lights(knobs).into_iter().map(|l| ball(SIDE, |n| question(n, l), |_, c: Vec3| Some(c))).collect()
}

pub(super) fn lambert(knobs: &Knobs<'_>) -> Vec<Panel> {
    colored(knobs, |n, l| arguments![C_R, C_L, n, l])
}

pub(super) fn ambient_and_diffuse(knobs: &Knobs<'_>) -> Vec<Panel> {
    colored(knobs, |n, l| arguments![C_R, C_A, C_L, n, l])
}

/// A ball for each exponent, and one with the light behind it.
fn gleaming(knobs: &Knobs<'_>, question: impl Fn(f32, Vec3, Vec3) -> Vec<Value>) -> Vec<Panel> {
    let (exponents, [before, behind]) = (knobs.exponents(), lights(knobs));
    let side = if exponents.len() > 2 { SMALL } else { SIDE };
    // Wide, so that a highlight where none belongs is seen.
    let widest = exponents.iter().copied().fold(2.0, f32::min);
    let balls = exponents.iter().map(|p| (*p, before)).chain([(widest, behind)]);
    balls.map(|(p, l)| ball(side, |n| question(p, n, l), |_, c: Vec3| Some(c))).collect()
}

pub(super) fn phong_highlight(knobs: &Knobs<'_>) -> Vec<Panel> {
    gleaming(knobs, |p, n, l| arguments![C_L, p, n, l, TO_EYE])
}

pub(super) fn blinn_phong(knobs: &Knobs<'_>) -> Vec<Panel> {
    gleaming(knobs, |p, n, l| arguments![Material { diffuse: C_R, exponent: p }, C_A, C_L, n, l, TO_EYE])
}

/// A sun, and a lamp near the ball.
pub(super) fn light_all(knobs: &Knobs<'_>) -> Vec<Panel> {
    gleaming(knobs, |p, n, l| {
        let sun = Light::Directional { to_light: l, colour: 0.8 * C_L };
        let lamp = Light::Point { position: vec3(2.2, -1.4, 1.0), colour: vec3(0.3, 0.7, 1.3) };
        let at = SurfacePoint { position: n, n, to_eye: TO_EYE };
        arguments![Material { diffuse: C_R, exponent: p }, C_A, vec![sun, lamp], at]
    })
}

/// The highlight that r gives, and r itself as a colour. The exercise's l has any length.
pub(super) fn reflection(knobs: &Knobs<'_>) -> Vec<Panel> {
    const LENGTH: f32 = 1.25;
    let (l, p) = (lights(knobs)[0], knobs.exponents()[0]);
    let question = move |n: Vec3| arguments![n, LENGTH * l];
    let highlight = move |n: Vec3, r: Vec3| {
        let share = if n.dot(l) > 0.0 { TO_EYE.dot(r / LENGTH).max(0.0).powf(p) } else { 0.0 };
        Some(Rgb::splat(share))
    };
    vec![ball(SIDE, question, highlight), ball(SIDE, question, |_, r: Vec3| Some(direction(r / LENGTH)))]
}

/// The highlight that h gives with eye and lamp near, and h itself as a colour for all angles between e and l: at the right edge they are opposite.
pub(super) fn halfway(knobs: &Knobs<'_>) -> Vec<Panel> {
    let (eye, lamp, p) = (4.0 * TO_EYE, 3.0 * lights(knobs)[0], knobs.exponents()[0]);
    let toward = |at: Vec3, from: Vec3| (at - from).normalize();
    let highlight = move |n: Vec3, h: Option<Vec3>| {
        let share = if n.dot(lamp - n) > 0.0 { n.dot(h?).max(0.0).powf(p) } else { 0.0 };
        Some(Rgb::splat(share))
    };
    let last = SIDE - 1;
    let between = move |i: u32, j: u32| {
        let (across, up) = (i as f32 / last as f32, j as f32 / last as f32);
        let e = to_light(PI * up);
        // Exactly opposite, to the bit.
        let l = if i == last {
            -e
        } else {
            glam::Quat::from_axis_angle(e.any_orthonormal_vector(), PI * across) * e
        };
        Some(arguments![e, l])
    };
    let colored = |_, _, h: Option<Vec3>| Some(h.map_or(Rgb::ZERO, direction));
    vec![
        ball(SIDE, move |n| arguments![toward(eye, n), toward(lamp, n)], highlight),
        Panel::of_pixels((SIDE, SIDE), between, colored),
    ]
}

/// A direction as a colour: its x, y and z from −1 to 1 are red, green and blue.
pub(super) fn direction(v: Vec3) -> Rgb {
    0.5 + 0.45 * v
}
