//! Does every parameter of a figure matter, and the size?

use figures::{Content, Drawing, Figure, Values};

fn drawn(figure: &Figure, values: &Values) -> Vec<Drawing> {
    let drawings = (figure.draw)(values);
    drawings.unwrap_or_else(|error| panic!("{} with {}: {error}", figure.stem(), values.summary()))
}

#[test]
fn every_parameter_changes_something() {
    let differ = |a: &[Drawing], b: &[Drawing]| {
        a.len() != b.len() || a.iter().zip(b).any(|(a, b)| a.content != b.content)
    };
    for figure in figures::all() {
        let mut usual = Values::of(figure);
        usual.set_size(48, 36).unwrap();
        let before = drawn(figure, &usual);
        for parameter in figure.parameters {
            let ends = [
                parameter.least,
                parameter.greatest.min(parameter.least + 4.0).max(0.5 * parameter.greatest),
            ];
            let changes = ends.into_iter().any(|end| {
                let mut values = usual.clone();
                let end = if parameter.whole { end.round() } else { end };
                values.set(parameter.name, end).is_ok() && differ(&before, &drawn(figure, &values))
            });
            assert!(changes, "{} does not depend on {}", figure.stem(), parameter.name);
        }
    }
}

#[test]
fn every_picture_has_the_size_that_is_asked_for() {
    let mut pictures = 0;
    for figure in figures::all() {
        let mut values = Values::of(figure);
        values.set_size(50, 34).unwrap();
        for drawing in drawn(figure, &values) {
            if let Content::Picture(image) = drawing.content {
                assert_eq!((image.width(), image.height()), (50, 34), "{} {}", figure.stem(), drawing.name);
                pictures += 1;
            }
        }
    }
    assert!(pictures > 30, "{pictures} pictures");
}
