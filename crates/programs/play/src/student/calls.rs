//! How is a function drawn whose answer is no colour and no point: a matrix, say? As the exercise draws one call.

use course::{Answerer, Exercise, InProcess, Reply, Value, arguments, values};
use glam::{Vec3, vec2, vec3};
use serde_json::json;
use sheet::Words;
use vocabulary::ViewVolume;

use super::drawing::Drawn;
use super::knobs::Knobs;
use super::messages::Trouble;
use crate::api::words;

/// Numbers of an answer that are as near as this, relative for those above 1, are the same: what one way to compute them rounds otherwise than another.
const SAME: f32 = 1e-3;

/// Asks the worked examples and the call that the figure's parameters make, and draws the call if it is wrong or all are right, else the first
/// worked example that is.
pub(super) fn of_a_call(exercise: &Exercise, knobs: &Knobs<'_>, yours: &mut dyn Answerer) -> Drawn {
    let mut questions: Vec<Vec<Value>> =
        exercise.examples.iter().map(|example| example.arguments.clone()).collect();
    let worked = questions.len();
    questions.extend(call(exercise, knobs));
    let replies = match yours.ask(&questions) {
        Ok(replies) => replies,
        Err(fault) => return Drawn::nothing(Trouble::fault(&fault.0)),
    };
    let trouble = replies.iter().find_map(Trouble::of_reply);
    let given = |at: usize| match replies.get(at) {
        Some(Reply::Value(value)) => Some(value),
        _ => None,
    };
    let is_right = |at: usize| given(at).is_some_and(|value| exercise.examples[at].check(value).is_ok());
    let wrong: Vec<usize> = (0..worked).filter(|at| !is_right(*at)).collect();
    let shown = match wrong.first() {
        // The figure's own call is drawn where it shows something.
        Some(first)
            if worked == questions.len()
                || is_as_the_reference(exercise, &questions[worked], given(worked)) =>
        {
            *first
        }
        _ => questions.len() - 1,
    };
    if replies.iter().all(|reply| !matches!(reply, Reply::Value(_))) {
        return Drawn { trouble, drawings: Vec::new(), differs: None };
    }
    let picture = exercise.picture(&questions[shown], given(shown), yours);
    let label = Words::new("yours beside the right one", "van jou naast de goede");
    let differs = Words::new(
        format!("{} of {worked} worked examples differ", wrong.len()),
        format!("{} van {worked} uitgewerkte voorbeelden verschillen", wrong.len()),
    );
    let alt = Words::new(
        format!("One call of {}, yours and right; {}.", exercise.name, differs.en),
        format!("Eén aanroep van {}, van jou en goed; {}.", exercise.name, differs.nl),
    );
    let drawings = picture.map(
        |picture| json!({ "name": "call", "label": words(&label), "alt": words(&alt), "svg": picture.svg }),
    );
    Drawn { trouble, drawings: drawings.into_iter().collect(), differs: Some((differs, wrong.len(), worked)) }
}

/// The call that the figure's parameters make, where they fit.
fn call(exercise: &Exercise, knobs: &Knobs<'_>) -> Option<Vec<Value>> {
    let [left, right, bottom, top, near, far] = ["l", "r", "b", "t", "n", "f"].map(|name| knobs.get(name));
    let volume = || {
        Some(ViewVolume { left: left?, right: right?, bottom: bottom?, top: top?, near: near?, far: far? })
    };
    let pixels = || Some((knobs.get("n_x")? as u32, knobs.get("n_y")? as u32));
    match exercise.name {
        "rotate_about_point" => {
            let pivot = vec2(knobs.get("p_x")?, knobs.get("p_y")?);
            Some(arguments![knobs.get("theta")?.to_radians(), pivot])
        }
        "perspective" => Some(arguments![near?, far?]),
        "canonical_from_camera" => Some(arguments![volume()?]),
        "screen_from_canonical" => pixels().map(|(width, height)| arguments![width, height]),
        "window_from_pixel" => {
            let volume = ViewVolume { left: -1.0, right: 1.4, bottom: -0.8, top: 1.0, near: -2.5, far: -5.5 };
            pixels().map(|(width, height)| arguments![volume, width, height])
        }
        "camera_frame" => {
            let (azimuth, elevation) =
                (knobs.get("azimuth")?.to_radians(), knobs.get("elevation")?.to_radians());
            let (sin, cos) = azimuth.sin_cos();
            let to_eye = vec3(elevation.cos() * sin, elevation.sin(), elevation.cos() * cos);
            Some(arguments![-to_eye, Vec3::Y])
        }
        _ => None,
    }
}

/// Whether an answer is the reference's, but for rounding.
fn is_as_the_reference(exercise: &Exercise, question: &[Value], given: Option<&Value>) -> bool {
    let right = values(&mut InProcess(exercise.reference.function), &[question.to_vec()]).pop().flatten();
    match (given.map(numbers), right.as_ref().map(numbers)) {
        (Some(given), Some(right)) => {
            given.len() == right.len()
                && given.iter().zip(&right).all(|(a, b)| (a - b).abs() <= SAME * b.abs().max(1.0))
        }
        _ => false,
    }
}

/// All numbers of a value, in order.
fn numbers(value: &Value) -> Vec<f32> {
    match value {
        Value::Number(number) => vec![*number],
        Value::Vector(numbers) | Value::Matrix(numbers) => numbers.clone(),
        Value::List(values) => values.iter().flat_map(numbers).collect(),
        Value::Record(record) => record.fields.iter().flat_map(|(_, value)| numbers(value)).collect(),
        Value::Whole(whole) => vec![*whole as f32],
        Value::Truth(truth) => vec![f32::from(u8::from(*truth))],
        Value::Nothing => Vec::new(),
    }
}
