//! How does a figure look when the student's function draws it?

use std::collections::BTreeMap;

use serde::Deserialize;
use serde_json::Value as Json;

use super::figure;
use crate::{Refusal, StudentPictures};

/// A figure, its values, and whose function.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct StudentRequest {
    figure: String,
    #[serde(default)]
    set: BTreeMap<String, f32>,
    exercise: String,
}

/// Draws it.
///
/// # Errors
/// [`Refusal`] if there is no such figure or exercise.
pub(crate) fn draw(mine: &StudentPictures, asked: &StudentRequest) -> Result<Json, Refusal> {
    let found = figure::find(&asked.figure)?;
    let values = figure::values(found, &asked.set, None)?;
    Ok(mine.draw(found, &values, super::exercise(&asked.exercise)?))
}
