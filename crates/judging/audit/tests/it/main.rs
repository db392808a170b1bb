//! Every integration test of `audit`, in one program: one to link instead of many.

mod audit;
