//! Every integration test of `lighting`, in one program: one to link instead of many.

mod exponents;
mod fast;
mod laws;
