//! Which figures are made of pixels? Those that a renderer draws.

mod apple;
mod coarse_spheres;
mod components;
mod cornell_box;
mod cycle;
pub(crate) mod depth_grids;
mod exponent_strip;
mod first_attempt;
mod flat_and_gouraud;
mod mirrors_and_glass;
mod shadow_puzzles;
mod shadows;
mod stages;
mod studio;
mod two_loops;
mod two_spheres;
mod z_fighting;

use crate::figure::Figure;

/// In the order of the lecture.
pub(crate) static ALL: &[&Figure] = &[
    &stages::FIGURE,
    &cycle::FIGURE,
    &two_spheres::FIGURE,
    &depth_grids::FIGURE,
    &z_fighting::FIGURE,
    &two_loops::FIGURE,
    &cornell_box::FIGURE,
    &apple::FIGURE,
    &first_attempt::FIGURE,
    &exponent_strip::FIGURE,
    &components::FIGURE,
    &flat_and_gouraud::FIGURE,
    &coarse_spheres::FIGURE,
    &shadow_puzzles::FIGURE,
    &shadows::FIGURE,
    &mirrors_and_glass::FIGURE,
];
