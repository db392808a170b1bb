//! Every integration test of `geometry`, in one program: one to link instead of many.

mod dialects;
mod laws;
mod obj;
