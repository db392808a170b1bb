//! How do a student's function and the right one become three pictures: yours, right, and the difference?

use canvas::{Image, Rgb, difference, side_by_side};
use course::{Answerer, Exercise, InProcess, Reply, Value, values};
use serde_json::{Value as Json, json};
use sheet::Words;

use super::messages::Trouble;
use super::panel::{Dots, Panel, enlarged};
use crate::api::drawings::png;
use crate::api::words;

/// What a screen shows as two colours: more than a step of eight bits, encoded.
const SEEN: f32 = 1.0 / 255.0;

/// Pictures are enlarged by whole numbers to about this width, in pixels.
const WIDTH: u32 = 480;

/// Between panels, and above lower ones, in pixels before they are enlarged.
const GAP: u32 = 2;
const BETWEEN: Rgb = Rgb::splat(0.02);

/// What came of drawing.
pub(super) struct Drawn {
    /// What went wrong on the way.
    pub(super) trouble: Option<Trouble>,
    /// The drawings, as the page wants them.
    pub(super) drawings: Vec<Json>,
    /// How much differs, in words and as two numbers: so many of so many.
    pub(super) differs: Option<(Words, usize, usize)>,
}

impl Drawn {
    /// That nothing can be drawn.
    pub(super) fn nothing(trouble: Trouble) -> Self {
        Self { trouble: Some(trouble), drawings: Vec::new(), differs: None }
    }
}

/// Draws panels beside each other with both functions.
pub(super) fn of_panels(exercise: &Exercise, panels: &[Panel], yours: &mut dyn Answerer) -> Drawn {
    let questions: Vec<Vec<Value>> =
        distinct(panels).flat_map(|(_, panel)| panel.questions.clone()).collect();
    let replies = match yours.ask(&questions) {
        Ok(replies) => replies,
        Err(fault) => return Drawn::nothing(Trouble::fault(&fault.0)),
    };
    let trouble = replies.iter().find_map(Trouble::of_reply);
    if !replies.iter().any(|reply| matches!(reply, Reply::Value(_))) {
        return Drawn { trouble, drawings: Vec::new(), differs: None };
    }
    let mut given: Vec<Option<Value>> = replies.into_iter().map(value).collect();
    given.resize(questions.len(), None);
    let right = values(&mut InProcess(exercise.reference.function), &questions);
    let (yours, right) = (painted(panels, &given), painted(panels, &right));
    let brightest = right.iter().map(Dots::brightest).fold(1.0, f32::max);
    compared(&yours, &right, 1.0 / brightest, trouble)
}

fn value(reply: Reply) -> Option<Value> {
    if let Reply::Value(value) = reply { Some(value) } else { None }
}

/// The panels that ask something else than those before them, with their places: two views of the same answers are asked for once.
fn distinct(panels: &[Panel]) -> impl Iterator<Item = (usize, &Panel)> {
    panels.iter().enumerate().filter(|(place, _)| first_of(panels, *place) == *place)
}

/// The first panel that asks the same as this one.
fn first_of(panels: &[Panel], place: usize) -> usize {
    panels[..place].iter().position(|panel| panel.questions == panels[place].questions).unwrap_or(place)
}

/// Each panel by its own answers, or by those of the first that asks the same.
fn painted(panels: &[Panel], answers: &[Option<Value>]) -> Vec<Dots> {
    let mut rest = answers;
    let mut own: Vec<&[Option<Value>]> = vec![&[]; panels.len()];
    for (place, panel) in distinct(panels) {
        (own[place], rest) = rest.split_at(panel.questions.len().min(rest.len()));
    }
    let dots = |(place, panel): (usize, &Panel)| panel.painted(own[first_of(panels, place)]);
    panels.iter().enumerate().map(dots).collect()
}

fn compared(yours: &[Dots], right: &[Dots], exposure: f32, trouble: Option<Trouble>) -> Drawn {
    let mut differing = 0;
    let mut greatest = 0.0_f32;
    let mut heat = Vec::new();
    for (yours, right) in yours.iter().zip(right) {
        // Panels of both are of one size.
        let Ok(found) = difference(&yours.comparable(exposure), &right.comparable(exposure), SEEN) else {
            continue;
        };
        differing += found.over_threshold;
        greatest = greatest.max(found.greatest);
        heat.push(found.heat_map());
    }
    let counted: Vec<(usize, usize)> = yours.iter().map(Dots::counted).collect();
    let all: usize = counted.iter().map(|(asked, _)| asked).sum();
    let missing: usize = counted.iter().map(|(_, missing)| missing).sum();
    let looked = |dots: &[Dots]| dots.iter().map(|dots| dots.image(exposure)).collect::<Vec<_>>();
    let differs = in_words(differing, all, missing, greatest);
    let drawings = [
        ("yours", Words::new("yours", "van jou"), looked(yours)),
        ("right", Words::new("right", "goed"), looked(right)),
        ("difference", Words::new("difference", "verschil"), heat),
    ];
    let drawings =
        drawings.into_iter().filter_map(|(name, label, images)| picture(name, &label, &images, &differs));
    Drawn { trouble, drawings: drawings.collect(), differs: Some((differs.clone(), differing, all)) }
}

fn in_words(differing: usize, all: usize, missing: usize, greatest: f32) -> Words {
    let steps = (255.0 * greatest).round();
    let mut words = Words::new(
        format!("{differing} of {all} pixels differ"),
        format!("{differing} van {all} pixels verschillen"),
    );
    if missing > 0 {
        words.en += &format!("; {missing} of them without a number, hatched");
        words.nl += &format!("; {missing} daarvan zonder getal, gearceerd");
    } else if differing > 0 {
        words.en += &format!(", by at most {steps} of 255 steps");
        words.nl += &format!(", met hoogstens {steps} van 255 stappen");
    }
    words
}

/// One drawing of the answer.
fn picture(name: &str, label: &Words, panels: &[Image], differs: &Words) -> Option<Json> {
    let tallest = panels.iter().map(Image::height).max()?;
    // A panel of few pixels is as tall as its neighbours, nearly.
    let grown: Vec<Image> =
        panels.iter().map(|panel| enlarged(panel, (tallest / panel.height()).max(1))).collect();
    let row = side_by_side(&grown.iter().collect::<Vec<_>>(), GAP, BETWEEN);
    let row = enlarged(&row, (WIDTH / row.width()).max(1));
    let alt = Words::new(
        format!("Drawn pixel by pixel, {}; {}.", label.en, differs.en),
        format!("Pixel voor pixel getekend, {}; {}.", label.nl, differs.nl),
    );
    Some(json!({
        "name": name,
        "label": words(label),
        "alt": words(&alt),
        "png": png(&row).ok()?,
    }))
}
