//! What does a scene file say? Its text becomes a [`Scene`], or an error at its line and column.
//!
//! [`Scene::from_toml`] tells the story; the README of this crate describes the format with an example.

use std::collections::BTreeMap;
use std::ops::Range;

use lighting::{Light, Material, Rgb};
use raytrace::{Optics, Surface};
use toml::de::DeTable;
use transforms::{Camera, DegenerateBasis, DegenerateCamera, DegenerateVolume, ViewVolume};
use zbuffer::DepthFormat;

use crate::limits::{
    GREATEST_DEPTH, GREATEST_EXPONENT, GREATEST_REFRACTIVE_INDEX, GREATEST_SAMPLES, GREATEST_SIDE,
    MOST_PIXELS,
};
use crate::parse_object::{Budget, object};
use crate::scene::{Lens, Scene, Settings, View};
use crate::value::{Source, Table, Value, plain};
use crate::{Named, SceneError};

/// The tallest light or background: brighter than that, `f32` could overflow in a sum of products.
const BRIGHTEST: f32 = 1e6;

/// A scene and where in its text the OBJ files are named, so that a missing one can be shown there.
#[derive(Debug)]
pub(crate) struct Parsed {
    pub(crate) scene: Scene,
    /// Path as written, and its place.
    pub(crate) obj_paths: Vec<(String, Range<usize>)>,
}

impl Scene {
    /// The scene that the text of a scene file describes. OBJ files are not opened: [`crate::load()`] does that.
    ///
    /// - `file`: the name of the text in messages, usually its path.
    ///
    /// # Errors
    /// [`SceneError`] at line and column: text that is no TOML, unknown or missing keys, values of the wrong type or out
    /// of range, a camera without a frame, names that nothing bears.
    ///
    /// ```
    /// use scene::Scene;
    /// let error = Scene::from_toml("[camera]\neye = [1, 2, 8]\ntaget = [0, 0, 3]\n", "pot.toml").unwrap_err();
    /// assert_eq!((error.line, error.column), (Some(3), Some(1)));
    /// assert_eq!(error.to_string(), "pot.toml:3:1: unknown key `camera.taget`\n  did you mean `target`?");
    /// ```
    pub fn from_toml(text: &str, file: &str) -> Result<Self, SceneError> {
        parse(text, file).map(|parsed| parsed.scene)
    }
}

/// [`Scene::from_toml`], with the places of the OBJ paths.
pub(crate) fn parse(text: &str, file: &str) -> Result<Parsed, SceneError> {
    let source = Source { file, text };
    let root = DeTable::parse(text).map_err(|error| {
        let problem = error
            .message()
            .lines()
            .next()
            .unwrap_or("this is no TOML")
            .to_owned();
        source.fault(
            &error.span().unwrap_or(0..0),
            problem,
            "a scene file is TOML: `key = value` lines under [table] lines",
        )
    })?;
    let root = Table::root(
        source,
        &root,
        &["camera", "background", "light", "material", "object", "render"],
    )?;

    let settings = match root.get("render") {
        Some(value) => settings(&value)?,
        None => Settings::default(),
    };
    let camera = camera(&root.need(
        "camera",
        "begin with [camera], eye = [x, y, z], target = [x, y, z], fov = 40",
    )?)?;
    let background = root
        .get("background")
        .map_or(Ok(Rgb::ZERO), |value| value.color(BRIGHTEST))?;
    let lights = list(&root, "light")?
        .iter()
        .map(light)
        .collect::<Result<_, _>>()?;
    let materials = materials(&root)?;
    let mut obj_paths = Vec::new();
    let mut budget = Budget::default();
    let objects = list(&root, "object")?;
    let objects = objects
        .iter()
        .map(|value| object(value, &materials, &mut budget, &mut obj_paths))
        .collect::<Result<_, _>>()?;
    Ok(Parsed {
        scene: Scene {
            camera,
            background,
            lights,
            materials,
            objects,
            settings,
        },
        obj_paths,
    })
}

fn list<'a>(root: &Table<'a>, key: &str) -> Result<Vec<Value<'a>>, SceneError> {
    root.get(key).map_or(Ok(Vec::new()), |value| value.items())
}

fn settings(value: &Value<'_>) -> Result<Settings, SceneError> {
    let table = value.table(&[
        "renderer",
        "shading",
        "size",
        "show",
        "samples",
        "shadows",
        "max-depth",
        "highlight",
        "depth-bits",
    ])?;
    let mut settings = Settings::default();
    if let Some(value) = table.get("renderer") {
        settings.renderer = value.choice()?;
    }
    if let Some(value) = table.get("shading") {
        settings.shading = value.choice()?;
    }
    if let Some(value) = table.get("size") {
        settings.size = size(&value)?;
    }
    if let Some(value) = table.get("show") {
        settings.show = value.choice()?;
    }
    if let Some(value) = table.get("samples") {
        settings.samples = value.whole(1..=GREATEST_SAMPLES)?;
    }
    if let Some(value) = table.get("shadows") {
        settings.shadows = value.truth()?;
    }
    if let Some(value) = table.get("max-depth") {
        settings.max_depth = value.whole(0..=GREATEST_DEPTH)?;
    }
    if let Some(value) = table.get("highlight") {
        settings.highlight = value.choice()?;
    }
    if let Some(value) = table.get("depth-bits") {
        settings.depth_bits = depth_bits(&value)?;
    }
    Ok(settings)
}

fn depth_bits(value: &Value<'_>) -> Result<DepthFormat, SceneError> {
    let bits = value.whole(16..=32)?;
    let found = DepthFormat::ALL.iter().find(|(_, format)| format.bits() == bits);
    found
        .map(|(_, format)| *format)
        .ok_or_else(|| value.must_be("16, 24 or 32"))
}

fn size(value: &Value<'_>) -> Result<(u32, u32), SceneError> {
    let items = value.items()?;
    let [width, height] = items.as_slice() else {
        return Err(value.must_be("width and height in pixels, [640, 480]"));
    };
    let (width, height) = (width.whole(1..=GREATEST_SIDE)?, height.whole(1..=GREATEST_SIDE)?);
    if u64::from(width) * u64::from(height) > MOST_PIXELS {
        return Err(value.must_be(format!("smaller: at most {MOST_PIXELS} pixels in all")));
    }
    Ok((width, height))
}

fn camera(value: &Value<'_>) -> Result<View, SceneError> {
    let table = value.table(&["eye", "target", "up", "fov", "window", "near", "far"])?;
    let eye = table
        .need("eye", "say where the eye is: eye = [x, y, z]")?
        .vector()?;
    let target_value = table.need("target", "say what it looks at: target = [x, y, z]")?;
    let target = target_value.vector()?;
    let up_value = table.get("up");
    let up = up_value.as_ref().map_or(Ok(glam::Vec3::Y), Value::vector)?;
    Camera::look_at(eye, target, up).map_err(|error| {
        let about_up = matches!(
            error,
            DegenerateCamera::Basis(DegenerateBasis::ZeroUp | DegenerateBasis::UpParallelToGaze { .. })
        );
        let place = up_value.as_ref().filter(|_| about_up).unwrap_or(&target_value);
        place.fault(
            error.to_string(),
            "eye, target and up must span a frame: up = [0, 1, 0] unless the eye looks along y",
        )
    })?;
    Ok(View {
        eye,
        target,
        up,
        lens: lens(&table)?,
    })
}

fn lens(table: &Table<'_>) -> Result<Lens, SceneError> {
    let plane = |key: &str| table.get(key).map(|value| w_coordinate(key, &value)).transpose();
    let (near, far) = (plane("near")?, plane("far")?);
    if let (Some(near), Some(far), Some(value)) = (near, far, table.get("far"))
        && far >= near
    {
        return Err(volume_fault(&value, &DegenerateVolume::NoDepth { near, far }));
    }
    match (table.get("fov"), table.get("window")) {
        (Some(_), Some(window)) => Err(window.fault(
            "both `fov` and `window` are there",
            "choose one: an angle or a window",
        )),
        (None, None) => Err(table.fault(
            "`camera.fov` is missing",
            "say how much the eye sees: fov = 40 (degrees, vertical)",
        )),
        (Some(fov), None) => {
            let degrees = fov.number_where("an angle between 0 and 180 degrees", |fov| {
                0.0 < fov && fov < 180.0
            })?;
            // The window must exist for some planes at least; an angle like 1e-30 has none.
            let (n, f) = (
                near.unwrap_or(-1.0),
                far.unwrap_or(near.map_or(-2.0, |n| 2.0 * n)),
            );
            ViewVolume::from_fov_y(degrees.to_radians(), 1.0, n.max(0.5 * f), f)
                .map_err(|error| volume_fault(&fov, &error))?;
            Ok(Lens::FieldOfView { degrees, near, far })
        }
        (None, Some(window)) => self::window(table, &window).map(Lens::Window),
    }
}

fn window(camera: &Table<'_>, value: &Value<'_>) -> Result<ViewVolume, SceneError> {
    let table = value.table(&["left", "right", "bottom", "top"])?;
    let side = |key: &str| {
        table
            .need(key, "a window has left, right, bottom and top")?
            .number()
    };
    let plane = |key: &str| {
        let remedy = "a window lies on the near plane: say near and far, both negative";
        w_coordinate(key, &camera.need(key, remedy)?)
    };
    let volume = ViewVolume {
        left: side("left")?,
        right: side("right")?,
        bottom: side("bottom")?,
        top: side("top")?,
        near: plane("near")?,
        far: plane("far")?,
    };
    volume.validate().map_err(|error| volume_fault(value, &error))?;
    Ok(volume)
}

/// The w-coordinate of the near or far plane, which is negative as on the slides (E2).
fn w_coordinate(key: &str, value: &Value<'_>) -> Result<f32, SceneError> {
    let w = value.number()?;
    if w < 0.0 {
        return Ok(w);
    }
    let name = if key == "near" { "near" } else { "far" };
    let error = DegenerateVolume::NotBeforeTheEye { name, value: w };
    let remedy = if w > 0.0 {
        format!("write {key} = {}", -w)
    } else {
        format!("write a negative number, {key} = -0.1")
    };
    Err(value.fault(error.to_string(), remedy))
}

fn volume_fault(value: &Value<'_>, error: &DegenerateVolume) -> SceneError {
    value.fault(
        error.to_string(),
        "a viewing volume needs left < right, bottom < top and far < near < 0",
    )
}

fn light(value: &Value<'_>) -> Result<Light, SceneError> {
    let kinds = "say kind = \"point\", \"directional\" or \"ambient\"";
    let kind = value.any_table()?.need("kind", kinds)?;
    let color = |table: &Table<'_>| {
        table
            .get("color")
            .map_or(Ok(Rgb::ONE), |value| value.color(BRIGHTEST))
    };
    match kind.text()? {
        "ambient" => {
            let table = value.table(&["kind", "color"])?;
            Ok(Light::Ambient {
                color: color(&table)?,
            })
        }
        "directional" => {
            let table = value.table(&["kind", "to-light", "color"])?;
            let to_light = table.need("to-light", "say where the light comes from: to-light = [x, y, z]")?;
            Ok(Light::Directional {
                to_light: to_light.direction()?,
                color: color(&table)?,
            })
        }
        "point" => {
            let table = value.table(&["kind", "position", "color"])?;
            let position = table.need("position", "say where the light is: position = [x, y, z]")?;
            Ok(Light::Point {
                position: position.vector()?,
                color: color(&table)?,
            })
        }
        other => Err(kind.fault(format!("\"{}\" is no kind of light", plain(other)), kinds)),
    }
}

fn materials(root: &Table<'_>) -> Result<BTreeMap<String, Surface>, SceneError> {
    let Some(value) = root.get("material") else {
        return Ok(BTreeMap::new());
    };
    let named = value.any_table()?;
    named
        .entries()
        .map(|(name, value)| Ok((name, surface(&value)?)))
        .collect()
}

fn surface(value: &Value<'_>) -> Result<Surface, SceneError> {
    let table = value.table(&["diffuse", "specular", "exponent", "mirror", "glass"])?;
    let diffuse = table
        .need("diffuse", "say its colour: diffuse = [red, green, blue]")?
        .color(1.0)?;
    let mut material = Material::new(diffuse, Material::default().exponent);
    if let Some(value) = table.get("specular") {
        material.specular = value.color(1.0)?;
    }
    if let Some(value) = table.get("exponent") {
        let must_be = format!("from 0 to {GREATEST_EXPONENT:e}");
        material.exponent = value.number_where(&must_be, |p| (0.0..=GREATEST_EXPONENT).contains(&p))?;
    }
    let optics = match (table.get("mirror"), table.get("glass")) {
        (None, None) => Optics::Opaque,
        (Some(mirror), None) => Optics::Mirror {
            reflectance: mirror.color(1.0)?,
        },
        (None, Some(glass)) => self::glass(&glass)?,
        (Some(_), Some(glass)) => {
            return Err(glass.fault(
                "both `mirror` and `glass` are there",
                "choose one; glass mirrors by itself",
            ));
        }
    };
    Ok(Surface { material, optics })
}

fn glass(value: &Value<'_>) -> Result<Optics, SceneError> {
    let table = value.table(&["index", "tint"])?;
    let index = table.need("index", "say its refractive index: glass = { index = 1.5 }")?;
    let must_be = format!("from 1 to {GREATEST_REFRACTIVE_INDEX}: window glass has 1.5, water 1.33");
    let refractive_index =
        index.number_where(&must_be, |n| (1.0..=GREATEST_REFRACTIVE_INDEX).contains(&n))?;
    let transmittance = table.get("tint").map_or(Ok(Rgb::ONE), |value| value.color(1.0))?;
    Ok(Optics::Glass {
        refractive_index,
        transmittance,
    })
}
