//! Where a ray first meets a sphere (L43, L47).
//!
//! A point p(t) = e + t d is on the sphere if it is r away from the centre c:
//!
//!     (e + t d − c)·(e + t d − c) = r²
//!
//! That is a quadratic equation in t. Give its smallest solution t > 0, or `None` if there is none.
//!
//! - `ray`: origin e and direction d, not zero, of any length: t counts steps of d. `sphere`: centre and radius. One space.
//! - From inside the sphere the ray meets it on its way out.
//! - Rays that only touch and origins on the surface do not occur.
//!
//! glam: `dot`, `length_squared`.

use vocabulary::{Ray, Sphere};

pub fn ray_sphere(ray: Ray, sphere: Sphere) -> Option<f32> {
    todo!()
}
