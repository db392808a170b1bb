//! What can the page ask? One file a question.

pub(crate) mod claim;
pub(crate) mod drawings;
pub(crate) mod figure;
pub(crate) mod frame;
pub(crate) mod lecture;
pub(crate) mod student;

use course::Exercise;
use serde::Deserialize;
use serde_json::{Value as Json, json};
use sheet::{Text, Words};

use crate::{Look, Refusal};

/// A pixel's story.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct StoryRequest {
    pub(crate) look: Look,
    pub(crate) pixel: [u32; 2],
}

/// What the page has measured of itself.
#[derive(Clone, Debug, Deserialize, PartialEq)]
pub struct Measured {
    /// Pictures of the z-buffer that appeared in a second.
    pub frames_per_second: f64,
    /// From the hand's movement to the picture that shows it.
    pub latency_ms: Latency,
    /// How many pictures that was.
    pub frames: u32,
    /// The size of the pictures in pixels.
    pub size: [u32; 2],
    /// The scene.
    pub scene: String,
}

/// A time that differs from picture to picture, in milliseconds.
#[derive(Clone, Copy, Debug, Deserialize, PartialEq)]
pub struct Latency {
    /// Half of the pictures came sooner.
    pub median: f64,
    /// 95 of 100 did.
    pub p95: f64,
}

/// Words in both languages.
pub(crate) fn words(words: &Words) -> Json {
    json!({ "en": words.en, "nl": words.nl })
}

/// The same of words that are known beforehand.
pub(crate) fn text(text: Text) -> Json {
    json!({ "en": text.en, "nl": text.nl })
}

/// The shortest digits that read back to the same number; nothing for an infinity or a NaN, which JSON does not have.
pub(crate) fn number(x: f32) -> Json {
    if x.is_finite() { x.to_string().parse::<f64>().map_or(Json::Null, |x| json!(x)) } else { Json::Null }
}

/// What an exercise is called.
pub(crate) fn title(exercise: &Exercise) -> Json {
    text(Text { en: exercise.title.english, nl: exercise.title.dutch })
}

/// The exercise of this name.
///
/// # Errors
/// [`Refusal`] if there is none.
pub(crate) fn exercise(name: &str) -> Result<&'static Exercise, Refusal> {
    course::find(name).ok_or_else(|| {
        Refusal::new(format!("there is no exercise {name:?}"), format!("er is geen opgave {name:?}"))
    })
}
