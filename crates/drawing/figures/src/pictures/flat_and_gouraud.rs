//! What does it change to compute the colour at the corners instead of once a polygon? (L37, L38)

use glam::vec3;
use scene::{Object, Renderer, Scene, Settings, Shape};
use shading::Shading;

use super::studio::{Fault, ambient, checked, materials, matte, seen_from, settings, shot, sun};
use crate::figure::{Drawing, Drawn, Figure, Text};
use crate::handle::without_handles;
use crate::parameter::{Parameter, Values};

pub(super) static FIGURE: Figure = Figure {
    numbers: &["L37", "L38", "L39"],
    name: "flat-and-gouraud",
    title: Text { en: "Flat shading and Gouraud shading", nl: "Flat shading en Gouraud shading" },
    caption: Text {
        en: "The same triangles twice. Flat: one normal and one colour a triangle, and every edge shows. Gouraud: a normal and a colour at every corner, interpolated between; only the outline still tells of the triangles.",
        nl: "Twee keer dezelfde driehoeken. Flat: één normaal en één kleur per driehoek, en elke rand is te zien. Gouraud: een normaal en een kleur in elk hoekpunt, daartussen geïnterpoleerd; alleen de omtrek verraadt nog de driehoeken.",
    },
    parameters: &[Parameter::count(
        "subdivision",
        Text { en: "subdivision of the teapot", nl: "onderverdeling van de theepot" },
        1.0,
        0.0,
        5.0,
    )],
    size: (400, 300),
    draw,
    handles: without_handles,
};

fn draw(values: &Values) -> Drawn {
    let level = values.count("subdivision");
    let loaded = checked(&Scene {
        background: vec3(0.05, 0.06, 0.08),
        lights: vec![ambient(0.15), sun(vec3(-0.5, 0.9, 0.8), 0.8)],
        materials: materials([("pot", matte(vec3(0.75, 0.42, 0.2)))]),
        objects: vec![Object::new(Shape::Teapot { level }, "pot")],
        ..seen_from(vec3(3.2, 4.2, 7.5), vec3(0.3, 1.45, 0.0), 38.0)
    })?;
    let drawing = |(shading, name, alt): (Shading, &str, Text)| -> Result<Drawing, Fault> {
        let settings = Settings { shading, ..settings(&loaded, Renderer::ZBuffer, values.size()) };
        Ok(Drawing::picture(name, alt, shot(&loaded, &settings)?))
    };
    let flat = Text {
        en: "A teapot of facets, each in one colour.",
        nl: "Een theepot van facetten, elk in één kleur.",
    };
    let smooth = Text {
        en: "The same teapot with smooth transitions.",
        nl: "Dezelfde theepot met vloeiende overgangen.",
    };
    [(Shading::Flat, "flat", flat), (Shading::Gouraud, "gouraud", smooth)].into_iter().map(drawing).collect()
}
