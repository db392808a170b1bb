//! What happens one step after the other?

use serde::Deserialize;
use serde_json::Value as Json;

use crate::{Refusal, Stage};

/// What is stepped through.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields, tag = "kind", rename_all = "kebab-case")]
pub enum Asked {
    /// The depth grids.
    Depth {},
}

/// The steps.
///
/// # Errors
/// [`Refusal`].
pub fn steps(_stage: &Stage, _asked: &Asked) -> Result<Json, Refusal> {
    Ok(Json::Null)
}
