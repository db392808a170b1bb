//! How do eight points take the time of one? Every step of the lighting model is done for all eight at once.
//!
//! A processor adds eight numbers as fast as one, if they stand side by side. So the coordinates of eight points are
//! kept as eight x, eight y, eight z ([`Vectors`]), and [`lit`] evaluates the model of [`crate::lit`] on such columns:
//!
//! 1. Where the slide's version decides (is the light behind the surface? is there a halfway vector?), all eight points are
//!    computed and a mask keeps those for which the answer is yes.
//! 2. The power of the highlight is exp2(p · log2(x)) by two polynomials, [`power`], because the one of the standard library
//!    takes one number at a time.
//! 3. Square roots and quotients are the exact ones; nothing is fused and nothing approximated by the processor. So the
//!    answer is the same, bit for bit, on every machine and at every width.
//!
//! The functions are generic over the instructions that are there (`S: Simd`); [`fearless_simd`] chooses them when the program
//! runs. Callers enter once for many points, by [`fearless_simd::dispatch!`].
//!
//! The answer differs from that of [`crate::lit`] by rounding only; `tests/it/fast.rs` says by how much, and why.

mod model;
mod power;
mod vectors;

pub use model::{Points, lit};
pub use power::power;
pub use vectors::{LANES, Vectors};
