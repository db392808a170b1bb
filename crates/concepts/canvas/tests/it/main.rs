//! Every integration test of `canvas`, in one program: one to link instead of many.

mod damaged_files;
mod files;
mod laws;
