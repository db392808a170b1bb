//! What part of space does a camera see? A pyramid without its top (L7, Fig 7.7).

use glam::{Vec3, vec2, vec3};
use transforms::ViewVolume;

use crate::figure::{Drawing, Drawn, Figure, Text, Words};
use crate::parameter::{Parameter, Values};
use crate::sheet::view::View;
use crate::sheet::{Ink, Letters, Sheet, Side};

pub(super) static FIGURE: Figure = Figure {
    numbers: &["L7", "E2"],
    name: "viewing-volume",
    title: Text { en: "Viewing volume for ray tracing", nl: "Viewing volume voor ray tracing" },
    caption: Text {
        en: "Rays from e through the window [l, r] × [b, t] on the view plane w = n fill a pyramid; what lies between w = n and w = f is seen. The camera looks along −w, so n and f are negative (E2).",
        nl: "Stralen vanuit e door het venster [l, r] × [b, t] op het viewplane w = n vullen een piramide; wat tussen w = n en w = f ligt wordt gezien. De camera kijkt langs −w, dus n en f zijn negatief (E2).",
    },
    parameters: &[
        Parameter::number(
            "n",
            Text { en: "w-coordinate n of the near plane", nl: "w-coördinaat n van het near-vlak" },
            -2.0,
            -2.8,
            -1.2,
        ),
        Parameter::number(
            "f",
            Text { en: "w-coordinate f of the far plane", nl: "w-coördinaat f van het far-vlak" },
            -5.0,
            -6.0,
            -3.2,
        ),
        Parameter::number(
            "r",
            Text { en: "right edge r of the window", nl: "rechterrand r van het venster" },
            1.0,
            0.2,
            1.4,
        ),
        Parameter::number(
            "t",
            Text { en: "upper edge t of the window", nl: "bovenrand t van het venster" },
            0.8,
            0.2,
            1.2,
        ),
    ],
    size: (640, 480),
    draw,
};

fn draw(values: &Values) -> Drawn {
    let [near, far, right, top] = ["n", "f", "r", "t"].map(|name| values.number(name));
    let volume = ViewVolume { left: -0.8, right, bottom: -0.6, top, near, far };
    volume.validate()?;
    let corners = corners(&volume);
    let view = View::new(vec3(5.5, 3.0, 3.5), Vec3::ZERO)?;
    let at = |p: Vec3| view.at(p);
    let all: Vec<_> = corners.iter().map(|p| at(*p)).chain([at(1.1 * Vec3::Z), at(1.1 * Vec3::Y)]).collect();
    let mut sheet = Sheet::around(&all, vec2(760.0, 440.0), 44.0, 0.0);
    let flat = corners.map(at);
    sheet.wash(&flat[..4], Ink::A);
    sheet.polygon(&flat[..4], Ink::A.pen());
    sheet.polygon(&flat[4..], Ink::B.pen());
    for k in 0..4 {
        sheet.line(flat[k], flat[4 + k], Ink::Main.pen());
        sheet.line(at(Vec3::ZERO), flat[k], Ink::Faint.pen().dashed());
    }
    frame(&mut sheet, &view);
    names(&mut sheet, &view, &volume);
    let alt = Words::new(
        format!(
            "A pyramid with its top at the eye e, cut by the planes w = {near} and w = {far}; the window reaches from {} to {right} and from {} to {top}.",
            volume.left, volume.bottom
        ),
        format!(
            "Een piramide met de top in het oog e, afgesneden door de vlakken w = {near} en w = {far}; het venster loopt van {} tot {right} en van {} tot {top}.",
            volume.left, volume.bottom
        ),
    );
    Ok(vec![Drawing::diagram("", alt.clone(), sheet.svg(&alt))])
}

/// In camera space, near first, each anticlockwise from the lower left.
fn corners(volume: &ViewVolume) -> [Vec3; 8] {
    let ViewVolume { left, right, bottom, top, near, far } = *volume;
    let sides = [(left, bottom), (right, bottom), (right, top), (left, top)];
    std::array::from_fn(|k| {
        let (x, y) = sides[k % 4];
        let depth = if k < 4 { near } else { far };
        depth / near * vec3(x, y, near)
    })
}

fn frame(sheet: &mut Sheet, view: &View) {
    let e = view.at(Vec3::ZERO);
    for (axis, name, side) in
        [(Vec3::X, "u", Side::BelowRight), (Vec3::Y, "v", Side::Above), (Vec3::Z, "w", Side::BelowLeft)]
    {
        let tip = view.at(axis);
        sheet.arrow(e, tip, Ink::C.pen());
        sheet.label(tip, side, name, Letters::Vector, Ink::C);
    }
    sheet.dot(e, Ink::Main);
    sheet.label(e, Side::AboveRight, "e", Letters::Vector, Ink::Main);
}

fn names(sheet: &mut Sheet, view: &View, volume: &ViewVolume) {
    let ViewVolume { left, right, bottom, top, near, far } = *volume;
    let (x, y) = (0.5 * (left + right), 0.5 * (bottom + top));
    let edges = [
        ("l", vec3(left, y, near), Side::Left),
        ("r", vec3(right, y, near), Side::Right),
        ("b", vec3(x, bottom, near), Side::Below),
        ("t", vec3(x, top, near), Side::Above),
    ];
    for (name, p, side) in edges {
        sheet.label(view.at(p), side, name, Letters::Scalar, Ink::A);
    }
    let far_corner = far / near * vec3(right, bottom, near);
    sheet.label(view.at(far_corner), Side::Below, "w = f", Letters::Scalar, Ink::B);
    sheet.label(view.at(vec3(right, bottom, near)), Side::Below, "w = n", Letters::Scalar, Ink::A);
}
