//! How do numbers, vectors and words go to the page?

use canvas::{Rgb, srgb};
use glam::Vec3;
use serde_json::{Value as Json, json};
use sheet::Words;
use sheet::text::decimal;

pub(crate) use crate::api::{number, words};

/// Three numbers.
pub(crate) fn vector(v: Vec3) -> Json {
    Json::Array(v.to_array().map(number).to_vec())
}

/// The colour as a file has it: three numbers from 0 to 255.
pub(crate) fn bytes(color: Rgb) -> Json {
    json!(steps_of(color))
}

/// The 8-bit steps of a colour.
pub(crate) fn steps_of(color: Rgb) -> [u8; 3] {
    color.to_array().map(srgb::to_u8)
}

/// How many of something there were.
pub(crate) fn count(what: &Words, count: usize) -> Json {
    json!({ "what": words(what), "count": count })
}

/// A vector as it stands in a formula.
pub(crate) fn triple(v: Vec3) -> String {
    let [x, y, z] = v.to_array().map(|x| decimal(x, 3));
    format!("({x}, {y}, {z})")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_number_reads_back_to_itself_and_looks_as_it_was_written() {
        assert_eq!(number(0.8).to_string(), "0.8");
        for x in [1.0_f32 / 3.0, -7.25e-12, f32::MAX, f32::MIN_POSITIVE, 16_777_217.0] {
            assert_eq!(number(x).as_f64().map(|y| y as f32), Some(x));
        }
        assert_eq!((number(f32::NAN), number(f32::INFINITY)), (Json::Null, Json::Null));
    }
}
