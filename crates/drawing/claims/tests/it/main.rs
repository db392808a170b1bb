//! Every integration test of `claims`, in one program: one to link instead of many.

mod claims;
mod lecture;
