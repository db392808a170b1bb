//! How is a counterexample drawn? Yours beside the right one, on the same grid of samples.

use glam::{Vec2, Vec3, vec2};
use sheet::text::decimal;
use sheet::{Ink, Letters, Sheet, Side, Words};
use vocabulary::{Barycentric, Buffers, Fragment, Occlusion, Pixel, Triangle, Triangle2};

use crate::exercise::{Picture, Seen, arguments};
use crate::{Plain, Value};

/// What is drawn on the left and on the right.
const SIDES: [(&str, &str); 2] = [("yours", "jouw antwoord"), ("right", "goed")];

/// The longer side of a panel in pixels, if its cells are neither too large nor too small for it.
const PANEL: f32 = 340.0;

/// A panel is at least so wide, in pixels, for the words above it.
const LEAST_PANEL: f32 = 280.0;

/// Between two panels, and above them, in pixels.
const MARGIN: f32 = 36.0;

/// The height of numbers in a grid, in pixels.
const SMALL: f32 = 12.0;

/// Numbers that are no further apart are drawn as the same; much less than two decimals show.
const SAME: f32 = 1e-3;

/// The text of a terminal: so many characters and lines at most.
const LONGEST_LINE: usize = 76;
const MOST_LINES: usize = 20;

/// A sheet with two panels, each showing the same part of the plane.
struct Panels {
    sheet: Sheet,
    /// From a point of the plane to its place in each panel.
    offsets: [Vec2; 2],
}

impl Panels {
    /// Panels that show the points from `low` to `high`, with words above each.
    fn new(low: Vec2, high: Vec2, captions: [Words; 2]) -> Self {
        let size = high - low;
        let scale = (PANEL / size.max_element()).clamp(24.0, 60.0);
        // Room for the words.
        let lacking = (LEAST_PANEL / scale - size.x).max(0.0);
        let (low, high) = (low - vec2(0.5 * lacking, 0.0), high + vec2(0.5 * lacking, 0.0));
        let across = high.x - low.x + MARGIN / scale;
        let upper_right = vec2(high.x + across, high.y + MARGIN / scale);
        let mut sheet = Sheet::new(low, upper_right, (upper_right.x - low.x) * scale);
        let offsets = [Vec2::ZERO, vec2(across, 0.0)];
        for ((offset, caption), (en, nl)) in offsets.into_iter().zip(captions).zip(SIDES) {
            let words = Words::new(format!("{en}: {}", caption.en), format!("{nl}: {}", caption.nl));
            let place = vec2(0.5 * (low.x + high.x), high.y + 0.5 * MARGIN / scale) + offset;
            sheet.label_sized(place, Side::Middle, words, Letters::Plain, Ink::Main, 16.0);
        }
        Self { sheet, offsets }
    }

    /// Draws in both panels, `draw(sheet, place of a point, which panel)`.
    fn each(&mut self, mut draw: impl FnMut(&mut Sheet, &dyn Fn(Vec2) -> Vec2, usize)) {
        for (panel, offset) in self.offsets.into_iter().enumerate() {
            draw(&mut self.sheet, &|p| p + offset, panel);
        }
    }

    fn picture(self, alt: Words, text: Option<String>) -> Option<Picture> {
        Some(Picture { svg: self.sheet.svg(&alt), text })
    }
}

fn read<T: Plain>(value: Option<&Value>) -> Option<T> {
    value.cloned().and_then(T::from_value)
}

/// The box around points, a unit larger on each side.
fn around(points: &[Vec2]) -> (Vec2, Vec2) {
    let least = points.iter().copied().fold(Vec2::INFINITY, Vec2::min);
    let greatest = points.iter().copied().fold(Vec2::NEG_INFINITY, Vec2::max);
    (least - Vec2::ONE, greatest + Vec2::ONE)
}

/// The samples between two corners, row after row from the top.
fn samples(low: Vec2, high: Vec2) -> Vec<Vec<Vec2>> {
    let whole = |from: f32, to: f32| from.ceil() as i32..=to.floor() as i32;
    let row = |j: i32| whole(low.x, high.x).map(|i| vec2(i as f32, j as f32)).collect();
    whole(low.y, high.y).rev().map(row).collect()
}

fn outline(sheet: &mut Sheet, at: &dyn Fn(Vec2) -> Vec2, triangle: Triangle2) {
    let corners = [triangle.a, triangle.b, triangle.c].map(at);
    sheet.wash(&corners, Ink::Faint);
    sheet.polygon(&corners, Ink::Main.pen().fine());
}

fn named_corners(sheet: &mut Sheet, at: &dyn Fn(Vec2) -> Vec2, triangle: Triangle2) {
    let centre = (triangle.a + triangle.b + triangle.c) / 3.0;
    for (name, corner) in [("a", triangle.a), ("b", triangle.b), ("c", triangle.c)] {
        let side = if corner.y < centre.y { Side::Below } else { Side::Above };
        sheet.label(at(corner), side, name, Letters::Vector, Ink::Main);
    }
}

/// The square of a pixel.
fn square(at: &dyn Fn(Vec2) -> Vec2, p: Vec2) -> [Vec2; 4] {
    [vec2(-0.5, -0.5), vec2(0.5, -0.5), vec2(0.5, 0.5), vec2(-0.5, 0.5)].map(|corner| at(p + corner))
}

/// A ring that says: look here.
fn ring(sheet: &mut Sheet, place: Vec2, pixels: f32, ink: Ink) {
    let radius = sheet.units(pixels);
    sheet.circle(place, radius, ink.pen());
}

/// What both functions answer for a triangle at each sample.
fn at_samples<T: Plain>(seen: &Seen<'_>, rows: &[Vec<Vec2>]) -> Option<[Vec<Option<T>>; 2]> {
    let triangle = seen.arguments.first()?;
    let questions: Vec<Vec<Value>> =
        rows.iter().flatten().map(|sample| arguments![triangle.clone(), *sample]).collect();
    let read = |answer: Option<Value>| answer.and_then(T::from_value);
    Some([seen.yours, seen.reference].map(|calls| {
        let mut answers: Vec<Option<T>> = calls(&questions).into_iter().map(read).collect();
        answers.resize_with(questions.len(), || None);
        answers
    }))
}

/// Grids of short words, one for each panel: `word(panel, number of the sample, sample)`.
fn words(rows: &[Vec<Vec2>], word: impl Fn(usize, usize, Vec2) -> String) -> [Vec<Vec<String>>; 2] {
    [0, 1].map(|panel| {
        let mut number = 0..;
        let mut cell = |p: &Vec2| word(panel, number.next().unwrap_or_default(), *p);
        rows.iter().map(|row| row.iter().map(&mut cell).collect()).collect()
    })
}

/// Grids of short words side by side, row after row from the top; `None` if they are too large for a terminal.
fn side_by_side(grids: &[Vec<Vec<String>>; 2]) -> Option<String> {
    let cell = grids.iter().flatten().flatten().map(|word| word.chars().count()).max()?;
    let line = |row: &Vec<String>| {
        let words: Vec<String> = row.iter().map(|word| format!("{word:>cell$}")).collect();
        words.join(" ")
    };
    let [left, right] = grids.each_ref().map(|grid| grid.iter().map(line).collect::<Vec<String>>());
    let width = left.iter().map(|line| line.chars().count()).chain([SIDES[0].0.len()]).max()?;
    let rows = left.len().max(right.len());
    let (empty, [(yours, _), (good, _)]) = (String::new(), SIDES);
    let mut lines = vec![format!("{yours:<width$}    {good}")];
    lines.extend((0..rows).map(|at| {
        let [left, right] = [&left, &right].map(|lines| lines.get(at).unwrap_or(&empty));
        format!("{left:<width$}    {right}").trim_end().to_owned()
    }));
    let fits = lines.len() <= MOST_LINES && lines.iter().all(|line| line.chars().count() <= LONGEST_LINE);
    fits.then(|| lines.join("\n"))
}

/// A number for a caption or a cell.
fn short(x: f32) -> String {
    match x {
        x if x.is_nan() => "NaN".to_owned(),
        x if x.abs() < 1000.0 => decimal(x, 2),
        x if x > 0.0 => "huge".to_owned(),
        _ => "−huge".to_owned(),
    }
}

/// The point, the triangle that belongs to each weight, and the point that your weights make.
pub(super) fn weights(seen: &Seen<'_>) -> Option<Picture> {
    let triangle: Triangle2 = seen.argument(0)?;
    let p: Vec2 = seen.argument(1)?;
    let answers = [seen.given.cloned(), Some(seen.right.clone())];
    let answers = answers.map(|answer| <Option<Barycentric>>::from_value(answer?).flatten());
    let captions = answers.map(|answer| match answer {
        Some(Barycentric { alpha, beta, gamma }) => {
            Words::from(format!("α {}  β {}  γ {}", short(alpha), short(beta), short(gamma)))
        }
        None => Words::from("None"),
    });
    let Triangle2 { a, b, c } = triangle;
    let made = answers.map(|answer| answer.map(|w| w.alpha * a + w.beta * b + w.gamma * c));
    // What the weights make is shown unless it lies far away or nowhere.
    let (low, high) = around(&[a, b, c, p]);
    let near = |q: &Vec2| q.cmpge(low - 4.0).all() && q.cmple(high + 4.0).all();
    let made = made.map(|q| q.filter(near));
    let shown: Vec<Vec2> = made.into_iter().flatten().chain([a, b, c, p]).collect();
    let (low, high) = around(&shown);
    let mut panels = Panels::new(low, high, captions);
    panels.each(|sheet, at, panel| {
        for (side, ink) in [([p, b, c], Ink::B), ([a, p, c], Ink::C), ([a, b, p], Ink::D)] {
            sheet.wash(&side.map(at), ink);
            sheet.polygon(&side.map(at), Ink::Faint.pen().fine());
        }
        sheet.polygon(&[a, b, c].map(at), Ink::Main.pen());
        named_corners(sheet, at, triangle);
        sheet.dot(at(p), Ink::Main);
        sheet.label(at(p), Side::AboveRight, "p", Letters::Vector, Ink::Main);
        if let Some(q) = made[panel].filter(|q| q.distance(p) > SAME) {
            sheet.dot(at(q), Ink::A);
            sheet.label(at(q), Side::BelowRight, "αa + βb + γc", Letters::Plain, Ink::A);
        }
    });
    let alt = Words::new(
        "A triangle with its point p, and the point that the weights make.",
        "Een driehoek met haar punt p, en het punt dat de gewichten opleveren.",
    );
    panels.picture(alt, None)
}

/// The samples around a triangle, those that it covers as dots, and the sample that was asked about.
pub(super) fn coverage(seen: &Seen<'_>) -> Option<Picture> {
    let triangle: Triangle2 = seen.argument(0)?;
    let p: Vec2 = seen.argument(1)?;
    let captions = [seen.given, Some(seen.right)].map(|answer| match read(answer) {
        Some(true) => Words::new("p is covered", "p is bedekt"),
        Some(false) => Words::new("p is not covered", "p is niet bedekt"),
        None => Words::new("no answer", "geen antwoord"),
    });
    let (low, high) = around(&[triangle.a, triangle.b, triangle.c, p]);
    let rows = samples(low, high);
    let covered = at_samples::<bool>(seen, &rows)?;
    let mut panels = Panels::new(low - 0.25, high + 0.25, captions);
    panels.each(|sheet, at, panel| {
        outline(sheet, at, triangle);
        named_corners(sheet, at, triangle);
        for (k, sample) in rows.iter().flatten().enumerate() {
            match covered[panel][k] {
                Some(true) => sheet.dot(at(*sample), Ink::B),
                _ => sheet.speck(at(*sample), Ink::Faint),
            }
            if covered[panel][k] != covered[1][k] {
                ring(sheet, at(*sample), 9.0, Ink::A);
            }
        }
        let wrong = panel == 0 && read::<bool>(seen.given) != read(Some(seen.right));
        let ink = if wrong { Ink::A } else { Ink::Main };
        ring(sheet, at(p), 6.0, ink);
        sheet.label(at(p), Side::AboveRight, "p", Letters::Vector, ink);
    });
    let grids = words(&rows, |panel, k, _| match covered[panel][k] {
        Some(true) => "#".to_owned(),
        Some(false) => ".".to_owned(),
        None => "?".to_owned(),
    });
    let alt = Words::new(
        "A triangle and the samples that it covers, as dots.",
        "Een driehoek en de monsterpunten die ze bedekt, als stippen.",
    );
    panels.picture(alt, side_by_side(&grids))
}

/// The depth at the samples around a triangle, and at the point that was asked about.
pub(super) fn depths(seen: &Seen<'_>) -> Option<Picture> {
    let triangle: Triangle = seen.argument(0)?;
    let p: Vec2 = seen.argument(1)?;
    let captions = [seen.given, Some(seen.right)].map(|answer| match read::<f32>(answer) {
        Some(z) => Words::new(format!("z = {} at p", short(z)), format!("z = {} in p", short(z))),
        None => Words::new("no answer", "geen antwoord"),
    });
    let on_screen =
        Triangle2 { a: triangle.a.truncate(), b: triangle.b.truncate(), c: triangle.c.truncate() };
    let (low, high) = around(&[on_screen.a, on_screen.b, on_screen.c, p]);
    let rows = samples(low + 0.5, high - 0.5);
    let depth = at_samples::<f32>(seen, &rows)?;
    let alike = |at: usize| match (depth[0][at], depth[1][at]) {
        (Some(yours), Some(right)) => (yours - right).abs() <= SAME * right.abs().max(1.0),
        _ => false,
    };
    let mut panels = Panels::new(low, high, captions);
    panels.each(|sheet, at, panel| {
        outline(sheet, at, on_screen);
        for (k, sample) in rows.iter().flatten().enumerate() {
            let words = depth[panel][k].map_or("?".to_owned(), short);
            let ink = if panel == 1 || alike(k) { Ink::Main } else { Ink::A };
            sheet.label_sized(at(*sample), Side::Middle, words, Letters::Plain, ink, SMALL);
        }
        depths_of_corners(sheet, at, triangle);
        ring(sheet, at(p), 16.0, Ink::C);
        sheet.label(at(p) + sheet.units(10.0), Side::AboveRight, "p", Letters::Vector, Ink::C);
    });
    let alt = Words::new(
        "A triangle on the screen with the depth at every sample around it.",
        "Een driehoek op het scherm met de diepte in elk monsterpunt eromheen.",
    );
    panels.picture(alt, None)
}

fn depths_of_corners(sheet: &mut Sheet, at: &dyn Fn(Vec2) -> Vec2, triangle: Triangle) {
    for corner in [triangle.a, triangle.b, triangle.c] {
        let place = at(corner.truncate());
        sheet.speck(place, Ink::B);
        // Below the number of a sample that may stand in the corner.
        let place = place - vec2(0.0, sheet.units(6.0));
        let words = format!("z = {}", short(corner.z));
        sheet.label_sized(place, Side::Below, words, Letters::Scalar, Ink::B, SMALL);
    }
}

/// The screen with the pixels that a triangle owns.
pub(super) fn pixels(seen: &Seen<'_>) -> Option<Picture> {
    let triangle: Triangle2 = seen.argument(0)?;
    let width: u32 = seen.argument(1)?;
    let height: u32 = seen.argument(2)?;
    let answers = [seen.given, Some(seen.right)].map(|answer| read::<Vec<Pixel>>(answer).unwrap_or_default());
    let captions = answers.each_ref().map(|pixels| {
        let count = pixels.len();
        Words::new(format!("{count} pixels"), format!("{count} pixels"))
    });
    let screen = [vec2(0.0, 0.0), vec2(width as f32 - 1.0, height as f32 - 1.0)];
    let (low, high) = around(&[triangle.a, triangle.b, triangle.c, screen[0], screen[1]]);
    let rows = samples(screen[0], screen[1]);
    let times = |panel: usize, p: Vec2| {
        let pixel = Pixel { i: p.x as u32, j: p.y as u32 };
        answers[panel].iter().filter(|other| **other == pixel).count()
    };
    let mut panels = Panels::new(low, high, captions);
    panels.each(|sheet, at, panel| {
        for p in rows.iter().flatten() {
            let square = square(at, *p);
            if times(panel, *p) > 0 {
                sheet.wash(&square, Ink::B);
            }
            sheet.polygon(&square, Ink::Faint.pen().fine());
        }
        sheet.polygon(&[triangle.a, triangle.b, triangle.c].map(at), Ink::Main.pen());
        for p in rows.iter().flatten() {
            sheet.speck(at(*p), Ink::Main);
            if times(panel, *p) != times(1, *p) {
                ring(sheet, at(*p), 9.0, Ink::A);
            }
        }
    });
    let grids = words(&rows, |panel, _, p| match times(panel, p) {
        0 => ".".to_owned(),
        1 => "#".to_owned(),
        times => times.to_string(),
    });
    let alt = Words::new(
        "A triangle over the pixels of the screen, those that it owns tinted; rings mark the differences.",
        "Een driehoek over de pixels van het scherm, met haar pixels gekleurd; ringen geven de verschillen aan.",
    );
    panels.picture(alt, side_by_side(&grids))
}

/// The z-buffer as the slide prints it, with a letter and a tint for the colour in the rgb-buffer.
pub(super) fn grids(seen: &Seen<'_>) -> Option<Picture> {
    let fragments: Vec<Fragment> = seen.argument(0)?;
    let background: Vec3 = seen.argument(1)?;
    let width: u32 = seen.argument(2)?;
    let height: u32 = seen.argument(3)?;
    let colours = colours_of(&fragments, background);
    let answers = [seen.given, Some(seen.right)].map(read::<Buffers>);
    let cell = |panel: usize, p: Vec2| -> Option<(f32, Vec3)> {
        let buffers = answers[panel].as_ref()?;
        let (i, j) = (p.x as usize, p.y as usize);
        Some((*buffers.z.get(j)?.get(i)?, *buffers.rgb.get(j)?.get(i)?))
    };
    let word = |panel: usize, p: Vec2| {
        cell(panel, p).map_or("?".to_owned(), |(z, colour)| {
            let letter = match colours.iter().position(|other| *other == colour) {
                Some(at) => char::from(b'a' + (at % 26) as u8),
                None if colour == background => '-',
                None => '?',
            };
            format!("{}{letter}", depth_in_a_cell(z))
        })
    };
    let captions = answers.each_ref().map(|_| Words::new("depth and colour", "diepte en kleur"));
    let (low, high) = (Vec2::ZERO, vec2(width as f32 - 1.0, height as f32 - 1.0));
    let rows = samples(low, high);
    let mut panels = Panels::new(low - 0.75, high + 0.75, captions);
    panels.each(|sheet, at, panel| {
        for p in rows.iter().flatten() {
            let square = square(at, *p);
            let colour = cell(panel, *p).map(|(_, colour)| colour);
            if let Some(k) = colours.iter().position(|other| Some(*other) == colour) {
                sheet.wash(&square, [Ink::A, Ink::B, Ink::C, Ink::D][k % 4]);
            }
            sheet.polygon(&square, Ink::Faint.pen().fine());
            let differs = cell(panel, *p) != cell(1, *p);
            let ink = if differs { Ink::A } else { Ink::Main };
            sheet.label_sized(at(*p), Side::Middle, word(panel, *p), Letters::Plain, ink, 14.0);
            if differs {
                ring(sheet, at(*p), 18.0, Ink::A);
            }
        }
    });
    let grids = words(&rows, |panel, _, p| word(panel, p));
    let alt = Words::new(
        "The z-buffer and a letter for each colour, the lowest row at the bottom; rings mark the differences.",
        "De z-buffer en een letter voor elke kleur, de laagste rij onderaan; ringen geven de verschillen aan.",
    );
    panels.picture(alt, side_by_side(&grids))
}

/// The colours of the fragments in the order in which they are drawn, each once, without the background's.
fn colours_of(fragments: &[Fragment], background: Vec3) -> Vec<Vec3> {
    let mut colours: Vec<Vec3> = Vec::new();
    for fragment in fragments {
        if fragment.colour != background && !colours.contains(&fragment.colour) {
            colours.push(fragment.colour);
        }
    }
    colours
}

/// Whole depths without decimals, as on the slide.
fn depth_in_a_cell(z: f32) -> String {
    if z.abs() < 1000.0 && z.fract() == 0.0 { decimal(z, 0) } else { short(z) }
}

/// The polygons in a ring, an arrow from each to what hides it; arrows that an order breaks stand out.
pub(super) fn orders(seen: &Seen<'_>) -> Option<Picture> {
    let count: usize = seen.argument(0)?;
    let occlusions: Vec<Occlusion> = seen.argument(1)?;
    let answers = [seen.given, Some(seen.right)].map(|answer| read::<Option<Vec<usize>>>(answer).flatten());
    let captions = answers.each_ref().map(|order| Words::from(written(order.as_deref(), count)));
    let at_ring = |k: usize| 1.8 * Vec2::from_angle(std::f32::consts::TAU * (0.25 - k as f32 / count as f32));
    let mut panels = Panels::new(Vec2::splat(-2.9), Vec2::splat(2.9), captions);
    panels.each(|sheet, at, panel| {
        let place = |polygon: usize| {
            answers[panel].as_ref().and_then(|o| o.iter().position(|other| *other == polygon))
        };
        for Occlusion { behind, in_front } in &occlusions {
            let kept = match (place(*behind), place(*in_front)) {
                (Some(first), Some(second)) => first < second,
                _ => false,
            };
            // Without an order no arrow is broken by it.
            let pen = if kept || answers[panel].is_none() { Ink::Main.pen().fine() } else { Ink::A.pen() };
            let (from, to) = (at_ring(*behind), at_ring(*in_front));
            let along = (to - from).normalize_or_zero();
            // Two arrows between the same two do not cover each other.
            let aside = 0.08 * along.perp();
            sheet.arrow(at(from + 0.4 * along + aside), at(to - 0.4 * along + aside), pen);
        }
        for polygon in 0..count {
            let p = at_ring(polygon);
            sheet.circle(at(p), 0.33, Ink::B.pen());
            sheet.label(at(p), Side::Middle, polygon.to_string(), Letters::Plain, Ink::Main);
            if answers[panel].is_some() {
                let (words, ink) = match place(polygon) {
                    Some(place) => (Words::from(format!("{}.", place + 1)), Ink::Faint),
                    None => (Words::new("missing", "ontbreekt"), Ink::A),
                };
                sheet.label_sized(at(1.35 * p), Side::Middle, words, Letters::Plain, ink, 14.0);
            }
        }
    });
    let alt = Words::new(
        "Polygons in a ring, an arrow from each to what hides it; arrows against the order stand out.",
        "Veelhoeken in een ring, met een pijl naar wat ze verbergt; pijlen tegen de volgorde in vallen op.",
    );
    panels.picture(alt, None)
}

/// An order as it is written; no right one is longer than `count`.
fn written(order: Option<&[usize]>, count: usize) -> String {
    let Some(order) = order else { return "None".to_owned() };
    let mut names: Vec<String> = order.iter().take(count + 1).map(ToString::to_string).collect();
    if order.len() > count + 1 {
        names.push("…".to_owned());
    }
    format!("[{}]", names.join(", "))
}
