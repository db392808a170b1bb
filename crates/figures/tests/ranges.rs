//! Can every figure be drawn within the whole range of each of its parameters?

use figures::{Content, Drawing, Figure, Values};

fn drawn(figure: &Figure, values: &Values) -> Vec<Drawing> {
    let drawings = (figure.draw)(values);
    drawings.unwrap_or_else(|error| panic!("{} with {}: {error}", figure.stem(), values.summary()))
}

fn check(figure: &Figure, values: &Values) {
    let drawings = drawn(figure, values);
    assert!(!drawings.is_empty(), "{}", figure.stem());
    for drawing in drawings {
        let name = drawing.file_name(&figure.stem());
        match drawing.content {
            Content::Picture(image) => {
                let is_light = |color: &canvas::Rgb| color.is_finite() && color.min_element() >= 0.0;
                assert!(image.pixels().iter().all(is_light), "{name} with {}", values.summary());
            }
            Content::Diagram(svg) => {
                let read = roxmltree::Document::parse(&svg);
                let document =
                    read.unwrap_or_else(|error| panic!("{name} with {}: {error}", values.summary()));
                let root = document.root_element();
                assert_eq!(root.attribute("role"), Some("img"));
                for word in ["NaN", "inf"] {
                    assert!(!svg.contains(word), "{name} with {} has {word}", values.summary());
                }
            }
        }
    }
}

#[test]
fn every_figure_is_drawn_at_both_ends_of_each_parameter() {
    for figure in figures::all() {
        let mut usual = Values::of(figure);
        usual.set_size(48, 36).unwrap();
        check(figure, &usual);
        for parameter in figure.parameters {
            // The finest meshes take minutes without optimization and say nothing new.
            let greatest = if parameter.name == "subdivision" {
                parameter.greatest.min(4.0)
            } else {
                parameter.greatest
            };
            for end in [parameter.least, greatest] {
                let mut values = usual.clone();
                values.set(parameter.name, end).unwrap();
                check(figure, &values);
            }
        }
    }
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
