//! What does the formula do when the light moves? A page in the browser shows it, and a server on this machine computes it.
//!
//! Nothing is computed in the page: every number and pixel comes from the concept crates. Drawn with the student's own functions, a
//! figure is asked from a process of its own, as a grader asks.
//!
//! - [`Server`]: listens on the loopback address, and answers the page and nobody else.
//! - [`Look`], [`Stage`]: what the three loops look at.
//! - [`mod@story`]: how a pixel got its colour; [`mod@steps`]: what happens one step after the other.
//! - [`StudentPictures`]: figures by the student's functions.

#![forbid(unsafe_code)]

mod api;
mod look;
mod refusal;
mod serve;
pub mod steps;
pub mod story;
mod student;

pub use api::{Latency, Measured};
pub use look::{Look, Stage};
pub use refusal::Refusal;
pub use serve::{FIRST_PORT, Server, StartError};
pub use student::StudentPictures;

#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct ReadmeExamples;
