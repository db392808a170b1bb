//! How does a point of the world find its pixel? Through a chain of matrices, one a stage.
//!
//! ```text
//!   world ──R·T──▶ camera ──P,C,S──▶ clip ──÷w──▶ canonical ──V──▶ screen
//! ```
//!
//! - [`affine2`]: translation, scale, rotation in the plane, and rotation about a point (L10).
//! - [`basis`]: orthonormal bases and the change between two of them (L6, L11, L12).
//! - [`camera`]: where the eye is and how it looks (L1, L6).
//! - [`volume`]: what the eye sees (L7).
//! - [`projection`]: perspective and orthographic matrices (L2, L3).
//! - [`viewport`]: pixels (L4, L8, L9).
//! - [`pipeline`]: all of it in order, every stage open to inspection (L5).
//! - [`opengl`]: the same in OpenGL's conventions.
//!
//! Conventions, the lecture's: right-handed axes; column vectors, p' = M·p; the camera looks along −w; near and far are
//! the *negative* w-coordinates of their planes, 0 > n > f; canonical z is +1 at the near plane and −1 at the far one, so
//! **larger z is nearer**. Angles are radians.
//!
//! A matrix is named target_from_source, so that neighbours cancel:
//! `screen_from_canonical * canonical_from_camera * camera_from_world`.

#![forbid(unsafe_code)]

pub mod affine2;
pub mod basis;
pub mod camera;
pub mod opengl;
pub mod pipeline;
pub mod projection;
pub mod viewport;
pub mod volume;

pub use basis::{Basis, DegenerateBasis, change_of_basis, change_of_basis_inverse};
pub use camera::{Camera, DegenerateCamera};
pub use pipeline::{DegeneratePipeline, Factor, Pipeline, Traced};
pub use projection::canonical_from_camera;
pub use volume::{DegenerateVolume, ViewVolume};

#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct ReadmeExamples;
