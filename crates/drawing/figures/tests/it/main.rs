//! Every integration test of `figures`, in one program: one to link instead of many.

mod claims;
mod drag;
mod lecture;
mod page;
mod parameters;
mod ranges;
