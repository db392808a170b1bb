//! Does every figure keep its promise: a drawing for every value in the declared ranges?

use std::error::Error;

use figures::{Content, Drawing, Figure, Values};
use rayon::prelude::*;
use roxmltree::{Document, Node};

/// Small, so that pictures take no time: what is tested does not depend on the size.
const SIZE: (u32, u32) = (48, 36);

#[test]
fn every_figure_draws_over_the_ranges_of_its_parameters() {
    let figures = figures::all();
    let faults: Vec<String> = figures
        .par_iter()
        .flat_map(|figure| cases(figure).into_par_iter().map(|values| (*figure, values)))
        .filter_map(|(figure, values)| {
            let fault = draw(figure, &values).err()?;
            Some(format!("{} with {}: {fault}", figure.stem(), values.summary()))
        })
        .collect();
    assert!(faults.is_empty(), "{}", faults.join("\n"));
}

/// The lecture's values, and each parameter at its ends, at night also at the quarters between, with the others as they are.
fn cases(figure: &'static Figure) -> Vec<Values> {
    let mut lecture = Values::of(figure);
    lecture.set_size(SIZE.0, SIZE.1).expect("a size for a figure");
    let shares = testkit::effort(&[0.0, 1.0][..], &[0.0, 0.25, 0.5, 0.75, 1.0]);
    let others = figure.parameters.iter().flat_map(|parameter| {
        shares.iter().map(|share| {
            let value = parameter.least + share * (parameter.greatest - parameter.least);
            let value = if parameter.whole { value.round() } else { value };
            let mut values = lecture.clone();
            values.set(parameter.name, value).expect("a value in the range");
            values
        })
    });
    std::iter::once(lecture.clone()).chain(others).collect()
}

fn draw(figure: &Figure, values: &Values) -> Result<(), Box<dyn Error + Send + Sync>> {
    let drawings = (figure.draw)(values)?;
    if drawings.is_empty() {
        return Err("no drawing".into());
    }
    drawings.iter().try_for_each(check)
}

fn check(drawing: &Drawing) -> Result<(), Box<dyn Error + Send + Sync>> {
    if drawing.alt.en.is_empty() || drawing.alt.nl.is_empty() {
        return Err("no words for those who cannot see it".into());
    }
    let Content::Diagram(svg) = &drawing.content else {
        return Ok(());
    };
    if svg.contains("NaN") || svg.contains("inf\"") || svg.contains("inf ") {
        return Err("a place that is no number".into());
    }
    let document = Document::parse(svg).map_err(|fault| fault.to_string())?;
    let root = document.root_element();
    let (width, height) = (number(root, "width")?, number(root, "height")?);
    for text in root.descendants().filter(|node| node.has_tag_name("text")) {
        let (left, right, y) = extent(text)?;
        if left < 0.0 || right > width || y < 0.0 || y > height {
            return Err(format!("\"{}\" is cut off by the edge of the sheet", words(text)).into());
        }
    }
    Ok(())
}

/// From where to where a text reaches, and the line on which it stands.
fn extent(text: Node) -> Result<(f64, f64, f64), Box<dyn Error + Send + Sync>> {
    /// The mean width of a letter in heights of a line. Fonts differ: what this finds is cut off in all of them.
    const LETTER: f64 = 0.5;
    let (x, y) = (number(text, "x")?, number(text, "y")?);
    let width = LETTER * number(text, "font-size")? * words(text).chars().count() as f64;
    let left = match text.attribute("text-anchor") {
        Some("middle") => x - 0.5 * width,
        Some("end") => x - width,
        _ => x,
    };
    Ok((left, left + width, y))
}

fn words(text: Node) -> String {
    text.descendants().filter(Node::is_text).filter_map(|node| node.text()).collect()
}

fn number(node: Node, attribute: &str) -> Result<f64, Box<dyn Error + Send + Sync>> {
    let value = node.attribute(attribute).ok_or_else(|| format!("a {attribute} is missing"))?;
    Ok(value.parse()?)
}
