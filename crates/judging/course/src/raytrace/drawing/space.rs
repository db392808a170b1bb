//! Ray and triangle from outside, with the points that are right and those that were given.

use glam::{Mat3, Vec2, Vec3, vec2, vec3};
use sheet::text::decimal;
use sheet::view::View;
use sheet::{Ink, Letters, Sheet, Side};
use vocabulary::{Ray, Triangle, TriangleHit};

use super::{MARGIN, arrow, below_the_words, compared, mark, near};
use crate::exercise::{Picture, Seen};
use crate::stage::{Panel, RIGHT, YOURS, blank, finished, read};

const SIZE: Vec2 = vec2(720.0, 460.0);

/// Where ray and triangle meet.
pub(crate) fn triangle_from_outside(seen: &Seen<'_>) -> Option<Picture> {
    let [ray, triangle] = seen.arguments else { return None };
    let (ray, triangle): (Ray, Triangle) = (read(ray)?, read(triangle)?);
    let right: Option<TriangleHit> = seen.right_as()?;
    let yours: Option<TriangleHit> = seen.given_as::<Option<TriangleHit>>().flatten();
    let say = |hit: Option<TriangleHit>| {
        hit.map_or("no hit".to_owned(), |hit| unknowns(vec3(hit.beta, hit.gamma, hit.t)))
    };
    let x = |hit: TriangleHit| vec3(hit.beta, hit.gamma, hit.t);
    let words = [if seen.given.is_some() { say(yours) } else { "no answer".to_owned() }, say(right)];
    drawn(ray, triangle, [yours.map(x), right.map(x)], &words)
}

/// The solution of the given system, and of the right one.
pub(crate) fn solved_system(seen: &Seen<'_>) -> Option<Picture> {
    let [ray, triangle] = seen.arguments else { return None };
    let (ray, triangle): (Ray, Triangle) = (read(ray)?, read(triangle)?);
    let solution = |(matrix, right): (Mat3, Vec3)| {
        let x = (matrix.as_dmat3().inverse() * right.as_dvec3()).as_vec3();
        x.is_finite().then_some(x)
    };
    let right = solution(seen.right_as()?);
    let system: Option<(Mat3, Vec3)> = seen.given_as();
    let yours = system.and_then(solution);
    let say = |x: Option<Vec3>| x.map_or("no solution".to_owned(), unknowns);
    let picture = drawn(ray, triangle, [yours, right], &[say(yours), say(right)])?;
    let text = system
        .map(|system| [rows("should be", seen.right_as()?), rows("yours", Some(system))].concat().into());
    Some(Picture { text: text.flatten(), ..picture })
}

/// A system as three lines: [ 1 2 3 ] (β) = [ 4 ].
fn rows(name: &str, system: Option<(Mat3, Vec3)>) -> String {
    let Some((matrix, right)) = system else { return String::new() };
    let line = |k: usize| {
        let Vec3 { x, y, z } = matrix.row(k);
        let unknown = ["β", "γ", "t"][k];
        let title = if k == 1 { name } else { "" };
        format!(
            "{title:>10}  [{} {} {} ]  ({unknown})  =  [{} ]\n",
            cell(x),
            cell(y),
            cell(z),
            cell(right[k])
        )
    };
    (0..3).map(line).collect::<String>() + "\n"
}

/// A number that fits its column, whatever it is.
fn cell(x: f32) -> String {
    let plain = format!("{:>9}", decimal(x, 3));
    if x.is_finite() && plain.chars().count() <= 9 { plain } else { format!("{x:>9.1e}") }
}

fn unknowns(x: Vec3) -> String {
    format!("β = {}, γ = {}, t = {}", decimal(x.x, 3), decimal(x.y, 3), decimal(x.z, 3))
}

/// The direction from which ray and triangle are seen least edge-on.
fn view(ray: &Ray, triangle: &Triangle) -> Option<View> {
    let sides = [
        vec3(2.2, 1.8, 4.0),
        vec3(-3.5, 2.0, 2.5),
        vec3(4.0, 1.5, -1.0),
        vec3(1.5, 4.5, 1.5),
        vec3(-1.0, -2.0, 4.0),
    ];
    let normal = (triangle.b - triangle.a).cross(triangle.c - triangle.a).normalize_or_zero();
    let along = ray.direction.normalize_or_zero();
    let shows = |side: Vec3| side.normalize().dot(normal).abs().min(side.normalize().cross(along).length());
    let best = sides.into_iter().max_by(|s, t| shows(*s).total_cmp(&shows(*t)))?;
    View::new(best, Vec3::ZERO).ok()
}

/// Each answer as two points: that of the ray at t, that of the plane at β and γ. They are one if the answer is right.
fn drawn(ray: Ray, triangle: Triangle, answers: [Option<Vec3>; 2], words: &[String; 2]) -> Option<Picture> {
    let view = view(&ray, &triangle)?;
    let Triangle { a, b, c } = triangle;
    let corners = [a, b, c].map(|p| view.at(p));
    let pair =
        |x: Vec3| [ray.origin + x.z * ray.direction, a + x.x * (b - a) + x.y * (c - a)].map(|p| view.at(p));
    let [yours, right] = answers.map(|x| x.map(pair));
    // Without a hit the ray is drawn past the triangle.
    let reach = answers[1].map_or(2.0, |x| 1.3 * x.z.max(1.0)).min(8.0);
    let (origin, tip) = (view.at(ray.origin), view.at(ray.origin + reach * ray.direction));
    let around: Vec<Vec2> =
        corners.into_iter().chain([origin, tip]).chain(right.into_iter().flatten()).collect();
    let yours = yours.map(|pair| pair.map(|p| near(p, &around)));
    let seen: Vec<Vec2> = around.iter().copied().chain(yours.into_iter().flatten().flatten()).collect();
    let panel = Panel::showing(&seen, below_the_words(SIZE), MARGIN);

    let mut sheet = blank(SIZE);
    compared(&mut sheet, &words[0], &words[1]);
    sheet.wash(&panel.all_at(&corners), Ink::B);
    sheet.polygon(&panel.all_at(&corners), Ink::B.pen());
    named(&mut sheet, &panel, corners);
    arrow(&mut sheet, panel.at(origin), panel.at(tip), Ink::Main);
    sheet.dot(panel.at(origin), Ink::Main);
    sheet.label(panel.at(origin), Side::Below, "e", Letters::Vector, Ink::Main);
    if let Some([p, _]) = right {
        mark(&mut sheet, panel.at(p), RIGHT, 9.0);
    }
    if let Some([on_ray, on_plane]) = yours {
        for p in [on_ray, on_plane].into_iter().flatten() {
            mark(&mut sheet, panel.at(p), YOURS, 13.0);
        }
        if let (Some(p), Some(q)) = (on_ray, on_plane) {
            sheet.line(panel.at(p), panel.at(q), YOURS.pen().fine().dashed());
        }
    }
    finished(
        sheet,
        "A ray and a triangle from outside, with the point where they should meet and where yours is.",
    )
}

/// The corners' names, away from the middle.
fn named(sheet: &mut Sheet, panel: &Panel, corners: [Vec2; 3]) {
    let middle = panel.at((corners[0] + corners[1] + corners[2]) / 3.0);
    for (corner, name) in corners.into_iter().zip(["a", "b", "c"]) {
        let p = panel.at(corner);
        let place = p + 14.0 * (p - middle).normalize_or_zero();
        sheet.label(place, Side::Middle, name, Letters::Vector, Ink::B);
    }
}
