//! How does a drawing travel? As text that the page can show at once.

use base64::Engine as _;
use base64::engine::general_purpose::STANDARD;
use canvas::codec::{self, Format};
use canvas::Image;
use figures::{Content, Drawing};
use serde_json::{Value as Json, json};

use super::words;
use crate::Refusal;

/// Drawings with their handles.
///
/// # Errors
/// [`Refusal`] if a picture cannot be encoded.
pub(crate) fn drawings(drawings: &[Drawing]) -> Result<Vec<Json>, Refusal> {
    drawings.iter().map(drawing).collect()
}

fn drawing(drawing: &Drawing) -> Result<Json, Refusal> {
    let mut json = json!({ "name": drawing.name, "alt": words(&drawing.alt) });
    match &drawing.content {
        Content::Picture(image) => json["png"] = png(image)?.into(),
        Content::Diagram(svg) => json["svg"] = sheet::inside_a_page(svg, &drawing.alt).into(),
    }
    Ok(json)
}

/// A picture as an address that holds all of it.
///
/// # Errors
/// [`Refusal`] if it cannot be encoded.
pub(crate) fn png(image: &Image) -> Result<String, Refusal> {
    let bytes = codec::encode(image, Format::Png8).map_err(|error| Refusal(error.to_string().into()))?;
    Ok(format!("data:image/png;base64,{}", STANDARD.encode(bytes)))
}
