//! Every figure of the lecture, as a function from parameters to pictures and diagrams.
//!
//! [`all`] lists the [`Figure`]s. A [`Handle`] is a point in a drawing that can be dragged, and [`drag()`] moves it. Everything shown
//! is computed by the concept crates. The crate `claims` tries the lecture's sentences; `album` makes one page of both.
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

pub mod drag;
pub mod figure;
pub mod handle;
pub mod on_screen;
pub mod parameter;

mod ball;
mod diagrams;
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
    figures.sort_by_key(|figure| lecture_order(figure.number()));
    figures
}

/// The figures that a number (`L31`, `E4`) or a name means; none if it means nothing.
#[must_use]
pub fn find(asked: &str) -> Vec<&'static Figure> {
    all().into_iter().filter(|figure| figure.is_called(asked)).collect()
}

/// Returns the position of an item in the lecture: 31 for `L31`. The slides' errors (`E3`) follow all items.
#[must_use]
pub fn lecture_order(number: &str) -> u32 {
    let digits = number.get(1..).and_then(|digits| digits.parse().ok()).unwrap_or(0);
    if number.starts_with('E') { 1000 + digits } else { digits }
}
