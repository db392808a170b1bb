//! Every integration test of `album`, in one program: one to link instead of many.

mod page;
