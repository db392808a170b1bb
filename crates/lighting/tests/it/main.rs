//! Every integration test of `lighting`, in one program: one to link instead of many.

mod fast;
mod laws;
