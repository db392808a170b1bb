//! How are two hundred submissions graded with one command, and what is said about them?
//!
//! - [`intake`]: who handed in what.
//! - [`results`]: what is known of a class once it has been graded; every report is made from it.

#![forbid(unsafe_code)]

pub mod intake;
pub mod results;
mod sum;
