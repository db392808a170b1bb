//! How do numbers and formulas stand on a sheet? With a minus sign that is one, and with letters lowered and raised.

use glam::Vec3;
use maud::{Markup, html};

/// A number with so many decimals: `−0.50`. A zero has no sign.
pub fn decimal(x: impl Into<f64>, decimals: usize) -> String {
    let text = format!("{:.decimals$}", x.into());
    match text.strip_prefix('-') {
        Some(digits) if digits.bytes().any(|digit| (b'1'..=b'9').contains(&digit)) => format!("−{digits}"),
        Some(zero) => zero.to_owned(),
        None => text,
    }
}

/// A point or vector with two decimals: `(0.50, −1.00, 2.25)`.
pub fn triple(p: Vec3) -> String {
    format!("({}, {}, {})", decimal(p.x, 2), decimal(p.y, 2), decimal(p.z, 2))
}

/// An angle in degrees with one decimal: `22.5°`.
pub fn degrees(radians: f32) -> String {
    format!("{}°", decimal(radians.to_degrees(), 1))
}

/// `u_s` with a lowered s, `x^p` with a raised p: small letters up or down by a part of the letters' height.
pub(crate) fn raised_and_lowered(words: &str, height: f32) -> Markup {
    let (mut parts, mut rest, mut shift) = (Vec::new(), words, 0.0);
    while let Some(mark) = rest.find(['_', '^']) {
        let (before, after) = rest.split_at(mark);
        let end = after[1..].find(|c: char| !c.is_alphanumeric()).map_or(after.len(), |end| end + 1);
        parts.push((before, -shift, false));
        shift = if after.starts_with('_') { 0.24 } else { -0.38 };
        parts.push((&after[1..end], shift, true));
        rest = &after[end..];
    }
    parts.push((rest, -shift, false));
    html! {
        @for (text, shift, is_small) in parts {
            @if is_small {
                tspan dy=(format!("{:.1}", shift * height)) font-size=(format!("{:.1}", 0.72 * height)) { (text) }
            } @else if shift != 0.0 && !text.is_empty() {
                tspan dy=(format!("{:.1}", shift * height)) { (text) }
            } @else {
                (text)
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_minus_is_a_minus_and_zero_has_none() {
        assert_eq!(decimal(-0.127, 2), "−0.13");
        assert_eq!(decimal(-0.001, 2), "0.00");
        assert_eq!(decimal(7.0_f32, 0), "7");
    }

    #[test]
    fn what_follows_a_mark_is_small_and_the_rest_returns_to_the_line() {
        let text = raised_and_lowered("u_s = x^2.", 10.0).into_string();
        let lowered = "<tspan dy=\"2.4\" font-size=\"7.2\">s</tspan><tspan dy=\"-2.4\"> = x</tspan>";
        let raised = "<tspan dy=\"-3.8\" font-size=\"7.2\">2</tspan><tspan dy=\"3.8\">.</tspan>";
        assert_eq!(text, format!("u{lowered}{raised}"));
        assert_eq!(raised_and_lowered("a & b", 10.0).into_string(), "a &amp; b");
    }
}
