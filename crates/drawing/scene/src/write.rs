//! How is a scene written down? As the text that reads back to the same scene.

use std::fmt::Write as _;

use glam::Vec3;
use lighting::Light;
use raytrace::{Optics, Surface};

use crate::Named;
use crate::scene::{Lens, Object, Scene, Settings, Shape, Transform, View};

impl Scene {
    /// The scene file of this scene: [`Scene::from_toml`] gives the same scene back, provided that it would accept what
    /// is in it (a NaN it does not).
    #[must_use]
    pub fn to_toml(&self) -> String {
        let mut text = format!("background = {}\n", vector(self.background));
        text += &render_table(&self.settings);
        text += &camera_table(&self.camera);
        for light in &self.lights {
            text += &light_table(light);
        }
        for (name, surface) in &self.materials {
            text += &material_table(name, surface);
        }
        for object in &self.objects {
            text += &object_table(object);
        }
        text
    }
}

/// Lines under a heading. Writing to a `String` cannot fail.
struct Lines(String);

impl Lines {
    fn under(heading: &str) -> Self {
        Self(format!("\n{heading}\n"))
    }

    fn line(mut self, key: &str, value: impl std::fmt::Display) -> Self {
        let _ = writeln!(self.0, "{key} = {value}");
        self
    }

    fn line_if(self, key: &str, value: Option<impl std::fmt::Display>) -> Self {
        match value {
            Some(value) => self.line(key, value),
            None => self,
        }
    }
}

fn render_table(settings: &Settings) -> String {
    let Settings { renderer, shading, size, show, samples, shadows, max_depth, highlight, depth_bits } =
        settings;
    Lines::under("[render]")
        .line("renderer", quoted(renderer.name()))
        .line("shading", quoted(shading.name()))
        .line("size", format!("[{}, {}]", size.0, size.1))
        .line("show", quoted(show.name()))
        .line("samples", samples)
        .line("shadows", shadows)
        .line("max-depth", max_depth)
        .line("highlight", quoted(highlight.name()))
        .line("depth-bits", depth_bits.bits())
        .0
}

fn camera_table(camera: &View) -> String {
    let lines = Lines::under("[camera]")
        .line("eye", vector(camera.eye))
        .line("target", vector(camera.target))
        .line("up", vector(camera.up));
    match camera.lens {
        Lens::FieldOfView { degrees, near, far } => lines
            .line("fov", number(degrees))
            .line_if("near", near.map(number))
            .line_if("far", far.map(number)),
        Lens::Window(v) => {
            let sides = [("left", v.left), ("right", v.right), ("bottom", v.bottom), ("top", v.top)];
            let sides = sides.map(|(key, side)| format!("{key} = {}", number(side)));
            lines
                .line("window", format!("{{ {} }}", sides.join(", ")))
                .line("near", number(v.near))
                .line("far", number(v.far))
        }
    }
    .0
}

fn light_table(light: &Light) -> String {
    let lines = Lines::under("[[light]]");
    match *light {
        Light::Ambient { color } => lines.line("kind", "\"ambient\"").line("color", vector(color)),
        Light::Directional { to_light, color } => lines
            .line("kind", "\"directional\"")
            .line("to-light", vector(to_light))
            .line("color", vector(color)),
        Light::Point { position, color } => {
            lines.line("kind", "\"point\"").line("position", vector(position)).line("color", vector(color))
        }
    }
    .0
}

fn material_table(name: &str, surface: &Surface) -> String {
    let lines = Lines::under(&format!("[material.{}]", quoted(name)))
        .line("diffuse", vector(surface.material.diffuse))
        .line("specular", vector(surface.material.specular))
        .line("exponent", number(surface.material.exponent));
    match surface.optics {
        Optics::Opaque => lines,
        Optics::Mirror { reflectance } => lines.line("mirror", vector(reflectance)),
        Optics::Dissolved { opacity } => lines.line("opacity", number(opacity)),
        Optics::Glass { refractive_index, transmittance } => lines.line(
            "glass",
            format!("{{ index = {}, tint = {} }}", number(refractive_index), vector(transmittance)),
        ),
    }
    .0
}

fn object_table(object: &Object) -> String {
    let lines = shape_lines(Lines::under("[[object]]"), &object.shape)
        .line_if("material", object.material.as_deref().map(quoted))
        .line("crease", number(object.crease_degrees))
        .line("transforms", transforms(&object.transforms));
    if object.instances.is_empty() {
        return lines.0;
    }
    let copies: Vec<String> =
        object.instances.iter().map(|copy| format!("    {},\n", transforms(copy))).collect();
    lines.line("instances", format!("[\n{}]", copies.concat())).0
}

fn shape_lines(lines: Lines, shape: &Shape) -> Lines {
    let ball = |lines: Lines, name: &str, radius: f32, level: u32| {
        lines.line("shape", quoted(name)).line("radius", number(radius)).line("level", level)
    };
    match shape {
        Shape::Sphere { radius, level } => ball(lines, "sphere", *radius, *level),
        Shape::UvSphere { radius, level } => ball(lines, "uv-sphere", *radius, *level),
        Shape::Icosphere { radius, level } => ball(lines, "icosphere", *radius, *level),
        Shape::Disc { radius, level } => ball(lines, "disc", *radius, *level),
        Shape::Cuboid { size, level } => {
            lines.line("shape", "\"box\"").line("size", vector(*size)).line("level", level)
        }
        Shape::Torus { major, minor, level } => lines
            .line("shape", "\"torus\"")
            .line("major", number(*major))
            .line("minor", number(*minor))
            .line("level", level),
        Shape::Teapot { level } => lines.line("shape", "\"teapot\"").line("level", level),
        Shape::Polygons { polygons } => {
            let outline = |corners: &Vec<Vec3>| {
                let corners: Vec<String> = corners.iter().map(|corner| vector(*corner)).collect();
                format!("    [{}],\n", corners.join(", "))
            };
            let outlines: Vec<String> = polygons.iter().map(outline).collect();
            lines.line("polygons", format!("[\n{}]", outlines.concat()))
        }
        Shape::Obj { path, fit } => lines.line("obj", quoted(path)).line("fit", fit),
    }
}

fn transforms(list: &[Transform]) -> String {
    let steps: Vec<String> = list.iter().map(transform).collect();
    format!("[{}]", steps.join(", "))
}

fn transform(step: &Transform) -> String {
    match *step {
        Transform::Translate(by) => format!("{{ translate = {} }}", vector(by)),
        Transform::Scale(by) => format!("{{ scale = {} }}", vector(by)),
        Transform::Rotate { degrees, axis } => {
            format!("{{ rotate = {}, axis = {} }}", number(degrees), vector(axis))
        }
    }
}

fn vector(v: Vec3) -> String {
    format!("[{}, {}, {}]", number(v.x), number(v.y), number(v.z))
}

/// The shortest digits that read back to the same `f32`.
fn number(x: f32) -> String {
    if x.is_nan() { "nan".to_owned() } else { format!("{x:?}") }
}

/// A TOML basic string.
fn quoted(text: &str) -> String {
    let mut quoted = String::from("\"");
    for c in text.chars() {
        match c {
            '"' | '\\' => quoted.extend(['\\', c]),
            c if c.is_control() => {
                let _ = write!(quoted, "\\u{:04X}", u32::from(c));
            }
            c => quoted.push(c),
        }
    }
    quoted + "\""
}
