//! How bright is a point of a surface?

mod ambient_and_diffuse;
mod blinn_phong;
mod drawing;
mod halfway;
mod lambert;
mod light_all;
mod phong_highlight;
mod reflection;

use crate::Exercise;

/// The exercises about lighting.
pub(crate) fn exercises() -> Vec<Exercise> {
    vec![
        lambert::exercise(),
        ambient_and_diffuse::exercise(),
        reflection::exercise(),
        phong_highlight::exercise(),
        halfway::exercise(),
        blinn_phong::exercise(),
        light_all::exercise(),
    ]
}
