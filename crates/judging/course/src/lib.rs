//! What is asked of a student, what does any right answer satisfy, and what do people get wrong? One file an exercise.
//!
//! - [`all`] and [`find`]: the exercises, in the order in which they are best done.
//! - [`Exercise`]: the task, hints, worked examples, laws, solutions, misconceptions.
//! - [`Law`]: a sentence, inputs, and a check that asks the student's function as often as it needs.
//! - [`trial::examine`]: puts a function on trial; [`diagnosis::diagnose`]: which misconception it looks like.
//!
//! Nothing here runs a student's code: an [`Answerer`] does, in a process of its own (or a plain function, for our own solutions).

#![forbid(unsafe_code)]

mod answerer;
mod concept;
pub mod diagnosis;
mod exercise;
mod law;
mod panels;
mod source;
mod stage;
pub mod trial;

mod lighting;
mod raytrace;
mod shading;
mod transforms;
mod zbuffer;

use std::sync::LazyLock;

pub use answerer::{Answerer, Fault, InProcess, Late, Loss, Reply, values};
pub use concept::Concept;
pub use exercise::{Calls, Example, Exercise, Misconception, Picture, Program, Seen, Signature, Title};
pub use law::{Asker, Broken, Law, Stop, Unbound, close, that};
pub use testkit::fingerprint;
pub use worker::{Plain, Value};

/// The exercises, in the order in which they are best done; made once.
pub fn all() -> &'static [Exercise] {
    static ALL: LazyLock<Vec<Exercise>> = LazyLock::new(|| {
        [
            transforms::exercises(),
            zbuffer::exercises(),
            lighting::exercises(),
            shading::exercises(),
            raytrace::exercises(),
        ]
        .into_iter()
        .flatten()
        .collect()
    });
    &ALL
}

/// The exercise of this name.
pub fn find(name: &str) -> Option<&'static Exercise> {
    all().iter().find(|exercise| exercise.name == name)
}

#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct ReadmeExamples;
