//! Which way are right, up and back for a camera? (L6, Fig 4.8)

use glam::{Vec2, Vec3, vec2, vec3};
use transforms::Basis;

use crate::figure::{Drawing, Drawn, Figure, Text, Words};
use crate::parameter::{Parameter, Values};
use crate::sheet::crowd::Vector;
use crate::sheet::text::triple;
use crate::sheet::view::View;
use crate::sheet::{Ink, Sheet};

pub(super) static FIGURE: Figure = Figure {
    numbers: &["L6", "L1"],
    name: "camera-frame",
    title: Text { en: "The camera frame u, v, w", nl: "Het camera-assenstelsel u, v, w" },
    caption: Text {
        en: "w points against the gaze. u = up × w is perpendicular to both, and v = w × u lies in the plane of w and up (coloured), as upright as it can be. All three are unit vectors.",
        nl: "w wijst tegen de kijkrichting in. u = up × w staat loodrecht op beide, en v = w × u ligt in het vlak van w en up (gekleurd), zo rechtop als kan. Alle drie zijn eenheidsvectoren.",
    },
    parameters: &[
        Parameter::number(
            "turn",
            Text { en: "turn of the gaze, degrees", nl: "draaiing van de kijkrichting, graden" },
            25.0,
            -80.0,
            80.0,
        ),
        Parameter::number(
            "down",
            Text { en: "gaze below the horizon, degrees", nl: "kijkrichting onder de horizon, graden" },
            25.0,
            -80.0,
            80.0,
        ),
    ],
    size: (640, 480),
    draw,
};

/// How long the gaze and up are drawn; both may have any length.
const LENGTH: f32 = 1.25;

fn draw(values: &Values) -> Drawn {
    let [turn, down] = ["turn", "down"].map(|name| values.number(name).to_radians());
    let gaze = LENGTH * vec3(turn.sin() * down.cos(), -down.sin(), -turn.cos() * down.cos());
    let up = LENGTH * Vec3::Y;
    let Basis { u, v, w } = Basis::from_gaze_and_up(gaze, up)?;
    let view = View::new(vec3(4.0, 2.0, 3.2), Vec3::ZERO)?;
    // Everything fits whichever way the camera looks.
    let seen = [vec2(-1.3, -1.3), vec2(1.3, 1.35)];
    let mut sheet = Sheet::around(&seen, vec2(760.0, 430.0), 24.0, 250.0);
    let plane = [w, up / LENGTH, -w, -up / LENGTH].map(|p| view.at(1.05 * p));
    sheet.wash(&plane, Ink::Faint);
    sheet.vectors(
        Vec2::ZERO,
        &[
            Vector::new("gaze", view.at(gaze), Ink::Faint).called("gaze", "kijkrichting").dashed(),
            Vector::new("up", view.at(up), Ink::Faint).dashed(),
            Vector::new("u", view.at(u), Ink::A),
            Vector::new("v", view.at(v), Ink::C),
            Vector::new("w", view.at(w), Ink::B),
        ],
    );
    sheet.dot(Vec2::ZERO, Ink::Main);
    sheet.lines(
        490.0,
        70.0,
        [format!("u = {}", triple(u)), format!("v = {}", triple(v)), format!("w = {}", triple(w))],
    );
    let alt = Words::new(
        format!(
            "A camera looks along {}; its frame is u = {}, v = {}, w = {}.",
            triple(gaze),
            triple(u),
            triple(v),
            triple(w)
        ),
        format!(
            "Een camera kijkt langs {}; zijn assen zijn u = {}, v = {}, w = {}.",
            triple(gaze),
            triple(u),
            triple(v),
            triple(w)
        ),
    );
    Ok(vec![Drawing::diagram("", alt.clone(), sheet.svg(&alt))])
}
