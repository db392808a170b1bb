//! Which part of space does the camera see, and where do its rays cross the view plane? (L7, Fig 7.7)

use glam::{Vec2, Vec3, vec2, vec3};
use sheet::label_layout::Vector;
use sheet::text::decimal;
use sheet::view::View;
use sheet::{Ink, Pen, Sheet};
use transforms::{DegenerateCamera, ViewVolume};

use crate::figure::{Drawing, Drawn, Figure, Text, Words};
use crate::handle::{Handled, Handles, with_handles};
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
    handles,
};

fn volume(values: &Values) -> ViewVolume {
    let [left, right, bottom, top, near, far] =
        ["l", "r", "b", "t", "n", "f"].map(|name| values.number(name));
    ViewVolume { left, right, bottom, top, near, far }
}

/// The view, and a sheet on which the whole volume is seen.
fn laid_out(volume: &ViewVolume) -> Result<(View, Sheet), DegenerateCamera> {
    // In camera coordinates u, v, w are x, y, z.
    let view = View::new(vec3(5.0, 3.0, 3.2), Vec3::ZERO)?;
    let (window, end) = (rectangle(volume, volume.near), rectangle(volume, volume.far));
    let seen: Vec<Vec2> = window.iter().chain(&end).chain(&[Vec3::Y, Vec3::Z]).map(|p| view.at(*p)).collect();
    Ok((view, Sheet::around(&seen, vec2(760.0, 460.0), 46.0, 120.0)))
}

/// Where the planes cut the axes: the middles of the window's left, right, bottom and top edge, its own, and that of the far
/// plane.
fn marks(volume: &ViewVolume) -> [Vec3; 6] {
    let ViewVolume { left, right, bottom, top, near, far } = *volume;
    [
        vec3(left, 0.0, near),
        vec3(right, 0.0, near),
        vec3(0.0, bottom, near),
        vec3(0.0, top, near),
        vec3(0.0, 0.0, near),
        vec3(0.0, 0.0, far),
    ]
}

fn draw(values: &Values) -> Drawn {
    let volume = volume(values);
    volume.validate()?;
    let ViewVolume { left, right, bottom, top, near, far } = volume;
    let (view, mut sheet) = laid_out(&volume)?;
    edges(&mut sheet, &view, &rectangle(&volume, near), &rectangle(&volume, far));
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
    with_handles(vec![Drawing::only(alt, |alt| sheet.svg(alt))], handles(values))
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
    let [left, right, bottom, top, near, far] = marks(volume).map(|p| view.at(p));
    let thin = |ink: Ink| -> Pen { ink.pen().dashed().fine() };
    sheet.line(view.at(Vec3::ZERO), far, thin(Ink::Main));
    sheet.line(left, right, thin(Ink::B));
    sheet.line(bottom, top, thin(Ink::B));
    let axis = |name, tip| Vector::new(name, view.at(tip), Ink::Main);
    let eye = view.at(Vec3::ZERO);
    sheet.vectors(eye, &[axis("u", Vec3::X), axis("v", Vec3::Y), axis("w", Vec3::Z)]);
    for p in [eye, near, far] {
        sheet.dot(p, Ink::Main);
    }
    let (aside, below) = (vec2(sheet.units(11.0), 0.0), vec2(0.0, -sheet.units(14.0)));
    sheet.names(&[
        (eye + below - aside, "e", Ink::Main),
        (left - aside, "l", Ink::B),
        (right + aside, "r", Ink::B),
        (bottom + below, "b", Ink::B),
        (top - below, "t", Ink::B),
        (near + below + 2.0 * aside, "n", Ink::Main),
        (far + below, "f", Ink::Main),
    ]);
}

fn handles(values: &Values) -> Handled {
    let volume = volume(values);
    let (view, sheet) = laid_out(&volume)?;
    let [left, right, bottom, top, near, far] = marks(&volume).map(|p| view.at(p));
    let list: [(Text, &[&str], Vec2); 6] = [
        (Text { en: "the left edge", nl: "de linkerrand" }, &["l"], left),
        (Text { en: "the right edge", nl: "de rechterrand" }, &["r"], right),
        (Text { en: "the bottom edge", nl: "de onderrand" }, &["b"], bottom),
        (Text { en: "the top edge", nl: "de bovenrand" }, &["t"], top),
        (Text { en: "the near plane", nl: "het near-vlak" }, &["n"], near),
        (Text { en: "the far plane", nl: "het far-vlak" }, &["f"], far),
    ];
    Ok(vec![Handles::on(&sheet, list)])
}
