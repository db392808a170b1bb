//! Which way do the camera's own axes point? (L6, Fig 4.8)

use glam::{Vec2, Vec3, vec2, vec3};
use sheet::label_layout::Vector;
use sheet::text::triple;
use sheet::view::View;
use sheet::{Ink, Sheet};
use transforms::{Basis, DegenerateCamera};

use crate::figure::{Drawing, Drawn, Figure, Text, Words};
use crate::handle::{Handled, Handles, with_handles};
use crate::parameter::{Parameter, Values};

pub(super) static FIGURE: Figure = Figure {
    numbers: &["L6"],
    name: "camera-frame",
    title: Text { en: "The camera frame u, v, w", nl: "Het cameraframe u, v, w" },
    caption: Text {
        en: "w is opposite the view direction, u stands at a right angle to up and w, and v lies in the plane of up and w (tinted). Up itself need not be at a right angle to the view direction.",
        nl: "w is tegengesteld aan de kijkrichting, u staat loodrecht op up en w, en v ligt in het vlak van up en w (gekleurd). Up zelf hoeft niet loodrecht op de kijkrichting te staan.",
    },
    parameters: &[
        Parameter::number(
            "azimuth",
            Text { en: "view direction: turn about up, degrees", nl: "kijkrichting: draaiing om up, graden" },
            5.0,
            -180.0,
            180.0,
        ),
        Parameter::number(
            "elevation",
            Text {
                en: "view direction: above the horizon, degrees",
                nl: "kijkrichting: boven de horizon, graden",
            },
            -10.0,
            -75.0,
            75.0,
        ),
    ],
    size: (640, 480),
    draw,
    handles,
};

/// How long the arrow of up is: longer than v, which it may cover.
const LONG: f32 = 1.4;

/// The length of the view direction: it is told from the unit vectors, and −w lies under it.
const GAZE: f32 = 1.15;

fn view() -> Result<View, DegenerateCamera> {
    View::new(vec3(2.2, 2.6, 4.0), Vec3::ZERO)
}

fn sheet() -> Sheet {
    // Whichever way the camera looks, all arrows end in a circle; the longest name needs more room at the left.
    let seen = [vec2(-1.95, -1.25), vec2(1.3, LONG)];
    Sheet::around(&seen, vec2(760.0, 440.0), 24.0, 250.0)
}

fn draw(values: &Values) -> Drawn {
    let gaze = gaze(values.number("azimuth"), values.number("elevation"));
    let basis = Basis::from_gaze_and_up(gaze, Vec3::Y)?;
    let (view, mut sheet) = (view()?, sheet());
    plane_of_up_and_w(&mut sheet, &view, &basis);
    let tip = |p: Vec3| view.at(p);
    sheet.vectors(
        Vec2::ZERO,
        &[
            Vector::new("", tip(GAZE * gaze), Ink::Main).called("view direction", "kijkrichting"),
            Vector::new("up", tip(LONG * Vec3::Y), Ink::Main).dashed(),
            Vector::new("u", tip(basis.u), Ink::A),
            Vector::new("v", tip(basis.v), Ink::B),
            Vector::new("w", tip(basis.w), Ink::C),
        ],
    );
    sheet.dot(Vec2::ZERO, Ink::Main);
    let Basis { u, v, w } = basis;
    sheet.lines(
        505.0,
        60.0,
        [format!("u = {}", triple(u)), format!("v = {}", triple(v)), format!("w = {}", triple(w))],
    );
    let (u, v, w) = (triple(u), triple(v), triple(w));
    let alt = Words::new(
        format!("Five arrows from the eye: the view direction, up, and the frame u = {u}, v = {v}, w = {w}."),
        format!("Vijf pijlen vanuit het oog: de kijkrichting, up, en het frame u = {u}, v = {v}, w = {w}."),
    );
    with_handles(vec![Drawing::only(alt, |alt| sheet.svg(alt))], handles(values))
}

/// The unit vector along −z, raised by `elevation` and then turned about y by `azimuth`, both in degrees.
fn gaze(azimuth: f32, elevation: f32) -> Vec3 {
    let (sin_a, cos_a) = azimuth.to_radians().sin_cos();
    let (sin_e, cos_e) = elevation.to_radians().sin_cos();
    vec3(-sin_a * cos_e, sin_e, -cos_a * cos_e)
}

fn plane_of_up_and_w(sheet: &mut Sheet, view: &View, basis: &Basis) {
    let corner = |v: f32, w: f32| view.at(v * basis.v + w * basis.w);
    let corners = [corner(0.0, 0.0), corner(0.0, 1.0), corner(1.0, 1.0), corner(1.0, 0.0)];
    sheet.wash(&corners, Ink::B);
    sheet.polygon(&corners, Ink::Faint.pen().fine());
}

fn handles(values: &Values) -> Handled {
    let gaze = gaze(values.number("azimuth"), values.number("elevation"));
    let name = Text { en: "the view direction", nl: "de kijkrichting" };
    let tip = view()?.at(GAZE * gaze);
    Ok(vec![Handles::on(&sheet(), [(name, &["azimuth", "elevation"], tip)])])
}
