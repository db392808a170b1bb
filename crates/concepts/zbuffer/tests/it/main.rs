//! Every integration test of `zbuffer`, in one program: one to link instead of many.

mod laws;
mod painter_laws;
