//! How does each figure of the lecture come about, and is each sentence of it true?
//!
//! [`Figure`]s are functions from parameters to pictures and diagrams; [`all`] lists them. What has a place in a drawing is a
//! [`Handle`], and [`drag()`] moves it. [`claims`] puts the lecture's sentences on trial. [`page`] makes one HTML page of both.
//! Everything shown is computed by the concept crates.
//!
//! ```
//! let figure = figures::find("L54")[0];
//! let values = figures::Values::of(figure);
//! let drawings = (figure.draw)(&values)?;
//! assert_eq!(drawings[0].file_name(&figure.stem()), "L54-worked-example.svg");
//! # Ok::<(), Box<dyn std::error::Error + Send + Sync>>(())
//! ```

#![forbid(unsafe_code)]

#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct ReadmeExamples;

pub mod claims;
pub mod drag;
pub mod figure;
pub mod handle;
pub mod page;
pub mod parameter;

mod ball;
mod diagrams;
mod on_screen;
mod pictures;
mod plots;

pub use drag::{DragError, drag};
pub use figure::{Content, Drawing, Drawn, Figure, Text, Words};
pub use handle::{Handle, Handled, Handles};
pub use parameter::{Parameter, ParameterError, Values};
pub use pictures::depth_grids::{GRID, polygons_of_the_grids};

/// Every figure, in the order of the lecture.
#[must_use]
pub fn all() -> Vec<&'static Figure> {
    let mut figures: Vec<&'static Figure> =
        pictures::ALL.iter().chain(diagrams::ALL).chain(plots::ALL).copied().collect();
    // Stable: figures of one item stay in the order of the lists, pictures first.
    figures.sort_by_key(|figure| item(figure.number()));
    figures
}

/// The figures that a number (`L31`, `E4`) or a name means; none if it means nothing.
#[must_use]
pub fn find(asked: &str) -> Vec<&'static Figure> {
    all().into_iter().filter(|figure| figure.is_called(asked)).collect()
}

/// The place of `L31` in the lecture: 31. Errors come last.
fn item(number: &str) -> u32 {
    let digits = number.get(1..).and_then(|digits| digits.parse().ok()).unwrap_or(0);
    if number.starts_with('E') { 1000 + digits } else { digits }
}
