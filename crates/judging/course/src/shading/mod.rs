//! How do a few normals make a smooth surface?

mod drawing;
mod face_normal;
mod gouraud;
mod inputs;
mod phong_shading;
mod vertex_normals;

use crate::Exercise;

/// The exercises about shading.
pub(crate) fn exercises() -> Vec<Exercise> {
    vec![face_normal::exercise(), vertex_normals::exercise(), gouraud::exercise(), phong_shading::exercise()]
}
