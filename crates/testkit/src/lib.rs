//! Is it true for every input, and were the inputs interesting? Laws for property-based tests.
//!
//! - [`Law`]: a sentence, a [proptest] strategy and a check; it can demand that a given share of the inputs falls in a
//!   named class, so that no law is true for want of interesting inputs.
//! - [`strategy`]: bases, rotations, triangles, rays, directions… on asymmetric data.
//! - [`by_hand`]: inputs that a person can check with pencil and paper.
//! - [`close`](mod@close): comparisons with a bound that the caller derives.
//! - [`fingerprint`]: a number for some bytes, the same on every machine.
//! - [`effort`](fn@effort): few inputs in `cargo test`, many in the nightly script.
//! - [`damage`]: files as they should not be, and a watch over whoever reads them.
//!
//! A law in five lines:
//!
//! ```
//! use testkit::{Law, strategy};
//!
//! Law::new("reflection keeps length").demand("lit", 0.2).holds_for(
//!     (strategy::unit_vector(), strategy::unit_vector()),
//!     |(n, to_light), seen| {
//!         seen.class("lit", n.dot(to_light) > 0.0);
//!         testkit::ensure_close("|r|", lighting::reflect(n, to_light).length(), 1.0, 8.0 * f32::EPSILON)
//!     },
//! );
//! ```

#![forbid(unsafe_code)]

pub mod by_hand;
pub mod close;
pub mod damage;
mod effort;
mod fingerprint;
pub mod law;
pub mod strategy;

pub use close::{Deviation, assert_close, ensure, ensure_close};
pub use effort::{NIGHTLY, effort};
pub use fingerprint::fingerprint;
pub use law::{Classes, Law, Outcome};

#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct ReadmeExamples;
