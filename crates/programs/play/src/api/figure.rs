//! How does a figure look with these values?

use std::collections::BTreeMap;

use figures::{Figure, Values};
use glam::Vec2;
use serde::Deserialize;
use serde_json::{Value as Json, json};

use super::drawings::drawings;
use super::number;
use crate::Refusal;

/// A figure with some of its values.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct FigureRequest {
    figure: String,
    #[serde(default)]
    set: BTreeMap<String, f32>,
    #[serde(default)]
    size: Option<[u32; 2]>,
}

/// Draws it.
///
/// # Errors
/// [`Refusal`] if there is no such figure, or it cannot be drawn with these values.
pub(crate) fn draw(asked: &FigureRequest) -> Result<Json, Refusal> {
    let figure = find(&asked.figure)?;
    drawn(figure, &values(figure, &asked.set, asked.size)?)
}

/// The figure of this name.
///
/// # Errors
/// [`Refusal`] if there is none.
pub(crate) fn find(name: &str) -> Result<&'static Figure, Refusal> {
    figures::find(name).into_iter().next().ok_or_else(|| {
        Refusal::new(format!("there is no figure {name:?}"), format!("er is geen figuur {name:?}"))
    })
}

/// The lecture's values, but for those that are set.
///
/// # Errors
/// [`Refusal`] if a value is out of range.
pub(crate) fn values(
    figure: &Figure,
    set: &BTreeMap<String, f32>,
    size: Option<[u32; 2]>,
) -> Result<Values, Refusal> {
    let mut values = Values::of(figure);
    for (name, value) in set {
        values.set(name, *value).map_err(Refusal::because)?;
    }
    if let Some([width, height]) = size {
        values.set_size(width, height).map_err(Refusal::because)?;
    }
    Ok(values)
}

fn drawn(figure: &Figure, values: &Values) -> Result<Json, Refusal> {
    let drawn = (figure.draw)(values).map_err(Refusal::because)?;
    let set: serde_json::Map<String, Json> = figure
        .parameters
        .iter()
        .map(|parameter| (parameter.name.to_owned(), number(values.number(parameter.name))))
        .collect();
    Ok(json!({ "set": set, "drawings": drawings(&drawn)? }))
}

/// A handle of a figure, and whereto it was dragged.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Dragged {
    figure: String,
    #[serde(default)]
    set: BTreeMap<String, f32>,
    #[serde(default)]
    size: Option<[u32; 2]>,
    drawing: usize,
    handle: usize,
    /// As fractions of the drawing's width and height, from its top left corner.
    to: [f32; 2],
}

/// Draws the figure with the values for which the handle is nearest to where it was dragged.
///
/// # Errors
/// [`Refusal`] if there is no such figure or handle.
pub(crate) fn drag(asked: &Dragged) -> Result<Json, Refusal> {
    let figure = find(&asked.figure)?;
    let values = values(figure, &asked.set, asked.size)?;
    let to = Vec2::from(asked.to).clamp(Vec2::ZERO, Vec2::ONE);
    let values = figures::drag(figure, &values, asked.drawing, asked.handle, to);
    drawn(figure, &values.map_err(Refusal::because)?)
}
