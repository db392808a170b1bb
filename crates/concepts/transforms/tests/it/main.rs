//! Every integration test of `transforms`, in one program: one to link instead of many.

mod laws;
