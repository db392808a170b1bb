//! How does a scene become a picture? One function, any renderer.

use canvas::Image;
use raytrace::{Interpolation, Search};
use shading::{Frame, Shading, Visibility};
use transforms::Pipeline;
use zbuffer::DepthFormat;
use zbuffer::clip::GREATEST_SIDE as GREATEST_SCREEN;

use crate::limits::{
    GREATEST_DEPTH, GREATEST_SAMPLES, GREATEST_SIDE, MOST_PAINTED, MOST_PIXELS, MOST_SAMPLES,
};
use crate::show::{self, Loop, Seen};
use crate::{Prepared, RenderError, Renderer, Settings, Show};

/// A picture and what is to be said about it.
#[derive(Clone, Debug, PartialEq)]
pub struct Rendered {
    /// The picture, linear RGB. Where it shows numbers ([`Show`]), they are decoded, so that a PNG file has them in it.
    pub image: Image,
    /// What the renderer met: "painter: 1 occlusion cycle, 2 cuts", say. One sentence each.
    pub notes: Vec<String>,
}

/// Renders with `settings`, which need not be those of the scene.
///
/// All renderers show the same surfaces in the same pixels (L21); what only the ray tracer does, shadows, mirrors and glass,
/// is said in the notes of the others. Rasterizers take n × n samples by drawing a picture n times as large and averaging,
/// so their samples lie where the ray tracer's do. Pictures of numbers ([`Show`]) take one sample, for a mean of depths or
/// normals of different surfaces is the depth or normal of none.
///
/// - `progress`: called from any thread with the share that is done, 0 to 1. The last call is with 1.
///
/// # Errors
/// [`RenderError`] if a setting is out of range or the picture would not fit in memory.
///
/// ```
/// use scene::{Settings, Show, builtin, prepare, render};
///
/// let loaded = builtin::find("two-spheres").unwrap().load()?;
/// let settings = Settings { size: (48, 36), show: Show::Depth, ..loaded.scene.settings };
/// let rendered = render(&prepare(&loaded)?, &settings, &|_| ())?;
/// assert_eq!((rendered.image.width(), rendered.image.height()), (48, 36));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn render(
    prepared: &Prepared,
    settings: &Settings,
    progress: &(dyn Fn(f32) + Sync),
) -> Result<Rendered, RenderError> {
    render_by(Version::Fast, prepared, settings, progress)
}

/// The picture of [`render`] by the slides' own loops: all triangles for each ray (L43), and a colour for each fragment that is
/// nearer than those before it (L16). It takes many times as long and differs by rounding only.
///
/// The painter's algorithm has one version; its picture is the same.
///
/// # Errors
/// As [`render`].
pub fn render_slide(
    prepared: &Prepared,
    settings: &Settings,
    progress: &(dyn Fn(f32) + Sync),
) -> Result<Rendered, RenderError> {
    render_by(Version::Slide, prepared, settings, progress)
}

/// Which loops draw.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Version {
    Fast,
    Slide,
}

fn render_by(
    version: Version,
    prepared: &Prepared,
    settings: &Settings,
    progress: &(dyn Fn(f32) + Sync),
) -> Result<Rendered, RenderError> {
    settings.check()?;
    let (width, height) = settings.size;
    let mut notes = Vec::new();
    let mut is_empty = false;
    let image = match (settings.renderer, settings.show) {
        (Renderer::Raytrace, Show::Color) => {
            trace(version, prepared, settings, &prepared.pipeline(width, height)?, progress)?
        }
        (Renderer::Raytrace, _) => {
            let pipeline = prepared.pipeline(width, height)?;
            let world = prepared.traced_world(settings)?;
            let visible = if version == Version::Slide { raytrace::visible_brute } else { raytrace::visible };
            let hits = visible(&world, &pipeline);
            let seen =
                |hit: &Option<raytrace::Hit>| hit.as_ref().map(|hit| Seen::hit(&world, &pipeline, hit));
            let seen: Vec<Option<Seen>> = hits.iter().map(seen).collect();
            is_empty = seen.iter().all(Option::is_none);
            show::picture(settings.show, (width, height), &seen, Loop::Pixels, &mut notes)
        }
        (_, Show::Color) => {
            let n = settings.samples;
            let pipeline = prepared.pipeline(width * n, height * n)?;
            let image = colors(version, prepared, settings, &pipeline, &mut notes)?;
            if n == 1 { image } else { image.box_downsampled(n) }
        }
        (_, _) => {
            let pipeline = prepared.pipeline(width, height)?;
            let frame = rasterized(version, prepared, settings, &pipeline, &mut notes)?;
            let seen = Seen::all(&frame);
            is_empty = seen.iter().all(Option::is_none);
            show::picture(settings.show, (width, height), &seen, Loop::Objects, &mut notes)
        }
    };
    notes.extend(prepared.cut_from(width, height).map(|distance| near_note(settings.renderer, distance)));
    let has_one_color = image.pixels().iter().all(|pixel| *pixel == prepared.background);
    if settings.show == Show::Color && has_one_color {
        is_empty = covers_nothing(version, prepared, settings)?;
        if !is_empty {
            notes.push(format!(
                "{}: objects are in view, but all have the color of the background; is there a light?",
                settings.renderer
            ));
        }
    }
    if is_empty {
        notes.push(format!(
            "{}: every pixel is background; is anything in front of the camera, and has it an area?",
            settings.renderer
        ));
    }
    progress(1.0);
    Ok(Rendered { image, notes })
}

/// Whether no sample of the picture shows any object. Drawn again for that, since a color does not tell it.
fn covers_nothing(version: Version, prepared: &Prepared, settings: &Settings) -> Result<bool, RenderError> {
    let ((width, height), n) = (settings.size, settings.samples);
    if settings.renderer == Renderer::Raytrace {
        let world = prepared.traced_world(settings)?;
        return Ok(!raytrace::covers_anything(&world, &prepared.pipeline(width, height)?, n));
    }
    let pipeline = prepared.pipeline(width * n, height * n)?;
    let frame = rasterized(version, prepared, settings, &pipeline, &mut Vec::new())?;
    Ok(frame.visible.iter().all(Option::is_none))
}

impl Settings {
    /// Refuses what is out of range or does not fit in memory.
    fn check(&self) -> Result<(), RenderError> {
        let (width, height) = self.size;
        for (name, value, least, greatest) in [
            ("the width", width, 1, GREATEST_SIDE),
            ("the height", height, 1, GREATEST_SIDE),
            ("the number of samples", self.samples, 1, GREATEST_SAMPLES),
            ("the depth of recursion", self.max_depth, 0, GREATEST_DEPTH),
        ] {
            if !(least..=greatest).contains(&value) {
                return Err(RenderError::Setting { name, value, least, greatest });
            }
        }
        // The ray tracer adds a pixel's samples up one by one; a rasterizer keeps them all.
        let keeps_samples = self.renderer != Renderer::Raytrace && self.show == Show::Color;
        let kept = if keeps_samples { self.samples } else { 1 };
        let pixels = u64::from(width) * u64::from(height);
        let samples = pixels * u64::from(kept) * u64::from(kept);
        let too_many = |most| RenderError::TooManyPixels { width, height, samples: kept, most };
        if pixels > MOST_PIXELS {
            return Err(too_many(MOST_PIXELS));
        }
        if self.renderer != Renderer::Raytrace && samples > MOST_SAMPLES {
            return Err(too_many(MOST_SAMPLES));
        }
        if self.renderer != Renderer::Raytrace && width.max(height) * kept > GREATEST_SCREEN {
            return Err(too_many(MOST_SAMPLES));
        }
        Ok(())
    }
}

/// The picture in image order.
fn trace(
    version: Version,
    prepared: &Prepared,
    settings: &Settings,
    pipeline: &Pipeline,
    progress: &(dyn Fn(f32) + Sync),
) -> Result<Image, RenderError> {
    let world = prepared.traced_world(settings)?;
    let rays = raytrace::Settings {
        samples: settings.samples,
        shadows: settings.shadows,
        max_depth: settings.max_depth,
        search: if version == Version::Slide { Search::BruteForce } else { Search::Hierarchy },
    };
    let rows = pipeline.height() as f32;
    Ok(raytrace::render(&world, pipeline, &rays, &|done| progress(done as f32 / rows)))
}

impl Prepared {
    /// The scene as the ray tracer wants it. Hierarchies are built the first time, and shared.
    ///
    /// # Errors
    /// [`RenderError`] if an object's matrix cannot be inverted.
    pub fn traced_world(&self, settings: &Settings) -> Result<raytrace::World, RenderError> {
        let mut objects = Vec::new();
        for part in self.parts.iter() {
            for world_from_object in &part.world_from_object {
                let object =
                    raytrace::Object::new(part.traced_shape(), *world_from_object, part.surfaces.clone())?;
                objects.push(object);
            }
        }
        let mut world = raytrace::World::new(objects, self.lights.clone());
        world.background = self.background;
        world.highlight = settings.highlight;
        world.interpolation = match settings.shading {
            Shading::Flat => Interpolation::Flat,
            Shading::Gouraud => Interpolation::Gouraud,
            Shading::Phong => Interpolation::Phong,
        };
        Ok(world)
    }

    /// Looks at the scene as rasterizers want it: objects in the order in which they are drawn.
    pub fn in_world<T>(&self, settings: &Settings, look: impl FnOnce(&shading::World) -> T) -> T {
        let mut objects = Vec::new();
        for part in self.parts.iter() {
            objects.extend(part.world_from_object.iter().map(|world_from_object| shading::Object {
                mesh: &part.mesh,
                world_from_object: *world_from_object,
                materials: &part.materials,
            }));
        }
        look(&shading::World {
            objects: &objects,
            lights: &self.lights,
            background: self.background,
            highlight: settings.highlight,
        })
    }
}

/// The colours in object order.
fn colors(
    version: Version,
    prepared: &Prepared,
    settings: &Settings,
    pipeline: &Pipeline,
    notes: &mut Vec<String>,
) -> Result<Image, RenderError> {
    // The fast version knows one depth format.
    let is_fast = (version, settings.renderer, settings.depth_bits)
        == (Version::Fast, Renderer::ZBuffer, DepthFormat::F32);
    if !is_fast {
        return Ok(rasterized(version, prepared, settings, pipeline, notes)?.image);
    }
    notes.extend(optics_note(prepared, settings));
    Ok(prepared.in_world(settings, |world| shading::fast::render(world, pipeline, settings.shading)))
}

/// The frame in object order.
fn rasterized(
    version: Version,
    prepared: &Prepared,
    settings: &Settings,
    pipeline: &Pipeline,
    notes: &mut Vec<String>,
) -> Result<Frame, RenderError> {
    let visibility = if settings.renderer == Renderer::Painter {
        let triangles = prepared.triangle_count();
        if triangles > MOST_PAINTED {
            return Err(RenderError::TooManyToPaint { triangles });
        }
        Visibility::Painter
    } else {
        Visibility::ZBuffer(settings.depth_bits)
    };
    let frame = prepared.in_world(settings, |world| match (version, visibility) {
        (Version::Slide, Visibility::ZBuffer(format)) => {
            shading::render_plain(world, pipeline, settings.shading, format)
        }
        _ => shading::render(world, pipeline, settings.shading, visibility),
    });
    if frame.painter.as_ref().is_some_and(|report| report.gave_up) {
        return Err(RenderError::TooEntangled);
    }
    notes.extend(frame.painter.as_ref().and_then(painters_note));
    notes.extend(optics_note(prepared, settings));
    Ok(frame)
}

/// Says what a fitted near plane cuts off.
fn near_note(renderer: Renderer, distance: f32) -> String {
    format!(
        "{renderer}: something comes within {distance:.1e} of the eye and is cut off there, since near and far are fitted to all objects; \
         give the camera `near` and `far` to see it"
    )
}

/// What a rasterizer leaves out, if anything.
fn optics_note(prepared: &Prepared, settings: &Settings) -> Option<String> {
    let leaves_out = prepared.has_optics() && settings.show == Show::Color;
    leaves_out.then(|| {
        format!(
            "{}: mirrors and glass have only their own colour here; the ray tracer follows the light",
            settings.renderer
        )
    })
}

/// What stood in the painter's way, if anything did.
fn painters_note(report: &shading::PainterReport) -> Option<String> {
    let cycles = report.cycles.len();
    let first = report.cycles.first()?;
    let names: Vec<String> = first
        .iter()
        .take(4)
        .map(|(object, triangle)| format!("triangle {triangle} of object {object}"))
        .collect();
    let more = if first.len() > names.len() { ", …" } else { "" };
    let plural = |count: usize| if count == 1 { "" } else { "s" };
    Some(format!(
        "painter: {cycles} occlusion cycle{} ({}{more}), broken by {} cut{}",
        plural(cycles),
        names.join(", "),
        report.splits,
        plural(report.splits)
    ))
}
