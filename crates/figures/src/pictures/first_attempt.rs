//! What is wrong with c = c_l (e·r), and what does Phong's exponent mend? (L30, L31)

use canvas::{Image, Rgb};
use geometry::Sphere;
use glam::{Vec3, vec3};
use lighting::{phong_highlight, reflect};
use raytrace::{sphere, viewing_ray};
use transforms::{Camera, Pipeline, ViewVolume};

use super::studio::Fault;
use crate::figure::{Drawing, Drawn, Figure, Text, Words};
use crate::handle::without_handles;
use crate::parameter::{Parameter, Values};

pub(super) static FIGURE: Figure = Figure {
    numbers: &["L30", "L31"],
    name: "first-attempt",
    title: Text { en: "First attempt and Phong's highlight", nl: "Eerste poging en highlight van Phong" },
    caption: Text {
        en: "The highlight alone on a ball. The first attempt e·r (left) is negative on the far side, shown blue, and so wide that nearly the whole lit half gleams. max(0, e·r)^p (right) has neither fault.",
        nl: "Alleen de highlight op een bol. De eerste poging e·r (links) is negatief aan de afgekeerde kant, blauw getekend, en zo breed dat bijna de hele verlichte helft glanst. max(0, e·r)^p (rechts) heeft geen van beide fouten.",
    },
    parameters: &[
        Parameter::number("p", Text { en: "Phong exponent p", nl: "Phong-exponent p" }, 32.0, 0.0, 2000.0),
        Parameter::number(
            "light",
            Text {
                en: "angle of the light from the gaze, degrees",
                nl: "hoek van het licht met de kijkrichting, graden",
            },
            50.0,
            0.0,
            90.0,
        ),
    ],
    size: (360, 360),
    draw,
    handles: without_handles,
};

fn draw(values: &Values) -> Drawn {
    let (p, angle) = (values.number("p"), values.number("light").to_radians());
    let to_light = vec3(-angle.sin() * 0.8, angle.sin() * 0.6, angle.cos());
    let mut least = f32::INFINITY;
    let first = ball(values.size(), |n, to_eye| {
        let value = to_eye.dot(reflect(n, to_light));
        least = least.min(value);
        value
    })?;
    let phong = ball(values.size(), |n, to_eye| phong_highlight(n, to_light, to_eye, p))?;
    Ok(vec![
        Drawing::picture(
            "attempt",
            Words::new(
                format!(
                    "A ball that is white over most of its lit side and blue, which means negative, elsewhere; the least value is {least:.2}."
                ),
                format!(
                    "Een bol die wit is over het grootste deel van de verlichte kant en elders blauw, dat is negatief; de kleinste waarde is {least:.2}."
                ),
            ),
            first,
        ),
        Drawing::picture(
            "phong",
            Words::new(
                format!("A dark ball with one small white highlight, p = {p}."),
                format!("Een donkere bol met één kleine witte highlight, p = {p}."),
            ),
            phong,
        ),
    ])
}

/// A value at each point of a unit ball: white for 1, black for 0, blue below; grey beside the ball.
fn ball((width, height): (u32, u32), mut value: impl FnMut(Vec3, Vec3) -> f32) -> Result<Image, Fault> {
    const BESIDE: Rgb = Rgb::splat(0.08);
    /// Rays along each side of a pixel.
    const FINER: u32 = 2;
    let (width, height) = (FINER * width, FINER * height);
    let camera = Camera::look_at(vec3(0.0, 0.0, 6.0), Vec3::ZERO, Vec3::Y)?;
    // Up and down a little more than the ball; also sideways if the picture is narrow.
    let aspect = width as f32 / height as f32;
    let fov = 2.0 * (0.2 / aspect.min(1.0)).atan();
    let pipeline = Pipeline::new(camera, ViewVolume::from_fov_y(fov, aspect, -1.0, -9.0)?, width, height)?;
    let unit = Sphere::new(Vec3::ZERO, 1.0);
    let image = Image::from_fn(width, height, |i, j| {
        let ray = viewing_ray(&pipeline, i as f32, j as f32);
        let Some(t) = sphere::intersect(&ray, &unit, 0.0, f32::INFINITY) else {
            return BESIDE;
        };
        let n = ray.at(t).normalize();
        let value = value(n, -ray.direction.normalize());
        if value >= 0.0 { Rgb::splat(value) } else { Rgb::new(0.1, 0.25, 1.0) * -value }
    });
    Ok(image.box_downsampled(FINER))
}
