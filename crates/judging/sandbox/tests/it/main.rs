//! Every integration test of `sandbox`, in one program: one to link instead of many.

mod confined;
mod doctor;
