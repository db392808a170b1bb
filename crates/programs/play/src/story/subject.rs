//! Of what is the story told? A pixel of a picture, and all that the picture is made of.

use geometry::Ray;
use lighting::{Light, SurfacePoint};
use raytrace::{viewing_ray, visible_interval};
use scene::{Prepared, Renderer, Settings};
use sheet::Words;
use transforms::Pipeline;

use super::names::Names;
use crate::{Look, Refusal, Stage};

/// A pixel, and the scene as both loops have it.
pub(crate) struct Subject {
    pub(crate) prepared: Prepared,
    pub(crate) settings: Settings,
    pub(crate) pipeline: Pipeline,
    pub(crate) world: raytrace::World,
    pub(crate) names: Names,
    /// The pixel's column.
    pub(crate) i: u32,
    /// The pixel's row, upwards.
    pub(crate) j: u32,
}

impl Subject {
    /// Pixel (i, j) of the picture of a look.
    pub(crate) fn new(stage: &Stage, look: &Look, (i, j): (u32, u32)) -> Result<Self, Refusal> {
        let settings = look.settings(Renderer::Raytrace)?;
        if i >= look.width || j >= look.height {
            let (width, height) = (look.width, look.height);
            return Err(Refusal::new(
                format!("pixel ({i}, {j}) is outside a picture of {width} × {height} pixels"),
                format!("pixel ({i}, {j}) ligt buiten een beeld van {width} × {height} pixels"),
            ));
        }
        let prepared = stage.prepared(look)?;
        Ok(Self {
            pipeline: prepared.pipeline(look.width, look.height)?,
            world: prepared.traced_world(&settings)?,
            names: Names::of(&*stage.scene(look)?),
            prepared,
            settings,
            i,
            j,
        })
    }

    /// The viewing ray through the pixel's centre (L46).
    pub(crate) fn ray(&self) -> Ray {
        viewing_ray(&self.pipeline, self.i as f32, self.j as f32)
    }

    /// Where hits count: from the near plane to the far plane (E12).
    pub(crate) fn interval(&self) -> (f32, f32) {
        visible_interval(&self.pipeline.volume())
    }

    /// How the ray tracer makes this pixel: one ray through its centre.
    pub(crate) fn rays(&self) -> raytrace::Settings {
        raytrace::Settings {
            samples: 1,
            shadows: self.settings.shadows,
            max_depth: self.settings.max_depth,
            ..raytrace::Settings::default()
        }
    }
}

/// A point where the lighting model is evaluated, and by how much that counts.
pub(crate) type Weighted = (SurfacePoint, f32);

/// What a light is called: by its place in the scene's list, from 1, and its kind.
pub(crate) fn name_of_light(k: usize, light: &Light) -> Words {
    let (en, nl) = match light {
        Light::Ambient { .. } => ("ambient", "omgevingslicht"),
        Light::Directional { .. } => ("directional", "evenwijdig"),
        Light::Point { .. } => ("point", "puntvormig"),
    };
    let number = k + 1;
    Words::new(format!("light {number} ({en})"), format!("lichtbron {number} ({nl})"))
}
