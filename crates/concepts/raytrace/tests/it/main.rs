//! Every integration test of `raytrace`, in one program: one to link instead of many.

mod fast;
mod glass;
mod laws;
mod pictures;
mod shading;
mod shadows;
mod shares;
