//! Every integration test of `class`, in one program: one to link instead of many.

mod exports;
mod formats;
mod ids;
mod intake;
mod made_up;
mod oddities;
mod reports;
