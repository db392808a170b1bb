//! What does a ray meet, and what colour does it bring back?

mod drawing;
mod in_shadow;
mod inputs;
mod nearest_hit;
mod ray_color;
mod ray_color_recursive;
mod ray_sphere;
mod ray_triangle;
mod ray_triangle_system;
mod refract;
mod viewing_ray;

use crate::Exercise;

/// The exercises about raytrace.
pub(crate) fn exercises() -> Vec<Exercise> {
    vec![
        viewing_ray::exercise(),
        ray_triangle_system::exercise(),
        ray_triangle::exercise(),
        ray_sphere::exercise(),
        nearest_hit::exercise(),
        in_shadow::exercise(),
        ray_color::exercise(),
        refract::exercise(),
        ray_color_recursive::exercise(),
    ]
}
