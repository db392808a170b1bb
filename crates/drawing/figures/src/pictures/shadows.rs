//! What does a shadow ray change? (L56, L57)

use canvas::Rgb;
use glam::{Vec2, Vec3, vec2, vec3};
use lighting::Light;
use scene::{Object, Renderer, Scene, Settings, Shape, Transform};
use sheet::text::triple;
use sheet::view::View;
use sheet::{Ink, Letters, Sheet, Side};
use transforms::{Camera, DegenerateCamera, Pipeline, ViewVolume};

use super::studio::{Fault, ambient, checked, materials, matte, seen_from, settings, shot, surface};
use crate::figure::{Drawing, Drawn, Figure, Text, Words};
use crate::handle::{Handled, Handles, in_picture, with_handles};
use crate::parameter::{Parameter, Values};

pub(super) static FIGURE: Figure = Figure {
    numbers: &["L56", "L57"],
    name: "shadows",
    title: Text { en: "Ray tracing with shadows", nl: "Ray tracing met schaduwen" },
    caption: Text {
        en: "From each visible point a ray goes to the light. Where it meets an object, diffuse and specular light are left out and ambient light alone remains. The drawing from outside shows where the light is.",
        nl: "Van elk zichtbaar punt gaat een straal naar het licht. Waar die een object raakt vervallen diffuus en spiegelend licht, en blijft alleen het omgevingslicht over. De tekening van buiten toont waar het licht is.",
    },
    parameters: &[
        Parameter::number("x", Text { en: "x of the light", nl: "x van het licht" }, -3.0, -6.0, 6.0),
        Parameter::number(
            "y",
            Text { en: "height of the light", nl: "hoogte van het licht" },
            5.0,
            2.5,
            12.0,
        ),
        Parameter::number("z", Text { en: "z of the light", nl: "z van het licht" }, 3.5, -6.0, 6.0),
    ],
    size: (400, 300),
    draw,
    handles,
};

/// The camera of the pictures, the angle in degrees.
const EYE: Vec3 = vec3(1.5, 3.4, 8.0);
const TARGET: Vec3 = vec3(0.0, 0.7, 0.0);
const FOV: f32 = 36.0;
/// The red ball, whose top throws the shadow that can be taken.
const BALL: Vec3 = vec3(-0.6, 0.9, 0.5);
const RADIUS: f32 = 0.9;
const TOP: Vec3 = vec3(BALL.x, BALL.y + RADIUS, BALL.z);

fn draw(values: &Values) -> Drawn {
    let lamp = lamp(values);
    let loaded = checked(&still_life(lamp))?;
    let drawing = |(shadows, name, alt): (bool, &str, Text)| -> Result<Drawing, Fault> {
        let settings = Settings { shadows, ..settings(&loaded, Renderer::Raytrace, values.size()) };
        Ok(Drawing::picture(name, alt, shot(&loaded, &settings)?))
    };
    let with = Text {
        en: "A ball, a box and a ring with shadows on the floor and on each other.",
        nl: "Een bol, een blok en een ring met schaduwen op de vloer en op elkaar.",
    };
    let without = Text {
        en: "The same without shadows: the ring might lie or float anywhere.",
        nl: "Hetzelfde zonder schaduwen: de ring kan overal liggen of zweven.",
    };
    let mut drawings = Vec::new();
    for which in [(false, "without-shadow", without), (true, "with-shadow", with)] {
        drawings.push(drawing(which)?);
    }
    drawings.push(from_outside(lamp)?);
    with_handles(drawings, handles(values))
}

/// Returns a ball, a box and a ring on a floor, lit by the lamp.
fn still_life(lamp: Vec3) -> Scene {
    let turned = |degrees: f32, axis: Vec3| Transform::Rotate { degrees, axis };
    let floor = vec![[-60.0, 12.0], [60.0, 12.0], [60.0, -60.0], [-60.0, -60.0]];
    let floor = floor.into_iter().map(|[x, z]| vec3(x, 0.0, z)).collect();
    Scene {
        background: vec3(0.45, 0.55, 0.68),
        lights: vec![ambient(0.28), Light::Point { position: lamp, color: Rgb::splat(0.66) }],
        materials: materials([
            ("floor", matte(vec3(0.66, 0.64, 0.58))),
            ("red", surface(vec3(0.62, 0.12, 0.08), 0.4, 60.0)),
            ("blue", surface(vec3(0.12, 0.26, 0.62), 0.3, 40.0)),
            ("ochre", surface(vec3(0.66, 0.46, 0.12), 0.2, 20.0)),
        ]),
        objects: vec![
            Object::new(Shape::Polygons { polygons: vec![floor] }, "floor"),
            Object::new(Shape::Sphere { radius: 1.0, level: 5 }, "red")
                .moved([Transform::Scale(Vec3::splat(RADIUS)), Transform::Translate(BALL)]),
            Object::new(Shape::Cuboid { size: vec3(1.1, 1.9, 1.1), level: 3 }, "blue")
                .moved([turned(30.0, Vec3::Y), Transform::Translate(vec3(1.6, 0.95, -0.7))]),
            Object::new(Shape::Torus { major: 0.75, minor: 0.22, level: 4 }, "ochre").moved([
                turned(68.0, Vec3::X),
                turned(25.0, Vec3::Y),
                Transform::Translate(vec3(-2.2, 0.9, -0.9)),
            ]),
        ],
        ..seen_from(EYE, TARGET, FOV)
    }
}

fn lamp(values: &Values) -> Vec3 {
    ["x", "y", "z"].map(|axis| values.number(axis)).into()
}

/// The lamp is beside the picture, so there it is taken by the shadow of the ball's top; from outside by itself and by the place
/// below it.
fn handles(values: &Values) -> Handled {
    let (lamp, (width, height)) = (lamp(values), values.size());
    let aspect = width as f32 / height as f32;
    // Near and far do not matter to where something is seen.
    let volume = ViewVolume::from_fov_y(FOV.to_radians(), aspect, -1.0, -100.0)?;
    let pipeline = Pipeline::new(Camera::look_at(EYE, TARGET, Vec3::Y)?, volume, width, height)?;
    let size = vec2(width as f32, height as f32);
    let name = Text { en: "the shadow of the ball's top", nl: "de schaduw van de top van de bol" };
    let view = outside()?;
    let list: [(Text, &[&str], Vec2); 2] = [
        (Text { en: "the light", nl: "het licht" }, &["x", "y"], view.at(lamp)),
        (
            Text { en: "the place below the light", nl: "de plek onder het licht" },
            &["x", "z"],
            view.at(on_the_floor(lamp)),
        ),
    ];
    Ok(vec![
        Handles::none(size),
        // A low lamp at the back throws the shadow behind the eye; then there is nothing to take.
        match in_picture(&pipeline, shadow(lamp)) {
            Some(shadow) => Handles::none(size).and(name, &["x", "z"], shadow),
            None => Handles::none(size),
        },
        Handles::on(&sheet(&view), list),
    ])
}

/// Where the shadow of the ball's top falls: the lamp is always higher.
fn shadow(lamp: Vec3) -> Vec3 {
    let down = lamp.y / (lamp.y - TOP.y);
    on_the_floor(lamp + down * (TOP - lamp))
}

fn on_the_floor(p: Vec3) -> Vec3 {
    vec3(p.x, 0.0, p.z)
}

fn outside() -> Result<View, DegenerateCamera> {
    View::new(vec3(4.0, 4.0, 9.0), Vec3::ZERO)
}

/// The sides of the floor that is drawn, left and right of the middle: the lamp stays above it.
const FLOOR: f32 = 6.0;
/// The lamp gets no higher.
const CEILING: f32 = 12.0;

/// A sheet that shows every place that the lamp can have.
fn sheet(view: &View) -> Sheet {
    let ends = [-FLOOR, FLOOR];
    let places = ends.into_iter().flat_map(|x| ends.map(|z| vec2(x, z)));
    let seen: Vec<Vec2> =
        places.flat_map(|at| [0.0, CEILING].map(|y| view.at(vec3(at.x, y, at.y)))).collect();
    Sheet::around(&seen, vec2(640.0, 560.0), 24.0, 0.0)
}

/// The lamp above the floor, and how it throws the shadow of the ball.
fn from_outside(lamp: Vec3) -> Result<Drawing, Fault> {
    let view = outside()?;
    let mut sheet = sheet(&view);
    let at = |p: Vec3| view.at(p);
    let floor = [(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)];
    let floor = floor.map(|(x, z)| at(FLOOR * vec3(x, 0.0, z)));
    sheet.wash(&floor, Ink::Faint);
    sheet.polygon(&floor, Ink::Faint.pen());
    sheet.circle(at(BALL), RADIUS, Ink::B.pen());
    let (foot, shadow) = (on_the_floor(lamp), shadow(lamp));
    sheet.line(at(foot), at(lamp), Ink::Faint.pen().dashed());
    sheet.line(at(lamp), at(TOP), Ink::A.pen());
    sheet.line(at(TOP), at(shadow), Ink::D.pen().dashed());
    sheet.dot(at(foot), Ink::Faint);
    sheet.dot(at(shadow), Ink::D);
    sheet.dot(at(lamp), Ink::A);
    sheet.label(at(lamp), Side::Right, Words::new("light", "licht"), Letters::Plain, Ink::A);
    sheet.label(at(BALL), Side::Middle, Words::new("ball", "bol"), Letters::Plain, Ink::B);
    let alt = Words::new(
        format!(
            "From outside: the light at {} above the floor, and the way from it past the top of the ball to its shadow at {}.",
            triple(lamp),
            triple(shadow)
        ),
        format!(
            "Van buiten: het licht op {} boven de vloer, en de weg ervan langs de top van de bol naar zijn schaduw op {}.",
            triple(lamp),
            triple(shadow)
        ),
    );
    Ok(Drawing::diagram("from-outside", alt.clone(), sheet.svg(&alt)))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_handle_is_seen_by_the_camera_of_the_scene() {
        let values = Values::of(&FIGURE);
        let picture = |lists: Vec<Handles>| lists[1].handles[0].at;
        let at = picture(handles(&values).unwrap());
        let Drawing { content, .. } = &draw(&values).unwrap()[1];
        let crate::figure::Content::Picture(with) = content else { panic!("lines") };
        let size = vec2(with.width() as f32, with.height() as f32);
        let pixel = (at * size).as_uvec2();
        let place = with.pixels()[(pixel.y * with.width() + pixel.x) as usize];
        // Ambient light alone: 0.28 of the floor's colour.
        assert!(place.abs_diff_eq(0.28 * vec3(0.66, 0.64, 0.58), 0.01), "{place} at {pixel}");
    }
}
