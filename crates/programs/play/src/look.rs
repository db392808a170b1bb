//! What do the three loops look at? One scene, one camera, one way to shade: the same for all of them.

use std::sync::{Arc, Mutex, PoisonError};

use glam::{Mat3, Quat, Vec3};
use scene::{Named, Prepared, Renderer, Scene, Settings, Shape, View, builtin, parse_name, prepare};
use serde::Deserialize;

use crate::Refusal;

/// What is looked at, and how, as the page asks for it.
#[derive(Clone, Debug, Deserialize, PartialEq)]
#[serde(deny_unknown_fields, default)]
pub struct Look {
    /// The name of a built-in scene.
    pub scene: String,
    /// How far the eye went around its target from where the scene has it, degrees, anticlockwise seen from above.
    pub azimuth: f32,
    /// How much higher it stands, degrees.
    pub elevation: f32,
    /// Its distance from the target, as a multiple of the scene's.
    pub distance: f32,
    /// Width of the picture in pixels.
    pub width: u32,
    /// Height of the picture in pixels.
    pub height: u32,
    /// `flat`, `gouraud` or `phong`.
    pub shading: String,
    /// `phong` or `blinn`.
    pub highlight: String,
    /// The exponent of all materials; the scene's own without one.
    pub p: Option<f32>,
    /// Whether lights cast shadows; only the ray tracer can.
    pub shadows: bool,
    /// The subdivision of all shapes that have one; the scene's own without one.
    pub level: Option<u32>,
    /// `color`, `depth`, `normals`, `barycentric` or `overdraw`.
    pub show: String,
}

impl Default for Look {
    fn default() -> Self {
        Self {
            scene: builtin::all()[0].name.to_owned(),
            azimuth: 0.0,
            elevation: 0.0,
            distance: 1.0,
            width: 640,
            height: 480,
            shading: "phong".to_owned(),
            highlight: "blinn".to_owned(),
            p: None,
            shadows: true,
            level: None,
            show: "color".to_owned(),
        }
    }
}

/// As large as a picture may be asked for, along a side.
const GREATEST_SIDE: u32 = 1920;
/// The eye stays so many degrees away from straight above and below.
const NEAREST_TO_THE_POLE: f32 = 5.0;
/// As fine as shapes may be asked for.
const FINEST: u32 = 5;
/// The greatest exponent that may be asked for.
const GREATEST_EXPONENT: f32 = 4096.0;

/// A scene that was made ready, and what it was made of.
#[derive(Debug)]
struct Kept {
    scene: String,
    p: Option<u32>,
    level: Option<u32>,
    ready: Ready,
}

/// A scene, and what it was made into.
#[derive(Clone, Debug)]
struct Ready {
    /// As its file has it, but for exponent and subdivision.
    scene: Arc<Scene>,
    prepared: Arc<Prepared>,
}

/// Scenes that were made ready lately, so that moving the camera costs nothing.
#[derive(Debug, Default)]
pub struct Stage {
    kept: Mutex<Vec<Kept>>,
}

/// So many scenes are kept: those of a few tabs, each with a parameter that is being dragged.
const KEPT: usize = 8;

impl Look {
    /// How to render it.
    ///
    /// # Errors
    /// [`Refusal`] if a word is unknown or a number out of range.
    pub fn settings(&self, renderer: Renderer) -> Result<Settings, Refusal> {
        if !(1..=GREATEST_SIDE).contains(&self.width) || !(1..=GREATEST_SIDE).contains(&self.height) {
            return Err(out_of_range("the size", &format!("1 … {GREATEST_SIDE}")));
        }
        Ok(Settings {
            renderer,
            shading: named(&self.shading)?,
            size: (self.width, self.height),
            show: named(&self.show)?,
            samples: 1,
            shadows: self.shadows,
            highlight: named(&self.highlight)?,
            ..Settings::default()
        })
    }
}

/// The choice of this name.
///
/// # Errors
/// [`Refusal`] if there is none.
pub(crate) fn named<T: Named>(name: &str) -> Result<T, Refusal> {
    parse_name(name).map_err(Refusal::because)
}

fn out_of_range(what: &str, range: &str) -> Refusal {
    Refusal::new(format!("{what} is out of range: {range}"), format!("{what}: buiten het bereik {range}"))
}

impl Stage {
    /// The scene of a look, seen from where the look says.
    ///
    /// # Errors
    /// [`Refusal`] if there is no such scene, or a number is out of range.
    pub fn prepared(&self, look: &Look) -> Result<Prepared, Refusal> {
        let ready = self.ready(look)?;
        Ok(ready.prepared.seen_by(&moved(&ready.scene.camera, look)?)?)
    }

    /// What the scene of a look says.
    ///
    /// # Errors
    /// As [`Stage::prepared`].
    pub(crate) fn scene(&self, look: &Look) -> Result<Arc<Scene>, Refusal> {
        Ok(self.ready(look)?.scene)
    }

    fn ready(&self, look: &Look) -> Result<Ready, Refusal> {
        let p = look.p.map(f32::to_bits);
        let is_this = |kept: &Kept| kept.scene == look.scene && kept.p == p && kept.level == look.level;
        {
            let mut kept = self.kept.lock().unwrap_or_else(PoisonError::into_inner);
            if let Some(at) = kept.iter().position(is_this) {
                // The one that was used last goes last.
                let found = kept.remove(at);
                let ready = found.ready.clone();
                kept.push(found);
                return Ok(ready);
            }
        }
        let ready = made_ready(look)?;
        let mut kept = self.kept.lock().unwrap_or_else(PoisonError::into_inner);
        if kept.len() >= KEPT {
            kept.remove(0);
        }
        kept.push(Kept { scene: look.scene.clone(), p, level: look.level, ready: ready.clone() });
        Ok(ready)
    }
}

fn made_ready(look: &Look) -> Result<Ready, Refusal> {
    let builtin = builtin::find(&look.scene).ok_or_else(|| {
        Refusal::new(
            format!("there is no scene {:?}", look.scene),
            format!("er is geen scène {:?}", look.scene),
        )
    })?;
    let mut loaded = builtin.load().map_err(Refusal::because)?;
    if let Some(p) = look.p {
        if !(0.0..=GREATEST_EXPONENT).contains(&p) {
            return Err(out_of_range("p", &format!("0 … {GREATEST_EXPONENT}")));
        }
        loaded.scene.materials.values_mut().for_each(|surface| surface.material.exponent = p);
    }
    if let Some(asked) = look.level {
        if asked > FINEST {
            return Err(out_of_range("level", &format!("0 … {FINEST}")));
        }
        for object in &mut loaded.scene.objects {
            subdivide(&mut object.shape, asked);
        }
    }
    let prepared = Arc::new(prepare(&loaded)?);
    Ok(Ready { scene: Arc::new(loaded.scene), prepared })
}

fn subdivide(shape: &mut Shape, asked: u32) {
    match shape {
        Shape::Sphere { level, .. }
        | Shape::UvSphere { level, .. }
        | Shape::Icosphere { level, .. }
        | Shape::Cuboid { level, .. }
        | Shape::Torus { level, .. }
        | Shape::Disc { level, .. }
        | Shape::Teapot { level } => *level = asked,
        Shape::Polygons { .. } | Shape::Obj { .. } => {}
    }
}

/// The scene's eye, carried around its target.
fn moved(view: &View, look: &Look) -> Result<View, Refusal> {
    for (name, value, least, greatest) in [
        ("azimuth", look.azimuth, -3600.0, 3600.0),
        ("elevation", look.elevation, -180.0, 180.0),
        ("distance", look.distance, 0.2, 5.0),
    ] {
        if !(least..=greatest).contains(&value) {
            return Err(out_of_range(name, &format!("{least} … {greatest}")));
        }
    }
    let up = view.up.normalize_or(Vec3::Y);
    let from_target = view.eye - view.target;
    let around = Quat::from_axis_angle(up, look.azimuth.to_radians());
    let turned = Mat3::from_quat(around) * from_target;
    // The height above the horizon, kept away from the poles.
    let flat = turned - turned.dot(up) * up;
    let now = turned.dot(up).atan2(flat.length()).to_degrees();
    let most = 90.0 - NEAREST_TO_THE_POLE;
    let wanted = (now + look.elevation).clamp(-most.max(-now), most.max(now)).to_radians();
    let ahead = flat.normalize_or(up.any_orthonormal_vector());
    let length = look.distance * from_target.length();
    Ok(View { eye: view.target + length * (wanted.cos() * ahead + wanted.sin() * up), ..*view })
}
