//! How are results shown to people? A page for the lecturer, feedback for each student, a table of points.
//!
//! Each is a function of the results alone, without clock or environment, so the same results give the same bytes. Student names, printed
//! output, compiler messages and panics may hold any characters: [`foreign`] makes them harmless, and each format escapes what is
//! special in it.
//!
//! - [`class_page`]: what a lecturer wants to know of the whole class; the only page with what is for the staff alone.
//! - [`feedback_page`], [`feedback_markdown`]: what one student gets back.
//! - [`grades_csv`]: points for a spreadsheet.

pub(crate) mod account;
mod charts;
mod class_page;
mod csv;
mod feedback;
pub mod foreign;
mod groups;
pub(crate) mod markdown;
mod statistics;
mod submissions;

pub use class_page::class_page;
pub use csv::grades_csv;
pub use feedback::feedback_page;
pub use markdown::feedback_markdown;

use maud::{DOCTYPE, Markup, PreEscaped, html};

use crate::results::{Kind, LawResult, Outcome};

/// Looks that all pages share.
const BASE: &str = include_str!("base.css");

/// What tells outcomes apart where there is room for one letter.
fn mark(outcome: Outcome) -> &'static str {
    match outcome.kind() {
        Kind::Right => "✓",
        Kind::Wrong => "✗",
        Kind::Absent => "·",
        _ => "!",
    }
}

fn law_mark(result: &LawResult) -> &'static str {
    match result {
        LawResult::Kept(_) => "✓",
        LawResult::Failed(_) => "✗",
        LawResult::NotRun => "–",
    }
}

/// The colours of an outcome, as classes.
fn tone(outcome: Outcome) -> &'static str {
    match outcome.kind() {
        Kind::Right => "good",
        Kind::Absent => "soft",
        Kind::Wrong => "bad",
        _ => "worse",
    }
}

/// A sentence of the course, in which names stand between backticks.
fn prose(text: &str) -> Markup {
    let text = foreign::plain(text);
    // Without a partner a backtick is a backtick.
    let whole = text.matches('`').count().is_multiple_of(2);
    html! {
        @if whole {
            @for (at, part) in text.split('`').enumerate() { @if at % 2 == 1 { code { (part) } } @else { (part) } }
        } @else { (text) }
    }
}

/// A page that asks nothing of any network, and runs `script` alone, which is told by its `fingerprint`.
fn page(title: &str, style: &str, (script, fingerprint): (&str, &str), body: &Markup) -> String {
    let scripts = if script.is_empty() { String::new() } else { format!("; script-src '{fingerprint}'") };
    let policy = format!("default-src 'none'; style-src 'unsafe-inline'; img-src data:{scripts}");
    let page = html! {
        (DOCTYPE)
        html lang="en" {
            head {
                meta charset="utf-8";
                meta name="viewport" content="width=device-width, initial-scale=1";
                meta name="color-scheme" content="light dark";
                meta name="referrer" content="no-referrer";
                meta http-equiv="Content-Security-Policy" content=(policy);
                title { (title) }
                // An empty picture, so that the browser does not ask for one.
                link rel="icon" href="data:,";
                style { (PreEscaped(BASE)) (PreEscaped(style)) }
            }
            body {
                (body)
                @if !script.is_empty() { script { (PreEscaped(script)) } }
            }
        }
    };
    page.into_string()
}
