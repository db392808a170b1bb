//! What does the exponent p do? (L31)

use std::fmt::Write;

use scene::Renderer;

use super::studio::{scene, settings, shot};
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
    let loaded = scene(&text(&exponents))?;
    let image = shot(&loaded, &settings(&loaded, Renderer::Raytrace, values.size()))?;
    let list = exponents.map(|p| p.to_string()).join(", ");
    let alt = Words::new(
        format!("Six red balls with p = {list}: the white highlight gets smaller from left to right."),
        format!("Zes rode bollen met p = {list}: de witte highlight wordt van links naar rechts kleiner."),
    );
    Ok(vec![Drawing::picture("", alt, image)])
}

fn text(exponents: &[f32]) -> String {
    let mut text = String::from(
        r#"
background = [0.05, 0.055, 0.07]
[render]
size = [960, 180]
highlight = "phong"
[camera]
eye = [0, 0, 40]
target = [0, 0, 0]
fov = 3.8
[[light]]
kind = "ambient"
color = 0.25
[[light]]
kind = "directional"
to-light = [-0.45, 0.55, 1]
color = 0.68
"#,
    );
    for (k, p) in exponents.iter().enumerate() {
        let x = 2.3 * (k as f32 - 2.5);
        // Writing to a string cannot fail.
        let _ = write!(
            text,
            "[material.m{k}]\ndiffuse = [0.28, 0.04, 0.03]\nexponent = {p}\n\
             [[object]]\nshape = \"sphere\"\nlevel = 5\nmaterial = \"m{k}\"\ntransforms = [{{ translate = [{x}, 0, 0] }}]\n"
        );
    }
    text
}
