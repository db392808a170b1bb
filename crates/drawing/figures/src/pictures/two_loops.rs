//! Do object order and image order draw the same picture? (L21)

use scene::{Renderer, Settings};

use super::studio::{built_in, settings, shot};
use crate::figure::{Drawing, Drawn, Figure, Text, Words};
use crate::handle::without_handles;
use crate::parameter::Values;

/// Colours that differ by less look the same: a step of an 8-bit file.
const STEP: f32 = 1.0 / 255.0;

pub(super) static FIGURE: Figure = Figure {
    numbers: &["L21", "L55"],
    name: "two-loops",
    title: Text { en: "z-buffer versus ray tracing", nl: "z-buffer versus ray tracing" },
    caption: Text {
        en: "One scene by two loops: for each object its pixels (z-buffer), for each pixel the objects (ray tracing). The third picture shows where they differ: black is nowhere. What is left are pixels whose centre lies on an edge, where the two round differently.",
        nl: "Eén scène door twee lussen: voor elk object zijn pixels (z-buffer), voor elke pixel de objecten (ray tracing). Het derde plaatje toont waar ze verschillen: zwart is nergens. Wat overblijft zijn pixels waarvan het midden op een rand ligt, waar de twee verschillend afronden.",
    },
    parameters: &[],
    size: (400, 300),
    draw,
    handles: without_handles,
};

fn draw(values: &Values) -> Drawn {
    let loaded = built_in("teapot")?;
    let by = |renderer| {
        let settings = Settings { samples: 1, shadows: false, ..settings(&loaded, renderer, values.size()) };
        shot(&loaded, &settings)
    };
    let (z_buffer, traced) = (by(Renderer::ZBuffer)?, by(Renderer::Raytrace)?);
    let difference = canvas::difference(&z_buffer, &traced, STEP)?;
    let (count, all) = (difference.over_threshold, z_buffer.pixels().len());
    let alt = Words::new(
        format!("Where the two differ: {count} of {all} pixels by more than one step of an 8-bit file."),
        format!(
            "Waar de twee verschillen: {count} van {all} pixels meer dan één stap van een 8-bits bestand."
        ),
    );
    let teapot = |loop_en, loop_nl| {
        Words::new(format!("The teapot, drawn {loop_en}."), format!("De theepot, getekend {loop_nl}."))
    };
    Ok(vec![
        Drawing::picture(
            "object-order",
            teapot("object by object with a z-buffer", "object voor object met een z-buffer"),
            z_buffer,
        ),
        Drawing::picture(
            "image-order",
            teapot("pixel by pixel with rays", "pixel voor pixel met stralen"),
            traced,
        ),
        Drawing::picture("difference", alt, difference.heat_map()),
    ])
}
