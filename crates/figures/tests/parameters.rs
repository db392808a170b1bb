//! Does every parameter of a figure matter?

use figures::{Drawing, Figure, Values};

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
