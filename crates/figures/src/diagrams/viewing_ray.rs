//! Which points lie on the ray of a pixel? p(t) = e + t(s − e) (L46, L47, Fig 4.6)

use glam::{Vec3, vec2, vec3};
use transforms::{Camera, Pipeline, ViewVolume};

use crate::figure::{Drawing, Drawn, Figure, Text, Words};
use crate::parameter::{Parameter, Values};
use crate::sheet::text::triple;
use crate::sheet::view::View;
use crate::sheet::{Ink, Letters, Sheet, Side};

pub(super) static FIGURE: Figure = Figure {
    numbers: &["L46", "L47", "E13"],
    name: "viewing-ray",
    title: Text { en: "Computing viewing rays", nl: "Berekenen viewing rays" },
    caption: Text {
        en: "The ray from the eye e through the point s of the window that belongs to a pixel. p(0) = e and p(1) = s; larger t is farther away, negative t behind the eye. s is a point of the world: e + u_s u + v_s v + n w (E13).",
        nl: "De straal vanuit het oog e door het punt s van het venster dat bij een pixel hoort. p(0) = e en p(1) = s; grotere t is verder weg, negatieve t achter het oog. s is een punt van de wereld: e + u_s u + v_s v + n w (E13).",
    },
    parameters: &[
        Parameter::number("t", Text { en: "t of the point p", nl: "t van het punt p" }, 1.7, -0.4, 2.2),
        Parameter::count(
            "i",
            Text { en: "column i of the pixel", nl: "kolom i van de pixel" },
            5.0,
            0.0,
            7.0,
        ),
        Parameter::count("j", Text { en: "row j of the pixel", nl: "rij j van de pixel" }, 4.0, 0.0, 5.0),
    ],
    size: (640, 480),
    draw,
};

/// Pixels of the screen.
const SCREEN: (u32, u32) = (8, 6);

fn draw(values: &Values) -> Drawn {
    let t = values.number("t");
    let (i, j) = (values.count("i"), values.count("j"));
    let volume = ViewVolume { left: -1.2, right: 1.2, bottom: -0.9, top: 0.9, near: -2.0, far: -9.0 };
    let camera = Camera::look_at(vec3(0.0, 0.0, 2.0), Vec3::ZERO, Vec3::Y)?;
    let pipeline = Pipeline::new(camera, volume, SCREEN.0, SCREEN.1)?;
    let ray = raytrace::viewing_ray(&pipeline, i as f32, j as f32);
    let (e, s, p) = (ray.at(0.0), ray.at(1.0), ray.at(t));

    let view = View::new(vec3(4.0, 1.6, 1.6), Vec3::ZERO)?;
    let at = |p: Vec3| view.at(p);
    let seen = [
        at(vec3(0.5, -0.9, 2.8)),
        at(vec3(1.2, 0.9, 0.0)),
        at(vec3(1.0, 1.4, -2.6)),
        at(vec3(-1.2, -0.9, 0.0)),
    ];
    let mut sheet = Sheet::around(&seen, vec2(780.0, 400.0), 20.0, 0.0);
    window(&mut sheet, &view, &volume, (i, j));
    sheet.line(at(ray.at(-0.4)), at(e), Ink::A.pen().dashed());
    sheet.line(at(e), at(s), Ink::A.pen().wide());
    sheet.arrow(at(s), at(ray.at(2.3)), Ink::A.pen());
    let here = [(e, "e = p(0)", Ink::Main, Side::Below), (s, "s = p(1)", Ink::A, Side::Below)];
    for (point, name, ink, side) in here {
        sheet.dot(at(point), ink);
        sheet.label(at(point), side, name, Letters::Vector, ink);
    }
    sheet.dot(at(p), Ink::D);
    sheet.label(at(p), Side::Above, format!("p({t})"), Letters::Vector, Ink::D);
    let where_it_is = match t {
        t if t < 0.0 => Words::new("behind the eye", "achter het oog"),
        t if t < 1.0 => Words::new("between eye and window", "tussen oog en venster"),
        _ => Words::new("beyond the window", "voorbij het venster"),
    };
    let alt = Words::new(
        format!(
            "The ray through pixel ({i}, {j}): e = {}, s = {}, p({t}) = {}, {}.",
            triple(e),
            triple(s),
            triple(p),
            where_it_is.en
        ),
        format!(
            "De straal door pixel ({i}, {j}): e = {}, s = {}, p({t}) = {}, {}.",
            triple(e),
            triple(s),
            triple(p),
            where_it_is.nl
        ),
    );
    Ok(vec![Drawing::diagram("", alt.clone(), sheet.svg(&alt))])
}

/// The window with its pixels, that of the ray filled.
fn window(sheet: &mut Sheet, view: &View, volume: &ViewVolume, (i, j): (u32, u32)) {
    // The camera's frame is that of the world, its eye at z = 2, so the window lies at z = 0.
    let at = |x: f32, y: f32| {
        let u = volume.left + (volume.right - volume.left) * x / SCREEN.0 as f32;
        let v = volume.bottom + (volume.top - volume.bottom) * y / SCREEN.1 as f32;
        view.at(vec3(u, v, 0.0))
    };
    let (width, height) = (SCREEN.0 as f32, SCREEN.1 as f32);
    for column in 0..=SCREEN.0 {
        let x = column as f32;
        sheet.line(at(x, 0.0), at(x, height), Ink::Faint.pen().fine());
    }
    for row in 0..=SCREEN.1 {
        let y = row as f32;
        sheet.line(at(0.0, y), at(width, y), Ink::Faint.pen().fine());
    }
    let (x, y) = (i as f32, j as f32);
    sheet.wash(&[at(x, y), at(x + 1.0, y), at(x + 1.0, y + 1.0), at(x, y + 1.0)], Ink::A);
    sheet.polygon(&[at(0.0, 0.0), at(width, 0.0), at(width, height), at(0.0, height)], Ink::B.pen());
}
