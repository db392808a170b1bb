//! How does a student's function answer questions without being trusted? In a process of its own that receives arguments and
//! gives back values; whoever asked judges them.
//!
//! - [`Value`]: what travels: numbers, vectors, matrices, lists, records; NaN and infinities as they are.
//! - [`Plain`]: a type that can be a value; [`Parameter`]: one that can be an argument, slices too.
//! - [`function!`](crate::function): makes a [`Function`] of values from a typed function.
//! - [`wire`]: questions and answers as bytes.
//! - [`serve`]: the worker's whole main function; [`system`] is what differs from system to system.

#![forbid(unsafe_code)]

mod function;
mod plain;
mod records;
mod serve;
pub mod system;
mod value;
pub mod wire;

pub use function::{Function, Mismatch, Parameter};
pub use plain::Plain;
pub use serve::{TOO_MANY_THREADS, serve};
pub use value::{Value, identical};

#[doc(hidden)]
pub use {glam, vocabulary};

#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct ReadmeExamples;
