//! Every integration test of `grader`, in one program: one to link instead of many.

mod bench;
mod course;
mod hostile;
mod outcomes;
mod session;
