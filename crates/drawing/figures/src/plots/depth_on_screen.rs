//! Which depth lies halfway on the screen? Not the one halfway in space (E9).

use std::error::Error;

use glam::{Vec3, vec3};
use sheet::Ink;
use sheet::plot::{Axis, Kind, Plot, Series};
use sheet::text::decimal;
use transforms::{Camera, Pipeline, ViewVolume};

use crate::figure::{Drawing, Drawn, Figure, Text, Words};
use crate::handle::{Handled, Handles, with_handles};
use crate::parameter::{Parameter, Values};

pub(super) static FIGURE: Figure = Figure {
    numbers: &["E9", "L18"],
    name: "depth-on-screen",
    title: Text { en: "Which z may be interpolated?", nl: "Welke z mag worden geïnterpoleerd?" },
    caption: Text {
        en: "Along a line on the screen camera z does not change evenly: interpolating it between the ends (dashed) is wrong in between. Canonical z, after the division, does change evenly: interpolated and carried back (dots), it lies on the true curve.",
        nl: "Langs een lijn op het scherm verandert camera-z niet gelijkmatig: interpoleren tussen de uiteinden (gestreept) is daartussen fout. Canonieke z, na de deling, verandert wel gelijkmatig: geïnterpoleerd en teruggerekend (stippen) ligt die op de ware kromme.",
    },
    parameters: &[
        Parameter::number(
            "near_end",
            Text { en: "camera z of the near end", nl: "camera-z van het nabije eind" },
            -2.0,
            -10.0,
            -1.0,
        ),
        Parameter::number(
            "far_end",
            Text { en: "camera z of the far end", nl: "camera-z van het verre eind" },
            -50.0,
            -200.0,
            -12.0,
        ),
    ],
    size: (640, 480),
    draw,
    handles,
};

fn draw(values: &Values) -> Drawn {
    let (near_end, far_end) = (values.number("near_end"), values.number("far_end"));
    let (pipeline, ends) = (pipeline()?, ends(values));
    let [from, to] = on_screen(&pipeline, ends)?;
    let plot = plot(&pipeline, ends)?;
    let middle = decimal(0.5 * (near_end + far_end), 2);
    let halfway_z = decimal(z_behind(&pipeline, from.lerp(to, 0.5)), 2);
    let alt = Words::new(
        format!(
            "Halfway on the screen the true camera z is {halfway_z}; straight interpolation gives {middle}."
        ),
        format!(
            "Halverwege op het scherm is de ware camera-z {halfway_z}; recht interpoleren geeft {middle}."
        ),
    );
    with_handles(vec![Drawing::only(alt, |alt| plot.svg(alt))], handles(values))
}

fn pipeline() -> Result<Pipeline, Box<dyn Error + Send + Sync>> {
    // Camera space is world space: the eye stands at the origin and looks along −z.
    let camera = Camera::look_at(Vec3::ZERO, Vec3::NEG_Z, Vec3::Y)?;
    Ok(Pipeline::new(camera, ViewVolume::from_fov_y(1.5, 1.0, -0.5, -250.0)?, 200, 200)?)
}

/// From the left to the right of the picture, and away from the eye.
fn ends(values: &Values) -> [Vec3; 2] {
    let (near_end, far_end) = (values.number("near_end"), values.number("far_end"));
    [vec3(0.6 * near_end, 0.1 * near_end, near_end), vec3(-0.6 * far_end, 0.2 * far_end, far_end)]
}

/// The far end has no handle: the axis always reaches down to it, so its place never changes.
fn handles(values: &Values) -> Handled {
    let ends = ends(values);
    let plot = plot(&pipeline()?, ends)?;
    let name = Text { en: "camera z of the near end", nl: "camera-z van het nabije eind" };
    let at = plot.share((0.0, f64::from(ends[0].z)));
    Ok(vec![Handles::none(Plot::SIZE).and(name, &["near_end"], at)])
}

fn plot(pipeline: &Pipeline, ends: [Vec3; 2]) -> Result<Plot, &'static str> {
    let [from, to] = on_screen(pipeline, ends)?;
    let straight = ends.map(|p| f64::from(p.z));
    Ok(Plot {
        x: Axis::linear(Words::new("share of the way on the screen", "deel van de weg op het scherm")),
        y: Axis::linear(Words::new("camera z", "camera-z")),
        series: vec![
            Series {
                name: Words::new("true z", "ware z"),
                ink: Ink::B,
                points: true_curve(pipeline, ends)?,
                kind: Kind::Measured,
            },
            Series {
                name: Words::new("from canonical z", "uit canonieke z"),
                ink: Ink::C,
                points: (0..=20_u8)
                    .map(|k| f32::from(k) / 20.0)
                    .map(|share| (f64::from(share), f64::from(z_behind(pipeline, from.lerp(to, share)))))
                    .collect(),
                kind: Kind::Places,
            },
            Series {
                name: Words::new("camera z, straight", "camera-z, recht"),
                ink: Ink::A,
                points: vec![(0.0, straight[0]), (1.0, straight[1])],
                kind: Kind::Theory,
            },
        ],
    })
}

/// The ends of the line on the screen, with canonical z.
fn on_screen(pipeline: &Pipeline, ends: [Vec3; 2]) -> Result<[Vec3; 2], &'static str> {
    let [from, to] = ends.map(|p| pipeline.trace(p).screen);
    Ok([
        from.ok_or("an end without a place on the screen")?,
        to.ok_or("an end without a place on the screen")?,
    ])
}

/// The camera z of what the pipeline put at this place of the screen.
fn z_behind(pipeline: &Pipeline, screen: Vec3) -> f32 {
    pipeline.screen_from_world().inverse().project_point3(screen).z
}

/// How far along on the screen each point of the line in space is, and its z. Small steps near the eye: there the points
/// lie far apart on the screen.
fn true_curve(pipeline: &Pipeline, [from, to]: [Vec3; 2]) -> Result<Vec<(f64, f64)>, &'static str> {
    const POINTS: u16 = 80;
    let [start, end] = on_screen(pipeline, [from, to])?;
    let line = (end - start).truncate();
    let point = |k: u16| {
        let p = from.lerp(to, (f32::from(k) / f32::from(POINTS)).powi(3));
        let screen = pipeline.trace(p).screen?.truncate();
        let share = (screen - start.truncate()).dot(line) / line.length_squared();
        Some((f64::from(share), f64::from(p.z)))
    };
    (0..=POINTS).map(point).collect::<Option<_>>().ok_or("a point without a place on the screen")
}
