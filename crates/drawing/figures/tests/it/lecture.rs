//! Is nothing of the lecture missing? The lists of what it shows and claims, walked.

use std::collections::BTreeSet;

/// What the lecture shows as a picture, a diagram or a measurement.
const SHOWN: [&str; 31] = [
    "L5", "L6", "L7", "L9", "L14", "L15", "L17", "L20", "L21", "L23", "L26", "L27", "L29", "L30", "L31",
    "L33", "L36", "L37", "L38", "L39", "L41", "L45", "L46", "L48", "L54", "L56", "L58", "E4", "E9", "E16",
    "L21",
];

/// What it claims, or asks to be measured, beside its errors.
const CLAIMED: [&str; 12] =
    ["L14", "L19", "L20", "L21", "L24", "L25", "L26", "L29", "L30", "L35", "L39", "L51"];

/// Items whose figure is both a picture and a diagram, or a picture and a plot.
const SHOWN_TWICE: [&str; 5] = ["L20", "L21", "L31", "L39", "L56"];

#[test]
fn every_figure_of_the_lecture_is_drawn() {
    let missing: Vec<_> = SHOWN.into_iter().filter(|number| figures::find(number).is_empty()).collect();
    assert!(missing.is_empty(), "no figure shows {missing:?}");
    for number in SHOWN_TWICE {
        assert!(figures::find(number).len() >= 2, "{number} has a picture and a diagram or plot");
    }
}

#[test]
fn every_claim_and_every_error_is_on_trial() {
    let errors = (1..=18).map(|k| format!("E{k}"));
    let asked = errors.chain(CLAIMED.map(str::to_owned));
    let missing: Vec<_> = asked.filter(|number| figures::claims::find(number).is_empty()).collect();
    assert!(missing.is_empty(), "no claim is about {missing:?}");
    // Three advantages and three drawbacks.
    assert!(figures::claims::find("L19").len() >= 6, "the z-buffer has six of them");
}

#[test]
fn every_number_is_one_of_the_lecture() {
    let of_figures = figures::all().into_iter().flat_map(|figure| figure.numbers.iter().copied());
    let of_claims = figures::claims::all().into_iter().map(|claim| claim.number);
    for number in of_figures.chain(of_claims) {
        let (kind, digits) = number.split_at(1);
        let last = if kind == "L" { 58 } else { 18 };
        let place: u32 = digits.parse().unwrap_or_else(|_| panic!("{number}"));
        assert!((kind == "L" || kind == "E") && (1..=last).contains(&place), "{number}");
    }
}

#[test]
fn no_two_figures_or_claims_share_a_name() {
    let names: Vec<String> = figures::all().iter().map(|figure| figure.stem()).collect();
    let claims = figures::claims::all().iter().map(|claim| claim.stem()).collect::<Vec<_>>();
    let all: Vec<&String> = names.iter().chain(&claims).collect();
    assert_eq!(all.iter().collect::<BTreeSet<_>>().len(), all.len(), "{all:?}");
}

#[test]
fn both_languages_say_something() {
    for figure in figures::all() {
        let labels = figure.parameters.iter().map(|parameter| parameter.label);
        for text in labels.chain([figure.title, figure.caption]) {
            assert!(!text.en.trim().is_empty() && !text.nl.trim().is_empty(), "{}", figure.stem());
        }
        // Titles may be the same words; captions are sentences.
        assert_ne!(figure.caption.en, figure.caption.nl, "{}", figure.stem());
    }
}
