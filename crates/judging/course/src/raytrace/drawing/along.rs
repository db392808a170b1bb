//! Spheres along a ray. Each is turned about the ray into the sheet: where the ray crosses it does not change by that.

use glam::{Vec2, Vec3, vec2};
use sheet::text::decimal;
use sheet::{Ink, LETTER, Letters, Side};
use vocabulary::{Ray, Sphere};

use super::{MARGIN, below_the_words, compared, mark};
use crate::exercise::{Picture, Seen};
use crate::stage::{Panel, RIGHT, YOURS, blank, extent, finished, read};

const SIZE: Vec2 = vec2(720.0, 360.0);

/// So far beyond everything else may a given t be drawn, as a share of the whole.
const BEYOND: f32 = 1.0;

/// The ray and one sphere, in their plane.
pub(crate) fn sphere_along_the_ray(seen: &Seen<'_>) -> Option<Picture> {
    let [ray, sphere] = seen.arguments else { return None };
    let (ray, sphere): (Ray, Sphere) = (read(ray)?, read(sphere)?);
    let right: Option<f32> = seen.right_as()?;
    let yours: Option<f32> = seen.given_as::<Option<f32>>().flatten();
    let words = [spoken(seen, yours.map(at_t)), right.map_or("None".to_owned(), at_t)];
    drawn(ray, &[sphere], (0.0, None), [yours, right], &words)
}

/// The ray and all spheres, and the interval.
pub(crate) fn nearest_along_the_ray(seen: &Seen<'_>) -> Option<Picture> {
    let [ray, spheres, t0, t1] = seen.arguments else { return None };
    let (ray, spheres): (Ray, Vec<Sphere>) = (read(ray)?, read(spheres)?);
    let interval: (f32, f32) = (read(t0)?, read(t1)?);
    let right: Option<(usize, f32)> = seen.right_as()?;
    let yours: Option<(usize, f32)> = seen.given_as::<Option<(usize, f32)>>().flatten();
    let say = |(index, t): (usize, f32)| format!("sphere {index} at t = {}", decimal(t, 3));
    let words = [spoken(seen, yours.map(say)), right.map_or("None".to_owned(), say)];
    let t = |hit: (usize, f32)| hit.1;
    drawn(ray, &spheres, (interval.0, Some(interval.1)), [yours.map(t), right.map(t)], &words)
}

/// The way from the point to the lamp.
pub(crate) fn on_the_way_to_the_lamp(seen: &Seen<'_>) -> Option<Picture> {
    let [point, light, spheres] = seen.arguments else { return None };
    let (point, light, spheres): (Vec3, Vec3, Vec<Sphere>) = (read(point)?, read(light)?, read(spheres)?);
    let say = |dark: bool| if dark { "in shadow" } else { "lit" }.to_owned();
    let words = [spoken(seen, seen.given_as().map(say)), say(seen.right_as()?)];
    drawn(Ray { origin: point, direction: light - point }, &spheres, (0.0, Some(1.0)), [None, None], &words)
}

fn at_t(t: f32) -> String {
    format!("t = {}", decimal(t, 3))
}

/// What was given, in words.
fn spoken(seen: &Seen<'_>, given: Option<String>) -> String {
    given.unwrap_or_else(|| if seen.given.is_some() { "None" } else { "no answer" }.to_owned())
}

/// Where a sphere's centre is: along the ray, in units of length, and beside it.
fn turned(ray: &Ray, sphere: &Sphere, side: f32) -> Vec2 {
    let d = ray.direction.normalize_or_zero();
    let along = d.dot(sphere.center - ray.origin);
    vec2(along, side * (ray.origin + along * d).distance(sphere.center))
}

fn drawn(
    ray: Ray,
    spheres: &[Sphere],
    (t0, t1): (f32, Option<f32>),
    [yours, right]: [Option<f32>; 2],
    words: &[String; 2],
) -> Option<Picture> {
    let length = ray.direction.length();
    // Neighbours lie on different sides, so that they do not hide each other.
    let sides = (0..spheres.len()).map(|k| if k % 2 == 0 { 1.0 } else { -1.0 });
    let centres: Vec<Vec2> =
        spheres.iter().zip(sides).map(|(sphere, side)| turned(&ray, sphere, side)).collect();
    let on_ray = |t: f32| vec2(t * length, 0.0);
    let ends = [0.0, t0, 1.0].into_iter().chain(t1).chain(right).filter(|t| t.is_finite()).map(on_ray);
    let corners = centres.iter().zip(spheres).flat_map(|(c, s)| [*c - s.radius, *c + s.radius]);
    let mut shown: Vec<Vec2> = ends.chain(corners).collect();
    let (least, greatest) = extent(&shown);
    let room = BEYOND * (greatest.x - least.x);
    let is_near = |x: f32| least.x - room <= x && x <= greatest.x + room;
    let yours = yours.map(on_ray).filter(|p| p.is_finite() && is_near(p.x));
    shown.extend(yours);
    let panel = Panel::showing(&shown, below_the_words(SIZE), MARGIN);
    let (least, greatest) = extent(&shown);

    let mut sheet = blank(SIZE);
    compared(&mut sheet, &words[0], &words[1]);
    for (k, (centre, sphere)) in centres.iter().zip(spheres).enumerate() {
        sheet.circle(panel.at(*centre), panel.scale * sphere.radius, Ink::B.pen());
        sheet.label_sized(
            panel.at(*centre),
            Side::Middle,
            k.to_string(),
            Letters::Plain,
            Ink::B,
            0.8 * LETTER,
        );
    }
    let behind = vec2(least.x.min(0.0), 0.0);
    sheet.line(panel.at(behind), panel.at(Vec2::ZERO), Ink::Faint.pen().fine().dashed());
    let end = t1.filter(|t| t.is_finite()).map_or(greatest.x, |t| t * length);
    sheet.line(
        panel.at(vec2(end, 0.0)),
        panel.at(vec2(greatest.x.max(end), 0.0)),
        Ink::Faint.pen().fine().dashed(),
    );
    super::arrow(&mut sheet, panel.at(Vec2::ZERO), panel.at(vec2(end, 0.0)), Ink::Main);
    let mut tick = |t: f32, name: &str| {
        let p = panel.at(on_ray(t));
        sheet.line(p - vec2(0.0, 8.0), p + vec2(0.0, 8.0), Ink::Main.pen());
        sheet.label_sized(p - vec2(0.0, 6.0), Side::Below, name, Letters::Plain, Ink::Main, 0.8 * LETTER);
    };
    tick(0.0, "0");
    if t0 > 0.0 {
        tick(t0, "t0");
    }
    if let Some(t1) = t1.filter(|t| t.is_finite()) {
        tick(t1, if t0 == 0.0 && t1 == 1.0 { "1" } else { "t1" });
    }
    if let Some(t) = right {
        mark(&mut sheet, panel.at(on_ray(t)), RIGHT, 9.0);
    }
    if let Some(p) = yours {
        mark(&mut sheet, panel.at(p), YOURS, 13.0);
    }
    finished(sheet, "A ray from left to right and the spheres along it, with the right answer and yours.")
}
