//! One HTML page of all figures and claims, which needs no other file and no network.
//!
//! Pictures are inside the page; diagrams are part of it and take its colors, light or dark. The page speaks English or Dutch; its
//! arrow keys step from figure to figure in full screen.

#![forbid(unsafe_code)]

#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct ReadmeExamples;

mod shown;

pub use shown::{Entry, Medium, Shown, Trial};

use base64::Engine;
use base64::engine::general_purpose::STANDARD;
use maud::{DOCTYPE, Markup, PreEscaped, html};
use sheet::STYLE;

use figures::{Text, Words};

/// Nothing from elsewhere, not even by mistake.
const POLICY: &str =
    "default-src 'none'; img-src data:; style-src 'unsafe-inline'; script-src 'unsafe-inline'";

/// The page of these figures and claims, in the order given.
#[must_use]
pub fn html(figures: &[Entry], claims: &[Trial]) -> String {
    let page = html! {
        (DOCTYPE)
        html lang="en" {
            head {
                meta charset="utf-8";
                meta name="viewport" content="width=device-width, initial-scale=1";
                meta http-equiv="Content-Security-Policy" content=(POLICY);
                title { "lightlab: lighting and ray tracing" }
                // An empty picture, so that the browser does not ask for one.
                link rel="icon" href="data:,";
                style { (PreEscaped(include_str!("page.css"))) (PreEscaped(STYLE)) }
            }
            body {
                a.skip href="#content" { (both(&SKIP.into())) }
                (navigation(figures, claims))
                header {
                    h1 { (both(&TITLE.into())) }
                    p { (both(&ABOUT.into())) }
                }
                main #content {
                    @for entry in figures { (figure(entry)) }
                    @if !claims.is_empty() {
                        h2 #claims { (both(&CLAIMS.into())) }
                        @for trial in claims { (claim(trial)) }
                    }
                }
                // For those without keys, on a phone say.
                div.steps {
                    button #before type="button" aria-label="back" { "‹" }
                    button #after type="button" aria-label="on" { "›" }
                    button #leave type="button" aria-label="leave full screen" { "×" }
                }
                p.skip #spoken role="status" aria-live="polite" {}
                script { (PreEscaped(include_str!("page.js"))) }
            }
        }
    };
    page.into_string()
}

const TITLE: Text = Text { en: "Lighting and ray tracing", nl: "Belichting en raytracing" };
const ABOUT: Text = Text {
    en: "Every figure of the lecture, computed; every claim, put on trial. Press f for full screen and step with the arrow keys.",
    nl: "Elke figuur van het college, berekend; elke bewering, op de proef gesteld. Druk op f voor volledig scherm en blader met de pijltjes.",
};
const SKIP: Text = Text { en: "Skip to the figures", nl: "Direct naar de figuren" };
const CLAIMS: Text = Text { en: "Claims on trial", nl: "Beweringen op de proef gesteld" };
const PRESENT: Text = Text { en: "Full screen", nl: "Volledig scherm" };

fn navigation(figures: &[Entry], claims: &[Trial]) -> Markup {
    html! {
        nav aria-label="Figures and claims" {
            div {
                ul {
                    @for entry in figures {
                        li { a href={ "#" (entry.stem) } title=(entry.title.en) { (entry.numbers[0]) } }
                    }
                    @if !claims.is_empty() {
                        li { a href="#claims" { (both(&CLAIMS.into())) } }
                    }
                }
                button #present type="button" { (both(&PRESENT.into())) }
                button #language type="button" { "Nederlands" }
            }
        }
    }
}

fn figure(entry: &Entry) -> Markup {
    html! {
        article id=(entry.stem) {
            h3 {
                span.number { (entry.numbers[0]) }
                span { (both(&entry.title)) }
                @if entry.numbers.len() > 1 { span.also { (entry.numbers[1..].join(" · ")) } }
            }
            (drawings(&entry.drawings))
            p.caption { (both(&entry.caption)) }
            p.values { (entry.values) }
        }
    }
}

fn claim(trial: &Trial) -> Markup {
    html! {
        article.claim id=(trial.stem) {
            h3 {
                span.number { (trial.number) }
                span class={ "verdict " (trial.verdict.class()) } { (both(&trial.verdict.in_words())) }
                @if !trial.is_as_expected {
                    span.unexpected { (both(&UNEXPECTED.into())) }
                }
            }
            p.quote lang="nl" { "„" (trial.quote) "”" }
            p.translation lang="en" { "“" (trial.translation) "”" }
            p.truth { (both(&trial.truth)) }
            (drawings(&trial.drawings))
            ul lang="en" { @for line in &trial.evidence { li { (line) } } }
            p { @for name in &trial.code { code { (name) } " " } }
        }
    }
}

const UNEXPECTED: Text = Text { en: "not the recorded verdict", nl: "niet het vastgelegde oordeel" };

fn drawings(drawings: &[Shown]) -> Markup {
    // In full screen: one row of up to four, else two rows.
    let columns = if drawings.len() > 4 { drawings.len().div_ceil(2) } else { drawings.len() };
    let class = match drawings.len() {
        0 | 1 => "drawings one",
        2..=4 => "drawings",
        _ => "drawings many",
    };
    html! {
        @if !drawings.is_empty() {
            div class=(class) style={ "--columns:" (columns) } {
                @for shown in drawings {
                    figure.drawing {
                        (medium(shown))
                        @if !shown.name.is_empty() { figcaption lang="en" { (shown.name.replace('-', " ")) } }
                    }
                }
            }
        }
    }
}

fn medium(shown: &Shown) -> Markup {
    match &shown.medium {
        Medium::Png(bytes) => html! {
            img alt=(shown.alt.en) data-en=(shown.alt.en) data-nl=(shown.alt.nl) loading="lazy" decoding="async"
                src={ "data:image/png;base64," (STANDARD.encode(bytes)) };
        },
        Medium::Svg(text) => PreEscaped(sheet::inside_a_page(text, &shown.alt)),
    }
}

/// Both languages; the style sheet shows one.
fn both(words: &Words) -> Markup {
    html! {
        @if words.en == words.nl { (words.en) } @else {
            span.en lang="en" { (words.en) } span.nl lang="nl" { (words.nl) }
        }
    }
}
