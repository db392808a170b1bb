//! What does the viewing ray look like from the side? The scene from elsewhere, with eye, window, ray and hits drawn in.

mod overlay;
mod place;

use scene::{Renderer, Settings, Show, render};
use serde_json::{Value as Json, json};
use sheet::Words;

use super::json::words;
use super::light::OnHit;
use super::rays::Cast;
use super::subject::Subject;
use crate::Refusal;
use crate::api::drawings::png;

/// The size of the picture under the lines.
const SIZE: (u32, u32) = (720, 450);

/// The drawing, and what it says to somebody who cannot see it.
pub(super) fn seen(subject: &Subject, cast: &Cast, light: &OnHit) -> Result<Json, Refusal> {
    let view = place::view(subject, cast, light)?;
    let elsewhere = subject.prepared.seen_by(&view)?;
    let settings = Settings {
        renderer: Renderer::ZBuffer,
        size: SIZE,
        samples: 1,
        show: Show::Color,
        ..subject.settings
    };
    let picture = png(&render(&elsewhere, &settings, &|_| ())?.image)?;
    let pipeline = elsewhere.pipeline(SIZE.0, SIZE.1)?;
    let alt = alt(cast, light);
    let svg = overlay::drawn(subject, cast, light, &pipeline, &picture).svg(&alt);
    Ok(json!({ "svg": sheet::inside_a_page(&svg, &alt), "alt": words(&alt) }))
}

fn alt(cast: &Cast, light: &OnHit) -> Words {
    let met = match &cast.hit {
        Some(hit) => Words::new(
            format!("it meets a surface at t = {:.3}", hit.t),
            format!("die treft een oppervlak bij t = {:.3}", hit.t),
        ),
        None => Words::new("it meets nothing", "die treft niets"),
    };
    let (free, stopped): (Vec<_>, Vec<_>) = light.shadows.iter().partition(|shadow| shadow.is_lit());
    let (free, stopped) = (free.len(), stopped.len());
    Words::new(
        format!(
            "The scene from the side: a ray from the eye through the window; {}. Shadow rays: {free} reach their light, {stopped} are stopped.",
            met.en
        ),
        format!(
            "De scène van opzij: een straal uit het oog door het venster; {}. Schaduwstralen: {free} bereiken hun lichtbron, {stopped} worden tegengehouden.",
            met.nl
        ),
    )
}
