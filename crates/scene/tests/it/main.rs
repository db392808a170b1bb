//! Every integration test of `scene`, in one program: one to link instead of many.

mod faults;
mod hostile;
mod laws;
mod loading;
mod readme;
mod views;
