//! What does a shadow ray change? (L56, L57)

use scene::{Renderer, Settings};

use super::studio::{Fault, scene, settings, shot};
use crate::figure::{Drawing, Drawn, Figure, Text};
use crate::handle::without_handles;
use crate::parameter::{Parameter, Values};

pub(super) static FIGURE: Figure = Figure {
    numbers: &["L56", "L57"],
    name: "shadows",
    title: Text { en: "Ray tracing with shadows", nl: "Ray tracing met schaduwen" },
    caption: Text {
        en: "From each visible point a ray goes to the light. Where it meets an object, diffuse and specular light are left out and ambient light alone remains.",
        nl: "Van elk zichtbaar punt gaat een straal naar het licht. Waar die een object raakt vervallen diffuus en spiegelend licht, en blijft alleen het omgevingslicht over.",
    },
    parameters: &[
        Parameter::number("x", Text { en: "x of the light", nl: "x van het licht" }, -3.0, -6.0, 6.0),
        Parameter::number(
            "y",
            Text { en: "height of the light", nl: "hoogte van het licht" },
            5.0,
            2.5,
            12.0,
        ),
        Parameter::number("z", Text { en: "z of the light", nl: "z van het licht" }, 3.5, -6.0, 6.0),
    ],
    size: (400, 300),
    draw,
    handles: without_handles,
};

fn draw(values: &Values) -> Drawn {
    let [x, y, z] = ["x", "y", "z"].map(|axis| values.number(axis));
    let loaded = scene(&format!(
        r#"
background = [0.45, 0.55, 0.68]
[camera]
eye = [1.5, 3.4, 8]
target = [0, 0.7, 0]
fov = 36
[[light]]
kind = "ambient"
color = 0.28
[[light]]
kind = "point"
position = [{x}, {y}, {z}]
color = 0.66
[material.floor]
diffuse = [0.66, 0.64, 0.58]
specular = 0
[material.red]
diffuse = [0.62, 0.12, 0.08]
specular = 0.4
exponent = 60
[material.blue]
diffuse = [0.12, 0.26, 0.62]
specular = 0.3
exponent = 40
[material.ochre]
diffuse = [0.66, 0.46, 0.12]
specular = 0.2
exponent = 20
[[object]]
material = "floor"
polygons = [[[-60, 0, 12], [60, 0, 12], [60, 0, -60], [-60, 0, -60]]]
[[object]]
shape = "sphere"
level = 5
material = "red"
transforms = [{{ scale = 0.9 }}, {{ translate = [-0.6, 0.9, 0.5] }}]
[[object]]
shape = "box"
size = [1.1, 1.9, 1.1]
material = "blue"
transforms = [{{ rotate = 30, axis = [0, 1, 0] }}, {{ translate = [1.6, 0.95, -0.7] }}]
[[object]]
shape = "torus"
major = 0.75
minor = 0.22
level = 4
material = "ochre"
transforms = [{{ rotate = 68, axis = [1, 0, 0] }}, {{ rotate = 25, axis = [0, 1, 0] }}, {{ translate = [-2.2, 0.9, -0.9] }}]
"#
    ))?;
    let drawing = |(shadows, name, alt): (bool, &str, Text)| -> Result<Drawing, Fault> {
        let settings = Settings { shadows, ..settings(&loaded, Renderer::Raytrace, values.size()) };
        Ok(Drawing::picture(name, alt, shot(&loaded, &settings)?))
    };
    let with = Text {
        en: "A ball, a box and a ring with shadows on the floor and on each other.",
        nl: "Een bol, een blok en een ring met schaduwen op de vloer en op elkaar.",
    };
    let without = Text {
        en: "The same without shadows: the ring might lie or float anywhere.",
        nl: "Hetzelfde zonder schaduwen: de ring kan overal liggen of zweven.",
    };
    [(false, "without-shadow", without), (true, "with-shadow", with)].into_iter().map(drawing).collect()
}
