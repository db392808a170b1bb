//! How did this pixel get its colour? Told for the z-buffer and for the ray tracer, side by side.
//!
//! - [`story`]: both loops at one pixel, and why they differ where they do.
//! - `zbuffer`: the loop over triangles that asks whether each holds the pixel (L16); `rays`: the loop that asks whether
//!   the pixel's ray hits each (L43).
//! - `terms`: the lighting equation, term by term; `light`: shadow rays, mirrors and glass.
//! - `why`: reasons for a difference. `outside`: the ray and its hits, seen from the side.
//!
//! The loops are the slides'; the pictures come from the fast ones. Tests hold one to the other, bit by bit.

pub(crate) mod json;
mod light;
pub(crate) mod names;
mod outside;
mod rays;
pub(crate) mod subject;
mod terms;
mod why;
mod zbuffer;

use serde_json::{Map, Value as Json, json};

use crate::{Look, Refusal, Stage};
use subject::Subject;

/// The story of pixel (i, j), j upwards.
///
/// # Errors
/// [`Refusal`] if the look is none, or the pixel is outside the picture.
pub fn story(stage: &Stage, look: &Look, pixel: (u32, u32)) -> Result<Json, Refusal> {
    let subject = Subject::new(stage, look, pixel)?;
    let rasterized = zbuffer::looped(&subject);
    let cast = rays::cast(&subject);
    let light = light::on_hit(&subject, &cast);
    let (agree, why) = why::compared(&subject, &rasterized, &cast, &light);
    let mut raytrace: Map<String, Json> =
        cast.told(&subject).into_iter().map(|(key, value)| (key.to_owned(), value)).collect();
    raytrace.insert("color".to_owned(), json::bytes(light.color));
    raytrace.insert("linear".to_owned(), json::vector(light.color));
    raytrace.insert("shading".to_owned(), light.shading(&subject, &cast));
    raytrace.insert("shadows".to_owned(), light.told(&subject));
    Ok(json!({
        "pixel": [subject.i, subject.j],
        "zbuffer": rasterized.told(&subject),
        "raytrace": raytrace,
        "agree": agree,
        "why": why.iter().map(json::words).collect::<Vec<_>>(),
        "outside": outside::seen(&subject, &cast, &light)?,
    }))
}
