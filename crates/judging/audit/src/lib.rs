//! Who judges the judges? The exercises' laws on trial: right programs must be accepted, wrong ones rejected.
//!
//! - [`audit`]: puts exercises on trial, with their own solutions and misconceptions and with [`mutants`] of the slide's solution.
//! - [`Report`]: what came of it, as a table and as JSON; [`Report::met`] says whether all targets are met.
//! - [`equivalent`]: the mutants that are no less right than the original, each with the reason.

#![forbid(unsafe_code)]

pub mod equivalent;
pub mod mutants;
mod place;
mod report;
mod trials;

pub use report::{Audited, Caught, Mutants, Recognized, Report, Share, Survivor};
pub use trials::{AuditError, SEEDS, audit};
