//! Laws that span crates: nothing here but the tests in `tests/`.
//!
//! - `layering`: the arrows between crates point down, and the invariants of the map hold.
//! - `conventions`: which way is up, right and near, in every renderer.
//! - `occlusion`: two spheres without and with depth (L15).
//! - `agreement`: rasterizer and ray tracer draw the same picture.

#![forbid(unsafe_code)]
