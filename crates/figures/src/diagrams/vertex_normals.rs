//! For which surface do vertex normals stand? For the curved one that the polygons replace (L39, Fig 10.4).

use std::f32::consts::TAU;

use geometry::Mesh;
use glam::{Vec2, Vec3, vec2, vec3};

use crate::figure::{Drawing, Drawn, Figure, Text, Words};
use crate::parameter::{Parameter, Values};
use crate::sheet::text::{decimal, degrees};
use crate::sheet::{Ink, Letters, Sheet, Side};

pub(super) static FIGURE: Figure = Figure {
    numbers: &["L39"],
    name: "octagon-and-circle",
    title: Text { en: "Normals for Gouraud shading", nl: "Normaalvectoren bij Gouraud shading" },
    caption: Text {
        en: "A circle (left) is replaced by a polygon (right). The normals of its sides are wrong by up to half the angle of a side; the normals at its corners, the mean of the two sides around, are those of the circle.",
        nl: "Een cirkel (links) wordt vervangen door een veelhoek (rechts). De normalen van de zijden wijken tot de halve hoek van een zijde af; de normalen in de hoekpunten, het gemiddelde van de twee zijden eromheen, zijn die van de cirkel.",
    },
    parameters: &[Parameter::count(
        "corners",
        Text { en: "corners of the polygon", nl: "hoekpunten van de veelhoek" },
        8.0,
        3.0,
        24.0,
    )],
    size: (640, 480),
    draw,
};

fn draw(values: &Values) -> Drawn {
    let n = values.count("corners");
    let tube = tube(n)?;
    // A tube has no hard edge, however few its sides.
    let normals = shading::vertex_normals(&tube, std::f32::consts::PI);
    let corners: Vec<(Vec2, Vec2)> = (0..n as usize)
        .map(|k| {
            // Side k is triangles 2k and 2k + 1; its first corner is corner k of the ring below.
            let normal = normals.values[normals.triangles[2 * k][0] as usize];
            (on_sheet(tube.triangle(2 * k).a), on_sheet(normal))
        })
        .collect();
    let worst = corners.iter().map(|(p, normal)| p.angle_to(*normal).abs()).fold(0.0, f32::max);
    let side = tube.triangle(0).normal().map_or(0.0, |normal| on_sheet(normal).angle_to(corners[0].0).abs());

    let mut sheet = Sheet::new(vec2(-1.75, -1.8), vec2(5.25, 1.75), 840.0);
    let right = vec2(3.5, 0.0);
    sheet.circle(Vec2::ZERO, 1.0, Ink::B.pen());
    sheet.circle(right, 1.0, Ink::Faint.pen().dashed());
    let outline: Vec<Vec2> = corners.iter().map(|corner| right + corner.0).collect();
    sheet.polygon(&outline, Ink::B.pen());
    for (p, normal) in &corners {
        sheet.arrow(*p, 1.55 * *p, Ink::A.pen());
        sheet.arrow(right + *p, right + *p + 0.55 * *normal, Ink::A.pen());
        sheet.dot(right + *p, Ink::B);
    }
    let words = Words::new(
        format!("at the corners off by {}, on the sides by up to {}", degrees(worst), degrees(side)),
        format!("in de hoekpunten {} ernaast, op de zijden tot {}", degrees(worst), degrees(side)),
    );
    sheet.label(vec2(1.75, -1.75), Side::Above, words, Letters::Plain, Ink::Main);
    let alt = Words::new(
        format!(
            "A circle and a polygon of {n} corners with normals; at the corners they agree to {}°, on the sides they are off by up to {}.",
            decimal(worst.to_degrees(), 3),
            degrees(side)
        ),
        format!(
            "Een cirkel en een veelhoek van {n} hoekpunten met normalen; in de hoekpunten gelijk op {}° na, op de zijden tot {} ernaast.",
            decimal(worst.to_degrees(), 3),
            degrees(side)
        ),
    );
    Ok(vec![Drawing::diagram("", alt.clone(), sheet.svg(&alt))])
}

/// A tube of n sides around the z axis, its corners on the unit circle; two triangles a side.
fn tube(n: u32) -> Result<Mesh, geometry::MeshError> {
    let angle = |k: u32| TAU * (k as f32 + 0.5) / n as f32;
    let ring = |z: f32| (0..n).map(move |k| vec3(angle(k).cos(), angle(k).sin(), z));
    let positions = ring(-1.0).chain(ring(1.0)).collect();
    let side = |k: u32| {
        let next = (k + 1) % n;
        [[k, next, n + next], [k, n + next, n + k]]
    };
    Mesh::new(positions, (0..n).flat_map(side).collect())
}

/// Seen along the tube.
fn on_sheet(p: Vec3) -> Vec2 {
    p.truncate()
}
