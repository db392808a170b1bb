//! Every integration test of `class`, in one program: one to link instead of many.

mod exports;
mod formats;
mod intake;
mod made_up;
mod reports;
