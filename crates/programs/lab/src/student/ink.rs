//! Are there colours, and which? Where there are none, words and marks say the same.

use std::sync::OnceLock;

use console::Style;

/// Whether standard output shows colours: a terminal, and nobody has said no (`NO_COLOR`, `TERM=dumb`).
pub(crate) fn on() -> bool {
    static ON: OnceLock<bool> = OnceLock::new();
    *ON.get_or_init(|| {
        let unwanted = std::env::var_os("NO_COLOR").is_some_and(|value| !value.is_empty());
        !unwanted && console::colors_enabled()
    })
}

fn with(style: &Style, text: &str) -> String {
    if on() { style.apply_to(text).force_styling(true).to_string() } else { text.to_owned() }
}

/// What is right.
pub(crate) fn good(text: &str) -> String {
    with(&Style::new().green(), text)
}

/// What is not right.
pub(crate) fn bad(text: &str) -> String {
    with(&Style::new().red().bold(), text)
}

/// What to look at.
pub(crate) fn strong(text: &str) -> String {
    with(&Style::new().bold(), text)
}

/// What is there, but not the point.
pub(crate) fn faint(text: &str) -> String {
    with(&Style::new().dim(), text)
}

/// What to type.
pub(crate) fn typed(text: &str) -> String {
    with(&Style::new().cyan(), text)
}
