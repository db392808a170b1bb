//! Which of two points is in shadow? A ray from each to the light tells (L56, Fig 4.17).

use std::sync::Arc;

use canvas::Rgb;
use geometry::{Plane, Ray, shapes};
use glam::{Mat4, Vec2, Vec3, vec2, vec3};
use lighting::Light;
use raytrace::{Object, Shape, Surface, TracedMesh, World, nearest, shadow};

use crate::figure::{Drawing, Drawn, Figure, Text, Words};
use crate::parameter::{Parameter, Values};
use crate::sheet::{Ink, Letters, Sheet, Side};

pub(super) static FIGURE: Figure = Figure {
    numbers: &["L56", "E12"],
    name: "shadow-rays",
    title: Text { en: "Shadow rays", nl: "Schaduwstralen" },
    caption: Text {
        en: "Light comes from the direction l, from infinitely far. The ray from p meets nothing on its way there, so p is lit; the ray from q meets the box, so q is in shadow.",
        nl: "Licht komt uit de richting l, van oneindig ver. De straal vanuit p raakt onderweg niets, dus p is belicht; de straal vanuit q raakt de doos, dus q ligt in de schaduw.",
    },
    parameters: &[
        Parameter::number(
            "light",
            Text {
                en: "height of the light above the horizon, degrees",
                nl: "hoogte van het licht boven de horizon, graden",
            },
            50.0,
            15.0,
            165.0,
        ),
        Parameter::number(
            "q",
            Text { en: "place of q on the ground", nl: "plaats van q op de grond" },
            -1.3,
            -3.0,
            3.0,
        ),
    ],
    size: (640, 480),
    draw,
};

/// Width and height of the box, which stands on the ground around x = 0.
const BOX: Vec2 = vec2(1.2, 1.5);

fn draw(values: &Values) -> Drawn {
    let (angle, q) = (values.number("light").to_radians(), values.number("q"));
    let light = Light::Directional { to_light: vec3(angle.cos(), angle.sin(), 0.0), color: Rgb::ONE };
    let world = world(light)?;
    let mut sheet = Sheet::new(vec2(-4.0, -0.55), vec2(4.0, 3.2), 800.0);
    // The inside of a surface is drawn at its right, so the ground runs to the left.
    sheet.surface(vec2(-3.9, 0.0), vec2(3.9, 0.0));
    let corners = [(-0.5, 0.0), (0.5, 0.0), (0.5, 1.0), (-0.5, 1.0)].map(|(x, y)| BOX * vec2(x, y));
    sheet.wash(&corners, Ink::B);
    sheet.polygon(&corners, Ink::B.pen());
    let mut said = Vec::new();
    for (name, x, ink) in [("p", 2.1, Ink::C), ("q", q, Ink::A)] {
        let found = shadow_ray(&world, light, x)?;
        let pen = if found.is_lit { Ink::C.pen() } else { Ink::D.pen() };
        sheet.arrow(found.start, found.end, pen);
        if !found.is_lit {
            sheet.dot(found.end, Ink::D);
        }
        sheet.dot(found.start, ink);
        sheet.label(found.start, Side::Below, name, Letters::Vector, ink);
        said.push((name, found.is_lit));
    }
    let way = vec2(angle.cos(), angle.sin());
    let corner = vec2(if way.x > 0.0 { -3.6 } else { 3.6 }, 2.2);
    sheet.arrow(corner, corner + 0.7 * way, Ink::Main.pen());
    sheet.label(corner + 0.35 * way, Side::Left, "l", Letters::Vector, Ink::Main);
    let alt = alt(&said);
    Ok(vec![Drawing::diagram("", alt.clone(), sheet.svg(&alt))])
}

/// The ground and a box, deep enough to be a rectangle seen from the side.
fn world(light: Light) -> Result<World, Box<dyn std::error::Error + Send + Sync>> {
    let cuboid = shapes::cuboid(vec3(BOX.x, BOX.y, 2.0), 0)?;
    let place = Mat4::from_translation(vec3(0.0, 0.5 * BOX.y, 0.0));
    let surface = || vec![Surface::default()];
    let objects = vec![
        Object::new(Shape::Plane(Plane::new(Vec3::ZERO, Vec3::Y)), Mat4::IDENTITY, surface())?,
        Object::new(Shape::Mesh(Arc::new(TracedMesh::new(cuboid))), place, surface())?,
    ];
    Ok(World::new(objects, vec![light]))
}

/// A shadow ray as it is drawn.
struct Found {
    start: Vec2,
    end: Vec2,
    is_lit: bool,
}

/// The shadow ray from what is seen from above at `x`: the ground, or the top of the box.
fn shadow_ray(world: &World, light: Light, x: f32) -> Result<Found, &'static str> {
    /// How much of a ray that meets nothing is drawn.
    const LENGTH: f32 = 2.6;
    let from_above = Ray::new(vec3(x, 9.0, 0.0), Vec3::NEG_Y);
    let hit = nearest(world, &from_above, 0.0, f32::INFINITY).ok_or("there is no ground")?;
    let light = light.illumination(hit.point).ok_or("the light comes from nowhere")?;
    let ray = shadow::shadow_ray(world, &from_above, &hit, &light);
    let is_lit = shadow::is_lit(world, &from_above, &hit, &light);
    let end = nearest(world, &ray, 0.0, light.distance).map_or(LENGTH, |stop| stop.t);
    Ok(Found { start: hit.point.truncate(), end: ray.at(end).truncate(), is_lit })
}

fn alt(said: &[(&str, bool)]) -> Words {
    let en = said.iter().map(|(name, lit)| format!("{name} is {}", if *lit { "lit" } else { "in shadow" }));
    let nl = said
        .iter()
        .map(|(name, lit)| format!("{name} {}", if *lit { "is belicht" } else { "ligt in de schaduw" }));
    Words::new(
        format!(
            "A box on the ground and a ray towards the light from two points: {}.",
            en.collect::<Vec<_>>().join(", ")
        ),
        format!(
            "Een doos op de grond en een straal naar het licht vanuit twee punten: {}.",
            nl.collect::<Vec<_>>().join(", ")
        ),
    )
}
