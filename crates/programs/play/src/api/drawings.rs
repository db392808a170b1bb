//! How does a drawing travel? As text that the page can show at once.

use base64::Engine as _;
use base64::engine::general_purpose::STANDARD;
use canvas::Image;
use canvas::codec::{self, Format};
use figures::{Content, Drawing, Handle};
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
    let handles: Vec<Json> = drawing.handles.iter().map(handle).collect();
    let mut json = json!({ "name": drawing.name, "alt": words(&drawing.alt), "handles": handles });
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
    let bytes = codec::encode(image, Format::Png8).map_err(Refusal::because)?;
    Ok(format!("data:image/png;base64,{}", STANDARD.encode(bytes)))
}

fn handle(handle: &Handle) -> Json {
    json!({ "name": words(&handle.name), "moves": handle.moves, "x": handle.at.x, "y": handle.at.y })
}
