//! What do ambient, diffuse and specular light each add? (L36, L25)

use canvas::Image;
use glam::vec3;
use lighting::Highlight;
use scene::{Object, Renderer, Scene, Settings, Shape};

use super::studio::{Fault, ambient, checked, materials, seen_from, settings, shot, sun, surface};
use crate::figure::{Drawing, Drawn, Figure, Text};
use crate::handle::without_handles;
use crate::parameter::{Parameter, Values};

pub(super) static FIGURE: Figure = Figure {
    numbers: &["L36", "L25", "L32"],
    name: "components",
    title: Text {
        en: "Ambient + diffuse + specular = total",
        nl: "Omgevingslicht + diffuus + spiegelend = totaal",
    },
    caption: Text {
        en: "Ambient and diffuse colour are blue, the highlight has the colour of the light, white. The ambient part is the same everywhere, the diffuse part follows the surface, the specular part is narrow. The fourth picture is the sum of the first three.",
        nl: "Omgevings- en diffuse kleur zijn blauw, de highlight heeft de kleur van het licht, wit. Het omgevingslicht is overal gelijk, het diffuse deel volgt het oppervlak, het spiegelende deel is smal. Het vierde plaatje is de som van de eerste drie.",
    },
    parameters: &[Parameter::number(
        "p",
        Text { en: "Phong exponent p", nl: "Phong-exponent p" },
        32.0,
        0.0,
        2000.0,
    )],
    size: (300, 240),
    draw,
    handles: without_handles,
};

/// One part of the lighting equation: its name, and how much there is of ambient light, diffuse and specular reflection.
struct Component {
    name: &'static str,
    ambient: f32,
    light: f32,
    diffuse: f32,
    specular: f32,
    alt: Text,
}

const PARTS: [Component; 4] = [
    Component {
        name: "ambient",
        ambient: 0.3,
        light: 0.0,
        diffuse: 1.0,
        specular: 0.0,
        alt: Text {
            en: "A teapot in one dark blue, without form.",
            nl: "Een theepot in één donkerblauw, zonder vorm.",
        },
    },
    Component {
        name: "diffuse",
        ambient: 0.0,
        light: 0.7,
        diffuse: 1.0,
        specular: 0.0,
        alt: Text {
            en: "A blue teapot, bright towards the light and black away from it.",
            nl: "Een blauwe theepot, helder naar het licht toe en zwart ervan af.",
        },
    },
    Component {
        name: "specular",
        ambient: 0.0,
        light: 0.7,
        diffuse: 0.0,
        specular: 1.0,
        alt: Text { en: "White highlights on black.", nl: "Witte highlights op zwart." },
    },
    Component {
        name: "total",
        ambient: 0.3,
        light: 0.7,
        diffuse: 1.0,
        specular: 1.0,
        alt: Text { en: "A glossy blue teapot.", nl: "Een glanzende blauwe theepot." },
    },
];

fn draw(values: &Values) -> Drawn {
    let drawing = |part: &Component| -> Result<Drawing, Fault> {
        Ok(Drawing::picture(part.name, part.alt, picture(part, values)?))
    };
    PARTS.iter().map(drawing).collect()
}

fn picture(part: &Component, values: &Values) -> Result<Image, Fault> {
    let Component { ambient, light, diffuse, specular, .. } = *part;
    let blue = diffuse * vec3(0.08, 0.22, 0.75);
    let loaded = checked(&Scene {
        lights: vec![self::ambient(ambient), sun(vec3(-0.5, 0.9, 0.8), light)],
        materials: materials([("pot", surface(blue, specular, values.number("p")))]),
        objects: vec![Object::new(Shape::Teapot { level: 3 }, "pot")],
        settings: Settings { highlight: Highlight::Phong, ..Settings::default() },
        ..seen_from(vec3(3.2, 4.2, 7.5), vec3(0.3, 1.45, 0.0), 38.0)
    })?;
    let settings = Settings { shadows: false, ..settings(&loaded, Renderer::ZBuffer, values.size()) };
    shot(&loaded, &settings)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_total_is_the_sum_of_the_parts() {
        let mut values = Values::of(&FIGURE);
        values.set_size(64, 48).unwrap();
        let images: Vec<Image> = PARTS.iter().map(|part| picture(part, &values).unwrap()).collect();
        let mut bright = 0;
        for k in 0..images[0].pixels().len() {
            let sum: canvas::Rgb = images[..3].iter().map(|image| image.pixels()[k]).sum();
            // Up to five additions of numbers below 2, each rounded to f32.
            assert!((sum - images[3].pixels()[k]).abs().max_element() <= 5.0 * f32::EPSILON, "pixel {k}");
            bright += usize::from(sum.max_element() > 0.5);
        }
        assert!(bright > 10, "nothing gleams");
    }
}
