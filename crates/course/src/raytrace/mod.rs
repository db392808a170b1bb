//! What does a ray meet, and what colour does it bring back?

mod inputs;
mod ray_triangle_system;
mod viewing_ray;

use crate::Exercise;

/// The exercises about raytrace.
pub(crate) fn exercises() -> Vec<Exercise> {
    vec![viewing_ray::exercise(), ray_triangle_system::exercise()]
}
