//! What does a coarse sphere show of its triangles, shaded per vertex and per fragment? (L41)

use glam::{Vec3, vec3};
use scene::{Object, Renderer, Scene, Settings, Shape, Transform};
use shading::Shading;

use super::studio::{Fault, ambient, checked, materials, seen_from, settings, shot, sun, surface};
use crate::figure::{Drawing, Drawn, Figure, Text};
use crate::handle::without_handles;
use crate::parameter::{Parameter, Values};

pub(super) static FIGURE: Figure = Figure {
    numbers: &["L41", "L40", "L42"],
    name: "coarse-spheres",
    title: Text { en: "Per-vertex and per-fragment shading", nl: "Per-vertex en per-fragment shading" },
    caption: Text {
        en: "Two coarse spheres. Per vertex (Gouraud), the highlight is caught only where a corner happens to lie in it, and fades along the edges. Per fragment (Phong shading), the interpolated normal finds it wherever it is; the outline stays a polygon.",
        nl: "Twee grove bollen. Per vertex (Gouraud) wordt de highlight alleen gevangen waar toevallig een hoekpunt in ligt, en vervaagt hij langs de randen. Per fragment (Phong shading) vindt de geïnterpoleerde normaal hem overal; de omtrek blijft een veelhoek.",
    },
    parameters: &[
        Parameter::count(
            "subdivision",
            Text { en: "subdivision of the spheres", nl: "onderverdeling van de bollen" },
            1.0,
            0.0,
            5.0,
        ),
        Parameter::number("p", Text { en: "exponent p", nl: "exponent p" }, 60.0, 0.0, 2000.0),
    ],
    size: (480, 260),
    draw,
    handles: without_handles,
};

fn draw(values: &Values) -> Drawn {
    let (level, p) = (values.count("subdivision"), values.number("p"));
    let loaded = checked(&two_spheres(level, p))?;
    let drawing = |(shading, name, alt): (Shading, &str, Text)| -> Result<Drawing, Fault> {
        let settings = Settings { shading, ..settings(&loaded, Renderer::ZBuffer, values.size()) };
        Ok(Drawing::picture(name, alt, shot(&loaded, &settings)?))
    };
    let gouraud = Text {
        en: "Two coarse spheres whose highlights are dull and follow the edges of the triangles.",
        nl: "Twee grove bollen waarvan de highlights dof zijn en de randen van de driehoeken volgen.",
    };
    let phong = Text {
        en: "The same spheres with bright, nearly round highlights.",
        nl: "Dezelfde bollen met heldere, bijna ronde highlights.",
    };
    [(Shading::Gouraud, "gouraud", gouraud), (Shading::Phong, "phong", phong)]
        .into_iter()
        .map(drawing)
        .collect()
}

/// Returns a red and a blue ball of few triangles; the blue one is turned.
fn two_spheres(level: u32, p: f32) -> Scene {
    let ball = || Shape::Icosphere { radius: 1.25, level };
    let turned = Transform::Rotate { degrees: 40.0, axis: vec3(1.0, 2.0, 0.0) };
    let at = |x: f32| Transform::Translate(vec3(x, 0.0, 0.0));
    Scene {
        background: vec3(0.05, 0.06, 0.08),
        lights: vec![ambient(0.15), sun(vec3(-0.5, 0.6, 1.0), 0.7)],
        materials: materials([
            ("red", surface(vec3(0.6, 0.1, 0.08), 1.0, p)),
            ("blue", surface(vec3(0.1, 0.2, 0.6), 1.0, p)),
        ]),
        objects: vec![
            Object::new(ball(), "red").moved([at(-1.4)]),
            Object::new(ball(), "blue").moved([turned, at(1.4)]),
        ],
        ..seen_from(vec3(0.0, 0.0, 12.0), Vec3::ZERO, 15.0)
    }
}
