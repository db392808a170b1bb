//! Every integration test of `tests`, in one program: one to link instead of many.

mod agreement;
mod conventions;
mod layering;
mod occlusion;
