//! In which language does a drawing speak? In the two of the lecture: a page lets the reader choose.

/// Words in the two languages of the lecture.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Text {
    /// English.
    pub en: &'static str,
    /// Dutch.
    pub nl: &'static str,
}

/// Words that are put together while drawing, numbers among them.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Words {
    /// English.
    pub en: String,
    /// Dutch.
    pub nl: String,
}

impl Words {
    /// The same thing in English and in Dutch.
    pub fn new(en: impl Into<String>, nl: impl Into<String>) -> Self {
        Self { en: en.into(), nl: nl.into() }
    }
}

impl From<Text> for Words {
    fn from(text: Text) -> Self {
        Self::new(text.en, text.nl)
    }
}

impl From<&str> for Words {
    /// A name or symbol that is the same in both languages.
    fn from(symbol: &str) -> Self {
        Self::new(symbol, symbol)
    }
}

impl From<String> for Words {
    fn from(symbol: String) -> Self {
        Self::new(symbol.clone(), symbol)
    }
}
