//! What does a scene file say? Its text becomes a [`Scene`], or an error at its line and column.
//!
//! [`Scene::from_toml`] tells the story; the README of this crate describes the format with an example.

mod camera;
mod nearest;
mod object;
mod settings;
mod surface;
mod table;
mod value;

use std::ops::Range;

use lighting::Rgb;
use toml::de::DeTable;

use crate::SceneError;
use crate::scene::{Scene, Settings};
pub(crate) use object::CREASE_DEGREES;
use object::Objects;
pub(crate) use table::Source;
use table::Table;
use value::Value;

/// The brightest light or background: brighter than that, `f32` could overflow in a sum of products.
const BRIGHTEST: f32 = 1e6;

/// A scene and where in its text the OBJ files are named, so that a missing one can be shown there.
#[derive(Debug)]
pub(crate) struct Parsed {
    pub(crate) scene: Scene,
    /// Path as written, and its place.
    pub(crate) obj_paths: Vec<(String, Range<usize>)>,
    /// What is odd but can be drawn, with its place.
    pub(crate) warnings: Vec<String>,
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
        let problem = error.message().lines().next().unwrap_or("this is no TOML").to_owned();
        source.fault(
            &error.span().unwrap_or(0..0),
            problem,
            "a scene file is TOML: `key = value` lines under [table] lines",
        )
    })?;
    let root =
        Table::root(source, &root, &["camera", "background", "light", "material", "object", "render"])?;

    let settings = match root.get("render") {
        Some(value) => settings::settings(&value)?,
        None => Settings::default(),
    };
    let camera = camera::camera(
        &root.need("camera", "begin with [camera], eye = [x, y, z], target = [x, y, z], fov = 40")?,
    )?;
    let background = root.get("background").map_or(Ok(Rgb::ZERO), |value| value.color(BRIGHTEST))?;
    let lights = list(&root, "light")?.iter().map(surface::light).collect::<Result<_, _>>()?;
    let materials = surface::materials(&root)?;
    let mut so_far = Objects::default();
    let objects = list(&root, "object")?;
    let objects = objects
        .iter()
        .map(|value| object::object(value, &materials, &mut so_far))
        .collect::<Result<_, _>>()?;
    let scene = Scene { camera, background, lights, materials, objects, settings };
    Ok(Parsed { scene, obj_paths: so_far.obj_paths, warnings: so_far.warnings })
}

fn list<'a>(root: &Table<'a>, key: &str) -> Result<Vec<Value<'a>>, SceneError> {
    root.get(key).map_or(Ok(Vec::new()), |value| value.items())
}
