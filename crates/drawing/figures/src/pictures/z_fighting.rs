//! What do two surfaces look like that lie almost in one plane? (L20)

use glam::vec3;
use scene::{Lens, Object, Renderer, Scene, Settings, Shape};
use transforms::ViewVolume;
use zbuffer::DepthFormat;
use zbuffer::depth_format::step_at;

use super::studio::{Fault, ambient, checked, materials, matte, seen_from, settings, shot};
use crate::figure::{Drawing, Drawn, Figure, Text, Words};
use crate::handle::without_handles;
use crate::parameter::{Parameter, Values};

pub(super) static FIGURE: Figure = Figure {
    numbers: &["L20", "L19"],
    name: "z-fighting",
    title: Text { en: "Z-fighting at 16, 24 and 32 bits", nl: "Z-fighting bij 16, 24 en 32 bits" },
    caption: Text {
        en: "Light mats lie on a dark floor, a little above it. Where a depth buffer cannot tell the two apart, it shows whichever was drawn first, or a pattern of both. The near plane is close to the eye, which costs most of the resolution.",
        nl: "Lichte matten liggen op een donkere vloer, net erboven. Waar een z-buffer ze niet kan onderscheiden, toont hij wat het eerst getekend werd, of een patroon van beide. Het near-vlak ligt dicht bij het oog; dat kost het grootste deel van de resolutie.",
    },
    parameters: &[
        Parameter::number(
            "gap",
            Text { en: "height of the mats above the floor", nl: "hoogte van de matten boven de vloer" },
            0.001,
            0.0,
            0.5,
        ),
        Parameter::number(
            "near",
            Text { en: "distance of the near plane", nl: "afstand van het near-vlak" },
            0.05,
            0.01,
            1.0,
        ),
    ],
    size: (400, 300),
    draw,
    handles: without_handles,
};

/// The far plane of the scene.
const FAR: f32 = 120.0;

fn draw(values: &Values) -> Drawn {
    let (gap, near) = (values.number("gap"), values.number("near"));
    let loaded = checked(&mats(gap, near))?;
    let picture = |(format, bits): (DepthFormat, u32)| -> Result<Drawing, Fault> {
        let settings = Settings {
            depth_bits: format,
            samples: 1,
            ..settings(&loaded, Renderer::ZBuffer, values.size())
        };
        let volume = ViewVolume::from_fov_y(0.7, 4.0 / 3.0, -near, -FAR)?;
        let step = step_at(format, &volume, 30.0);
        let alt = Words::new(
            format!(
                "Light mats on a dark floor with {bits} bits of depth: at distance 30 one step is {step:.2e}, the gap {gap}."
            ),
            format!(
                "Lichte matten op een donkere vloer met {bits} bits diepte: op afstand 30 is één stap {step:.2e}, de tussenruimte {gap}."
            ),
        );
        Ok(Drawing::picture(format!("{bits}-bits"), alt, shot(&loaded, &settings)?))
    };
    [(DepthFormat::Bits16, 16), (DepthFormat::Bits24, 24), (DepthFormat::F32, 32)]
        .into_iter()
        .map(picture)
        .collect()
}

/// Returns six mats on a floor, each `gap` above it and further away than the one before.
fn mats(gap: f32, near: f32) -> Scene {
    let rectangle = |x: f32, y: f32, z: [f32; 2]| {
        vec![vec3(-x, y, z[0]), vec3(x, y, z[0]), vec3(x, y, z[1]), vec3(-x, y, z[1])]
    };
    let mats = (0..6).map(|k| {
        let (far, wide) = (-4.0 - 6.0 * k as f32, 1.6 + 0.9 * k as f32);
        rectangle(wide, gap, [far + 4.2, far])
    });
    let mut scene = Scene {
        background: vec3(0.62, 0.72, 0.84),
        lights: vec![ambient(0.9)],
        materials: materials([
            ("floor", matte(vec3(0.10, 0.13, 0.22))),
            ("mat", matte(vec3(0.90, 0.62, 0.20))),
        ]),
        objects: vec![
            Object::new(Shape::Polygons { polygons: vec![rectangle(60.0, 0.0, [8.0, -100.0])] }, "floor"),
            Object::new(Shape::Polygons { polygons: mats.collect() }, "mat"),
        ],
        ..seen_from(vec3(0.7, 2.2, 5.0), vec3(0.0, 0.0, -12.0), 40.0)
    };
    scene.camera.lens = Lens::FieldOfView { degrees: 40.0, near: Some(-near), far: Some(-FAR) };
    scene
}
