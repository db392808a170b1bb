//! Every integration test of `play`, in one program: one to link instead of many.

mod mine;
mod server;
mod steps;
mod story;
