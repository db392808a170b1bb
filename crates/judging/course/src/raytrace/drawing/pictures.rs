//! What a ray tracer of this kind sees: the right picture, yours, and where they differ.

use glam::{Vec2, Vec3, vec2};
use sheet::{Ink, LETTER, Letters, Sheet, Side, Words};
use vocabulary::{Ball, MirrorBall, Ray, Sphere};
use worker::{Plain, Value};

use crate::exercise::{Picture, Seen};
use crate::stage::read;

/// Pixels of a picture on each side; odd, so that one is in the middle.
const SIDE: i32 = 27;

/// A pixel's size on the sheet, and the room around a picture.
const PIXEL: f32 = 8.0;
const GAP: f32 = 16.0;

/// Differences of a colour below this are not shown: no screen shows them.
const SAME: f32 = 4e-3;

/// Balls with shadows, seen from the ray's origin along the ray.
pub(crate) fn shadow_pictures(seen: &Seen<'_>) -> Option<Picture> {
    let balls: Vec<Ball> = read(seen.arguments.get(1)?)?;
    drawn(seen, &balls.iter().map(|ball| ball.sphere).collect::<Vec<_>>())
}

/// Mirrors, seen from the ray's origin along the ray.
pub(crate) fn mirror_pictures(seen: &Seen<'_>) -> Option<Picture> {
    let balls: Vec<MirrorBall> = read(seen.arguments.get(1)?)?;
    drawn(seen, &balls.iter().map(|ball| ball.sphere).collect::<Vec<_>>())
}

fn drawn(seen: &Seen<'_>, spheres: &[Sphere]) -> Option<Picture> {
    let (ray, others) = seen.arguments.split_first()?;
    let rays = rays(read(ray)?, spheres)?;
    let questions: Vec<Vec<Value>> =
        rays.into_iter().map(|ray| [&[ray.into_value()], others].concat()).collect();
    let colours = |answers: Vec<Option<Value>>| -> Vec<Option<Vec3>> {
        answers.iter().map(|answer| answer.as_ref().and_then(read)).collect()
    };
    let (right, yours) = (colours((seen.reference)(&questions)), colours((seen.yours)(&questions)));
    if right.len() != questions.len() {
        return None;
    }
    let yours = |k: usize| yours.get(k).copied().flatten();
    let size = SIDE as f32 * PIXEL;
    let mut sheet = Sheet::new(
        Vec2::ZERO,
        vec2(3.0 * size + 4.0 * GAP, size + 3.0 * LETTER + GAP),
        3.0 * size + 4.0 * GAP,
    );
    let mut squares = String::new();
    let titles = ["should be", "yours", "the difference"];
    for (part, title) in titles.into_iter().enumerate() {
        let left = GAP + part as f32 * (size + GAP);
        let place = sheet.place(left, 1.2 * LETTER);
        sheet.label(place, Side::Right, title, Letters::Plain, Ink::Main);
        let fill = |k: usize| {
            let colour = match part {
                0 => right[k],
                1 => yours(k),
                _ => right[k].zip(yours(k)).map(|(right, yours)| difference(right, yours)),
            };
            encoded(colour)
        };
        squares.push_str(&picture(vec2(left, 2.0 * LETTER), fill));
    }
    let note = sheet.place(GAP, size + 2.0 * LETTER + 0.8 * GAP);
    sheet.label_sized(
        note,
        Side::Right,
        "The frame in the middle: the ray of this call.",
        Letters::Plain,
        Ink::Faint,
        0.8 * LETTER,
    );
    let said = "Three small pictures of the scene: as it should be, yours, and where they differ.";
    let svg = sheet.svg(&Words::new(said, said));
    // The sheet knows inks; a picture has colours of its own.
    let svg = svg.replacen("</svg>", &format!("{squares}</svg>"), 1);
    Some(Picture { svg, text: None })
}

/// Rays from the given one's origin, row by row from above; the given one is in the middle, and the spheres before it are seen.
fn rays(ray: Ray, spheres: &[Sphere]) -> Option<Vec<Ray>> {
    let forwards = ray.direction.try_normalize()?;
    let right = forwards.cross(Vec3::Y).try_normalize().unwrap_or(forwards.any_orthonormal_vector());
    let up = right.cross(forwards);
    // The largest slope to a sphere's border, if it is not beside or behind the eye.
    let slope = |sphere: &Sphere| {
        let to = sphere.center - ray.origin;
        let depth = to.dot(forwards);
        (depth > 1.2 * sphere.radius).then(|| ((to - depth * forwards).length() + sphere.radius) / depth)
    };
    let reach = spheres.iter().filter_map(slope).fold(0.2_f32, f32::max).min(1.4);
    let half = SIDE / 2;
    let step = 1.1 * reach / half as f32;
    let places =
        (-half..=half).rev().flat_map(|y| (-half..=half).map(move |x| (x as f32 * step, y as f32 * step)));
    let length = ray.direction.length();
    let aimed = |(x, y): (f32, f32)| Ray { direction: length * (forwards + x * right + y * up), ..ray };
    // The one in the middle is the ray itself, to the bit.
    Some(places.map(|place| if place == (0.0, 0.0) { ray } else { aimed(place) }).collect())
}

/// Grey where the two are the same, brighter the more they differ.
fn difference(right: Vec3, yours: Vec3) -> Vec3 {
    let apart = (right - yours).abs();
    if apart.max_element() <= SAME { Vec3::splat(0.02) } else { (4.0 * apart).max(Vec3::new(0.3, 0.0, 0.0)) }
}

/// The squares of one picture, neighbours of one colour in one piece, and a frame around the pixel in the middle.
fn picture(corner: Vec2, fill: impl Fn(usize) -> Option<[u8; 3]>) -> String {
    let mut squares = "<g shape-rendering=\"crispEdges\">".to_owned();
    let side = SIDE as usize;
    for row in 0..side {
        let colours: Vec<Option<[u8; 3]>> = (0..side).map(|column| fill(row * side + column)).collect();
        let mut column = 0;
        for run in colours.chunk_by(|a, b| a == b) {
            let place = corner + PIXEL * vec2(column as f32, row as f32);
            squares.push_str(&square(place, PIXEL * run.len() as f32, run[0]));
            column += run.len();
        }
    }
    let Vec2 { x, y } = corner + PIXEL * (side / 2) as f32;
    squares
        + &format!(
            "<rect x=\"{x}\" y=\"{y}\" width=\"{PIXEL}\" height=\"{PIXEL}\" class=\"s s-a\" stroke-width=\"1.5\"/></g>"
        )
}

/// A row of pixels of one colour; a thin line where there is none.
fn square(Vec2 { x, y }: Vec2, width: f32, colour: Option<[u8; 3]>) -> String {
    match colour {
        Some([r, g, b]) => {
            format!(
                "<rect x=\"{x}\" y=\"{y}\" width=\"{width}\" height=\"{PIXEL}\" fill=\"#{r:02x}{g:02x}{b:02x}\"/>"
            )
        }
        None => format!("<path d=\"M{x} {}h{width}\" class=\"s s-faint\"/>", y + 0.5 * PIXEL),
    }
}

/// A linear colour as screens want it: sRGB, clamped (E8). `None` if it is none, or not a number.
fn encoded(linear: Option<Vec3>) -> Option<[u8; 3]> {
    let share = |linear: f32| {
        let linear = linear.clamp(0.0, 1.0);
        let encoded =
            if linear <= 0.003_130_8 { 12.92 * linear } else { 1.055 * linear.powf(1.0 / 2.4) - 0.055 };
        (255.0 * encoded).round() as u8
    };
    linear.filter(|colour| colour.is_finite()).map(|colour| colour.to_array().map(share))
}
