//! How wrong are the normals of a faceted ball, and how much does interpolation mend? (L39, L40)

use geometry::{Barycentric, Mesh, shapes};
use shading::mode::phong_normal;
use shading::vertex_normals;

use crate::figure::{Drawing, Drawn, Figure, Text, Words};
use crate::parameter::{Parameter, Values};
use crate::sheet::Ink;
use crate::sheet::plot::{Axis, Plot, Series};

pub(super) static FIGURE: Figure = Figure {
    numbers: &["L39", "L40"],
    name: "faceted-normals",
    title: Text {
        en: "Error of faceted normals against subdivision",
        nl: "Fout van facetnormalen tegen onderverdeling",
    },
    caption: Text {
        en: "The greatest angle between the normal of a ball and that of its triangles. The triangle's normal errs in proportion to the length of an edge. Interpolating the normals of the corners would be exact on a ball if those were; what is left is their own error, since they are computed from the triangles around them. (The two coarsest balls are so regular that they have none: no point.)",
        nl: "De grootste hoek tussen de normaal van een bol en die van zijn driehoeken. De fout van de driehoeksnormaal is evenredig met de lengte van een ribbe. Hoekpuntnormalen interpoleren zou op een bol exact zijn als die het waren; wat overblijft is hun eigen fout, want ze worden uit de driehoeken eromheen berekend. (De twee grofste bollen zijn zo regelmatig dat ze er geen hebben: geen punt.)",
    },
    parameters: &[Parameter::count(
        "subdivision",
        Text { en: "greatest subdivision", nl: "grootste onderverdeling" },
        5.0,
        1.0,
        6.0,
    )],
    size: (640, 480),
    draw,
};

/// In degrees: below this an error is that of f32, not of the mesh.
const ROUNDING: f64 = 1e-4;

fn draw(values: &Values) -> Drawn {
    let levels = values.count("subdivision");
    let (mut flat, mut smooth) = (Vec::new(), Vec::new());
    for level in 0..=levels {
        let ball = shapes::icosphere(level)?.without_normals();
        let errors = greatest_errors(&ball);
        flat.push((ball.len() as f64, errors.0));
        if errors.1 > ROUNDING {
            smooth.push((ball.len() as f64, errors.1));
        }
    }
    let last = |points: &[(f64, f64)]| points.last().map_or(0.0, |point| point.1);
    let (coarsest, finest, interpolated) = (flat[0].1, last(&flat), last(&smooth));
    let plot = Plot {
        x: Axis::logarithmic(Words::new("triangles", "driehoeken")),
        y: Axis::logarithmic(Words::new("greatest error in degrees", "grootste fout in graden")),
        series: vec![
            Series {
                name: Words::new("triangle's normal", "driehoeksnormaal"),
                ink: Ink::A,
                points: flat,
                is_theory: false,
            },
            Series {
                name: Words::new("interpolated", "geïnterpoleerd"),
                ink: Ink::B,
                points: smooth,
                is_theory: false,
            },
        ],
    };
    let alt = Words::new(
        format!(
            "Two falling lines: the triangle's normal errs by {coarsest:.1}° at first and {finest:.2}° at last, the interpolated one by {interpolated:.3}°."
        ),
        format!(
            "Twee dalende lijnen: de driehoeksnormaal wijkt eerst {coarsest:.1}° af en ten slotte {finest:.2}°, de geïnterpoleerde {interpolated:.3}°."
        ),
    );
    Ok(vec![Drawing::diagram("", alt.clone(), plot.svg(&alt))])
}

/// The greatest angles, in degrees, between the ball's normal and (the triangle's, the interpolated one).
fn greatest_errors(ball: &Mesh) -> (f64, f64) {
    /// Points along each edge of a triangle at which to look.
    const STEPS: u8 = 8;
    // No edge of a ball is hard.
    let normals = vertex_normals(ball, std::f32::consts::PI);
    let mut greatest = (0.0_f64, 0.0_f64);
    for k in 0..ball.len() {
        let triangle = ball.triangle(k);
        let Some(face) = triangle.normal() else { continue };
        let corners = normals.triangles[k].map(|index| normals.values[index as usize]);
        for b in 0..=STEPS {
            for c in 0..=STEPS - b {
                let [beta, gamma] = [b, c].map(|x| f32::from(x) / f32::from(STEPS));
                let weights = Barycentric::from_beta_gamma(beta, gamma);
                let truth = weights.interpolate(triangle.a, triangle.b, triangle.c).as_dvec3().normalize();
                greatest.0 = greatest.0.max(truth.angle_between(face.as_dvec3()));
                if let Some(n) = phong_normal(corners, weights) {
                    greatest.1 = greatest.1.max(truth.angle_between(n.as_dvec3()));
                }
            }
        }
    }
    (greatest.0.to_degrees(), greatest.1.to_degrees())
}
