//! How do the vectors of a lighting model lie? All in the plane of normal and light, which is the sheet.

use glam::{Vec2, Vec3, vec2};
use sheet::{Ink, Sheet};

use crate::figure::Text;
use crate::parameter::Parameter;

/// The normal of the surface, up on the sheet.
pub(super) const N: Vec3 = Vec3::Y;

/// The unit vector so many degrees from the normal, clockwise: to the right.
pub(super) fn direction(degrees: f32) -> Vec3 {
    let (sin, cos) = degrees.to_radians().sin_cos();
    Vec3::new(sin, cos, 0.0)
}

/// Where a vector that starts at the lit point ends on the sheet.
pub(super) fn tip(vector: Vec3) -> Vec2 {
    vector.truncate()
}

/// The least y that is drawn where everything lies above the surface: a little below it.
pub(super) const LOWEST: f32 = -0.12;

/// An empty sheet with half of the unit circle in which all unit vectors end, and room for words at the right. `lowest` is
/// the least y that must be seen.
pub(super) fn paper(lowest: f32) -> Sheet {
    let seen = [vec2(-1.15, lowest), vec2(1.15, 1.12)];
    let height = 60.0 + 205.0 * (1.12 - lowest);
    Sheet::around(&seen, vec2(760.0, height), 20.0, 230.0)
}

/// The same with the surface, from 1.1 at the left to 1.1 at the right, and that half circle.
pub(super) fn sheet(lowest: f32) -> Sheet {
    let mut sheet = paper(lowest);
    sheet.surface(vec2(-1.1, 0.0), vec2(1.1, 0.0));
    let circle: Vec<Vec2> = (-45..=45).map(|k| tip(direction(2.0 * k as f32))).collect();
    sheet.path(&circle, Ink::Faint.pen().fine().dashed());
    sheet
}

/// Pixels from the left where the words of a sheet of this kind begin.
pub(super) const WORDS: f32 = 515.0;

/// The angle of the light from the normal.
pub(super) const fn light(degrees: f32) -> Parameter {
    let label = Text { en: "angle between n and l, degrees", nl: "hoek tussen n en l, graden" };
    Parameter::number("light", label, degrees, 0.0, 85.0)
}

/// The angle of the eye from the normal.
pub(super) const fn eye(degrees: f32) -> Parameter {
    let label = Text {
        en: "angle between n and e, degrees; positive on the side of r",
        nl: "hoek tussen n en e, graden; positief aan de kant van r",
    };
    Parameter::number("eye", label, degrees, -85.0, 85.0)
}

/// The handle of l.
pub(super) const THE_LIGHT: Text = Text { en: "the light", nl: "het licht" };
/// The handle of e.
pub(super) const THE_EYE: Text = Text { en: "the eye", nl: "het oog" };
