//! Builds scenes for figures and renders them.

use std::collections::BTreeMap;
use std::error::Error;
use std::path::Path;

use canvas::{Image, Rgb};
use glam::Vec3;
use lighting::{Light, Material};
use raytrace::Surface;
use scene::{Lens, Loaded, Renderer, Scene, Settings, View, builtin, prepare, render};

/// Why a picture could not be drawn.
pub(super) type Fault = Box<dyn Error + Send + Sync>;

/// Reads a constant text in the format of scene files.
pub(super) fn from_text(text: &str) -> Result<Loaded, Fault> {
    Ok(Loaded::from_toml(text, "the figure's scene", Path::new(""))?)
}

/// Checks a scene that was built in memory.
///
/// # Errors
/// What a scene file with these values would give.
pub(super) fn checked(scene: &Scene) -> Result<Loaded, Fault> {
    Ok(Loaded::from_scene(scene, Path::new(""))?)
}

/// Returns a black scene without objects, seen from `eye`; `degrees` is the vertical field of view.
pub(super) fn seen_from(eye: Vec3, target: Vec3, degrees: f32) -> Scene {
    Scene {
        camera: View { eye, target, up: Vec3::Y, lens: Lens::FieldOfView { degrees, near: None, far: None } },
        background: Rgb::ZERO,
        lights: Vec::new(),
        materials: BTreeMap::new(),
        objects: Vec::new(),
        settings: Settings::default(),
    }
}

/// Returns white ambient light of this brightness.
pub(super) fn ambient(brightness: f32) -> Light {
    Light::Ambient { color: Rgb::splat(brightness) }
}

/// Returns white light from this direction.
pub(super) fn sun(to_light: Vec3, brightness: f32) -> Light {
    Light::Directional { to_light, color: Rgb::splat(brightness) }
}

/// Returns an opaque surface; `specular` is the brightness of its highlight, 1 in the lecture.
pub(super) fn surface(diffuse: Rgb, specular: f32, exponent: f32) -> Surface {
    Surface::opaque(Material { specular: Rgb::splat(specular), ..Material::new(diffuse, exponent) })
}

/// Returns a surface without a highlight.
pub(super) fn matte(diffuse: Rgb) -> Surface {
    surface(diffuse, 0.0, Material::default().exponent)
}

/// Returns materials by name.
pub(super) fn materials<const COUNT: usize>(list: [(&str, Surface); COUNT]) -> BTreeMap<String, Surface> {
    list.into_iter().map(|(name, surface)| (name.to_owned(), surface)).collect()
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
