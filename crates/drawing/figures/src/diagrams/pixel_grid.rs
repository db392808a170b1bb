//! Which point of the window belongs to a pixel? (L9, Fig 4.7)

use glam::{Mat3, Vec2, vec2};
use sheet::text::decimal;
use sheet::{Ink, Letters, Sheet, Side};
use transforms::affine2::{scale, translate};
use transforms::{ViewVolume, viewport};

use crate::figure::{Drawing, Drawn, Figure, Text, Words};
use crate::handle::{Handled, Handles, with_handles};
use crate::parameter::{Parameter, Values};

pub(super) static FIGURE: Figure = Figure {
    numbers: &["L9", "L8"],
    name: "pixel-grid",
    title: Text { en: "Rays through pixel centres", nl: "Rays door pixelcentra" },
    caption: Text {
        en: "Left the screen [−½, n_x−½] × [−½, n_y−½], where the centres of pixels are whole numbers; right the window [l, r] × [b, t] in the view plane. The window transform carries one to the other, and a ray goes through each dot at the right.",
        nl: "Links het scherm [−½, n_x−½] × [−½, n_y−½], waar pixelcentra gehele getallen zijn; rechts het venster [l, r] × [b, t] in het viewplane. De windowtransformatie voert het ene over in het andere, en door elke stip rechts gaat een straal.",
    },
    parameters: &[
        Parameter::count(
            "n_x",
            Text { en: "pixels in a row, n_x", nl: "pixels op een rij, n_x" },
            8.0,
            1.0,
            16.0,
        ),
        Parameter::count(
            "n_y",
            Text { en: "pixels in a column, n_y", nl: "pixels in een kolom, n_y" },
            5.0,
            1.0,
            12.0,
        ),
        Parameter::count(
            "i",
            Text { en: "column i; at most n_x − 1", nl: "kolom i; hoogstens n_x − 1" },
            6.0,
            0.0,
            15.0,
        ),
        Parameter::count(
            "j",
            Text { en: "row j, upwards; at most n_y − 1", nl: "rij j, omhoog; hoogstens n_y − 1" },
            1.0,
            0.0,
            11.0,
        ),
    ],
    size: (640, 480),
    draw,
    handles,
};

/// Not in the middle, so that no number stands for two things; near and far do not matter here.
const VOLUME: ViewVolume =
    ViewVolume { left: -2.0, right: 4.0, bottom: -1.0, top: 3.0, near: -1.0, far: -9.0 };

/// The room for each of the two grids, in pixels.
const ROOM: Vec2 = vec2(290.0, 240.0);

/// Where both grids lie on the sheet.
struct Layout {
    pixels: (u32, u32),
    pixel: (u32, u32),
    sheet_from_screen: Mat3,
    /// By way of the window.
    sheet_from_pixel: Mat3,
}

impl Layout {
    fn of(values: &Values) -> Self {
        let (n_x, n_y) = (values.count("n_x"), values.count("n_y"));
        // A column or row beyond the screen is the last one.
        let pixel = (values.count("i").min(n_x - 1), values.count("j").min(n_y - 1));
        let (half, size) = (Vec2::splat(0.5), vec2(n_x as f32, n_y as f32));
        let (lower_left, upper_right) = (vec2(VOLUME.left, VOLUME.bottom), vec2(VOLUME.right, VOLUME.top));
        let sheet_from_window = fitted(lower_left, upper_right, vec2(420.0, 150.0));
        Self {
            pixels: (n_x, n_y),
            pixel,
            sheet_from_screen: fitted(-half, size - half, vec2(60.0, 150.0)),
            sheet_from_pixel: sheet_from_window * viewport::window_from_pixel(&VOLUME, n_x, n_y),
        }
    }

    /// The middle of the pixel, on the screen and in the window.
    fn middles(&self) -> [Vec2; 2] {
        let pixel = vec2(self.pixel.0 as f32, self.pixel.1 as f32);
        [self.sheet_from_screen, self.sheet_from_pixel].map(|map| map.transform_point2(pixel))
    }
}

fn sheet() -> Sheet {
    Sheet::new(Vec2::ZERO, vec2(760.0, 440.0), 760.0)
}

fn draw(values: &Values) -> Drawn {
    let Layout { pixels: (n_x, n_y), pixel: (i, j), sheet_from_screen, sheet_from_pixel } =
        Layout::of(values);
    let (half, size) = (Vec2::splat(0.5), vec2(n_x as f32, n_y as f32));
    let pixel = vec2(i as f32, j as f32);
    let window = viewport::window_point(&VOLUME, n_x, n_y, pixel);
    let mut sheet = sheet();
    let corners = [
        (sheet_from_screen, Ink::A, "(−½, −½)".to_owned(), "(n_x−½, n_y−½)".to_owned()),
        (sheet_from_pixel, Ink::B, "(l, b) = (−2, −1)".to_owned(), "(r, t) = (4, 3)".to_owned()),
    ];
    for (map, ink, first, last) in corners {
        grid(&mut sheet, &map, size, pixel, ink);
        sheet.label(map.transform_point2(-half), Side::BelowRight, first, Letters::Plain, ink);
        sheet.label(map.transform_point2(size - half), Side::AboveLeft, last, Letters::Plain, ink);
    }
    let [from, to] = Layout::of(values).middles();
    sheet.arrow(from, to, Ink::Main.pen().fine());
    formulas(&mut sheet, (n_x, n_y), (i, j), window);
    let (u, v) = (decimal(window.x, 3), decimal(window.y, 3));
    let alt = Words::new(
        format!("Pixel ({i}, {j}) of {n_x} × {n_y} pixels belongs to the point ({u}, {v}) of the window."),
        format!("Pixel ({i}, {j}) van {n_x} × {n_y} pixels hoort bij het punt ({u}, {v}) van het venster."),
    );
    with_handles(vec![Drawing::only(alt, |alt| sheet.svg(alt))], handles(values))
}

/// From a rectangle of the plane into the room whose lower left corner is `at`, as large as it can be.
fn fitted(lower_left: Vec2, upper_right: Vec2, at: Vec2) -> Mat3 {
    let size = upper_right - lower_left;
    let factor = (ROOM / size).min_element();
    let aside = 0.5 * (ROOM - factor * size);
    translate(at + aside) * scale(Vec2::splat(factor)) * translate(-lower_left)
}

/// All pixels with their centres, as a map carries them to the sheet; one of them tinted.
fn grid(sheet: &mut Sheet, map: &Mat3, size: Vec2, pixel: Vec2, ink: Ink) {
    let at = |x: f32, y: f32| map.transform_point2(vec2(x, y));
    let (least, greatest) = (Vec2::splat(-0.5), size - Vec2::splat(0.5));
    for i in 0..=size.x as u16 {
        let x = f32::from(i) - 0.5;
        sheet.line(at(x, least.y), at(x, greatest.y), Ink::Faint.pen().fine());
    }
    for j in 0..=size.y as u16 {
        let y = f32::from(j) - 0.5;
        sheet.line(at(least.x, y), at(greatest.x, y), Ink::Faint.pen().fine());
    }
    let around = |c: Vec2, d: f32| [(-d, -d), (d, -d), (d, d), (-d, d)].map(|(x, y)| at(c.x + x, c.y + y));
    sheet.wash(&around(pixel, 0.5), ink);
    let middle = 0.5 * (size - Vec2::ONE);
    let half = 0.5 * size;
    let outline = [(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)]
        .map(|(x, y)| at(middle.x + x * half.x, middle.y + y * half.y));
    sheet.polygon(&outline, ink.pen());
    for i in 0..size.x as u16 {
        for j in 0..size.y as u16 {
            let center = vec2(f32::from(i), f32::from(j));
            if center == pixel {
                sheet.dot(at(center.x, center.y), ink);
            } else {
                sheet.speck(at(center.x, center.y), Ink::Faint);
            }
        }
    }
}

fn formulas(sheet: &mut Sheet, (n_x, n_y): (u32, u32), (i, j): (u32, u32), window: Vec2) {
    let number = |x| decimal(x, 0);
    let ViewVolume { left, right, bottom, top, .. } = VOLUME;
    let line = |letters: [&str; 5], [least, greatest]: [f32; 2], k: u32, n: u32, result: f32| {
        let [s, l, r, index, count] = letters;
        format!(
            "{s} = {l} + ({r}−{l})({index}+½)/{count} = {} + {}·{k}.5/{n} = {}",
            number(least),
            number(greatest - least),
            decimal(result, 3)
        )
    };
    sheet.lines(
        50.0,
        355.0,
        [
            format!("(i, j) = ({i}, {j})"),
            line(["u_s", "l", "r", "i", "n_x"], [left, right], i, n_x, window.x),
            line(["v_s", "b", "t", "j", "n_y"], [bottom, top], j, n_y, window.y),
        ],
    );
}

fn handles(values: &Values) -> Handled {
    let [screen, window] = Layout::of(values).middles();
    let pixel = Text { en: "the pixel", nl: "de pixel" };
    let place = Text { en: "its place in the window", nl: "zijn plaats in het venster" };
    Ok(vec![Handles::on(&sheet(), [(pixel, &["i", "j"], screen), (place, &["i", "j"], window)])])
}
