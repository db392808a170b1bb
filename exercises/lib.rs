//! What a student edits: one file an exercise, one folder a concept. README.md says how to begin.

/// How does a point of the world find its pixel?
pub mod transforms {
    pub mod rotate_about_point;
}

/// Which polygon does a pixel show?
pub mod zbuffer {
    pub mod barycentric;
    pub mod covers;
    pub mod depth_at;
    pub mod painters_order;
    pub mod rasterize;
    pub mod z_buffer_algorithm;
}
