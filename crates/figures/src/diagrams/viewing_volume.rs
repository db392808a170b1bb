//! Which part of space does the camera see, and where do its rays cross the view plane? (L7, Fig 7.7)

use glam::{Vec2, Vec3, vec2, vec3};
use sheet::crowd::Vector;
use sheet::text::decimal;
use sheet::view::View;
use sheet::{Ink, Pen, Sheet};
use transforms::ViewVolume;

use crate::figure::{Drawing, Drawn, Figure, Text, Words};
use crate::handle::without_handles;
use crate::parameter::{Parameter, Values};

const fn edge(name: &'static str, label: Text, default: f32, least: f32, greatest: f32) -> Parameter {
    Parameter::number(name, label, default, least, greatest)
}

pub(super) static FIGURE: Figure = Figure {
    numbers: &["L7"],
    name: "viewing-volume",
    title: Text { en: "Viewing volume and view plane w = n", nl: "Viewing volume en viewplane w = n" },
    caption: Text {
        en: "In camera coordinates the eye e is the origin and looks along −w. The window l, r, b, t lies in the view plane w = n; rays from e through its corners bound what is seen, up to the far plane w = f. Both n and f are negative.",
        nl: "In cameracoördinaten is het oog e de oorsprong en kijkt het langs −w. Het venster l, r, b, t ligt in het viewplane w = n; stralen vanuit e door de hoeken begrenzen wat gezien wordt, tot aan het far-vlak w = f. Zowel n als f is negatief.",
    },
    parameters: &[
        edge(
            "l",
            Text { en: "left edge l of the window", nl: "linkerrand l van het venster" },
            -1.0,
            -1.6,
            -0.2,
        ),
        edge("r", Text { en: "right edge r", nl: "rechterrand r" }, 1.4, 0.2, 1.6),
        edge("b", Text { en: "bottom edge b", nl: "onderrand b" }, -0.8, -1.2, -0.2),
        edge("t", Text { en: "top edge t", nl: "bovenrand t" }, 1.0, 0.2, 1.2),
        edge("n", Text { en: "near plane n", nl: "near-vlak n" }, -2.5, -3.5, -1.5),
        edge("f", Text { en: "far plane f", nl: "far-vlak f" }, -5.5, -8.0, -4.5),
    ],
    size: (640, 480),
    draw,
    handles: without_handles,
};

fn draw(values: &Values) -> Drawn {
    let [left, right, bottom, top, near, far] =
        ["l", "r", "b", "t", "n", "f"].map(|name| values.number(name));
    let volume = ViewVolume { left, right, bottom, top, near, far };
    volume.validate()?;
    // In camera coordinates u, v, w are x, y, z.
    let view = View::new(vec3(5.0, 3.0, 3.2), Vec3::ZERO)?;
    let (window, end) = (rectangle(&volume, near), rectangle(&volume, far));
    let seen: Vec<Vec2> = window.iter().chain(&end).chain(&[Vec3::Y, Vec3::Z]).map(|p| view.at(*p)).collect();
    let mut sheet = Sheet::around(&seen, vec2(760.0, 460.0), 46.0, 120.0);
    edges(&mut sheet, &view, &window, &end);
    axes_and_names(&mut sheet, &view, &volume);
    let number = |x| decimal(x, 1);
    sheet.lines(
        630.0,
        60.0,
        [("l", left), ("r", right), ("b", bottom), ("t", top), ("n", near), ("f", far)]
            .map(|(name, value)| format!("{name} = {}", number(value))),
    );
    let (n, f) = (number(near), number(far));
    let alt = Words::new(
        format!(
            "A pyramid with its top at the eye, cut off by the window in the view plane w = {n} and by the far plane w = {f}."
        ),
        format!(
            "Een piramide met haar top in het oog, afgesneden door het venster in het viewplane w = {n} en door het far-vlak w = {f}."
        ),
    );
    Ok(vec![Drawing::only(alt, |alt| sheet.svg(alt))])
}

/// The corners of what is seen at depth w: the window, as much larger as it is farther away.
fn rectangle(volume: &ViewVolume, w: f32) -> [Vec3; 4] {
    let ViewVolume { left, right, bottom, top, near, .. } = *volume;
    [(left, bottom), (right, bottom), (right, top), (left, top)].map(|(u, v)| w / near * vec3(u, v, near))
}

fn edges(sheet: &mut Sheet, view: &View, window: &[Vec3; 4], end: &[Vec3; 4]) {
    let (window, end) = (window.map(|p| view.at(p)), end.map(|p| view.at(p)));
    sheet.polygon(&end, Ink::Faint.pen());
    for (near, far) in window.into_iter().zip(end) {
        sheet.line(view.at(Vec3::ZERO), near, Ink::A.pen().dashed());
        sheet.line(near, far, Ink::A.pen());
    }
    sheet.wash(&window, Ink::B);
    sheet.polygon(&window, Ink::B.pen().wide());
}

fn axes_and_names(sheet: &mut Sheet, view: &View, volume: &ViewVolume) {
    let ViewVolume { left, right, bottom, top, near, far } = *volume;
    let at = |u, v, w| view.at(vec3(u, v, w));
    let thin = |ink: Ink| -> Pen { ink.pen().dashed().fine() };
    sheet.line(at(0.0, 0.0, 0.0), at(0.0, 0.0, far), thin(Ink::Main));
    sheet.line(at(left, 0.0, near), at(right, 0.0, near), thin(Ink::B));
    sheet.line(at(0.0, bottom, near), at(0.0, top, near), thin(Ink::B));
    let axis = |name, tip| Vector::new(name, view.at(tip), Ink::Main);
    let eye = view.at(Vec3::ZERO);
    sheet.vectors(eye, &[axis("u", Vec3::X), axis("v", Vec3::Y), axis("w", Vec3::Z)]);
    for p in [eye, at(0.0, 0.0, near), at(0.0, 0.0, far)] {
        sheet.dot(p, Ink::Main);
    }
    let (aside, below) = (vec2(sheet.units(11.0), 0.0), vec2(0.0, -sheet.units(14.0)));
    sheet.names(&[
        (eye + below - aside, "e", Ink::Main),
        (at(left, 0.0, near) - aside, "l", Ink::B),
        (at(right, 0.0, near) + aside, "r", Ink::B),
        (at(0.0, bottom, near) + below, "b", Ink::B),
        (at(0.0, top, near) - below, "t", Ink::B),
        (at(0.0, 0.0, near) + below + 2.0 * aside, "n", Ink::Main),
        (at(0.0, 0.0, far) + below, "f", Ink::Main),
    ]);
}
