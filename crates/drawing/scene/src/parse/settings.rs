//! How should the picture be made? The `[render]` table of a scene file.

use zbuffer::DepthFormat;

use super::value::Value;
use crate::limits::{GREATEST_DEPTH, GREATEST_SAMPLES, GREATEST_SIDE, MOST_PIXELS};
use crate::scene::Settings;
use crate::{Named, SceneError};

/// The settings of the `[render]` table; what it does not say is as in [`Settings::default`].
pub(super) fn settings(value: &Value<'_>) -> Result<Settings, SceneError> {
    let table = value.table(&[
        "renderer",
        "shading",
        "size",
        "show",
        "samples",
        "shadows",
        "max-depth",
        "highlight",
        "depth-bits",
    ])?;
    let mut settings = Settings::default();
    if let Some(value) = table.get("renderer") {
        settings.renderer = value.choice()?;
    }
    if let Some(value) = table.get("shading") {
        settings.shading = value.choice()?;
    }
    if let Some(value) = table.get("size") {
        settings.size = size(&value)?;
    }
    if let Some(value) = table.get("show") {
        settings.show = value.choice()?;
    }
    if let Some(value) = table.get("samples") {
        settings.samples = value.whole(1..=GREATEST_SAMPLES)?;
    }
    if let Some(value) = table.get("shadows") {
        settings.shadows = value.truth()?;
    }
    if let Some(value) = table.get("max-depth") {
        settings.max_depth = value.whole(0..=GREATEST_DEPTH)?;
    }
    if let Some(value) = table.get("highlight") {
        settings.highlight = value.choice()?;
    }
    if let Some(value) = table.get("depth-bits") {
        settings.depth_bits = depth_bits(&value)?;
    }
    Ok(settings)
}

fn depth_bits(value: &Value<'_>) -> Result<DepthFormat, SceneError> {
    let bits = value.whole(16..=32)?;
    let found = DepthFormat::ALL.iter().find(|(_, format)| format.bits() == bits);
    found.map(|(_, format)| *format).ok_or_else(|| value.must_be("16, 24 or 32"))
}

fn size(value: &Value<'_>) -> Result<(u32, u32), SceneError> {
    let items = value.items()?;
    let [width, height] = items.as_slice() else {
        return Err(value.must_be("width and height in pixels, [640, 480]"));
    };
    let (width, height) = (width.whole(1..=GREATEST_SIDE)?, height.whole(1..=GREATEST_SIDE)?);
    if u64::from(width) * u64::from(height) > MOST_PIXELS {
        return Err(value.must_be(format!("smaller: at most {MOST_PIXELS} pixels in all")));
    }
    Ok((width, height))
}
