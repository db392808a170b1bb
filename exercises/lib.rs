//! What a student edits: one file an exercise, one folder a concept. README.md says how to begin.

/// How does a point of the world find its pixel?
pub mod transforms {
    pub mod rotate_about_point;
}

/// What does a ray meet, and what colour does it bring back?
pub mod raytrace {
    pub mod in_shadow;
    pub mod nearest_hit;
    pub mod ray_color;
    pub mod ray_color_recursive;
    pub mod ray_sphere;
    pub mod ray_triangle;
    pub mod ray_triangle_system;
    pub mod refract;
    pub mod viewing_ray;
}
