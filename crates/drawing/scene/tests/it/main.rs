//! Every integration test of `scene`, in one program: one to link instead of many.

mod elsewhere;
mod faults;
mod hostile;
mod laws;
mod loading;
mod planes;
mod readme;
mod views;
