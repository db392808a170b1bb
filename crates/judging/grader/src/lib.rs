//! What is a submission worth, and what would help the one who wrote it?
//!
//! - [`Judge::judge`]: compiles one file against the [`Kit`], asks it in a process of its own, and says what came of it.
//! - [`Judge::open`]: compiles it, to be asked anything else: to draw with it, say.
//! - [`Judgement`]: the outcome, each law, the smallest counterexample, the misconception it looks like, a picture.
//! - [`Token`]: repeats a judgement to the byte.
//!
//! A student's code never runs in this process, and never judges itself: it answers questions with values, and the laws of
//! `course` judge these.

#![forbid(unsafe_code)]

mod activity;
mod compile;
mod crowd;
mod doubt;
mod forbidden;
mod judge;
mod judgement;
mod kit;
mod meter;
mod open;
mod printed;
mod process;
mod running;
mod rustc;
mod token;
mod tokens;

pub use compile::Compiler;
pub use crowd::Crowd;
pub use doubt::Twice;
pub use judge::{Judge, LONGEST_FILE, bytes_of};
pub use judgement::{Forfeit, Judgement, LooksLike, Outcome, Unreadable, gave};
pub use kit::{Build, Kit, KitError};
pub use open::{Asked, Opened};
pub use printed::{Output, Printed};
pub use process::Limits;
pub use token::{NoToken, Token, version};

#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct ReadmeExamples;
