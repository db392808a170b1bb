//! How do numbers look on a page? A histogram as a drawing, shares as bars. Every number is there to be read or heard as well.

use maud::{Markup, html};

/// So many bars of equal width from 0 to 100 %.
const BINS: usize = 20;
const WIDTH: f64 = 760.0;
const HEIGHT: f64 = 256.0;
/// Room for the numbers at the axes.
const LEFT: f64 = 34.0;
const RIGHT: f64 = 26.0;
const BOTTOM: f64 = 30.0;
/// The word beside the line of the mean stands above the highest number.
const TOP: f64 = 34.0;

/// How many submissions have which share of the points. The last bar has its upper end, all points, in it.
pub(crate) fn histogram(shares: &[f64], mean: Option<f64>) -> Markup {
    let mut bins = [0_usize; BINS];
    for share in shares {
        bins[((share * BINS as f64) as usize).min(BINS - 1)] += 1;
    }
    let most = bins.iter().copied().max().unwrap_or(0).max(1);
    let x = |share: f64| LEFT + share * (WIDTH - LEFT - RIGHT);
    let y = |count: f64| HEIGHT - BOTTOM - count / most as f64 * (HEIGHT - BOTTOM - TOP);
    html! {
        svg.histogram viewBox={ "0 0 " (WIDTH) " " (HEIGHT) } role="img" aria-label=(in_words(&bins)) {
            @for line in grid(most) {
                line.grid x1=(LEFT) x2=(WIDTH - RIGHT) y1=(short(y(line as f64))) y2=(short(y(line as f64))) {}
                text.end x=(LEFT - 6.0) y=(short(y(line as f64) + 4.0)) { (line) }
            }
            @for (at, count) in bins.iter().enumerate().filter(|(_, count)| **count > 0) {
                @let (left, right) = (x(at as f64 / BINS as f64), x((at + 1) as f64 / BINS as f64));
                rect.column x=(short(left + 1.0)) width=(short(right - left - 2.0)) y=(short(y(*count as f64)))
                    height=(short(y(0.0) - y(*count as f64))) {}
            }
            @if let Some(mean) = mean {
                line.mean x1=(short(x(mean))) x2=(short(x(mean))) y1="4" y2=(short(y(0.0))) {}
                // On the side with more room.
                text class=(if mean > 0.5 { "end" } else { "start" })
                    x=(short(x(mean) + if mean > 0.5 { -5.0 } else { 5.0 })) y="12" { "mean" }
            }
            // Over the line, so that it strikes no number through.
            @for (at, count) in bins.iter().enumerate().filter(|(_, count)| **count > 0) {
                text.middle x=(short(x((at as f64 + 0.5) / BINS as f64))) y=(short(y(*count as f64) - 4.0)) { (count) }
            }
            line.axis x1=(LEFT) x2=(WIDTH - RIGHT) y1=(short(y(0.0))) y2=(short(y(0.0))) {}
            @for tenth in 0..=10 {
                text.middle x=(short(x(f64::from(tenth) / 10.0))) y=(HEIGHT - 10.0) { (10 * tenth) @if tenth == 10 { " %" } }
            }
        }
    }
}

/// Three or four round counts up to the highest.
fn grid(most: usize) -> Vec<usize> {
    let step = [1, 2, 5, 10, 20, 50, 100, 200, 500, 1000].into_iter().find(|step| most <= 4 * step);
    let step = step.unwrap_or(most);
    (0..=most).step_by(step).skip(1).collect()
}

fn in_words(bins: &[usize]) -> String {
    let width = 100 / BINS;
    let said: Vec<String> = bins
        .iter()
        .enumerate()
        .filter(|(_, count)| **count > 0)
        .map(|(at, count)| format!("{} to {} percent: {count}", at * width, (at + 1) * width))
        .collect();
    format!("Submissions by share of the points. {}.", said.join(", "))
}

/// A share as a bar, with its number; `None` is a dash.
pub(crate) fn share(share: Option<f64>) -> Markup {
    html! {
        @if let Some(share) = share {
            span.meter aria-hidden="true" { span style={ "width:" (short(100.0 * share)) "%" } {} }
            span.number { (percent(share)) }
        } @else { "–" }
    }
}

/// "71 %". Only all is 100 %, and only nothing 0 %.
pub(crate) fn percent(share: f64) -> String {
    let rounded = (100.0 * share).round();
    let shown = if share < 1.0 && rounded >= 100.0 {
        99.0
    } else if share > 0.0 && rounded <= 0.0 {
        1.0
    } else {
        rounded
    };
    format!("{shown} %")
}

/// Tenths of a pixel are enough.
fn short(x: f64) -> String {
    let text = format!("{x:.1}");
    text.strip_suffix(".0").unwrap_or(&text).to_owned()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_submission_is_in_one_bar_and_all_points_in_the_last() {
        let html = histogram(&[0.0, 0.049, 0.05, 0.5, 1.0, 0.97], Some(0.5)).into_string();
        assert!(
            html.contains(
                "0 to 5 percent: 2, 5 to 10 percent: 1, 50 to 55 percent: 1, 95 to 100 percent: 2."
            ),
            "{html}"
        );
    }

    #[test]
    fn only_all_is_a_hundred_percent() {
        assert_eq!([1.0, 0.999, 0.5, 0.001, 0.0].map(percent), ["100 %", "99 %", "50 %", "1 %", "0 %"]);
    }
}
