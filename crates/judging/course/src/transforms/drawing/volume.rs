//! What becomes of the viewing volume? A box, a cube: as it should be, and yours.

use glam::{Mat4, Vec2, Vec3, vec2, vec3};
use sheet::view::View;
use sheet::{Ink, Letters, Sheet, Side};
use vocabulary::ViewVolume;

use super::{MARGIN, NOT_SHOWN, halves, heading, near, note, rows};
use crate::exercise::{Picture, Seen};
use crate::stage::{Panel, RIGHT, YOURS, blank, finished, read};

const SIZE: Vec2 = vec2(760.0, 380.0);
const TALL: Vec2 = vec2(760.0, 520.0);

/// Depths at which points are put on each ray, as shares from near to far.
const DEPTHS: [f32; 5] = [0.0, 0.25, 0.5, 0.75, 1.0];
/// Where rays cross the near plane, in halves of the window's height.
const RAYS: [f32; 5] = [-1.0, -0.5, 0.0, 0.5, 1.0];

/// The pyramid from the side, and the box that it becomes: each scaled to its own width and height.
pub(crate) fn box_from_pyramid(seen: &Seen<'_>) -> Option<Picture> {
    let [n, f] = seen.arguments else { return None };
    let (n, f): (f32, f32) = (read(n)?, read(f)?);
    // The near plane at 0, the far one at 1; the window from −0.45 to 0.45.
    let on_sheet = |p: Vec3| vec2((n - p.z) / (n - f), 0.45 * p.y / n.abs());
    let points: Vec<Vec3> = DEPTHS
        .iter()
        .flat_map(|share| RAYS.map(|ray| vec3(0.0, ray * n.abs(), n) * (1.0 + share * (f / n - 1.0))))
        .collect();
    let images = |m: Mat4| points.iter().map(|p| on_sheet(m.project_point3(*p))).collect::<Vec<_>>();
    let right = images(seen.right_as()?);
    let yours = seen.given_as().and_then(|m| near(images(m), &right));

    let planes = [0.0, 1.0].map(|at| [vec2(at, -0.6), vec2(at, 0.6)]);
    let shown: Vec<Vec2> =
        right.iter().chain(yours.iter().flatten()).chain(planes.iter().flatten()).copied().collect();
    // A wrong image usually lies to the left or to the right: there is most room in wide halves.
    let mut sheet = blank(TALL);
    let titles = ["five rays after P, from the side", "yours"];
    for (k, (grid, part)) in [Some(&right), yours.as_ref()].into_iter().zip(rows(TALL)).enumerate() {
        let panel = Panel::showing(&shown, part, MARGIN);
        heading(&mut sheet, part, titles[k]);
        for ([low, high], name) in planes.iter().zip(["z = n", "z = f"]) {
            sheet.line(panel.at(*low), panel.at(*high), Ink::Faint.pen().dashed());
            sheet.label(panel.at(*low), Side::Below, name, Letters::Scalar, Ink::Faint);
        }
        if let Some(grid) = grid {
            rays_and_planes(&mut sheet, &panel.all_at(grid), [RIGHT, YOURS][k]);
        }
    }
    if yours.is_none() {
        note(&mut sheet, 12.0, NOT_SHOWN.to_owned());
    }
    finished(
        sheet,
        "Five rays of the viewing pyramid after the perspective matrix: parallel above, yours below.",
    )
}

/// The grid of points: along each ray a line, in each depth a line, the nearest wide.
fn rays_and_planes(sheet: &mut Sheet, grid: &[Vec2], ink: Ink) {
    let at = |depth: usize, ray: usize| grid[depth * RAYS.len() + ray];
    for ray in 0..RAYS.len() {
        let line: Vec<Vec2> = (0..DEPTHS.len()).map(|depth| at(depth, ray)).collect();
        sheet.path(&line, ink.pen());
    }
    for depth in 0..DEPTHS.len() {
        let line: Vec<Vec2> = (0..RAYS.len()).map(|ray| at(depth, ray)).collect();
        sheet.path(&line, if depth == 0 { Ink::B.pen().wide() } else { Ink::B.pen().fine() });
    }
    for p in grid {
        sheet.speck(*p, ink);
    }
    let above = vec2(0.0, 14.0);
    let [near, far] = [0, DEPTHS.len() - 1].map(|depth| at(depth, RAYS.len() - 1) + above);
    sheet.names(&[(near, "near", Ink::B), (far, "far", Ink::B)]);
}

/// The corners of the viewing volume in the canonical cube.
pub(crate) fn cube_from_pyramid(seen: &Seen<'_>) -> Option<Picture> {
    let [volume] = seen.arguments else { return None };
    let volume: ViewVolume = read(volume)?;
    // From above and from the right, the near face in front.
    let view = View::new(vec3(1.6, 1.2, 4.0), Vec3::ZERO).ok()?;
    let far = volume.far / volume.near;
    let corners: Vec<Vec3> = face(volume).into_iter().chain(face(volume).map(|p| p * far)).collect();
    let images = |m: Mat4| corners.iter().map(|p| view.at(m.project_point3(*p))).collect::<Vec<_>>();
    let right = images(seen.right_as()?);
    let yours = seen.given_as().and_then(|m| near(images(m), &right));

    let shown: Vec<Vec2> = right.iter().chain(yours.iter().flatten()).copied().collect();
    let mut sheet = blank(SIZE);
    let titles = ["the volume becomes the cube", "yours"];
    for (k, (corners, part)) in [Some(&right), yours.as_ref()].into_iter().zip(halves(SIZE)).enumerate() {
        let panel = Panel::showing(&shown, part, MARGIN);
        heading(&mut sheet, part, titles[k]);
        wires(&mut sheet, &panel.all_at(&right), [Ink::Faint.pen().dashed(); 3]);
        let Some(corners) = corners else { continue };
        let corners = panel.all_at(corners);
        sheet.wash(&corners[..4], Ink::B);
        wires(&mut sheet, &corners, [Ink::B.pen().wide(), Ink::D.pen(), Ink::Main.pen().fine()]);
        sheet.dot(corners[0], Ink::B);
        sheet.label(corners[0], Side::Below, "near l, b", Letters::Plain, Ink::B);
        sheet.label(corners[6], Side::Above, "far r, t", Letters::Plain, Ink::D);
    }
    if yours.is_none() {
        note(&mut sheet, SIZE.x / 2.0, NOT_SHOWN.to_owned());
    }
    finished(
        sheet,
        "The viewing volume's corners in the canonical cube: as they should be at the left, yours at the right.",
    )
}

/// The window's corners on the near plane: lower left, lower right, upper right, upper left.
fn face(volume: ViewVolume) -> [Vec3; 4] {
    let ViewVolume { left, right, bottom, top, near, .. } = volume;
    [(left, bottom), (right, bottom), (right, top), (left, top)].map(|(x, y)| vec3(x, y, near))
}

/// The edges of what was a box: the near face, the far face, what joins them, each with its pen.
fn wires(sheet: &mut Sheet, corners: &[Vec2], [near, far, between]: [sheet::Pen; 3]) {
    for k in 0..4 {
        sheet.line(corners[k], corners[k + 4], between);
    }
    sheet.polygon(&corners[4..], far);
    sheet.polygon(&corners[..4], near);
}
