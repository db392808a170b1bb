//! Where in the window does the ray of a pixel go through? (L9, L8, Fig 4.7)

use glam::{Vec2, vec2};
use transforms::ViewVolume;
use transforms::viewport::window_point;

use crate::figure::{Drawing, Drawn, Figure, Text, Words};
use crate::parameter::{Parameter, Values};
use crate::sheet::text::decimal;
use crate::sheet::{Ink, Letters, Sheet, Side};

pub(super) static FIGURE: Figure = Figure {
    numbers: &["L9", "L8", "E14"],
    name: "pixel-grid",
    title: Text { en: "From pixel (i, j) to (u_s, v_s)", nl: "Van pixel (i, j) naar (u_s, v_s)" },
    caption: Text {
        en: "The screen reaches from −½ to n_x − ½ and from −½ to n_y − ½, so that pixel centres have whole numbers. The window transform takes the screen to [l, r] × [b, t], and each centre to the point of the window where its viewing ray goes through.",
        nl: "Het scherm loopt van −½ tot n_x − ½ en van −½ tot n_y − ½, zodat pixelcentra gehele coördinaten hebben. De windowtransformatie brengt het scherm op [l, r] × [b, t], en elk centrum op het punt van het venster waar zijn straal doorheen gaat.",
    },
    parameters: &[
        Parameter::count(
            "nx",
            Text { en: "pixels in a row, n_x", nl: "pixels in een rij, n_x" },
            6.0,
            1.0,
            16.0,
        ),
        Parameter::count("ny", Text { en: "rows of pixels, n_y", nl: "rijen pixels, n_y" }, 4.0, 1.0, 12.0),
        Parameter::count(
            "i",
            Text { en: "column i of the pixel", nl: "kolom i van de pixel" },
            4.0,
            0.0,
            15.0,
        ),
        Parameter::count(
            "j",
            Text { en: "row j of the pixel, upwards", nl: "rij j van de pixel, omhoog" },
            1.0,
            0.0,
            11.0,
        ),
    ],
    size: (640, 480),
    draw,
};

/// The window of the figure.
const WINDOW: ViewVolume =
    ViewVolume { left: -1.5, right: 1.5, bottom: -1.0, top: 1.0, near: -1.0, far: -9.0 };

/// A rectangle on the sheet that shows a rectangle of another plane.
struct Panel {
    place: [Vec2; 2],
    shows: [Vec2; 2],
}

impl Panel {
    fn at(&self, p: Vec2) -> Vec2 {
        let [low, high] = self.shows;
        self.place[0] + (p - low) / (high - low) * (self.place[1] - self.place[0])
    }

    fn corners(&self, low: Vec2, high: Vec2) -> [Vec2; 4] {
        [low, vec2(high.x, low.y), high, vec2(low.x, high.y)].map(|p| self.at(p))
    }
}

fn draw(values: &Values) -> Drawn {
    let [nx, ny] = ["nx", "ny"].map(|name| values.count(name));
    // The pixel stays on the screen if that gets smaller.
    let pixel = vec2(values.count("i").min(nx - 1) as f32, values.count("j").min(ny - 1) as f32);
    let size = vec2(nx as f32, ny as f32);
    let screen =
        Panel { place: [vec2(70.0, 90.0), vec2(390.0, 310.0)], shows: [Vec2::splat(-0.5), size - 0.5] };
    let ViewVolume { left, right, bottom, top, .. } = WINDOW;
    let window = Panel {
        place: [vec2(520.0, 90.0), vec2(840.0, 310.0)],
        shows: [vec2(left, bottom), vec2(right, top)],
    };
    let to_window = |p: Vec2| window_point(&WINDOW, nx, ny, p);
    let s = to_window(pixel);

    let mut sheet = Sheet::new(Vec2::ZERO, vec2(900.0, 390.0), 900.0);
    let half = Vec2::splat(0.5);
    sheet.wash(&screen.corners(pixel - half, pixel + half), Ink::A);
    sheet.wash(&window.corners(to_window(pixel - half), to_window(pixel + half)), Ink::A);
    for j in 0..ny {
        for i in 0..nx {
            let center = vec2(i as f32, j as f32);
            sheet.polygon(&screen.corners(center - half, center + half), Ink::Faint.pen().fine());
            sheet.polygon(
                &window.corners(to_window(center - half), to_window(center + half)),
                Ink::Faint.pen().fine(),
            );
        }
    }
    sheet.polygon(&screen.corners(-half, size - 0.5), Ink::B.pen());
    sheet.polygon(&window.corners(vec2(left, bottom), vec2(right, top)), Ink::C.pen());
    sheet.arrow(vec2(410.0, 200.0), vec2(500.0, 200.0), Ink::Main.pen());
    sheet.dot(screen.at(pixel), Ink::A);
    sheet.dot(window.at(s), Ink::A);
    ends(&mut sheet, &screen, &window, (nx, ny));
    let words = format!("(i, j) = ({}, {})", pixel.x, pixel.y);
    sheet.label(vec2(230.0, 330.0), Side::Above, words, Letters::Plain, Ink::A);
    let words = format!("(u_s, v_s) = ({}, {})", decimal(s.x, 3), decimal(s.y, 3));
    sheet.label(vec2(680.0, 330.0), Side::Above, words, Letters::Plain, Ink::A);
    let alt = Words::new(
        format!(
            "Pixel ({}, {}) of {nx} × {ny} goes to ({}, {}) in the window.",
            pixel.x,
            pixel.y,
            decimal(s.x, 3),
            decimal(s.y, 3)
        ),
        format!(
            "Pixel ({}, {}) van {nx} × {ny} gaat naar ({}, {}) in het venster.",
            pixel.x,
            pixel.y,
            decimal(s.x, 3),
            decimal(s.y, 3)
        ),
    );
    Ok(vec![Drawing::diagram("", alt.clone(), sheet.svg(&alt))])
}

/// The numbers at the ends of both rectangles.
fn ends(sheet: &mut Sheet, screen: &Panel, window: &Panel, (nx, ny): (u32, u32)) {
    let half = |n: u32| format!("{}½", n - 1).replace("0½", "½");
    let mut below = |p: Vec2, words: String, ink| sheet.label(p, Side::Below, words, Letters::Plain, ink);
    let [low, high] = screen.place;
    below(low, "−½".to_owned(), Ink::B);
    below(vec2(high.x, low.y), half_name(nx, &half), Ink::B);
    let [wlow, whigh] = window.place;
    below(wlow, format!("l = {}", decimal(WINDOW.left, 1)), Ink::C);
    below(vec2(whigh.x, wlow.y), format!("r = {}", decimal(WINDOW.right, 1)), Ink::C);
    let mut left = |p: Vec2, words: String, ink| sheet.label(p, Side::AboveLeft, words, Letters::Plain, ink);
    left(low, "−½".to_owned(), Ink::B);
    left(vec2(low.x, high.y), half_name(ny, &half), Ink::B);
    left(wlow, format!("b = {}", decimal(WINDOW.bottom, 1)), Ink::C);
    left(vec2(wlow.x, whigh.y), format!("t = {}", decimal(WINDOW.top, 1)), Ink::C);
}

/// n − ½ as a mixed number.
fn half_name(n: u32, half: &dyn Fn(u32) -> String) -> String {
    if n == 1 { "½".to_owned() } else { half(n) }
}
