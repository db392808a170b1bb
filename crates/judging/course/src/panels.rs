//! How do a student's colours look beside the right ones? As three pictures of one thing: yours, right, and the difference.

use glam::{Vec2, Vec3, vec2};
use sheet::text::decimal;
use sheet::{Ink, Letters, Sheet, Side, Words};
use worker::{Plain, Value};

use crate::exercise::{Calls, Picture, Seen};

/// Samples along each side of a panel; three panels side by side fit a terminal.
const SAMPLES: usize = 24;
/// A panel's side and the room around it, in pixels.
const PANEL: f32 = 216.0;
const GAP: f32 = 20.0;
/// Below the panels: their names, and three lines of words.
const WORDS: f32 = 130.0;

/// What is drawn: a question for each place of the square [−1, 1]², and places with names.
pub(crate) struct Subject<'a> {
    /// The arguments for the place (x, y), y upwards; `None` where nothing is.
    pub(crate) question: &'a dyn Fn(Vec2) -> Option<Vec<Value>>,
    /// Places that are marked, with their names; the first is that of the counterexample.
    pub(crate) marks: &'a [(Vec2, &'static str)],
    /// What it is: "a ball in this light".
    pub(crate) name: Words,
}

/// The colours of a panel, row by row from the bottom; `None` where nothing is or no colour came back.
type Colours = Vec<Option<Vec3>>;

/// Draws a function that returns a colour, by calling it all over the subject.
pub(crate) fn draw(seen: &Seen<'_>, subject: &Subject<'_>) -> Option<Picture> {
    let questions: Vec<Option<Vec<Value>>> = places().map(|place| (subject.question)(place)).collect();
    let yours = colours(&questions, seen.yours);
    let right = colours(&questions, seen.reference);
    if right.iter().all(Option::is_none) {
        return None;
    }
    let exposure = exposure(&yours, &right);
    let difference = yours.iter().zip(&right).map(|(a, b)| Some((a.as_ref()? - b.as_ref()?).abs())).collect();
    let panels = [yours, right, difference];
    Some(Picture {
        svg: svg(seen, subject, &panels, exposure),
        text: Some(text(&panels, &questions, exposure)),
    })
}

/// The middles of all samples.
fn places() -> impl Iterator<Item = Vec2> {
    let middle = |k: usize| (2.0 * k as f32 + 1.0) / SAMPLES as f32 - 1.0;
    (0..SAMPLES * SAMPLES).map(move |k| vec2(middle(k % SAMPLES), middle(k / SAMPLES)))
}

fn colours(questions: &[Option<Vec<Value>>], calls: &Calls<'_>) -> Colours {
    let asked: Vec<Vec<Value>> = questions.iter().flatten().cloned().collect();
    let mut answers = calls(&asked).into_iter();
    let colour = |question: &Option<Vec<Value>>| {
        question.as_ref()?;
        let colour: Vec3 = Plain::from_value(answers.next()??)?;
        colour.is_finite().then_some(colour)
    };
    questions.iter().map(colour).collect()
}

/// The ground of a panel, sRGB.
const GROUND: [u8; 3] = [128, 132, 140];

/// What colours are multiplied by, so that the brightest is white; where yours are absurdly bright, the right ones stay visible.
fn exposure(yours: &Colours, right: &Colours) -> f32 {
    let brightest = |colours: &Colours| colours.iter().flatten().map(|c| c.max_element()).fold(0.0, f32::max);
    let (yours, right) = (brightest(yours), brightest(right));
    let white = if right > 0.0 { yours.min(4.0 * right).max(right) } else { yours };
    if white > 0.0 { 1.0 / white } else { 1.0 }
}

fn svg(seen: &Seen<'_>, subject: &Subject<'_>, panels: &[Colours; 3], exposure: f32) -> String {
    let size = vec2(3.0 * PANEL + 4.0 * GAP, PANEL + GAP + WORDS);
    let mut sheet = Sheet::new(Vec2::ZERO, size, size.x);
    let names =
        [Words::new("yours", "van jou"), Words::new("right", "goed"), Words::new("difference", "verschil")];
    for (k, (colours, name)) in panels.iter().zip(names).enumerate() {
        let corner = vec2(GAP + k as f32 * (PANEL + GAP), WORDS);
        paint(&mut sheet, corner, colours, exposure);
        for (place, letter) in subject.marks {
            let p = corner + 0.5 * PANEL * (*place + 1.0);
            sheet.circle(p, 5.0, Ink::A.pen());
            sheet.label(p, Side::AboveRight, *letter, Letters::Vector, Ink::A);
        }
        sheet.label(corner + vec2(0.5 * PANEL, 0.0), Side::Below, name, Letters::Plain, Ink::Main);
    }
    let [yours, right] = at_the_mark(seen, subject);
    let lines = [yours, right, what_is_white(subject, exposure)];
    sheet.lines(GAP - 10.0, PANEL + GAP + 52.0, lines);
    let alt = &subject.name;
    sheet.svg(&Words::new(
        format!("{}: the student's colours, the right ones, and the difference", alt.en),
        format!("{}: de kleuren van de student, de goede, en het verschil", alt.nl),
    ))
}

fn paint(sheet: &mut Sheet, corner: Vec2, colours: &Colours, exposure: f32) {
    // On a grey ground black and white are both seen, whatever the colour of the page.
    sheet.tile(corner, PANEL, GROUND);
    let side = PANEL / SAMPLES as f32;
    for (k, colour) in colours.iter().enumerate() {
        if let Some(colour) = colour {
            let place = side * vec2((k % SAMPLES) as f32, (k / SAMPLES) as f32);
            sheet.tile(corner + place, side, srgb(exposure * *colour));
        }
    }
}

/// What came out at the counterexample itself, and what should have.
fn at_the_mark(seen: &Seen<'_>, subject: &Subject<'_>) -> [Words; 2] {
    let letter = subject.marks.first().map_or("", |mark| mark.1);
    let short = |value: Option<&Value>| match value.cloned().and_then(<Vec3 as Plain>::from_value) {
        Some(c) => format!("({}, {}, {})", decimal(c.x, 3), decimal(c.y, 3), decimal(c.z, 3)),
        None => "—".to_owned(),
    };
    let (yours, right) = (short(seen.given), short(Some(seen.right)));
    [
        Words::new(format!("yours at {letter}: {yours}"), format!("van jou bij {letter}: {yours}")),
        Words::new(format!("right at {letter}: {right}"), format!("goed bij {letter}: {right}")),
    ]
}

fn what_is_white(subject: &Subject<'_>, exposure: f32) -> Words {
    let white = decimal(1.0 / exposure, 2);
    Words::new(
        format!("{}; white is a brightness of {white}", subject.name.en),
        format!("{}; wit is een helderheid van {white}", subject.name.nl),
    )
}

/// From linear light to numbers of a file.
fn srgb(colour: Vec3) -> [u8; 3] {
    colour.to_array().map(|light| {
        let light = light.clamp(0.0, 1.0);
        let curved = if light <= 0.003_130_8 { 12.92 * light } else { 1.055 * light.powf(1.0 / 2.4) - 0.055 };
        (255.0 * curved).round() as u8
    })
}

/// The panels side by side in letters, every second row: a letter is twice as high as wide.
fn text(panels: &[Colours; 3], questions: &[Option<Vec<Value>>], exposure: f32) -> String {
    const RAMP: [char; 10] = [' ', '.', ':', '-', '=', '+', '*', '#', '%', '@'];
    let letter = |colour: Option<Vec3>, asked: bool| match colour {
        Some(c) => {
            let light = (exposure * c.max_element()).clamp(0.0, 1.0).sqrt();
            RAMP[((light * 9.0).round() as usize).min(9)]
        }
        None if asked => '?',
        None => ' ',
    };
    let mut lines = vec![format!("{:<26}{:<26}{}", "yours", "right", "difference")];
    for row in (0..SAMPLES).step_by(2).rev() {
        let places = row * SAMPLES..(row + 1) * SAMPLES;
        let parts = panels.iter().map(|colours| -> String {
            places.clone().map(|k| letter(colours[k], questions[k].is_some())).collect()
        });
        lines.push(parts.collect::<Vec<_>>().join("  ").trim_end().to_owned());
    }
    lines.join("\n")
}
