//! How did this pixel get its colour? Told for the z-buffer and for the ray tracer, side by side.

use serde_json::Value as Json;

use crate::{Look, Refusal, Stage};

/// The story of pixel (i, j), j upwards.
///
/// # Errors
/// [`Refusal`] if the look is none, or the pixel is outside the picture.
pub fn story(_stage: &Stage, _look: &Look, _pixel: (u32, u32)) -> Result<Json, Refusal> {
    Ok(Json::Null)
}
