//! Where do axes and eyes go? As it should be at the left, yours at the right.

use glam::{Mat4, Vec2, Vec3, Vec4, vec2, vec3};
use sheet::label_layout::Vector;
use sheet::text::{decimal, triple};
use sheet::view::View;
use sheet::{Ink, LETTER, Sheet};
use vocabulary::Basis;

use super::{MARGIN, NOT_SHOWN, halves, heading, near, note};
use crate::exercise::{Picture, Seen};
use crate::stage::{Panel, blank, finished, read};

const SIZE: Vec2 = vec2(760.0, 400.0);

/// How long an arrow is on which a unit vector may lie: so much that both names can be read.
const LONGER: f32 = 1.5;

/// From where diagrams in space are seen.
fn view() -> Option<View> {
    View::new(vec3(2.2, 2.6, 4.0), Vec3::ZERO).ok()
}

/// The axes of `from` as arrows, and where the matrix carries them.
pub(crate) fn carried_axes(seen: &Seen<'_>) -> Option<Picture> {
    let [from, to] = seen.arguments else { return None };
    let (from, to): (Basis, Basis) = (read(from)?, read(to)?);
    axes_and_images(seen, from, to, ["from.u", "from.v", "from.w"])
}

/// The axes of `to` as arrows, and where the inverse carries them.
pub(crate) fn carried_back_axes(seen: &Seen<'_>) -> Option<Picture> {
    let [from, to] = seen.arguments else { return None };
    let (from, to): (Basis, Basis) = (read(from)?, read(to)?);
    axes_and_images(seen, to, from, ["to.u", "to.v", "to.w"])
}

/// The axes of one basis, thin and broken, and what becomes of them: those of the other, or where the given matrix puts them.
fn axes_and_images(
    seen: &Seen<'_>,
    before: Basis,
    right: Basis,
    names: [&'static str; 3],
) -> Option<Picture> {
    let m: Option<Mat4> = seen.given_as();
    let yours = m.map(|m| {
        let [u, v, w] = [before.u, before.v, before.w].map(|axis| m.transform_vector3(axis));
        Basis { u, v, w }
    });
    let faint: Vec<Arrow> = names
        .into_iter()
        .zip([before.u, before.v, before.w])
        .map(|(name, tip)| Arrow { name, tip: LONGER * tip, ink: Ink::Faint, dashed: true })
        .collect();
    let mut sheet = two_frames(&faint, Some(right), yours, ["should arrive here", "yours"])?;
    let last_row = m.map_or(Vec4::W, |m| m.row(3));
    if last_row.distance(Vec4::W).is_nan() || last_row.distance(Vec4::W) > 1e-3 {
        note(&mut sheet, SIZE.x / 2.0, format!("last row {}", quadruple(last_row)));
    }
    finished(sheet, "Three axes and where they are carried: as it should be at the left, yours at the right.")
}

/// Gaze and up with the camera's frame.
pub(crate) fn camera_axes(seen: &Seen<'_>) -> Option<Picture> {
    let [gaze, up] = seen.arguments else { return None };
    let (gaze, up): (Vec3, Vec3) = (read(gaze)?, read(up)?);
    let right: Option<Basis> = seen.right_as()?;
    let yours: Option<Basis> = seen.given_as::<Option<Basis>>().flatten();
    let directions = [
        Arrow { name: "gaze", tip: LONGER * gaze.normalize_or_zero(), ink: Ink::Main, dashed: false },
        Arrow { name: "up", tip: LONGER * up.normalize_or_zero(), ink: Ink::Main, dashed: true },
    ];
    let titles = [
        if right.is_some() { "the camera's frame" } else { "None: there is no frame" },
        match (seen.given, yours) {
            (Some(_), None) => "yours: None",
            _ => "yours",
        },
    ];
    let mut sheet = two_frames(&directions, right, yours, titles)?;
    if let Some(Basis { u, v, w }) = yours {
        let lengths = [u, v, w].map(Vec3::length);
        if lengths.iter().any(|length| (length - 1.0).abs() > 1e-3) {
            let [u, v, w] = lengths.map(|length| decimal(length, 2));
            note(&mut sheet, SIZE.x / 2.0, format!("lengths of u, v, w: {u}, {v}, {w}"));
        }
    }
    finished(sheet, "The gaze, up, and the camera's axes: as they should be at the left, yours at the right.")
}

/// An arrow from the origin.
struct Arrow {
    name: &'static str,
    tip: Vec3,
    ink: Ink,
    dashed: bool,
}

fn arrows(basis: Basis) -> [Arrow; 3] {
    let arrow = |name, tip, ink| Arrow { name, tip, ink, dashed: false };
    [arrow("u", basis.u, Ink::A), arrow("v", basis.v, Ink::B), arrow("w", basis.w, Ink::C)]
}

/// The same arrows twice, with the right frame at the left and the given one at the right.
fn two_frames(
    both: &[Arrow],
    right: Option<Basis>,
    yours: Option<Basis>,
    titles: [&str; 2],
) -> Option<Sheet> {
    let view = view()?;
    // Room for every unit vector, wherever it points, so that both halves have one scale.
    let around = [Vec2::splat(-LONGER), Vec2::splat(LONGER)];
    let mut sheet = blank(SIZE);
    for (k, (frame, part)) in [right, yours].into_iter().zip(halves(SIZE)).enumerate() {
        let panel = Panel::showing(&around, part, MARGIN);
        let mut drawn: Vec<Vector> = Vec::new();
        let frame = frame.map(arrows);
        for arrow in both.iter().chain(frame.iter().flatten()) {
            // Arrows without direction, or of no sensible length, are left out.
            let length = arrow.tip.length();
            if length > 0.02 && length < 2.0 {
                let vector = Vector::new(arrow.name, panel.at(view.at(arrow.tip)), arrow.ink);
                drawn.push(if arrow.dashed { vector.dashed() } else { vector });
            }
        }
        let missing = frame.is_some_and(|frame| frame.iter().any(|a| !a.tip.is_finite()));
        heading(&mut sheet, part, titles[k]);
        if missing {
            let place = vec2(part[0].x, part[1].y - LETTER);
            sheet.label(place, sheet::Side::Right, "not a number", sheet::Letters::Plain, Ink::A);
        }
        sheet.vectors(panel.at(Vec2::ZERO), &drawn);
        sheet.dot(panel.at(Vec2::ZERO), Ink::Main);
    }
    Some(sheet)
}

/// In camera space: the eye with its axes, and the world's origin.
pub(crate) fn world_before_the_camera(seen: &Seen<'_>) -> Option<Picture> {
    let [eye, frame] = seen.arguments else { return None };
    let (eye, frame): (Vec3, Basis) = (read(eye)?, read(frame)?);
    let view = view()?;
    // As large beside the eye's distance for a near eye as for a far one.
    let long = if eye == Vec3::ZERO { 1.0 } else { 0.6 * eye.length() };
    let points = [eye, eye + long * frame.u, eye + long * frame.v, eye + long * frame.w, Vec3::ZERO];
    let images = |m: Mat4| points.map(|p| view.at(m.project_point3(p))).to_vec();
    let origin_and_axes = [Vec3::ZERO, Vec3::X, Vec3::Y, Vec3::Z].map(|p| view.at(1.5 * long * p));
    let right = images(seen.right_as()?);
    let m: Option<Mat4> = seen.given_as();
    let around: Vec<Vec2> = right.iter().copied().chain(origin_and_axes).collect();
    let yours = m.map(images).and_then(|points| near(points, &around));

    let shown: Vec<Vec2> = around.iter().chain(yours.iter().flatten()).copied().collect();
    let mut sheet = blank(SIZE);
    let titles = ["in camera coordinates", "yours"];
    for (k, (points, part)) in [Some(&right), yours.as_ref()].into_iter().zip(halves(SIZE)).enumerate() {
        let panel = Panel::showing(&shown, part, MARGIN);
        heading(&mut sheet, part, titles[k]);
        let [origin, x, y, z] = origin_and_axes.map(|p| panel.at(p));
        let axis = |name, tip| Vector::new(name, tip, Ink::Faint).dashed();
        sheet.vectors(origin, &[axis("x", x), axis("y", y), axis("z", z)]);
        let Some([eye, u, v, w, world]) = points.and_then(|points| points.first_chunk()) else { continue };
        let [eye, u, v, w, world] = [eye, u, v, w, world].map(|p| panel.at(*p));
        sheet.line(eye, world, Ink::D.pen().fine().dashed());
        sheet.dot(world, Ink::D);
        sheet.vectors(
            eye,
            &[Vector::new("u", u, Ink::A), Vector::new("v", v, Ink::B), Vector::new("w", w, Ink::C)],
        );
        sheet.dot(eye, Ink::Main);
        let below = vec2(0.0, 0.9 * LETTER);
        sheet.names(&[(eye - below, "eye", Ink::Main), (world - below, "world", Ink::D)]);
    }
    let said = match (m, &yours) {
        (Some(m), Some(_)) => format!("the eye is at {}", triple(m.project_point3(eye))),
        _ => NOT_SHOWN.to_owned(),
    };
    note(&mut sheet, SIZE.x / 2.0, said);
    finished(
        sheet,
        "The eye with its axes and the world's origin in camera coordinates: as it should be, and yours.",
    )
}

fn quadruple(v: Vec4) -> String {
    let [x, y, z, w] = v.to_array().map(|x| decimal(x, 2));
    format!("({x}, {y}, {z}, {w})")
}
