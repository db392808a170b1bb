//! How does a scene's text become a picture of a figure?

use std::error::Error;
use std::path::Path;

use canvas::Image;
use scene::{Loaded, Renderer, Settings, builtin, prepare, render};

/// Why a picture could not be drawn.
pub(super) type Fault = Box<dyn Error + Send + Sync>;

/// The scene of a text, in the format of scene files.
pub(super) fn scene(text: &str) -> Result<Loaded, Fault> {
    Ok(Loaded::from_toml(text, "the figure's scene", Path::new(""))?)
}

/// A built-in scene.
pub(super) fn built_in(name: &str) -> Result<Loaded, Fault> {
    Ok(builtin::find(name).ok_or_else(|| format!("no built-in scene {name}"))?.load()?)
}

/// The scene's settings for a picture of this size by this renderer, with smooth edges.
pub(super) fn settings(loaded: &Loaded, renderer: Renderer, size: (u32, u32)) -> Settings {
    Settings { renderer, size, samples: 2, ..loaded.scene.settings }
}

/// The picture.
pub(super) fn shot(loaded: &Loaded, settings: &Settings) -> Result<Image, Fault> {
    Ok(render(&prepare(loaded)?, settings, &|_| ())?.image)
}

/// Each object drawn for itself, one over the other in this order, as if there were no depth.
pub(super) fn painted_over(loaded: &Loaded, order: &[usize], size: (u32, u32)) -> Result<Image, Fault> {
    /// Pixels along each side of what becomes one; averaged at the end, so that what is painted has no soft edge.
    const FINER: u32 = 2;
    let (width, height) = (FINER * size.0, FINER * size.1);
    let background = loaded.scene.background;
    let mut picture = Image::new(width, height, background);
    for &k in order {
        let mut alone = loaded.clone();
        alone.scene.objects = vec![loaded.scene.objects[k].clone()];
        let settings = Settings { samples: 1, ..settings(loaded, Renderer::ZBuffer, (width, height)) };
        let over = shot(&alone, &settings)?;
        for (pixel, above) in picture.pixels_mut().iter_mut().zip(over.pixels()) {
            if *above != background {
                *pixel = *above;
            }
        }
    }
    Ok(picture.box_downsampled(FINER))
}
