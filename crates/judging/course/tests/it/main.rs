//! Every integration test of `course`, in one program: one to link instead of many.

mod drawings;
mod exercises;
mod handout;
