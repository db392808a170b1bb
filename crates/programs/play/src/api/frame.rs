//! What does one of the three loops see? A picture, or some rows of it.

use std::ops::Range;
use std::sync::LazyLock;
use std::time::Instant;

use canvas::Rgb;
use canvas::srgb::EightBitSteps;
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
pub(crate) struct FrameRequest {
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
    rows: Range<u32>,
    /// As [`packed`] gives them.
    pixels: Vec<u8>,
    notes: Vec<String>,
    micros: u128,
}

/// Draws it.
///
/// # Errors
/// [`Refusal`] if a word is unknown, a number out of range, or the painter cannot.
pub(crate) fn draw(stage: &Stage, asked: &FrameRequest) -> Result<Frame, Refusal> {
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
    let (rows, pixels, notes) = match asked.rows {
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
            (from..to, packed(&pixels), Vec::new())
        }
        _ => {
            settings.samples = if renderer == Renderer::Raytrace { asked.samples } else { 1 };
            let rendered = scene::render(&prepared, &settings, &|_| ())?;
            (0..height, packed(rendered.image.pixels()), rendered.notes)
        }
    };
    Ok(Frame { width, rows, pixels, notes, micros: begun.elapsed().as_micros() })
}

/// So many pixels are encoded by one thread at a time.
const STRETCH: usize = 1 << 13;
/// From so many equal pixels on they are sent as one and their number.
const RUN: usize = 4;
/// Marks the number of pixels that are equal.
const EQUAL: u32 = 1 << 31;

/// Light as steps of a file, opaque, in words of four bytes: a number and so many pixels, or a number with its highest bit set and the one
/// pixel that stands for all of them. Background and flat faces take next to nothing, and most of a picture's time between
/// two processes is its length.
fn packed(pixels: &[Rgb]) -> Vec<u8> {
    let stretches: Vec<Vec<u8>> = pixels.par_chunks(STRETCH).map(stretch).collect();
    stretches.concat()
}

fn stretch(pixels: &[Rgb]) -> Vec<u8> {
    static STEPS: LazyLock<EightBitSteps> = LazyLock::new(EightBitSteps::new);
    let steps = &*STEPS;
    let encode = |light: Rgb| {
        let [r, g, b] = [light.x, light.y, light.z].map(|light| steps.nearest(light));
        u32::from_le_bytes([r, g, b, u8::MAX])
    };
    let mut last = (Rgb::ZERO, encode(Rgb::ZERO));
    let words = pixels.iter().map(|light| {
        // A pixel is often the one before it.
        if *light != last.0 {
            last = (*light, encode(*light));
        }
        last.1
    });
    let words: Vec<u32> = words.collect();
    let mut bytes = Vec::with_capacity(4 * words.len());
    let send = |bytes: &mut Vec<u8>, word: u32| bytes.extend_from_slice(&word.to_le_bytes());
    let mut different: Option<usize> = None;
    for equal in words.chunk_by(|a, b| a == b) {
        if equal.len() >= RUN {
            different = None;
            send(&mut bytes, EQUAL | equal.len() as u32);
            send(&mut bytes, equal[0]);
            continue;
        }
        // Their number stands before them and grows.
        let at = *different.get_or_insert_with(|| {
            send(&mut bytes, 0);
            bytes.len() - 4
        });
        equal.iter().for_each(|word| send(&mut bytes, *word));
        let count = ((bytes.len() - at) / 4 - 1) as u32;
        bytes[at..at + 4].copy_from_slice(&count.to_le_bytes());
    }
    bytes
}

impl Frame {
    /// Its numbers in the head, its pixels in the body.
    pub(crate) fn into_answer(self) -> Answer {
        let mut answer = answer::bytes(StatusCode::OK, "application/octet-stream", self.pixels);
        let notes = escaped(&Json::from(self.notes).to_string());
        for (name, value) in [
            ("x-width", self.width.to_string()),
            ("x-height", self.rows.len().to_string()),
            ("x-row", self.rows.start.to_string()),
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

#[cfg(test)]
mod tests {
    use canvas::srgb::to_u8;

    use super::*;

    /// What the page makes of it.
    fn unpacked(bytes: &[u8]) -> Vec<u32> {
        let words: Vec<u32> =
            bytes.chunks_exact(4).map(|word| u32::from_le_bytes(word.try_into().unwrap())).collect();
        let mut pixels = Vec::new();
        let mut at = 0;
        while at < words.len() {
            let count = (words[at] & !EQUAL) as usize;
            if words[at] & EQUAL == 0 {
                pixels.extend_from_slice(&words[at + 1..at + 1 + count]);
                at += 1 + count;
            } else {
                pixels.extend(std::iter::repeat_n(words[at + 1], count));
                at += 2;
            }
        }
        pixels
    }

    #[test]
    fn what_was_packed_comes_out_again() {
        let light = |k: usize| match k {
            // Flat, alternating, rising, and flat across the end of a stretch.
            0..100 => Rgb::splat(0.2),
            100..200 => Rgb::splat(if k.is_multiple_of(2) { 0.1 } else { 0.9 }),
            200..300 => Rgb::new(k as f32 / 300.0, 0.5, 0.1),
            _ => Rgb::new(2.0, f32::NAN, -1.0),
        };
        for length in [0, 1, 3, 4, 5, 150, 250, STRETCH - 1, STRETCH, STRETCH + 1, 3 * STRETCH + 7] {
            let pixels: Vec<Rgb> = (0..length).map(light).collect();
            let wanted: Vec<u32> = pixels
                .iter()
                .map(|p| u32::from_le_bytes([to_u8(p.x), to_u8(p.y), to_u8(p.z), 255]))
                .collect();
            assert_eq!(unpacked(&packed(&pixels)), wanted, "{length} pixels");
        }
        let background = vec![Rgb::splat(0.3); 640 * 480];
        assert!(packed(&background).len() < 1000);
    }
}
