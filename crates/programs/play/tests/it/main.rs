//! Every integration test of `play`, in one program: one to link instead of many.

mod server;
mod steps;
mod story;
mod student;
