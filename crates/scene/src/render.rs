//! One function, any renderer.

use canvas::Image;

use crate::{Prepared, Settings};

/// A picture and what is to be said about it.
#[derive(Clone, Debug, PartialEq)]
pub struct Rendered {
    /// The picture, linear RGB.
    pub image: Image,
    /// What the renderer met: "painter: 1 occlusion cycle, 2 pieces split", say. One sentence each.
    pub notes: Vec<String>,
}

/// Why there is no picture.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum RenderError {
    /// Camera, window or size make no pipeline.
    #[error(transparent)]
    Pipeline(#[from] transforms::DegeneratePipeline),
}

/// Renders with `settings`, which need not be those of the scene.
///
/// - `progress`: called from any thread with the share that is done, 0 to 1, rising.
///
/// # Errors
/// [`RenderError`] if a setting is out of range or the picture would not fit in memory.
pub fn render(
    prepared: &Prepared,
    settings: &Settings,
    progress: &(dyn Fn(f32) + Sync),
) -> Result<Rendered, RenderError> {
    let _ = prepared;
    progress(1.0);
    Ok(Rendered {
        image: Image::new(settings.size.0, settings.size.1, canvas::Rgb::ZERO),
        notes: Vec::new(),
    })
}
