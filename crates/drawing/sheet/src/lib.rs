//! How does a drawing of lines come about? On a sheet with plane coordinates, y up, that becomes SVG.
//!
//! Colours are names, not numbers: the style decides what they are, light on dark or dark on light. Letters follow the
//! lecture: vectors and points upright and bold, numbers and angles in italics.
//!
//! - [`Sheet`]: lines, arrows, polygons, words; [`Sheet::svg`] gives a file that stands alone.
//! - [`label_layout`]: arrows with names that keep out of each other's way.
//! - [`plot`]: measured numbers over two axes.
//! - [`text`]: numbers as they are printed.
//! - [`view`]: things in space, through the lecture's camera.
//! - [`Words`]: everything is said in English and in Dutch.

#![forbid(unsafe_code)]

pub mod label_layout;
mod matrix;
pub mod plot;
pub mod text;
pub mod view;
mod words;

pub use words::{Text, Words};

use glam::{Vec2, vec2};
use maud::{Markup, PreEscaped, html};

use text::raised_and_lowered;

#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct ReadmeExamples;

/// What the names of the inks mean. The page has it once; a file of its own carries it along.
pub const STYLE: &str = "\
.fig{color:#1b2330;--faint:#a3adbd;--a:#c2410c;--b:#1d4ed8;--c:#15803d;--d:#a21caf;--paper:#fff;\
font-family:system-ui,'Segoe UI','Noto Sans',sans-serif}\
@media(prefers-color-scheme:dark){.fig{color:#e8ecf3;--faint:#5b6578;--a:#fb923c;--b:#7ba7ff;--c:#5fd38a;--d:#e58af5;--paper:#12161e}}\
.fig .s{fill:none;stroke-linecap:round;stroke-linejoin:round}\
.fig .s-main{stroke:currentColor}.fig .s-faint{stroke:var(--faint)}.fig .s-a{stroke:var(--a)}.fig .s-b{stroke:var(--b)}\
.fig .s-c{stroke:var(--c)}.fig .s-d{stroke:var(--d)}\
.fig .f-main{fill:currentColor}.fig .f-faint{fill:var(--faint)}.fig .f-a{fill:var(--a)}.fig .f-b{fill:var(--b)}\
.fig .f-c{fill:var(--c)}.fig .f-d{fill:var(--d)}\
.fig .wash{fill-opacity:.18;stroke:none}\
.fig text{paint-order:stroke;stroke:var(--paper);stroke-width:4px;stroke-linejoin:round}\
.fig .vector{font-weight:700}.fig .scalar{font-style:italic}";

/// A file of its own speaks English; the page lets the reader choose.
const ALONE: &str = ".fig .nl{display:none}.fig{background:var(--paper)}";

/// A colour by its name.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Ink {
    /// That of the text.
    Main,
    /// For what is there but not the point.
    Faint,
    /// The first of the four that set things apart: orange.
    A,
    /// Blue.
    B,
    /// Green.
    C,
    /// Purple.
    D,
}

impl Ink {
    fn name(self) -> &'static str {
        ["main", "faint", "a", "b", "c", "d"][self as usize]
    }

    /// A line of this colour.
    pub fn pen(self) -> Pen {
        Pen { ink: self, width: 2.0, dashed: false }
    }
}

/// A line's colour and kind.
#[derive(Clone, Copy, Debug)]
pub struct Pen {
    ink: Ink,
    /// In pixels of the drawing's natural size.
    width: f32,
    dashed: bool,
}

impl Pen {
    /// The same, broken.
    pub fn dashed(self) -> Self {
        Self { dashed: true, ..self }
    }

    /// The same, for what matters most.
    pub fn wide(self) -> Self {
        Self { width: 3.5, ..self }
    }

    /// The same, for what should not be in the way.
    pub fn fine(self) -> Self {
        Self { width: 1.0, ..self }
    }
}

/// How letters stand.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Letters {
    /// Words and numbers.
    Plain,
    /// Points and vectors: bold.
    Vector,
    /// Numbers with a name, angles: italics.
    Scalar,
}

/// Where a label stands, seen from its point.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Side {
    /// Over it, centred.
    Above,
    /// Under it, centred.
    Below,
    /// It ends before it.
    Left,
    /// It begins after it.
    Right,
    /// On it, centred.
    Middle,
    /// It ends before and over it.
    AboveLeft,
    /// It begins after and over it.
    AboveRight,
    /// It begins after and under it.
    BelowRight,
}

/// The height of letters in pixels.
pub const LETTER: f32 = 18.0;

/// A drawing in the making.
#[derive(Debug)]
pub struct Sheet {
    lower_left: Vec2,
    upper_right: Vec2,
    /// Pixels for each unit of the plane.
    scale: f32,
    body: String,
}

impl Sheet {
    /// A sheet that shows the rectangle between two corners of the plane, `width` pixels wide.
    pub fn new(lower_left: Vec2, upper_right: Vec2, width: f32) -> Self {
        let scale = width / (upper_right.x - lower_left.x);
        Self { lower_left, upper_right, scale, body: String::new() }
    }

    /// A sheet of `size` pixels that shows all `points`, as large as they can be, with `margin` pixels around them and
    /// `right` more pixels at the right, for words.
    pub fn around(points: &[Vec2], size: Vec2, margin: f32, right: f32) -> Self {
        let least = points.iter().copied().fold(Vec2::INFINITY, Vec2::min);
        let greatest = points.iter().copied().fold(Vec2::NEG_INFINITY, Vec2::max);
        assert!(least.cmple(greatest).all(), "a sheet needs a point");
        let room = size - vec2(2.0 * margin + right, 2.0 * margin);
        // A single point has no extent: then any scale shows it.
        let scale = (room / (greatest - least).max(Vec2::splat(1e-3))).min_element();
        let center = 0.5 * (least + greatest) + vec2(0.5 * right / scale, 0.0);
        let half = 0.5 * size / scale;
        Self { lower_left: center - half, upper_right: center + half, scale, body: String::new() }
    }

    /// The point of the plane so many pixels from the left and from the top of the sheet.
    pub fn place(&self, left: f32, top: f32) -> Vec2 {
        vec2(self.lower_left.x + self.units(left), self.upper_right.y - self.units(top))
    }

    /// Where a point of the plane lies on the sheet: the shares of its width and of its height from the top left corner.
    pub fn share(&self, p: Vec2) -> Vec2 {
        self.at(p) / self.size()
    }

    /// Width and height of the sheet in pixels.
    pub fn size(&self) -> Vec2 {
        self.at(vec2(self.upper_right.x, self.lower_left.y))
    }

    /// So many units of the plane are this many pixels.
    pub fn units(&self, pixels: f32) -> f32 {
        pixels / self.scale
    }

    fn at(&self, p: Vec2) -> Vec2 {
        self.scale * vec2(p.x - self.lower_left.x, self.upper_right.y - p.y)
    }

    fn put(&mut self, markup: Markup) {
        self.body.push_str(&markup.into_string());
    }

    /// A line through all points.
    pub fn path(&mut self, points: &[Vec2], pen: Pen) {
        let d = self.data(points, false);
        self.stroke(&d, pen);
    }

    /// A line from `a` to `b`.
    pub fn line(&mut self, a: Vec2, b: Vec2, pen: Pen) {
        self.path(&[a, b], pen);
    }

    /// A line with a point at `b`.
    pub fn arrow(&mut self, a: Vec2, b: Vec2, pen: Pen) {
        let (from, to) = (self.at(a), self.at(b));
        let along = (to - from).normalize_or_zero();
        let (length, half_width) = (6.0 + 2.5 * pen.width, 2.5 + 1.3 * pen.width);
        let base = to - length * along;
        let corners = [to, base + half_width * along.perp(), base - half_width * along.perp()];
        let d = format!("M{}L{}", number_pair(from), number_pair(base));
        self.stroke(&d, pen);
        let points: Vec<String> = corners.iter().map(|p| number_pair(*p)).collect();
        self.put(html! { polygon points=(points.join(" ")) class={ "f-" (pen.ink.name()) } {} });
    }

    /// The outline of a polygon.
    pub fn polygon(&mut self, corners: &[Vec2], pen: Pen) {
        let d = self.data(corners, true);
        self.stroke(&d, pen);
    }

    /// A polygon filled with a thin colour.
    pub fn wash(&mut self, corners: &[Vec2], ink: Ink) {
        let d = self.data(corners, true);
        self.put(html! { path d=(d) class={ "wash f-" (ink.name()) } {} });
    }

    /// A square filled with a colour of its own, sRGB, the same in light and dark: a pixel of a picture.
    pub fn tile(&mut self, lower_left: Vec2, side: f32, [red, green, blue]: [u8; 3]) {
        let (corner, side) = (self.at(lower_left), number(side * self.scale));
        let d = format!("M{}v-{side}h{side}v{side}z", number_pair(corner));
        let fill = format!("#{red:02x}{green:02x}{blue:02x}");
        self.put(html! { path d=(d) fill=(fill) shape-rendering="crispEdges" {} });
    }

    /// A picture that fills the sheet, under what is drawn later; pale, so that lines and words stand out.
    ///
    /// - `address`: where the picture is; a `data:` address has it in the drawing itself.
    pub fn picture(&mut self, address: &str, opacity: f32) {
        let size = self.size();
        self.put(html! {
            image href=(address) width=(number(size.x)) height=(number(size.y)) opacity=(number(opacity)) {}
        });
    }

    /// A circle.
    pub fn circle(&mut self, center: Vec2, radius: f32, pen: Pen) {
        let (c, r) = (self.at(center), radius * self.scale);
        self.put(html! {
            circle cx=(number(c.x)) cy=(number(c.y)) r=(number(r)) class={ "s s-" (pen.ink.name()) }
                stroke-width=(pen.width) stroke-dasharray=[dashes(pen)] {}
        });
    }

    /// A point, drawn as a dot.
    pub fn dot(&mut self, p: Vec2, ink: Ink) {
        let p = self.at(p);
        self.put(html! { circle cx=(number(p.x)) cy=(number(p.y)) r="5" class={ "f-" (ink.name()) } {} });
    }

    /// One of many points, drawn as a small dot.
    pub fn speck(&mut self, p: Vec2, ink: Ink) {
        let p = self.at(p);
        self.put(html! { circle cx=(number(p.x)) cy=(number(p.y)) r="2" class={ "f-" (ink.name()) } {} });
    }

    /// An arc around `center` from direction `from` to direction `to`, the short way round: the mark of an angle.
    pub fn arc(&mut self, center: Vec2, radius: f32, from: Vec2, to: Vec2, pen: Pen) {
        /// Finer than the eye sees.
        const STEPS: u16 = 24;
        let (start, turn) = (from.to_angle(), from.angle_to(to));
        let point = |k| center + radius * Vec2::from_angle(start + turn * f32::from(k) / f32::from(STEPS));
        let points: Vec<Vec2> = (0..=STEPS).map(point).collect();
        self.path(&points, pen);
    }

    /// Lines of words, one under the other, the first so many pixels from the left and from the top of the sheet.
    pub fn lines<W: Into<Words>>(&mut self, left: f32, top: f32, lines: impl IntoIterator<Item = W>) {
        for (k, words) in lines.into_iter().enumerate() {
            let place = self.place(left, top + 1.5 * LETTER * k as f32);
            self.label(place, Side::Right, words, Letters::Plain, Ink::Main);
        }
    }

    /// A surface seen from the side: a line from `a` to `b` with strokes at its right, where its inside is.
    pub fn surface(&mut self, a: Vec2, b: Vec2) {
        let (along, step) = ((b - a).normalize_or_zero(), self.units(14.0));
        let inwards = step * (-along - along.perp()) * 0.8;
        let strokes = ((b - a).length() / step) as u16;
        for k in 1..=strokes {
            let foot = a + f32::from(k) * step * along;
            self.line(foot, foot + inwards, Ink::Faint.pen().fine());
        }
        self.line(a, b, Ink::Main.pen());
    }

    /// Words beside a point. `_` and `^` lower and raise the letters and digits that follow: `u_s`, `(e·r)^p`.
    pub fn label(&mut self, p: Vec2, side: Side, words: impl Into<Words>, letters: Letters, ink: Ink) {
        self.label_sized(p, side, words, letters, ink, LETTER);
    }

    /// Words beside a point, with letters of a height in pixels.
    pub fn label_sized(
        &mut self,
        p: Vec2,
        side: Side,
        words: impl Into<Words>,
        letters: Letters,
        ink: Ink,
        height: f32,
    ) {
        let gap = 0.55 * height;
        let (dx, dy) = match side {
            Side::Above => (0.0, -gap),
            Side::Below => (0.0, gap + 0.75 * height),
            Side::Left => (-gap, 0.35 * height),
            Side::Right => (gap, 0.35 * height),
            Side::Middle => (0.0, 0.35 * height),
            Side::AboveLeft => (-0.7 * gap, -0.5 * gap),
            Side::AboveRight => (0.7 * gap, -0.5 * gap),
            Side::BelowRight => (0.7 * gap, 0.5 * gap + 0.7 * height),
        };
        let anchor = match side {
            Side::Above | Side::Below | Side::Middle => "middle",
            Side::Left | Side::AboveLeft => "end",
            Side::Right | Side::AboveRight | Side::BelowRight => "start",
        };
        let place = self.at(p) + vec2(dx, dy);
        let words = words.into();
        let class = format!("f-{} {}", ink.name(), ["plain", "vector", "scalar"][letters as usize]);
        let text = |language: &str, words: &str| {
            html! {
                text x=(number(place.x)) y=(number(place.y)) text-anchor=(anchor) font-size=(number(height))
                    class={ (class) (language) } { (raised_and_lowered(words, height)) }
            }
        };
        if words.en == words.nl {
            self.put(text("", &words.en));
        } else {
            self.put(text(" en", &words.en));
            self.put(text(" nl", &words.nl));
        }
    }

    /// The text of an SVG file. `alt` is what it says to somebody who cannot see it.
    pub fn svg(self, alt: &Words) -> String {
        let size = self.size();
        let (width, height) = (number(size.x), number(size.y));
        html! {
            svg xmlns="http://www.w3.org/2000/svg" class="fig" viewBox={ "0 0 " (width) " " (height) }
                width=(width) height=(height) role="img" aria-label=(alt.en)
            {
                style { (PreEscaped(STYLE)) (PreEscaped(ALONE)) }
                (PreEscaped(&self.body))
            }
        }
        .into_string()
    }

    fn stroke(&mut self, d: &str, pen: Pen) {
        self.put(html! {
            path d=(d) class={ "s s-" (pen.ink.name()) } stroke-width=(pen.width) stroke-dasharray=[dashes(pen)] {}
        });
    }

    fn data(&self, points: &[Vec2], closed: bool) -> String {
        let mut d = String::new();
        for (k, p) in points.iter().enumerate() {
            d.push(if k == 0 { 'M' } else { 'L' });
            d.push_str(&number_pair(self.at(*p)));
        }
        if closed {
            d.push('Z');
        }
        d
    }
}

/// The SVG text of [`Sheet::svg`] as part of a page that has [`STYLE`] itself and lets the reader choose the language.
pub fn inside_a_page(svg: &str, alt: &Words) -> String {
    let described = html! { svg data-en=(alt.en) data-nl=(alt.nl) {} }.into_string();
    let described = described.trim_end_matches("></svg>");
    let without_style = match (svg.find("<style>"), svg.find("</style>")) {
        (Some(start), Some(end)) => [&svg[..start], &svg[end + "</style>".len()..]].concat(),
        _ => svg.to_owned(),
    };
    without_style.replacen("<svg", described, 1)
}

fn dashes(pen: Pen) -> Option<String> {
    pen.dashed.then(|| format!("{} {}", number(3.0 * pen.width), number(3.0 * pen.width)))
}

fn number_pair(p: Vec2) -> String {
    format!("{} {}", number(p.x), number(p.y))
}

/// Hundredths of a pixel are enough, and make the file small.
fn number(x: f32) -> String {
    let text = format!("{x:.2}");
    let short = text.trim_end_matches('0').trim_end_matches('.');
    if short == "-0" { "0".to_owned() } else { short.to_owned() }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn y_runs_up_on_the_sheet_and_down_in_the_file() {
        let mut sheet = Sheet::new(vec2(-1.0, 0.0), vec2(3.0, 2.0), 400.0);
        sheet.line(vec2(-1.0, 0.0), vec2(1.0, 1.5), Ink::Main.pen());
        let svg = sheet.svg(&"a line".into());
        assert!(svg.contains("M0 200L200 50"), "{svg}");
        assert!(svg.contains("viewBox=\"0 0 400 200\"") && svg.contains("aria-label=\"a line\""), "{svg}");
    }

    #[test]
    fn a_share_is_counted_from_the_top_left_corner() {
        let sheet = Sheet::new(vec2(-1.0, 0.0), vec2(3.0, 2.0), 400.0);
        assert_eq!(sheet.size(), vec2(400.0, 200.0));
        assert_eq!(sheet.share(vec2(-1.0, 2.0)), Vec2::ZERO);
        assert_eq!(sheet.share(vec2(0.0, 1.5)), vec2(0.25, 0.25));
    }

    #[test]
    fn a_tile_has_its_lower_left_corner_where_it_is_put() {
        let mut sheet = Sheet::new(Vec2::ZERO, vec2(4.0, 2.0), 400.0);
        sheet.tile(vec2(1.0, 0.5), 0.25, [255, 128, 0]);
        assert!(sheet.svg(&"a tile".into()).contains("M100 150v-25h25v25z\" fill=\"#ff8000\""));
    }

    #[test]
    fn a_picture_fills_the_sheet() {
        let mut sheet = Sheet::new(vec2(-0.5, -0.5), vec2(3.5, 1.5), 400.0);
        sheet.picture("data:image/png;base64,AA==", 0.5);
        let svg = sheet.svg(&"a picture".into());
        assert!(svg.contains(
            "<image href=\"data:image/png;base64,AA==\" width=\"400\" height=\"200\" opacity=\"0.5\""
        ));
    }

    #[test]
    fn what_could_break_the_file_is_escaped() {
        let mut sheet = Sheet::new(Vec2::ZERO, Vec2::ONE, 10.0);
        sheet.label(Vec2::ZERO, Side::Above, "a<b & c", Letters::Plain, Ink::A);
        assert!(sheet.svg(&"\"".into()).contains("a&lt;b &amp; c"));
    }
}
