//! What a student edits: one file an exercise, one folder a concept. README.md says how to begin.

#![forbid(unsafe_code)]
#![allow(clippy::module_inception, reason = "a concept and one of its exercises are called zbuffer")]

/// How does a point of the world find its pixel?
pub mod transforms {
    pub mod camera_frame;
    pub mod camera_from_world;
    pub mod canonical_from_camera;
    pub mod change_of_basis;
    pub mod change_of_basis_inverse;
    pub mod perspective;
    pub mod rotate_about_point;
    pub mod screen_from_canonical;
    pub mod window_from_pixel;
}

/// Which polygon does a pixel show?
pub mod zbuffer {
    pub mod barycentric;
    pub mod covers;
    pub mod depth_at;
    pub mod painters_order;
    pub mod rasterize;
    pub mod zbuffer;
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
