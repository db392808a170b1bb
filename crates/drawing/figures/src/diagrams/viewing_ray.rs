//! Which points lie on the ray from the eye through a pixel? (L46, L47, Fig 4.6)

use std::error::Error;

use glam::{Vec2, Vec3, vec2, vec3};
use raytrace::{Ray, viewing_ray};
use sheet::text::{decimal, triple};
use sheet::view::View;
use sheet::{Ink, Sheet};
use transforms::{Camera, DegenerateCamera, Pipeline, ViewVolume};

use crate::figure::{Drawing, Drawn, Figure, Text, Words};
use crate::handle::{Handled, Handles, with_handles};
use crate::parameter::{Parameter, Values};

pub(super) static FIGURE: Figure = Figure {
    numbers: &["L46", "L47"],
    name: "viewing-ray",
    title: Text { en: "Computing viewing rays", nl: "Berekenen viewing rays" },
    caption: Text {
        en: "The line p(t) = e + t(s − e) starts in the eye, p(0) = e, and crosses the image plane in the pixel, p(1) = s. Of two points before the eye the one with the smaller t is nearer; points with t < 0 lie behind the eye.",
        nl: "De lijn p(t) = e + t(s − e) begint in het oog, p(0) = e, en snijdt het beeldvlak in de pixel, p(1) = s. Van twee punten voor het oog is dat met de kleinste t het dichtst bij; punten met t < 0 liggen achter het oog.",
    },
    parameters: &[
        Parameter::count("i", Text { en: "column i of 8", nl: "kolom i van 8" }, 6.0, 0.0, 7.0),
        Parameter::count("j", Text { en: "row j of 6, upwards", nl: "rij j van 6, omhoog" }, 4.0, 0.0, 5.0),
        Parameter::number("t", Text { en: "t of the point p(t)", nl: "t van het punt p(t)" }, 1.7, -0.6, 2.5),
    ],
    size: (640, 480),
    draw,
    handles,
};

const WIDTH: u32 = 8;
const HEIGHT: u32 = 6;
/// How far the line is drawn.
const LEAST_T: f32 = -0.6;
const GREATEST_T: f32 = 2.5;

fn pipeline() -> Result<Pipeline, Box<dyn Error + Send + Sync>> {
    let camera = Camera::look_at(vec3(1.0, 2.0, 5.0), vec3(1.0, 2.0, 0.0), Vec3::Y)?;
    let volume = ViewVolume { left: -1.6, right: 1.6, bottom: -1.2, top: 1.2, near: -2.4, far: -12.0 };
    Ok(Pipeline::new(camera, volume, WIDTH, HEIGHT)?)
}

/// The view, and a sheet that shows the line of every pixel.
fn laid_out(pipeline: &Pipeline) -> Result<(View, Sheet), DegenerateCamera> {
    let view = View::new(vec3(6.0, 4.6, 7.0), vec3(1.0, 2.0, 2.0))?;
    // Wherever the pixel is, its line stays within those of the four corners.
    let ends = corners(pipeline).into_iter().flat_map(|ray| [ray.at(LEAST_T), ray.at(GREATEST_T)]);
    let seen: Vec<Vec2> = ends.map(|p| view.at(p)).collect();
    Ok((view, Sheet::around(&seen, vec2(760.0, 460.0), 20.0, 170.0)))
}

fn draw(values: &Values) -> Drawn {
    let [i, j, t] = ["i", "j", "t"].map(|name| values.number(name));
    let pipeline = pipeline()?;
    let ray = viewing_ray(&pipeline, i, j);
    let (view, mut sheet) = laid_out(&pipeline)?;
    image_plane(&mut sheet, &view, &pipeline, vec2(i, j));
    line(&mut sheet, &view, &ray, t);
    let place = words(&mut sheet, &ray, t);
    let (t, p) = (decimal(t, 2), triple(ray.at(t)));
    let alt = Words::new(
        format!(
            "A line from the eye through pixel ({i}, {j}) of the image plane; its point at t = {t} is {p}: {}.",
            place.en
        ),
        format!(
            "Een lijn vanuit het oog door pixel ({i}, {j}) van het beeldvlak; het punt bij t = {t} is {p}: {}.",
            place.nl
        ),
    );
    with_handles(vec![Drawing::only(alt, |alt| sheet.svg(alt))], handles(values))
}

/// The numbers of the line, and on which part of it t lies.
fn words(sheet: &mut Sheet, ray: &Ray, t: f32) -> Words {
    sheet.lines(
        500.0,
        50.0,
        [
            format!("e = {}", triple(ray.origin)),
            format!("s = {}", triple(ray.at(1.0))),
            format!("t = {}", decimal(t, 2)),
            format!("p = {}", triple(ray.at(t))),
        ],
    );
    let place = match t {
        t if t < 0.0 => Words::new("t < 0: behind the eye", "t < 0: achter het oog"),
        t if t < 1.0 => Words::new("between e and s", "tussen e en s"),
        _ => Words::new("t ≥ 1: s or beyond", "t ≥ 1: s of voorbij"),
    };
    sheet.lines(500.0, 158.0, [place.clone()]);
    place
}

/// The rays through the corners of the screen.
fn corners(pipeline: &Pipeline) -> [Ray; 4] {
    let (right, top) = (WIDTH as f32 - 0.5, HEIGHT as f32 - 0.5);
    [(-0.5, -0.5), (right, -0.5), (right, top), (-0.5, top)].map(|(i, j)| viewing_ray(pipeline, i, j))
}

/// The window with its pixels, the one of the ray tinted.
fn image_plane(sheet: &mut Sheet, view: &View, pipeline: &Pipeline, pixel: Vec2) {
    let at = |i: f32, j: f32| view.at(viewing_ray(pipeline, i, j).at(1.0));
    let (right, top) = (WIDTH as f32 - 0.5, HEIGHT as f32 - 0.5);
    for i in 0..=WIDTH {
        let i = i as f32 - 0.5;
        sheet.line(at(i, -0.5), at(i, top), Ink::Faint.pen().fine());
    }
    for j in 0..=HEIGHT {
        let j = j as f32 - 0.5;
        sheet.line(at(-0.5, j), at(right, j), Ink::Faint.pen().fine());
    }
    let outline = corners(pipeline).map(|ray| view.at(ray.at(1.0)));
    sheet.wash(&outline, Ink::B);
    sheet.polygon(&outline, Ink::B.pen());
    let d = 0.5;
    let around = [(-d, -d), (d, -d), (d, d), (-d, d)].map(|(x, y)| at(pixel.x + x, pixel.y + y));
    sheet.wash(&around, Ink::A);
    sheet.polygon(&around, Ink::A.pen().fine());
}

fn line(sheet: &mut Sheet, view: &View, ray: &Ray, t: f32) {
    let at = |t: f32| view.at(ray.at(t));
    sheet.line(at(LEAST_T), at(0.0), Ink::A.pen().dashed());
    sheet.arrow(at(0.0), at(GREATEST_T), Ink::A.pen());
    let beside = sheet.units(16.0) * (at(1.0) - at(0.0)).normalize_or(Vec2::X).perp();
    for (t, ink) in [(0.0, Ink::Main), (1.0, Ink::B), (t, Ink::D)] {
        sheet.dot(at(t), ink);
    }
    sheet.names(&[
        (at(0.0) - beside, "e", Ink::Main),
        (at(1.0) - beside, "s", Ink::B),
        (at(t) + 1.3 * beside, "p(t)", Ink::D),
    ]);
}

fn handles(values: &Values) -> Handled {
    let [i, j, t] = ["i", "j", "t"].map(|name| values.number(name));
    let pipeline = pipeline()?;
    let ray = viewing_ray(&pipeline, i, j);
    let (view, sheet) = laid_out(&pipeline)?;
    let list: [(Text, &[&str], Vec2); 2] = [
        (Text { en: "the pixel", nl: "de pixel" }, &["i", "j"], view.at(ray.at(1.0))),
        (Text { en: "the point p(t)", nl: "het punt p(t)" }, &["t"], view.at(ray.at(t))),
    ];
    Ok(vec![Handles::on(&sheet, list)])
}
