//! The viewing ray: at the left on the window, as the eye sees it; at the right from beside the camera.

use glam::{Vec2, Vec3, vec2, vec3};
use sheet::text::triple;
use sheet::view::View;
use sheet::{Ink, Letters, Side};
use vocabulary::{Basis, Ray, ViewVolume};

use super::{MARGIN, arrow, below_the_words, compared, mark, near};
use crate::exercise::{Picture, Seen};
use crate::stage::{Panel, RIGHT, YOURS, blank, finished, read};

const SIZE: Vec2 = vec2(760.0, 420.0);

/// Where the two rays pass the window.
pub(crate) fn ray_through_the_window(seen: &Seen<'_>) -> Option<Picture> {
    let [eye, basis, volume, width, height, i, j] = seen.arguments else { return None };
    let (eye, basis, volume): (Vec3, Basis, ViewVolume) = (read(eye)?, read(basis)?, read(volume)?);
    let grid: [u32; 4] = [read(width)?, read(height)?, read(i)?, read(j)?];
    let right: Ray = seen.right_as()?;
    let yours: Option<Ray> = seen.given_as();
    // Camera coordinates: the eye is the origin.
    let in_camera = |p: Vec3| vec3((p - eye).dot(basis.u), (p - eye).dot(basis.v), (p - eye).dot(basis.w));
    let ends = |ray: Ray| [in_camera(ray.origin), in_camera(ray.origin + ray.direction)];
    let (right, yours) = (ends(right), yours.map(ends));

    let mut sheet = blank(SIZE);
    let say = |[from, to]: [Vec3; 2]| {
        format!("from {} to {} at t = 1, in camera coordinates", triple(from), triple(to))
    };
    compared(&mut sheet, &yours.map_or("no ray".to_owned(), say), &say(right));
    let [low, high] = below_the_words(SIZE);
    on_the_window(&mut sheet, [low, vec2(0.5 * SIZE.x, high.y)], (&volume, grid), (right, yours));
    from_beside(&mut sheet, [vec2(0.5 * SIZE.x, 0.0), high], &volume, (right, yours));
    finished(
        sheet,
        "The pixels on the window and the ray from the eye through it: as it should be, and yours.",
    )
}

/// Both rays' starts and ends.
type Rays = ([Vec3; 2], Option<[Vec3; 2]>);

fn on_the_window(
    sheet: &mut sheet::Sheet,
    part: [Vec2; 2],
    (volume, [width, height, i, j]): (&ViewVolume, [u32; 4]),
    (right, yours): Rays,
) {
    let corner = vec2(volume.left, volume.bottom);
    let window = vec2(volume.right - volume.left, volume.top - volume.bottom);
    let place = |x: u32, y: u32| corner + window * vec2(x as f32 / width as f32, y as f32 / height as f32);
    let around = [place(0, 0), place(width, height), right[1].truncate()];
    let yours = yours.and_then(|ends| near(ends[1].truncate(), &around));
    let shown: Vec<Vec2> = around.into_iter().chain(yours).collect();
    let panel = Panel::showing(&shown, part, MARGIN);
    let pixel = [place(i, j), place(i + 1, j), place(i + 1, j + 1), place(i, j + 1)];
    sheet.wash(&panel.all_at(&pixel), Ink::B);
    let fine = Ink::Faint.pen().fine();
    (0..=width).for_each(|x| sheet.line(panel.at(place(x, 0)), panel.at(place(x, height)), fine));
    (0..=height).for_each(|y| sheet.line(panel.at(place(0, y)), panel.at(place(width, y)), fine));
    mark(sheet, panel.at(right[1].truncate()), RIGHT, 9.0);
    if let Some(p) = yours {
        mark(sheet, panel.at(p), YOURS, 13.0);
    }
}

fn from_beside(sheet: &mut sheet::Sheet, part: [Vec2; 2], volume: &ViewVolume, (right, yours): Rays) {
    let Ok(view) = View::new(vec3(4.0, 2.0, 1.5), Vec3::ZERO) else { return };
    let corner = |x: f32, y: f32| view.at(vec3(x, y, volume.near));
    let window = [
        corner(volume.left, volume.bottom),
        corner(volume.right, volume.bottom),
        corner(volume.right, volume.top),
        corner(volume.left, volume.top),
    ];
    let eye = view.at(Vec3::ZERO);
    let around: Vec<Vec2> = window.into_iter().chain([eye, view.at(right[1])]).collect();
    let yours = yours.map(|ends| ends.map(|p| view.at(p)));
    let yours = yours.filter(|ends| ends.iter().all(|p| near(*p, &around).is_some()));
    let shown: Vec<Vec2> = around.iter().copied().chain(yours.into_iter().flatten()).collect();
    let panel = Panel::showing(&shown, part, MARGIN);
    for corner in window {
        sheet.line(panel.at(eye), panel.at(corner), Ink::Faint.pen().fine().dashed());
    }
    sheet.polygon(&panel.all_at(&window), Ink::B.pen());
    arrow(sheet, panel.at(eye), panel.at(view.at(right[1])), RIGHT);
    if let Some([from, to]) = yours {
        arrow(sheet, panel.at(from), panel.at(to), YOURS);
        sheet.dot(panel.at(from), YOURS);
    }
    sheet.dot(panel.at(eye), Ink::Main);
    sheet.label(panel.at(eye), Side::Below, "e", Letters::Vector, Ink::Main);
}
