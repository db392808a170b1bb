//! What a student edits: one file an exercise, one folder a concept. README.md says how to begin.

/// How does a point of the world find its pixel?
pub mod transforms {
    pub mod rotate_about_point;
}

/// How bright is a point of a surface?
pub mod lighting {
    pub mod ambient_and_diffuse;
    pub mod blinn_phong;
    pub mod halfway;
    pub mod lambert;
    pub mod light_all;
    pub mod phong_highlight;
    pub mod reflection;
}

/// How do a few normals make a smooth surface?
pub mod shading {
    pub mod face_normal;
    pub mod gouraud;
    pub mod phong_shading;
    pub mod vertex_normals;
}
