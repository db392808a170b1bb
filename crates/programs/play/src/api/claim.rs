//! Is it true? The claim stands its trial when the page asks.

use claims::{self, Version};
use serde::Deserialize;
use serde_json::{Value as Json, json};

use super::drawings::drawings;
use super::words;
use crate::Refusal;

/// A claim.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct ClaimRequest {
    claim: String,
}

/// Runs it.
///
/// # Errors
/// [`Refusal`] if there is no such claim.
pub(crate) fn run(asked: &ClaimRequest) -> Result<Json, Refusal> {
    let name = &asked.claim;
    let claim = claims::find(name).into_iter().next().ok_or_else(|| {
        Refusal::new(format!("there is no claim {name:?}"), format!("er is geen bewering {name:?}"))
    })?;
    let report = claim.run();
    let verdict = report.examination.verdict;
    let pictures = claim.pictures.map(|pictures| pictures()).transpose();
    let pictures = pictures.map_err(Refusal::because)?.unwrap_or_default();
    let version = |version: &Version| json!({ "says": words(&version.says), "gives": words(&version.gives) });
    let [slide, right] = claim.versions.map_or([Json::Null, Json::Null], |run| run().each_ref().map(version));
    Ok(json!({
        "verdict": words(&verdict.in_words()),
        "class": verdict.class(),
        "expected": report.is_as_expected(),
        "evidence": report.examination.evidence.iter().map(ToString::to_string).collect::<Vec<_>>(),
        "drawings": drawings(&pictures)?,
        "slide": slide,
        "right": right,
    }))
}
