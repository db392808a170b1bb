//! What does one of the three loops see? A picture, or some rows of it.

use std::time::Instant;

use canvas::srgb::EightBitSteps;
use canvas::{Image, Rgb};
use hyper::StatusCode;
use hyper::header::HeaderValue;
use rayon::prelude::*;
use scene::{Renderer, Show};
use serde::Deserialize;
use serde_json::Value as Json;

use crate::look::named;
use crate::serve::answer::{self, Answer};
use crate::{Look, Refusal, Stage};

/// A picture by one of the loops.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Asked {
    look: Look,
    renderer: String,
    /// One pixel stands for so many, along each side.
    #[serde(default = "one")]
    scale: u32,
    /// From which row to before which, from the top down; the ray tracer alone draws rows.
    #[serde(default)]
    rows: Option<[u32; 2]>,
    /// n × n samples a pixel; the ray tracer alone.
    #[serde(default = "one")]
    samples: u32,
}

fn one() -> u32 {
    1
}

/// More would be smaller than a thumb.
const COARSEST: u32 = 16;
/// More are not seen.
const MOST_SAMPLES: u32 = 4;

/// Pixels as a page shows them.
pub(crate) struct Frame {
    width: u32,
    height: u32,
    row: u32,
    rgba: Vec<u8>,
    notes: Vec<String>,
    micros: u128,
}

/// Draws it.
///
/// # Errors
/// [`Refusal`] if a word is unknown, a number out of range, or the painter cannot.
pub(crate) fn draw(stage: &Stage, asked: &Asked) -> Result<Frame, Refusal> {
    let renderer: Renderer = named(&asked.renderer)?;
    if !(1..=COARSEST).contains(&asked.scale) || !(1..=MOST_SAMPLES).contains(&asked.samples) {
        return Err(Refusal::new("scale or samples are out of range", "schaal of samples buiten bereik"));
    }
    let mut settings = asked.look.settings(renderer)?;
    let prepared = stage.prepared(&asked.look)?;
    let begun = Instant::now();
    let (width, height) = settings.size;
    settings.size = (width.div_ceil(asked.scale), height.div_ceil(asked.scale));
    let (width, height) = settings.size;
    let (row, image, notes) = match asked.rows {
        Some([from, to]) if renderer == Renderer::Raytrace && settings.show == Show::Color => {
            if from >= to || to > height {
                return Err(Refusal::new("no such rows", "zulke rijen zijn er niet"));
            }
            let world = prepared.traced_world(&settings)?;
            let rays = raytrace::Settings {
                samples: asked.samples,
                shadows: settings.shadows,
                max_depth: settings.max_depth,
                ..raytrace::Settings::default()
            };
            let pixels = raytrace::render_rows(&world, &prepared.pipeline(width, height)?, &rays, from..to);
            (from, Image::from_rows(width, to - from, pixels), Vec::new())
        }
        _ => {
            settings.samples = if renderer == Renderer::Raytrace { asked.samples } else { 1 };
            let rendered = scene::render(&prepared, &settings, &|_| ())?;
            (0, Some(rendered.image), rendered.notes)
        }
    };
    let Some(image) = image else { return Err(Refusal::new("no rows", "geen rijen")) };
    let (rgba, height) = (encoded(image.pixels()), image.height());
    Ok(Frame { width, height, row, rgba, notes, micros: begun.elapsed().as_micros() })
}

/// Light as steps of a file, opaque.
fn encoded(pixels: &[Rgb]) -> Vec<u8> {
    static STEPS: std::sync::LazyLock<EightBitSteps> = std::sync::LazyLock::new(EightBitSteps::new);
    let steps = &*STEPS;
    let mut rgba = vec![u8::MAX; 4 * pixels.len()];
    rgba.par_chunks_exact_mut(4).with_min_len(1 << 14).zip(pixels).for_each(|(bytes, pixel)| {
        for (byte, light) in bytes.iter_mut().zip(pixel.to_array()) {
            *byte = steps.nearest(light);
        }
    });
    rgba
}

impl Frame {
    /// Its numbers in the head, its pixels in the body.
    pub(crate) fn into_answer(self) -> Answer {
        let mut answer = answer::bytes(StatusCode::OK, "application/octet-stream", self.rgba);
        let notes = escaped(&Json::from(self.notes).to_string());
        for (name, value) in [
            ("x-width", self.width.to_string()),
            ("x-height", self.height.to_string()),
            ("x-row", self.row.to_string()),
            ("x-micros", self.micros.to_string()),
            ("x-notes", notes),
        ] {
            if let Ok(value) = HeaderValue::from_str(&value) {
                answer.headers_mut().insert(name, value);
            }
        }
        answer
    }
}

/// Text for a head, where only few signs may stand: the others as % and two digits.
fn escaped(text: &str) -> String {
    let sign = |byte: u8| {
        if byte.is_ascii_alphanumeric() { char::from(byte).to_string() } else { format!("%{byte:02X}") }
    };
    text.bytes().map(sign).collect()
}
