//! How wrong are the normals of a faceted ball, and how soon do they become right? (L39)

use geometry::shapes::icosphere;
use geometry::{Barycentric, Mesh};
use glam::Vec3;
use shading::mode::phong_normal;
use shading::{CREASE_ANGLE, vertex_normals};
use sheet::Ink;
use sheet::plot::{Axis, Kind, Plot, Series};
use sheet::text::decimal;

use crate::figure::{Drawing, Drawn, Figure, Text, Words};
use crate::handle::without_handles;
use crate::parameter::{Parameter, Values};

pub(super) static FIGURE: Figure = Figure {
    numbers: &["L39", "L40"],
    name: "normal-error",
    title: Text {
        en: "Vertex normals stand for the curved surface",
        nl: "Hoekpuntnormalen vervangen het gebogen oppervlak",
    },
    caption: Text {
        en: "A ball made of ever more triangles: the angle between its true normal and the normal that shading uses, sampled all over each triangle. That of the face halves with each subdivision, four times as many triangles. The normals interpolated between vertices are many times better. With 20 and 80 triangles the ball is so regular that they are exact but for rounding; those points are left out.",
        nl: "Een bol van steeds meer driehoeken: de hoek tussen de ware normaal en de normaal die voor shading wordt gebruikt, overal op elke driehoek bemonsterd. Die van het vlak halveert bij elke onderverdeling, viermaal zoveel driehoeken. De tussen hoekpunten geïnterpoleerde normalen zijn vele malen beter. Met 20 en 80 driehoeken is de bol zo regelmatig dat ze op afronding na exact zijn; die punten zijn weggelaten.",
    },
    parameters: &[Parameter::count(
        "level",
        Text { en: "greatest subdivision", nl: "grootste onderverdeling" },
        5.0,
        2.0,
        6.0,
    )],
    size: (640, 480),
    draw,
    handles: without_handles,
};

/// The angles between true and used normals of one mesh, in radians.
#[derive(Clone, Copy, Debug, Default)]
struct Errors {
    greatest: f64,
    sum: f64,
    count: f64,
}

impl Errors {
    fn add(&mut self, truth: Vec3, used: Vec3) {
        // For nearly equal unit vectors their distance is more exact than the arc cosine of their product.
        let angle = 2.0 * (0.5 * truth.as_dvec3().distance(used.as_dvec3())).min(1.0).asin();
        self.greatest = self.greatest.max(angle);
        self.sum += angle;
        self.count += 1.0;
    }

    fn mean(&self) -> f64 {
        self.sum / self.count
    }
}

/// Below this, in radians, the difference of two unit vectors of f32 says nothing: some thirty roundings of 2⁻²⁴.
const ROUNDING: f64 = 2e-6;

fn draw(values: &Values) -> Drawn {
    let mut measured = Vec::new();
    for level in 0..=values.count("level") {
        let mesh = icosphere(level)?.without_normals();
        measured.push((mesh.len() as f64, errors(&mesh)));
    }
    let series = |name: Words, ink, value: fn(&[Errors; 2]) -> f64| {
        let point = |(triangles, errors): &(f64, [Errors; 2])| (*triangles, value(errors));
        let seen = measured.iter().map(point).filter(|(_, angle)| *angle > ROUNDING);
        let points = seen.map(|(triangles, angle)| (triangles, angle.to_degrees())).collect();
        Series { name, ink, points, kind: Kind::Measured }
    };
    let plot = Plot {
        x: Axis::logarithmic(Words::new("triangles", "driehoeken")),
        y: Axis::logarithmic(Words::new(
            "angle to the true normal, degrees",
            "hoek met de ware normaal, graden",
        )),
        series: vec![
            series(Words::new("face, greatest", "vlak, grootste"), Ink::A, |e| e[0].greatest),
            series(Words::new("face, mean", "vlak, gemiddeld"), Ink::D, |e| e[0].mean()),
            series(Words::new("vertices, greatest", "hoeken, grootste"), Ink::B, |e| e[1].greatest),
            series(Words::new("vertices, mean", "hoeken, gemiddeld"), Ink::C, |e| e[1].mean()),
        ],
    };
    let (triangles, [face, vertex]) = measured[measured.len() - 1];
    let [face, vertex] = [face, vertex].map(|errors| decimal(errors.greatest.to_degrees(), 3));
    let alt = Words::new(
        format!(
            "With {triangles} triangles the normal of a face is off by up to {face}°, the interpolated vertex normals by up to {vertex}°."
        ),
        format!(
            "Met {triangles} driehoeken zit de normaal van een vlak er tot {face}° naast, de geïnterpoleerde hoekpuntnormalen tot {vertex}°."
        ),
    );
    Ok(vec![Drawing::only(alt, |alt| plot.svg(alt))])
}

/// The errors of the faces' normals and of the interpolated vertex normals. The true normal of a unit ball points from its
/// centre to the sample.
fn errors(mesh: &Mesh) -> [Errors; 2] {
    let normals = vertex_normals(mesh, CREASE_ANGLE);
    let [mut face, mut vertex] = [Errors::default(); 2];
    for k in 0..mesh.len() {
        let triangle = mesh.triangle(k);
        let corners = normals.triangles[k].map(|index| normals.values[index as usize]);
        for weights in samples() {
            let truth = triangle.point(weights).normalize();
            face.add(truth, triangle.normal().unwrap_or(truth));
            vertex.add(truth, phong_normal(corners, weights).unwrap_or(truth));
        }
    }
    [face, vertex]
}

/// Points all over a triangle, its corners and sides among them.
fn samples() -> impl Iterator<Item = Barycentric> {
    const STEPS: u8 = 6;
    let share = |k: u8| f32::from(k) / f32::from(STEPS);
    (0..=STEPS)
        .flat_map(move |b| (0..=STEPS - b).map(move |c| Barycentric::from_beta_gamma(share(b), share(c))))
}
