//! What do the slide's version and ours give on one input? A switch can show one and then the other.
//!
//! For each error of the slides without a pair of pictures, two [`Version`]s: first the slide's, then ours. What is said is
//! quoted; what it gives is computed by the code that the claim examines.

mod light;
mod places;
mod rays;
mod words;

pub(super) use light::*;
pub(super) use places::*;
pub(super) use rays::*;
pub(super) use words::*;

use super::Version;
use figures::Words;

/// One of the two.
fn version(says: impl Into<Words>, en: impl Into<String>, nl: impl Into<String>) -> Version {
    Version { says: says.into(), gives: Words::new(en, nl) }
}
