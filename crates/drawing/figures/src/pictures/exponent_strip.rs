//! What does the exponent p do? (L31)

use glam::{Vec3, vec3};
use lighting::Highlight;
use scene::{Object, Renderer, Scene, Settings, Shape, Transform};

use super::studio::{ambient, checked, seen_from, settings, shot, sun, surface};
use crate::figure::{Drawing, Drawn, Figure, Text, Words};
use crate::handle::without_handles;
use crate::parameter::{Parameter, Values};

pub(super) static FIGURE: Figure = Figure {
    numbers: &["L31"],
    name: "exponent-strip",
    title: Text { en: "Effect of the Phong exponent", nl: "Effect van de Phong-exponent" },
    caption: Text {
        en: "Six balls under one light; from each to the next the exponent is four times as large. The highlight shrinks and keeps its brightness.",
        nl: "Zes bollen onder één licht; van elke bol naar de volgende is de exponent vier keer zo groot. De highlight krimpt en blijft even helder.",
    },
    parameters: &[Parameter::number(
        "p",
        Text { en: "exponent p of the fourth ball", nl: "exponent p van de vierde bol" },
        64.0,
        0.0,
        // The sixth ball has 16 times as much, and no material has more than 4096.
        scene::limits::GREATEST_EXPONENT / 16.0,
    )],
    size: (960, 180),
    draw,
    handles: without_handles,
};

fn draw(values: &Values) -> Drawn {
    let exponents = [1.0 / 64.0, 1.0 / 16.0, 0.25, 1.0, 4.0, 16.0].map(|factor| factor * values.number("p"));
    let loaded = checked(&strip(&exponents))?;
    let image = shot(&loaded, &settings(&loaded, Renderer::Raytrace, values.size()))?;
    let list = exponents.map(|p| p.to_string()).join(", ");
    let alt = Words::new(
        format!("Six red balls with p = {list}: the white highlight gets smaller from left to right."),
        format!("Zes rode bollen met p = {list}: de witte highlight wordt van links naar rechts kleiner."),
    );
    Ok(vec![Drawing::picture("", alt, image)])
}

/// Returns six red balls in a row, each with its own exponent.
fn strip(exponents: &[f32]) -> Scene {
    let mut scene = Scene {
        background: vec3(0.05, 0.055, 0.07),
        lights: vec![ambient(0.25), sun(vec3(-0.45, 0.55, 1.0), 0.68)],
        settings: Settings { highlight: Highlight::Phong, ..Settings::default() },
        ..seen_from(vec3(0.0, 0.0, 40.0), Vec3::ZERO, 3.8)
    };
    for (k, p) in exponents.iter().enumerate() {
        let name = format!("m{k}");
        let place = Transform::Translate(vec3(2.3 * (k as f32 - 2.5), 0.0, 0.0));
        let ball = Shape::Sphere { radius: 1.0, level: 5 };
        scene.objects.push(Object::new(ball, &name).moved([place]));
        scene.materials.insert(name, surface(vec3(0.28, 0.04, 0.03), 1.0, *p));
    }
    scene
}
