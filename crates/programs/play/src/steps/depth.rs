//! What does each triangle do to the depth buffer of the slide (L17)?

use canvas::{Image, Rgb};
use figures::{GRID, Values, polygons_of_the_grids};
use glam::{Vec2, vec2};
use sheet::{Ink, Letters, Sheet, Side, Words};
use zbuffer::{DepthBuffer, DepthFormat, Fragment, ScreenTriangle, draw::draw, rasterize};

use super::{Drawing, Step, Told};
use crate::Refusal;

/// What the figure calls the depths of its polygons.
const NAMES: [&str; 3] = ["first", "second", "third"];

/// The first of the slide's depths.
pub(super) fn first() -> f32 {
    slide().number(NAMES[0])
}

/// The second.
pub(super) fn second() -> f32 {
    slide().number(NAMES[1])
}

/// The third.
pub(super) fn third() -> f32 {
    slide().number(NAMES[2])
}

/// The numbers of the figure of the grids.
fn slide() -> Values {
    Values::of(figures::find("depth-grids")[0])
}

/// A triangle on the grid.
#[derive(Clone, Copy)]
struct Now<'a> {
    triangle: &'a ScreenTriangle,
    ink: Ink,
    covered: &'a [Fragment],
    /// Whether the comparison has been made, and the pixels that were won.
    won: Option<&'a [(u32, u32)]>,
}

/// Clearing, and for each triangle the pixels that it covers, then those that it wins.
pub(super) fn told(depths: [f32; 3]) -> Result<Told, Refusal> {
    let mut values = slide();
    for (name, z) in NAMES.into_iter().zip(depths) {
        values.set(name, z).map_err(Refusal::because)?;
    }
    let (width, height) = GRID;
    let mut image = Image::new(width, height, Rgb::ZERO);
    let mut depth = DepthBuffer::new(width, height, DepthFormat::F32);
    let cleared = Words::new(
        "Clear: the farthest depth, shown as 0, in every pixel. Larger is nearer.",
        "Wissen: de verste diepte, getoond als 0, in elke pixel. Groter is dichterbij.",
    );
    let mut steps = vec![step(cleared, Vec::new(), &depth, depths, None)];
    for (k, polygon) in polygons_of_the_grids(depths).iter().enumerate() {
        for (m, triangle) in polygon.iter().enumerate() {
            let name = name(k, m, polygon.len(), depths[k]);
            let mut covered = Vec::new();
            rasterize(triangle, width, height, |fragment| covered.push(fragment));
            let ink = INKS[k];
            let now = Now { triangle, ink, covered: &covered, won: None };
            let n = covered.len();
            let rasterized = Words::new(
                format!("{}: rasterize. The centres of {n} pixels lie inside.", name.en),
                format!("{}: rasteriseren. De middens van {n} pixels liggen erin.", name.nl),
            );
            steps.push(step(rasterized, Vec::new(), &depth, depths, Some(now)));

            let before = depth.clone();
            let mut won = Vec::new();
            let mut color = |fragment: &Fragment| {
                won.push((fragment.i, fragment.j));
                Rgb::ONE
            };
            draw(triangle, &mut color, &mut image, &mut depth);
            let compared = Words::new(
                format!(
                    "{}: nearer in {} of {n} pixels; they are drawn and their depth is kept.",
                    name.en,
                    won.len()
                ),
                format!(
                    "{}: dichterbij in {} van {n} pixels; die worden getekend en hun diepte onthouden.",
                    name.nl,
                    won.len()
                ),
            );
            let now = Now { won: Some(&won), ..now };
            steps.push(step(compared, comparisons(&covered, &before), &depth, depths, Some(now)));
        }
    }
    let title =
        Words::new("The z-buffer, triangle by triangle", "Het z-buffer-algoritme, driehoek voor driehoek");
    Ok(Told { title, steps })
}

/// The colours of the three polygons, those of the figure.
const INKS: [Ink; 3] = [Ink::B, Ink::C, Ink::A];

fn name(polygon: usize, triangle: usize, of: usize, z: f32) -> Words {
    let (k, m) = (polygon + 1, triangle + 1);
    if of == 1 {
        return Words::new(format!("Polygon {k}, z = {z}"), format!("Polygoon {k}, z = {z}"));
    }
    Words::new(
        format!("Polygon {k}, z = {z}, triangle {m} of {of}"),
        format!("Polygoon {k}, z = {z}, driehoek {m} van {of}"),
    )
}

/// The comparisons, one line for each depth that was stored.
fn comparisons(covered: &[Fragment], before: &DepthBuffer) -> Vec<Words> {
    let mut groups: Vec<(f32, f32, bool, usize)> = Vec::new();
    for fragment in covered {
        let stored = before.get(fragment.i, fragment.j);
        // As the buffer stores it.
        let z = fragment.z as f32;
        let wins = stored.is_none_or(|stored| z > stored);
        let stored = stored.unwrap_or(0.0);
        match groups.iter_mut().find(|group| (group.0, group.1) == (z, stored)) {
            Some(group) => group.3 += 1,
            None => groups.push((z, stored, wins, 1)),
        }
    }
    let line = |(z, stored, wins, n): (f32, f32, bool, usize)| {
        if wins {
            Words::new(
                format!("{z} > {stored}: drawn, {n} pixels"),
                format!("{z} > {stored}: getekend, {n} pixels"),
            )
        } else {
            Words::new(
                format!("{z} ≤ {stored}: the stored depth stays, {n} pixels"),
                format!("{z} ≤ {stored}: de opgeslagen diepte blijft, {n} pixels"),
            )
        }
    };
    groups.into_iter().map(line).collect()
}

fn step(words: Words, lines: Vec<Words>, depth: &DepthBuffer, depths: [f32; 3], now: Option<Now>) -> Step {
    let alt = words.clone();
    let (width, height) = (GRID.0 as f32, GRID.1 as f32);
    // Room for the parts of the triangle that leave the screen.
    let mut sheet = Sheet::new(vec2(-1.0, -1.0), vec2(width + 2.0, height + 1.0), 640.0);
    for j in 0..GRID.1 {
        for i in 0..GRID.0 {
            cell(&mut sheet, (i, j), depth.get(i, j), depths, now);
        }
    }
    if let Some(Now { triangle, ink, .. }) = now {
        // Pixel (i, j) is centred at (i, j); its cell begins half a pixel before.
        let corners = triangle.vertices.map(|vertex| vertex.position.truncate().as_vec2() + 0.5);
        sheet.polygon(&corners, ink.pen());
    }
    Step::new(words).lines(lines).showing(Drawing::Lines(sheet::inside_a_page(&sheet.svg(&alt), &alt)))
}

fn cell(sheet: &mut Sheet, (i, j): (u32, u32), z: Option<f32>, depths: [f32; 3], now: Option<Now>) {
    let at = vec2(i as f32, j as f32);
    let square = [at, at + Vec2::X, at + Vec2::ONE, at + Vec2::Y];
    let ink = z.and_then(|z| depths.iter().rposition(|depth| *depth == z)).map_or(Ink::Main, |k| INKS[k]);
    if z.is_some() {
        sheet.wash(&square, ink);
    }
    sheet.polygon(&square, Ink::Faint.pen().fine());
    if let Some(Now { ink, covered, won, .. }) = now {
        let is_covered = covered.iter().any(|fragment| (fragment.i, fragment.j) == (i, j));
        let inner = inset(at, 0.09);
        match won {
            None if is_covered => sheet.dot(at + vec2(0.5, 0.16), ink),
            Some(won) if won.contains(&(i, j)) => sheet.polygon(&inner, ink.pen().wide()),
            Some(_) if is_covered => sheet.polygon(&inner, ink.pen().dashed().fine()),
            _ => {}
        }
    }
    let text = z.unwrap_or(0.0).to_string();
    sheet.label_sized(at + Vec2::splat(0.5), Side::Middle, text, Letters::Plain, ink, 20.0);
}

fn inset(at: Vec2, by: f32) -> [Vec2; 4] {
    let (low, high) = (by, 1.0 - by);
    [(low, low), (high, low), (high, high), (low, high)].map(|(x, y)| at + vec2(x, y))
}
