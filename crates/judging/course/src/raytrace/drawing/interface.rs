//! A ray at the surface of glass, in the plane of ray and normal.

use glam::{Vec2, Vec3, vec2};
use sheet::text::{decimal, degrees};
use sheet::{Ink, Letters, Side};

use super::compared;
use crate::exercise::{Picture, Seen};
use crate::stage::{RIGHT, YOURS, blank, finished, read};

const SIZE: Vec2 = vec2(560.0, 500.0);

/// The length of a unit vector, in pixels.
const UNIT: f32 = 170.0;

/// The ray before the surface, the right one behind it, and yours.
pub(crate) fn bent_ray(seen: &Seen<'_>) -> Option<Picture> {
    let [direction, normal, ratio] = seen.arguments else { return None };
    let (d, n, ratio): (Vec3, Vec3, f32) = (read(direction)?, read(normal)?, read(ratio)?);
    let right: Option<Vec3> = seen.right_as()?;
    let yours: Option<Vec3> = seen.given_as::<Option<Vec3>>().flatten();
    let along = (d - d.dot(n) * n).try_normalize().unwrap_or(n.any_orthonormal_vector());
    let flat = |v: Vec3| vec2(v.dot(along), v.dot(n));
    let say = |on: Option<Vec3>| match on.map(flat) {
        None => "None: nothing passes".to_owned(),
        Some(on) if !on.is_finite() => "not a number".to_owned(),
        Some(on) => format!(
            "{} from the normal, length {}",
            degrees(on.angle_to(Vec2::NEG_Y).abs()),
            decimal(on.length(), 3)
        ),
    };

    let mut sheet = blank(SIZE);
    let words = if seen.given.is_some() { say(yours) } else { "no answer".to_owned() };
    compared(&mut sheet, &words, &say(right));
    let middle = vec2(SIZE.x / 2.0, (SIZE.y - 50.0) / 2.0);
    let at = |v: Vec2| middle + UNIT * v;
    sheet.wash(
        &[at(vec2(-1.4, 0.0)), at(vec2(1.4, 0.0)), at(vec2(1.4, -1.15)), at(vec2(-1.4, -1.15))],
        Ink::B,
    );
    sheet.line(at(vec2(-1.4, 0.0)), at(vec2(1.4, 0.0)), Ink::B.pen());
    sheet.line(at(Vec2::Y), at(Vec2::NEG_Y), Ink::Faint.pen().fine().dashed());
    sheet.label(at(vec2(0.0, 1.0)), Side::Right, "n", Letters::Vector, Ink::Main);
    let media = if ratio < 1.0 { "denser" } else { "less dense" };
    sheet.label(at(vec2(-1.35, -1.05)), Side::Right, media, Letters::Plain, Ink::B);
    sheet.arrow(at(-flat(d)), at(Vec2::ZERO), Ink::Main.pen());
    // Where nothing passes all is mirrored.
    let mirrored = flat(d - 2.0 * d.dot(n) * n);
    match right.map(flat) {
        Some(on) => sheet.arrow(at(Vec2::ZERO), at(on), RIGHT.pen().wide()),
        None => sheet.arrow(at(Vec2::ZERO), at(mirrored), Ink::Faint.pen().dashed()),
    }
    if let Some(on) = yours.map(flat).filter(|on| on.length() > 0.1 && on.length() < 1.6) {
        sheet.arrow(at(Vec2::ZERO), at(on), YOURS.pen());
    }
    finished(sheet, "A ray at a surface: before it, and behind it as it should go on and as yours does.")
}
