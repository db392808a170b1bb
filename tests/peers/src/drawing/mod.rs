//! The same scene drawn by everybody who draws object by object: ours, euc, retrofire.

pub(crate) mod agreement;
mod cases;
mod euc;
mod retrofire;

pub(crate) use cases::{HEIGHT, WIDTH, run};
use shading::Shading;
use transforms::Pipeline;

use crate::scenes::Scene;

/// Somebody with a scene prepared and buffers at hand.
pub(crate) trait Draws {
    /// The name in the table.
    fn name(&self) -> &'static str;

    /// One frame: buffers cleared, back faces culled, everything drawn. This is what is measured.
    fn draw(&mut self);

    /// What the last frame shows.
    fn picture(&self) -> Picture;
}

/// A frame in words that everybody understands.
pub(crate) struct Picture {
    /// n_x.
    pub(crate) width: usize,
    /// Rows from the top down; `None` where nothing was drawn.
    pub(crate) pixels: Vec<Option<Seen>>,
}

/// What a pixel shows.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Seen {
    /// Linear, 0 to 1.
    pub(crate) color: [f32; 3],
    /// Along the gaze, from the eye.
    pub(crate) distance: f32,
}

/// All peers that draw, each with the scene in its own form.
fn peers(scene: &Scene, view: &Pipeline, shading: Shading) -> Vec<Box<dyn Draws>> {
    vec![euc::prepare(scene, view, shading), retrofire::prepare(scene, view, shading)]
}
