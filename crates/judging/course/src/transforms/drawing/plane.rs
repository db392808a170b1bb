//! Where do points of the plane go? Before, as it should be, and yours, on one sheet.

use glam::{Mat3, Mat4, Vec2, Vec3, vec2};
use sheet::text::decimal;
use sheet::{Ink, Letters, Sheet, Side};
use vocabulary::ViewVolume;

use super::{MARGIN, NOT_SHOWN, legend, near, note};
use crate::exercise::{Picture, Seen};
use crate::stage::{Panel, RIGHT, YOURS, blank, finished, read};

/// The letter F: it shows a turn, a mirror and a transposition at once.
const LETTER_F: [Vec2; 10] = [
    vec2(0.0, 0.0),
    vec2(0.0, 2.0),
    vec2(1.2, 2.0),
    vec2(1.2, 1.6),
    vec2(0.4, 1.6),
    vec2(0.4, 1.2),
    vec2(0.9, 1.2),
    vec2(0.9, 0.8),
    vec2(0.4, 0.8),
    vec2(0.4, 0.0),
];

const SIZE: Vec2 = vec2(620.0, 460.0);
const BELOW_THE_LEGEND: [Vec2; 2] = [vec2(0.0, 28.0), vec2(SIZE.x, SIZE.y - 34.0)];

/// A letter beside the centre p, turned about it.
pub(crate) fn rotation(seen: &Seen<'_>) -> Option<Picture> {
    let [_, p] = seen.arguments else { return None };
    let (p, right): (Vec2, Mat3) = (read(p)?, seen.right_as()?);
    let size = (p.length() / 3.0).max(0.5);
    let before: Vec<Vec2> = LETTER_F.iter().map(|corner| p + size * (*corner + vec2(0.8, 0.3))).collect();
    // The centre goes along, as the last point.
    let with_centre: Vec<Vec2> = before.iter().copied().chain([p]).collect();
    let right = carried(right, &with_centre);
    let around: Vec<Vec2> = right.iter().chain(&with_centre).copied().chain([Vec2::ZERO]).collect();
    let yours = seen.given_as().and_then(|m: Mat3| near(carried(m, &with_centre), &around));

    let shown: Vec<Vec2> = around.iter().chain(yours.iter().flatten()).copied().collect();
    let panel = Panel::showing(&shown, BELOW_THE_LEGEND, MARGIN);
    let mut sheet = blank(SIZE);
    axes(&mut sheet, panel.at(Vec2::ZERO));
    sheet.polygon(&panel.all_at(&before), Ink::Faint.pen());
    for (carried, ink) in [(Some(&right), RIGHT), (yours.as_ref(), YOURS)] {
        let Some((centre, letter)) = carried.and_then(|points| points.split_last()) else { continue };
        let letter = panel.all_at(letter);
        sheet.wash(&letter, ink);
        sheet.polygon(&letter, ink.pen());
        sheet.dot(panel.at(*centre), ink);
    }
    if let Some(centre) = yours.as_ref().and_then(|points| points.last())
        && panel.scale * centre.distance(p) > 8.0
    {
        sheet.label(panel.at(*centre), Side::BelowRight, "M·p", Letters::Vector, YOURS);
    }
    sheet.label(panel.at(p), Side::AboveLeft, "p", Letters::Vector, Ink::Main);
    legend(&mut sheet, &[("before", Ink::Faint), ("turned about p", RIGHT), ("yours", YOURS)]);
    if yours.is_none() {
        note(&mut sheet, 12.0, NOT_SHOWN.to_owned());
    }
    finished(sheet, "A letter F beside the point p, turned about p, and where your matrix carries it.")
}

/// Where a matrix carries points of the plane, after division by the third coordinate.
fn carried(m: Mat3, points: &[Vec2]) -> Vec<Vec2> {
    points
        .iter()
        .map(|p| {
            let image = m * p.extend(1.0);
            image.truncate() / image.z
        })
        .collect()
}

/// Short axes x and y at the origin.
fn axes(sheet: &mut Sheet, origin: Vec2) {
    for (axis, name, side) in [(Vec2::X, "x", Side::Right), (Vec2::Y, "y", Side::Left)] {
        let tip = origin + 46.0 * axis;
        sheet.arrow(origin, tip, Ink::Faint.pen());
        sheet.label(tip, side, name, Letters::Scalar, Ink::Faint);
    }
}

/// More cells than this along a side are not drawn one by one.
const MOST_CELLS: u32 = 32;

/// The canonical square over the pixels of the screen.
pub(crate) fn square_on_the_screen(seen: &Seen<'_>) -> Option<Picture> {
    let [width, height] = seen.arguments else { return None };
    let (width, height): (u32, u32) = (read(width)?, read(height)?);
    let last = vec2(width as f32, height as f32) - 0.5;
    let screen = rectangle(Vec2::splat(-0.5), last);
    let yours: Option<Mat4> = seen.given_as();
    let square = yours.and_then(|m| {
        let corners = rectangle(Vec2::NEG_ONE, Vec2::ONE);
        near(corners.iter().map(|p| m.project_point3(p.extend(0.0)).truncate()).collect(), &screen)
    });

    let shown: Vec<Vec2> = screen.iter().chain(square.iter().flatten()).copied().collect();
    let panel = Panel::showing(&shown, BELOW_THE_LEGEND, MARGIN);
    let mut sheet = blank(SIZE);
    cells(&mut sheet, &panel, [screen[0], screen[2]], (width, height));
    outline(&mut sheet, &panel, &screen, RIGHT, "(−1, −1)");
    match &square {
        Some(square) => outline(&mut sheet, &panel, square, YOURS, "(−1, −1)"),
        None => note(&mut sheet, 12.0, NOT_SHOWN.to_owned()),
    }
    legend(&mut sheet, &[("pixels", Ink::Faint), ("the square [−1, 1]²", RIGHT), ("yours", YOURS)]);
    // Depth cannot be seen from the front.
    let depth = yours.map(|m| m.project_point3(Vec3::new(0.0, 0.0, 0.5)).z);
    if let Some(z) = depth.filter(|z| *z != 0.5 && square.is_some()) {
        note(&mut sheet, 12.0, format!("z = 0.5 becomes {}, should stay", decimal(z, 2)));
    }
    finished(
        sheet,
        format!(
            "A screen of {width} × {height} pixels, and where your matrix puts the canonical square on it."
        ),
    )
}

/// The pixels' centres on the window.
pub(crate) fn pixels_on_the_window(seen: &Seen<'_>) -> Option<Picture> {
    let [volume, width, height] = seen.arguments else { return None };
    let (volume, width, height): (ViewVolume, u32, u32) = (read(volume)?, read(width)?, read(height)?);
    let right: Mat3 = seen.right_as()?;
    let window = rectangle(vec2(volume.left, volume.bottom), vec2(volume.right, volume.top));
    let last = vec2(width as f32, height as f32) - 0.5;
    let screen = rectangle(Vec2::splat(-0.5), last);
    let yours: Option<Mat3> = seen.given_as();
    let image = yours.and_then(|m| near(carried(m, &screen), &window));

    let shown: Vec<Vec2> = window.iter().chain(image.iter().flatten()).copied().collect();
    let panel = Panel::showing(&shown, BELOW_THE_LEGEND, MARGIN);
    let mut sheet = blank(SIZE);
    cells(&mut sheet, &panel, [window[0], window[2]], (width, height));
    outline(&mut sheet, &panel, &window, RIGHT, "(l, b)");
    centres(&mut sheet, &panel, right, (width, height), RIGHT);
    match (yours, &image) {
        (Some(m), Some(image)) => {
            outline(&mut sheet, &panel, image, YOURS, "(−½, −½)");
            centres(&mut sheet, &panel, m, (width, height), YOURS);
        }
        _ => note(&mut sheet, 12.0, NOT_SHOWN.to_owned()),
    }
    legend(&mut sheet, &[("window, pixels' centres", RIGHT), ("yours", YOURS)]);
    finished(
        sheet,
        format!(
            "A window cut into {width} × {height} cells, the centres of the pixels on it, and where yours lie."
        ),
    )
}

/// Lower left, lower right, upper right, upper left.
fn rectangle(least: Vec2, greatest: Vec2) -> Vec<Vec2> {
    vec![least, vec2(greatest.x, least.y), greatest, vec2(least.x, greatest.y)]
}

/// Lines between cells, as many across and upwards as `counts` says, unless they are too many to see.
fn cells(sheet: &mut Sheet, panel: &Panel, [least, greatest]: [Vec2; 2], counts: (u32, u32)) {
    if counts.0.max(counts.1) > MOST_CELLS {
        return;
    }
    for k in 1..counts.0 {
        let x = least.x + (greatest.x - least.x) * k as f32 / counts.0 as f32;
        sheet.line(panel.at(vec2(x, least.y)), panel.at(vec2(x, greatest.y)), Ink::Faint.pen().fine());
    }
    for k in 1..counts.1 {
        let y = least.y + (greatest.y - least.y) * k as f32 / counts.1 as f32;
        sheet.line(panel.at(vec2(least.x, y)), panel.at(vec2(greatest.x, y)), Ink::Faint.pen().fine());
    }
}

/// The outline of a quadrangle, its first corner marked and named.
fn outline(sheet: &mut Sheet, panel: &Panel, corners: &[Vec2], ink: Ink, first: &str) {
    let corners = panel.all_at(corners);
    let pen = if ink == YOURS { ink.pen().wide().dashed() } else { ink.pen().wide() };
    sheet.polygon(&corners, pen);
    sheet.dot(corners[0], ink);
    let side = if ink == YOURS { Side::AboveRight } else { Side::Below };
    sheet.label(corners[0], side, first, Letters::Plain, ink);
}

/// The centres of all pixels, where a matrix carries them.
fn centres(sheet: &mut Sheet, panel: &Panel, m: Mat3, counts: (u32, u32), ink: Ink) {
    if counts.0.max(counts.1) > MOST_CELLS {
        return;
    }
    let pixels: Vec<Vec2> =
        (0..counts.1).flat_map(|j| (0..counts.0).map(move |i| vec2(i as f32, j as f32))).collect();
    // A matrix with strange numbers may carry corners to points and centres to none.
    for p in carried(m, &pixels).into_iter().filter(|p| p.is_finite()) {
        sheet.speck(panel.at(p), ink);
    }
}
