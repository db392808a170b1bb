//! Is every figure of the lecture drawn, in both languages?

/// What the lecture shows as a picture, a diagram or a measurement.
const SHOWN: [&str; 31] = [
    "L5", "L6", "L7", "L9", "L14", "L15", "L17", "L20", "L21", "L23", "L26", "L27", "L29", "L30", "L31",
    "L33", "L36", "L37", "L38", "L39", "L41", "L45", "L46", "L48", "L54", "L56", "L58", "E4", "E9", "E16",
    "L21",
];

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
