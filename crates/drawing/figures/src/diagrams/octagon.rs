//! Which way does the curve face that a polygon stands for? (L39, Fig 10.4)

use std::f32::consts::{PI, TAU};

use geometry::{Mesh, MeshError};
use glam::{Vec2, Vec3, vec2};
use shading::vertex_normals;
use sheet::text::degrees;
use sheet::{Ink, Letters, Sheet, Side};

use crate::figure::{Drawing, Drawn, Figure, Text, Words};
use crate::handle::without_handles;
use crate::parameter::{Parameter, Values};

pub(super) static FIGURE: Figure = Figure {
    numbers: &["L39"],
    name: "octagon",
    title: Text { en: "Normals for Gouraud shading", nl: "Normaalvectoren bij Gouraud shading" },
    caption: Text {
        en: "A circle at the left, a polygon that stands for it at the right. The normals of the sides (thin) jump at the corners. The vertex normals, each the mean of its two sides' normals, are those of the circle.",
        nl: "Links een cirkel, rechts een veelhoek die hem vervangt. De normalen van de zijden (dun) verspringen bij de hoeken. De hoekpuntnormalen, elk het gemiddelde van de normalen van twee zijden, zijn die van de cirkel.",
    },
    parameters: &[Parameter::count(
        "corners",
        Text { en: "number of corners", nl: "aantal hoekpunten" },
        8.0,
        3.0,
        24.0,
    )],
    size: (640, 480),
    draw,
    handles: without_handles,
};

/// The length of the normals, in radii of the circle.
const LENGTH: f32 = 0.36;
const CIRCLE: Vec2 = vec2(-1.75, 0.0);
const POLYGON: Vec2 = vec2(1.4, 0.0);

fn draw(values: &Values) -> Drawn {
    let corners = values.count("corners");
    let column = column(corners)?;
    // With 3 corners the sides meet at 120°: every angle is to be rounded.
    let normals = vertex_normals(&column, PI);
    let mut sheet = Sheet::around(&[vec2(-3.2, -1.85), vec2(3.2, 1.4)], vec2(760.0, 430.0), 10.0, 0.0);
    sheet.circle(CIRCLE, 1.0, Ink::Main.pen());
    let outline: Vec<Vec2> =
        (0..corners).map(|k| POLYGON + flat(column.triangle(2 * k as usize).a)).collect();
    sheet.polygon(&outline, Ink::Main.pen());
    let (mut worst_side, mut worst_vertex) = (0.0_f32, 0.0_f32);
    for side in 0..corners {
        // Each side of the column is two triangles; corner a of the first is this corner, at the bottom.
        let k = 2 * side as usize;
        let (triangle, ends) = (column.triangle(k), [column.triangle(k).a, column.triangle(k).b]);
        let face = triangle.normal().ok_or("a side without area")?;
        let vertex = normals.values[normals.triangles[k][0] as usize];
        let circle = flat(ends[0]).normalize();
        worst_side = worst_side.max(flat(face).angle_to(circle).abs());
        worst_vertex = worst_vertex.max(flat(vertex).angle_to(circle).abs());
        let [from, to] = ends.map(|end| POLYGON + flat(end));
        let middle = 0.5 * (from + to);
        sheet.arrow(middle, middle + 0.6 * LENGTH * flat(face), Ink::Faint.pen().fine());
        sheet.arrow(CIRCLE + circle, CIRCLE + (1.0 + LENGTH) * circle, Ink::B.pen());
        sheet.arrow(from, from + LENGTH * flat(vertex), Ink::A.pen());
        sheet.dot(CIRCLE + circle, Ink::B);
        sheet.dot(from, Ink::A);
    }
    let (side, vertex) = (degrees(worst_side), degrees(worst_vertex));
    words(&mut sheet, &side, &vertex);
    let alt = Words::new(
        format!(
            "A circle and a polygon with {corners} corners. At its corners the normals of the sides differ from the circle's by {side}, the vertex normals by {vertex}."
        ),
        format!(
            "Een cirkel en een veelhoek met {corners} hoekpunten. Bij de hoekpunten wijken de normalen van de zijden {side} af van die van de cirkel, de hoekpuntnormalen {vertex}."
        ),
    );
    Ok(vec![Drawing::only(alt, |alt| sheet.svg(alt))])
}

/// What the sheet shows of a vector of space: the column is seen from above.
fn flat(p: Vec3) -> Vec2 {
    p.truncate()
}

/// A column without lids whose ground plan is the regular polygon with its corners on the unit circle.
fn column(corners: u32) -> Result<Mesh, MeshError> {
    let corner = |k: u32| Vec2::from_angle(TAU * (k as f32 + 0.5) / corners as f32);
    let positions = (0..corners).flat_map(|k| [corner(k).extend(0.0), corner(k).extend(1.0)]).collect();
    let side = |k: u32| {
        let next = (k + 1) % corners;
        [[2 * k, 2 * next, 2 * next + 1], [2 * k, 2 * next + 1, 2 * k + 1]]
    };
    Mesh::new(positions, (0..corners).flat_map(side).collect())
}

fn words(sheet: &mut Sheet, side: &str, vertex: &str) {
    let circle = Words::new("normals of the circle", "normalen van de cirkel");
    let sides = Words::new(
        format!("sides: off by {side} at the corners"),
        format!("zijden: {side} ernaast bij de hoeken"),
    );
    let vertices =
        Words::new(format!("vertex normals: off by {vertex}"), format!("hoekpuntnormalen: {vertex} ernaast"));
    for (center, line, words, ink) in
        [(CIRCLE, 0.0, circle, Ink::B), (POLYGON, 0.0, vertices, Ink::A), (POLYGON, 1.0, sides, Ink::Main)]
    {
        let place = center - vec2(0.0, 1.55 + sheet.units(25.0 * line));
        sheet.label(place, Side::Middle, words, Letters::Plain, ink);
    }
}
