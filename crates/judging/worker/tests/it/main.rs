//! Every integration test of `worker`, in one program: one to link instead of many.

mod values;
