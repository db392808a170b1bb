//! Is a point in shadow? A ray from it to the light tells (L56, Fig 4.17).

use canvas::Rgb;
use geometry::{Plane, Sphere};
use glam::{Mat4, Vec2, Vec3, vec2, vec3};
use lighting::{Illumination, Light};
use raytrace::shadow::{is_lit, shadow_ray};
use raytrace::{Object, Ray, Shape, Surface, World, nearest};
use sheet::{Ink, Letters, Sheet, Side};

use crate::figure::{Drawing, Drawn, Figure, Text, Words};
use crate::handle::{Handled, Handles, with_handles};
use crate::parameter::{Parameter, Values};

pub(super) static FIGURE: Figure = Figure {
    numbers: &["L56"],
    name: "shadow-rays",
    title: Text { en: "Shadow rays", nl: "Schaduwstralen" },
    caption: Text {
        en: "From each point goes a shadow ray p + t·l towards a light at infinity. If it meets an object, the point is in shadow; otherwise it is lit. The dark part of the ground is asked in the same way, point by point.",
        nl: "Vanuit elk punt gaat een schaduwstraal p + t·l naar een lichtbron op oneindig. Snijdt die een object, dan ligt het punt in schaduw; anders is het verlicht. Het donkere deel van de grond is op dezelfde manier bevraagd, punt voor punt.",
    },
    parameters: &[
        Parameter::number(
            "light",
            Text {
                en: "angle between the vertical and the light, degrees; positive to the right",
                nl: "hoek tussen de verticaal en het licht, graden; positief naar rechts",
            },
            35.0,
            -60.0,
            60.0,
        ),
        Parameter::number(
            "p",
            Text { en: "place of p on the ground", nl: "plaats van p op de grond" },
            1.2,
            -2.6,
            2.6,
        ),
        Parameter::number(
            "q",
            Text { en: "place of q on the ground", nl: "plaats van q op de grond" },
            -0.9,
            -2.6,
            2.6,
        ),
    ],
    size: (640, 480),
    draw,
    handles,
};

const CENTER: Vec3 = vec3(0.1, 1.5, 0.0);
const RADIUS: f32 = 0.55;
/// The ends of what is drawn.
const LEFT: f32 = -3.4;
const RIGHT: f32 = 3.4;
const TOP: f32 = 2.9;

fn to_light(angle: f32) -> Vec3 {
    let (sin, cos) = angle.to_radians().sin_cos();
    vec3(sin, cos, 0.0)
}

fn sheet() -> Sheet {
    Sheet::around(&[vec2(LEFT, -0.75), vec2(RIGHT, TOP)], vec2(760.0, 440.0), 20.0, 0.0)
}

fn draw(values: &Values) -> Drawn {
    let [angle, p, q] = ["light", "p", "q"].map(|name| values.number(name));
    let to_light = to_light(angle);
    let world = world(to_light)?;
    let light = world.lights[0].illumination(Vec3::ZERO).ok_or("a light without a direction")?;
    let mut sheet = sheet();
    ground(&mut sheet, &world, &light);
    sheet.wash(&circle(), Ink::B);
    sheet.polygon(&circle(), Ink::B.pen());
    sheet.label(CENTER.truncate(), Side::Middle, Words::new("object", "object"), Letters::Plain, Ink::B);
    let lit = [p, q].map(|x| ray_to_light(&mut sheet, &world, &light, x));
    let below = vec2(0.0, -sheet.units(26.0));
    let names = [(p, "p", lit[0]), (q, "q", lit[1])];
    // The direction is the same everywhere; its name stands at both rays, on the side away from the vertical.
    let beside = 0.7 * to_light.truncate() + sheet.units(15.0) * to_light.truncate().perp();
    let letters = names.map(|(x, _, lit)| (vec2(x, 0.0) + beside, "l", ink(lit)));
    let points = names.map(|(x, name, lit)| (vec2(x, 0.0) + below, name, ink(lit)));
    sheet.names(&[letters, points].concat());
    let words = names.map(|(_, name, lit)| verdict(name, lit));
    for ((left, words), (_, _, lit)) in [30.0, 260.0].into_iter().zip(&words).zip(names) {
        let place = sheet.place(left, 415.0);
        sheet.label(place, Side::Right, words.clone(), Letters::Plain, ink(lit));
    }
    let alt = Words::new(
        format!(
            "A ball above the ground, light from {angle:.1}° off the vertical: {}; {}.",
            words[0].en, words[1].en
        ),
        format!(
            "Een bol boven de grond, licht van {angle:.1}° naast de verticaal: {}; {}.",
            words[0].nl, words[1].nl
        ),
    );
    with_handles(vec![Drawing::only(alt, |alt| sheet.svg(alt))], handles(values))
}

fn world(to_light: Vec3) -> Result<World, raytrace::ObjectError> {
    let object = |shape| Object::new(shape, Mat4::IDENTITY, vec![Surface::default()]);
    let ground = object(Shape::Plane(Plane::new(Vec3::ZERO, Vec3::Y)))?;
    let ball = object(Shape::Sphere(Sphere::new(CENTER, RADIUS)))?;
    Ok(World::new(vec![ground, ball], vec![Light::Directional { to_light, color: Rgb::ONE }]))
}

/// The shadow ray from the ground at x, and whether it is free. It starts where a ray from just above meets the ground.
fn shadow_ray_from(world: &World, light: &Illumination, x: f32) -> Option<(Ray, bool)> {
    let down = Ray::new(vec3(x, 0.5 * (CENTER.y - RADIUS), 0.0), Vec3::NEG_Y);
    let hit = nearest(world, &down, 0.0, f32::INFINITY)?;
    Some((shadow_ray(world, &down, &hit, light), is_lit(world, &down, &hit, light)))
}

/// The ground from the side; where no light arrives a broad line.
fn ground(sheet: &mut Sheet, world: &World, light: &Illumination) {
    /// A stretch of ground is a few pixels wide.
    const STRETCHES: u16 = 340;
    sheet.surface(vec2(LEFT, 0.0), vec2(RIGHT, 0.0));
    let width = (RIGHT - LEFT) / f32::from(STRETCHES);
    for k in 0..STRETCHES {
        let x = LEFT + width * (f32::from(k) + 0.5);
        if shadow_ray_from(world, light, x).is_some_and(|(_, is_lit)| !is_lit) {
            let half = vec2(0.5 * width, 0.0);
            sheet.line(vec2(x, 0.0) - half, vec2(x, 0.0) + half, Ink::D.pen().wide());
        }
    }
}

fn circle() -> Vec<Vec2> {
    let point = |k: u16| CENTER.truncate() + RADIUS * Vec2::from_angle(f32::from(k).to_radians());
    (0..360).step_by(3).map(point).collect()
}

/// Draws the ray, up to the edge of the drawing or to what it meets.
fn ray_to_light(sheet: &mut Sheet, world: &World, light: &Illumination, x: f32) -> bool {
    let Some((ray, is_lit)) = shadow_ray_from(world, light, x) else {
        return true;
    };
    let ink = ink(is_lit);
    sheet.dot(ray.origin.truncate(), ink);
    let leaves = end_of_sheet(&ray);
    if let Some(hit) = nearest(world, &ray, 0.0, light.distance) {
        let stop = hit.point.truncate();
        sheet.line(ray.origin.truncate(), stop, ink.pen());
        sheet.dot(stop, ink);
        sheet.line(stop, leaves, Ink::Faint.pen().dashed().fine());
    } else {
        sheet.arrow(ray.origin.truncate(), leaves, ink.pen());
    }
    is_lit
}

/// Where the ray leaves the drawing: at its top, or at a side before.
fn end_of_sheet(ray: &Ray) -> Vec2 {
    let d = ray.direction;
    let up = (TOP - ray.origin.y) / d.y;
    let aside = if d.x > 0.0 { (RIGHT - ray.origin.x) / d.x } else { (LEFT - ray.origin.x) / d.x };
    // Straight up the second is infinite.
    ray.at(up.min(if aside.is_nan() { up } else { aside.abs() })).truncate()
}

fn ink(is_lit: bool) -> Ink {
    if is_lit { Ink::A } else { Ink::D }
}

fn verdict(name: &str, is_lit: bool) -> Words {
    if is_lit {
        Words::new(format!("{name} is lit"), format!("{name} is verlicht"))
    } else {
        Words::new(format!("{name} is in shadow"), format!("{name} ligt in schaduw"))
    }
}

fn handles(values: &Values) -> Handled {
    let [angle, p, q] = ["light", "p", "q"].map(|name| values.number(name));
    // The light is infinitely far away; it is taken by the end of the ray that leads to it from p.
    let end = end_of_sheet(&Ray::new(vec3(p, 0.0, 0.0), to_light(angle)));
    let list: [(Text, &[&str], Vec2); 3] = [
        (Text { en: "the light", nl: "het licht" }, &["light"], end),
        (Text { en: "the point p", nl: "het punt p" }, &["p"], vec2(p, 0.0)),
        (Text { en: "the point q", nl: "het punt q" }, &["q"], vec2(q, 0.0)),
    ];
    Ok(vec![Handles::on(&sheet(), list)])
}
