//! What is there to see? Figures, claims, scenes and exercises, as their registries list them.

use claims::{self, Claim};
use figures::{Figure, Parameter};
use serde_json::{Value as Json, json};

use super::{number, text, title};
use crate::StudentPictures;

/// Everything that the page can show.
pub(crate) fn lecture(is_trusted: bool) -> Json {
    let scenes = scene::builtin::all().iter();
    json!({
        "figures": figures::all().into_iter().map(figure).collect::<Vec<_>>(),
        "claims": claims::all().into_iter().map(claim).collect::<Vec<_>>(),
        "scenes": scenes.map(|scene| json!({ "name": scene.name, "summary": scene.summary })).collect::<Vec<_>>(),
        "exercises": course::all().iter().map(exercise).collect::<Vec<_>>(),
        "token": is_trusted,
    })
}

fn figure(figure: &'static Figure) -> Json {
    json!({
        "stem": figure.stem(),
        "numbers": figure.numbers,
        "name": figure.name,
        "title": text(figure.title),
        "caption": text(figure.caption),
        "parameters": figure.parameters.iter().map(parameter).collect::<Vec<_>>(),
        "size": [figure.size.0, figure.size.1],
        "mine": StudentPictures::exercises_of(figure).iter().map(|exercise| exercise.name).collect::<Vec<_>>(),
    })
}

fn parameter(parameter: &Parameter) -> Json {
    json!({
        "name": parameter.name,
        "label": text(parameter.label),
        "default": number(parameter.default),
        "least": number(parameter.least),
        "greatest": number(parameter.greatest),
        "whole": parameter.whole,
    })
}

fn claim(claim: &'static Claim) -> Json {
    json!({
        "stem": claim.stem(),
        "number": claim.number,
        "quote": claim.quote,
        "translation": claim.translation,
        "truth": text(claim.truth),
        "code": claim.code,
        "erratum": claim.number.starts_with('E'),
    })
}

fn exercise(exercise: &course::Exercise) -> Json {
    json!({
        "name": exercise.name,
        "title": title(exercise),
        "concept": exercise.concept.name(),
        "path": exercise.path(),
    })
}
