//! Every integration test of `geometry`, in one program: one to link instead of many.

mod laws;
mod obj;
