//! What is a submission worth, and what would help the one who wrote it?
//!
//! - [`Judge::judge`]: compiles one file against the [`Libraries`], asks it in a process of its own, and says what came of it.
//! - [`Judge::open`]: compiles it, to be asked anything else: to draw with it, say.
//! - [`Judgement`]: the outcome, each law, the smallest counterexample, the misconception it looks like, a picture.
//! - [`Token`]: repeats a judgement to the byte.
//!
//! A student's code never runs in this process, and never judges itself: it answers questions with values, and the laws of
//! `course` judge these.

#![forbid(unsafe_code)]

mod activity;
mod batch;
mod captured_output;
mod compile;
mod consistency;
mod forbidden;
mod judge;
mod judgement;
mod libraries;
mod meter;
mod process;
mod running;
mod rustc;
mod session;
mod token;
mod tokens;

pub use batch::Batch;
pub use captured_output::{CapturedOutput, Output};
pub use compile::Compiler;
pub use consistency::InconsistentCall;
pub use judge::{Judge, LONGEST_FILE, bytes_of};
pub use judgement::{Forfeit, Judgement, LooksLike, Outcome, Unreadable, gave};
pub use libraries::{Build, Libraries, LibrariesError};
pub use process::Limits;
pub use session::{CompiledFunction, Session};
pub use token::{NoToken, Token, version};

#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct ReadmeExamples;
