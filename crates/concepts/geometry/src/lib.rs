//! What is there to draw? The vocabulary of shapes that every other crate speaks.
//!
//! - [`Triangle`] and [`Barycentric`]: the one polygon that every renderer draws, and the coordinates inside it (L48).
//! - [`Ray`]: a half-line p(t) = e + t·d (L46).
//! - [`Mesh`]: many triangles that share their vertices; [`Aabb`]: the box around them.
//! - [`Sphere`] and [`Plane`]: the exact surfaces beside the triangles.
//! - [`shapes`]: UV sphere, icosphere, box, torus, disc and the Utah teapot, at any subdivision level.
//! - [`polygon`]: polygons of any shape, cut into triangles.
//! - [`obj`]: Wavefront OBJ and MTL text to meshes and materials.
//!
//! All coordinates are right-handed; a triangle's front is the side from which its corners run anticlockwise.
//! Nothing here knows of cameras, colors or files: text comes in, meshes go out.
//!
//! Read [`triangle`] first, then [`mesh`], then [`shapes`].

#![forbid(unsafe_code)]

pub mod aabb;
pub mod mesh;
pub mod obj;
pub mod plane;
pub mod polygon;
pub mod ray;
pub mod shapes;
pub mod sphere;
pub mod triangle;

pub use aabb::Aabb;
pub use mesh::{Indexed, Mesh, MeshError};
pub use plane::Plane;
pub use ray::Ray;
pub use sphere::Sphere;
pub use triangle::{Barycentric, Triangle};

#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct ReadmeExamples;
