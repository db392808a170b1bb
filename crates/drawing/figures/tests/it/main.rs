//! Every integration test of `figures`, in one program: one to link instead of many.

mod drag;
mod lecture;
mod parameters;
mod ranges;
