//! What does a renderer need? Meshes instead of names, matrices instead of lists.

mod planes;
mod prepared_object;
mod smoothing;

use std::sync::Arc;

use glam::{DVec2, Vec3};
use lighting::{Light, Rgb};
use raytrace::Optics;
use transforms::{Camera, Pipeline, ViewVolume};

use crate::limits::MOST_TRIANGLES;
use crate::scene::{Lens, Scene, View};
use crate::{Loaded, RenderError};
use planes::{Planes, Sight};
pub(crate) use prepared_object::{PreparedObject, fitted};

/// A scene made ready: meshes built and shared, normals there, lights normalized. Renders any number of times.
#[derive(Clone, Debug)]
pub struct Prepared {
    /// Shared by all views of the scene.
    pub(crate) parts: Arc<Vec<PreparedObject>>,
    pub(crate) lights: Vec<Light>,
    pub(crate) background: Rgb,
    warnings: Vec<String>,
    camera: Camera,
    lens: Lens,
    /// The size for which the camera was described; a picture of another shape sees more.
    size: (u32, u32),
}

/// Makes a scene ready.
///
/// # Errors
/// [`RenderError`] if the scene was changed after loading to something that [`Scene::from_toml`] would refuse or that
/// names a file that was not loaded, if there are too many triangles, or if the transforms carry an object away.
pub fn prepare(loaded: &Loaded) -> Result<Prepared, RenderError> {
    // The fields of a scene are public. One place knows what is allowed in it: the reader.
    let scene = Scene::from_toml(&loaded.scene.to_toml(), "the scene in memory")?;
    let mut budget = MOST_TRIANGLES;
    let (mut parts, mut warnings) = (Vec::new(), Vec::new());
    for (k, object) in scene.objects.iter().enumerate() {
        let part = PreparedObject::new(object, &scene, &loaded.imports)?;
        let triangles = (part.mesh.len() * part.world_from_object.len()) as u64;
        budget = budget.checked_sub(triangles).ok_or(RenderError::TooManyTriangles { object: k })?;
        part.check_place(k)?;
        warnings.extend(part.distance_warning(k));
        parts.push(part);
    }
    let view = scene.camera;
    let camera = Camera::look_at(view.eye, view.target, view.up)?;
    Ok(Prepared {
        parts: Arc::new(parts),
        lights: scene.lights.iter().map(normalized).collect(),
        background: scene.background,
        warnings,
        camera,
        lens: view.lens,
        size: scene.settings.size,
    })
}

impl Prepared {
    /// The same scene from another place, or through another lens. Meshes and hierarchies are shared, so it costs next to nothing.
    ///
    /// # Errors
    /// [`RenderError`] if the camera has no direction or its gaze is along `up`.
    pub fn seen_by(&self, view: &View) -> Result<Self, RenderError> {
        let camera = Camera::look_at(view.eye, view.target, view.up)?;
        Ok(Self { camera, lens: view.lens, ..self.clone() })
    }

    /// What can be drawn but not well: objects so far from the origin that f32 rounds their shape visibly. One sentence each.
    #[must_use]
    pub fn warnings(&self) -> &[String] {
        &self.warnings
    }

    /// What shines on the scene, world space.
    #[must_use]
    pub fn lights(&self) -> &[Light] {
        &self.lights
    }

    /// The camera with its viewing volume, for a picture of `width` × `height` pixels.
    ///
    /// A picture of another shape than the scene's holds all that the scene's does, and more: a wider one at its sides, a
    /// narrower one above and below.
    ///
    /// # Errors
    /// [`RenderError`] if there is no pixel, or if the planes are so far apart that the matrices overflow.
    pub fn pipeline(&self, width: u32, height: u32) -> Result<Pipeline, RenderError> {
        let aspect = width as f32 / height.max(1) as f32;
        let (wider, higher) = self.wider_and_higher(aspect);
        let volume = match self.lens {
            Lens::FieldOfView { degrees, near, far } => {
                let Planes { near, far, .. } = self.planes(aspect, degrees, (near, far));
                let half = 0.5 * degrees.to_radians();
                ViewVolume::from_fov_y(2.0 * (higher * half.tan()).atan(), aspect, near, far)?
            }
            Lens::Window(window) => {
                let x = 0.5 * (window.left + window.right);
                let y = 0.5 * (window.bottom + window.top);
                ViewVolume {
                    left: x + wider * (window.left - x),
                    right: x + wider * (window.right - x),
                    bottom: y + higher * (window.bottom - y),
                    top: y + higher * (window.top - y),
                    ..window
                }
            }
        };
        Ok(Pipeline::new(self.camera, volume, width, height)?)
    }

    /// How many triangles a rasterizer has to draw, every copy counted.
    #[must_use]
    pub fn triangle_count(&self) -> usize {
        self.parts.iter().map(|part| part.mesh.len() * part.world_from_object.len()).sum()
    }

    /// Whether there is a mirror or glass.
    pub(crate) fn has_optics(&self) -> bool {
        self.parts.iter().flat_map(|part| &part.surfaces).any(|surface| surface.optics != Optics::Opaque)
    }

    /// How near the eye something visible is that no renderer shows, since the near plane was fitted and lies behind it.
    pub(crate) fn cut_from(&self, width: u32, height: u32) -> Option<f32> {
        let aspect = width as f32 / height.max(1) as f32;
        match self.lens {
            Lens::FieldOfView { degrees, near, far } => self.planes(aspect, degrees, (near, far)).cut_from,
            Lens::Window(_) => None,
        }
    }

    /// How much wider and how much higher the window of a picture of this shape is than the scene's.
    fn wider_and_higher(&self, aspect: f32) -> (f32, f32) {
        let scenes_aspect = self.size.0 as f32 / self.size.1 as f32;
        ((aspect / scenes_aspect).max(1.0), (scenes_aspect / aspect).max(1.0))
    }

    /// Near and far plane of a picture of this shape, as given or fitted.
    fn planes(&self, aspect: f32, degrees: f32, given: (Option<f32>, Option<f32>)) -> Planes {
        let (_, higher) = self.wider_and_higher(aspect);
        let slope = higher * (0.5 * degrees.to_radians()).tan();
        let slopes = DVec2::new((aspect * slope).into(), slope.into());
        Sight { camera: &self.camera, parts: &self.parts, slopes }.planes(given)
    }
}

fn normalized(light: &Light) -> Light {
    match *light {
        Light::Directional { to_light, color } => {
            Light::Directional { to_light: to_light.normalize_or(Vec3::Y), color }
        }
        other => other,
    }
}
