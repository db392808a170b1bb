//! What if something cannot be done? It is said in both languages, and the page lives on.

use sheet::Words;

/// Why a request is not answered with what it asked for.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("{}", .0.en)]
pub struct Refusal(pub Words);

impl Refusal {
    /// The same reason in English and in Dutch.
    pub fn new(en: impl Into<String>, nl: impl Into<String>) -> Self {
        Self(Words::new(en, nl))
    }

    /// The reason that an error of ours gives, in English only.
    pub(crate) fn because(error: impl std::fmt::Display) -> Self {
        Self(error.to_string().into())
    }
}

impl From<scene::RenderError> for Refusal {
    fn from(error: scene::RenderError) -> Self {
        Self::because(error)
    }
}
