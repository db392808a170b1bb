//! What does the formula do when the light moves? A page in the browser shows it, and a server on this machine computes it.
//!
//! Nothing is computed in the page: every number and pixel comes from the concept crates.

#![forbid(unsafe_code)]

mod look;
mod mine;
mod refusal;
pub mod steps;
pub mod story;

pub use look::{Look, Stage};
pub use mine::Mine;
pub use refusal::Refusal;
