//! What happens between the vertices? (L38–L42, E7, E18)

use canvas::{Image, difference};
use geometry::shapes::icosphere;
use geometry::{Barycentric, Mesh};
use glam::{Mat4, Vec3, vec3};
use lighting::{Highlight, Light, Material, Rgb};
use shading::mode::{gouraud_colors, phong_normal};
use shading::{Facet, Frame, Lighting, Object, Shading, Surface, Visibility, World, render};
use transforms::Pipeline;

use crate::sample::{pipeline, short, trials};
use crate::stage::SIZE;
use crate::{Claim, Examination, Trial, Verdict, judge, measured, pair, text, versions};
use figures::{Drawing, Drawn};

const EYE: Vec3 = Vec3::new(0.0, 0.0, 4.0);

const LIGHTS: [Light; 2] = [
    Light::Ambient { color: Rgb::splat(0.15) },
    Light::Directional { to_light: Vec3::new(0.48, 0.36, 0.8), color: Rgb::ONE },
];

fn glossy() -> Material {
    Material::new(Rgb::new(0.6, 0.12, 0.08), 32.0)
}

/// A ball of `mesh`, drawn with this shading.
fn ball(mesh: &Mesh, shading: Shading, highlight: Highlight, size: (u32, u32)) -> Frame {
    let objects = [Object { mesh, world_from_object: Mat4::IDENTITY, materials: &[glossy()] }];
    let world = World { objects: &objects, lights: &LIGHTS, background: Rgb::splat(0.02), highlight };
    render(&world, &view(size), shading, Visibility::default())
}

fn view(size: (u32, u32)) -> Pipeline {
    pipeline((EYE, Vec3::ZERO), 0.6, (-1.0, -9.0), size)
}

pub(super) fn sphere(level: u32) -> Mesh {
    icosphere(level).expect("a sphere of a low level")
}

fn lighting() -> Lighting<'static> {
    Lighting { lights: &LIGHTS, highlight: Highlight::Blinn, eye: EYE }
}

pub(super) static GOURAUD_IS_AFFINE: Claim = Claim {
    number: "L38",
    name: "colours-interpolated",
    quote: "interpoleer hoekpuntkleuren over hele gebied polygoon",
    translation: "interpolate the vertex colours over the whole polygon",
    truth: text(
        "Between the vertices the colour is αc₀ + βc₁ + γc₂, never brighter than the brightest vertex.",
        "Tussen de hoekpunten is de kleur αc₀ + βc₁ + γc₂, nooit helderder dan het helderste hoekpunt.",
    ),
    expected: Verdict::Holds,
    code: &["shading::Surface::color", "shading::mode::gouraud_colors"],
    examine: || {
        let mesh = sphere(1);
        let object = Object { mesh: &mesh, world_from_object: Mat4::IDENTITY, materials: &[glossy()] };
        let trials = trials(200, 91, |random| {
            let facet = Facet::new(&object, random.below(mesh.len()), EYE);
            let (beta, gamma) = (random.between(0.0, 0.5), random.between(0.0, 0.5));
            let weights = Barycentric::from_beta_gamma(beta, gamma);
            let [c0, c1, c2] = gouraud_colors(&facet, &lighting());
            let c = Surface::new(Shading::Gouraud, facet, lighting()).color(weights);
            let holds = c.abs_diff_eq(weights.alpha * c0 + beta * c1 + gamma * c2, 1e-6)
                && c.max_element() <= c0.max(c1).max(c2).max_element() + 1e-6;
            Trial::new(holds, format!("β = {beta:.2}, γ = {gamma:.2}: {}", short(c)))
        });
        judge("the colour is αc₀ + βc₁ + γc₂", None, &trials)
    },
    pictures: None,
    versions: None,
};

pub(super) static FINER_MESH: Claim = Claim {
    number: "L39",
    name: "finer-mesh-smaller-error",
    quote: "Vertex normals record the surface normal of the original curve.",
    translation: "vertex normals record the normal of the original curve",
    truth: text(
        "At the vertices they are the curve's own; between them the colour is off by less and less on a finer mesh, in the end by a quarter as much for twice as fine.",
        "In de hoekpunten zijn ze die van de kromme zelf; ertussen wordt de kleurfout steeds kleiner op een fijnere mesh, uiteindelijk een kwart bij tweemaal zo fijn.",
    ),
    expected: Verdict::Holds,
    code: &["geometry::shapes::icosphere", "shading::render"],
    examine: || {
        let errors: Vec<f32> = (0..5).map(|level| mean_error(&sphere(level), Shading::Gouraud)).collect();
        let mut trials: Vec<Trial> = errors
            .windows(2)
            .map(|two| Trial::new(two[1] < two[0], format!("error {:.4}, then {:.4}", two[0], two[1])))
            .collect();
        let mesh = sphere(2);
        trials.extend((0..mesh.len()).map(|k| {
            let (corners, normals) = (mesh.triangle(k).corners(), mesh.corner_normals(k));
            // On the unit sphere the position is the normal.
            let exact = normals.is_some_and(|n| (0..3).all(|c| n[c].abs_diff_eq(corners[c], 1e-6)));
            Trial::new(exact, format!("triangle {k} has other normals"))
        }));
        let list: Vec<_> = errors.iter().map(|error| format!("{error:.4}")).collect();
        judge("vertex normals are the sphere's, and a finer mesh is nearer to its colours", None, &trials)
            .noted(format!("mean error of Gouraud shading at levels 0 to 4: {}", list.join(", ")))
    },
    pictures: None,
    versions: None,
};

/// How far the colours are from those of the exact sphere, on average over the pixels that show the mesh.
pub(super) fn mean_error(mesh: &Mesh, shading: Shading) -> f32 {
    let frame = ball(mesh, shading, Highlight::Blinn, (60, 60));
    let objects = [Object { mesh, world_from_object: Mat4::IDENTITY, materials: &[glossy()] }];
    let (mut sum, mut count) = (0.0, 0.0_f32);
    for (visible, color) in frame.visible.iter().zip(frame.image.pixels()) {
        let Some(visible) = visible else { continue };
        let facet = Facet::new(&objects[0], visible.triangle, EYE);
        let p = facet.corners.point(visible.weights).normalize();
        sum += color.distance(lighting().color(&facet.material, p, p));
        count += 1.0;
    }
    sum / count.max(1.0)
}

pub(super) static PHONG_SHADING: Claim = Claim {
    number: "L40",
    name: "normals-interpolated",
    quote: "bereken kleur voor elk punt met behulp van geïnterpoleerde normaalvector",
    translation: "compute the colour of each point with the interpolated normal",
    truth: text(
        "It comes nearer to the curved surface than interpolated colours, on every mesh tried.",
        "Dat komt dichter bij het gekromde oppervlak dan geïnterpoleerde kleuren, op elke geprobeerde mesh.",
    ),
    expected: Verdict::Holds,
    code: &["shading::mode::phong_normal", "shading::render"],
    examine: || {
        let trials: Vec<Trial> = (0..4)
            .map(|level| {
                let error = |shading| mean_error(&sphere(level), shading);
                let (gouraud, phong) = (error(Shading::Gouraud), error(Shading::Phong));
                Trial::new(phong < gouraud, format!("level {level}: {phong:.4} against {gouraud:.4}"))
            })
            .collect();
        let numbers: Vec<_> = trials.iter().map(|trial| trial.numbers.clone()).collect();
        judge("Phong shading is nearer to the sphere's colours than Gouraud", None, &trials)
            .noted(format!("mean error, Phong against Gouraud shading: {}", numbers.join("; ")))
    },
    pictures: None,
    versions: None,
};

fn brightest(image: &Image) -> f32 {
    image.pixels().iter().map(|c| c.y).fold(0.0, f32::max)
}

pub(super) static MISSED_HIGHLIGHT: Claim = Claim {
    number: "L41",
    name: "gouraud-misses-the-highlight",
    quote: "Because the triangles are large, interpolation artifacts are visible.",
    translation: "because the triangles are large, interpolation artifacts are visible",
    truth: text(
        "A highlight between the vertices of a large triangle is lost: no vertex has it. On a fine mesh it is there.",
        "Een glansplek tussen de hoekpunten van een grote driehoek gaat verloren: geen hoekpunt heeft hem. Op een fijne mesh is hij er.",
    ),
    expected: Verdict::Holds,
    code: &["shading::render"],
    examine: || {
        let green =
            |level, shading| brightest(&ball(&sphere(level), shading, Highlight::Blinn, (60, 60)).image);
        let [coarse, fine] = [0, 4].map(|level| green(level, Shading::Gouraud));
        let phong = green(0, Shading::Phong);
        measured(
            coarse < 0.5 * phong && 0.9 * phong < fine,
            format!(
                "brightest green of the ball: Gouraud {coarse:.3} on 20 triangles and {fine:.3} on 5120, Phong shading {phong:.3} on 20"
            ),
        )
    },
    pictures: None,
    versions: None,
};

pub(super) static TWO_PHONGS: Claim = Claim {
    number: "L42",
    name: "two-phongs",
    quote: "confusing because the same name is attached to the Phong illumination model.",
    translation: "confusing, because the same name is attached to the Phong illumination model",
    truth: text(
        "Two different things: each of three shadings goes with each of two lighting models, and all six pictures differ.",
        "Twee verschillende dingen: elk van drie shadings gaat samen met elk van twee belichtingsmodellen, en alle zes beelden verschillen.",
    ),
    expected: Verdict::Holds,
    code: &["shading::Shading", "lighting::Highlight"],
    examine: || {
        let mesh = sphere(1);
        let mut frames = Vec::new();
        for shading in [Shading::Flat, Shading::Gouraud, Shading::Phong] {
            for highlight in [Highlight::Phong, Highlight::Blinn] {
                let name = format!("{shading:?} shading with {highlight:?}'s highlight");
                frames.push((name, ball(&mesh, shading, highlight, (60, 60)).image));
            }
        }
        let pairs = (0..6).flat_map(|a| (0..a).map(move |b| (a, b)));
        let trials: Vec<Trial> = pairs
            .map(|(a, b)| {
                let differs =
                    difference(&frames[a].1, &frames[b].1, 0.01).is_ok_and(|d| d.over_threshold > 0);
                Trial::new(differs, format!("{} looks like {}", frames[a].0, frames[b].0))
            })
            .collect();
        judge("each shading with each highlight gives another picture", None, &trials)
    },
    pictures: None,
    versions: None,
};

/// αn₀ + βn₁ + γn₂, as on the slide.
fn slide_normal([n0, n1, n2]: [Vec3; 3], weights: Barycentric) -> Vec3 {
    weights.alpha * n0 + weights.beta * n1 + weights.gamma * n2
}

pub(super) static NOT_UNIT: Claim = Claim {
    number: "E7",
    name: "normal-too-short",
    quote: "n = αn₀ + βn₁ + γn₂",
    translation: "n = αn₀ + βn₁ + γn₂",
    truth: text(
        "It must be brought back to length 1: normals ±45° from the middle meet at length 0.707, and 0.707³² = 1.5e−5 of the highlight is left.",
        "Die moet weer lengte 1 krijgen: normalen ±45° van het midden hebben daar lengte 0,707, en van de glansplek blijft 0,707³² = 1,5e−5 over.",
    ),
    expected: Verdict::HoldsIf(ALL_EQUAL),
    code: &["shading::mode::phong_normal"],
    examine: || {
        let trials = trials(200, 92, |random| {
            let (n0, level) = (random.direction(), random.below(4) == 0);
            let mut other = || if level { n0 } else { random.direction_around(n0) };
            let (n1, n2) = (other(), other());
            let length = slide_normal([n0, n1, n2], Barycentric::from_beta_gamma(0.3, 0.5)).length();
            // A sum of three unit vectors, a few roundings.
            Trial::under(level, (length - 1.0).abs() < 1e-5, format!("‖n‖ = {length:.3}"))
        });
        let normals = [vec3(1.0, 0.0, 1.0).normalize(), vec3(-1.0, 0.0, 1.0).normalize(), Vec3::Z];
        let middle = Barycentric { alpha: 0.5, beta: 0.5, gamma: 0.0 };
        let right = phong_normal(normals, middle).map_or(0.0, |n| n.z);
        let slide = slide_normal(normals, middle).z;
        let unit = crate::sample::trials(200, 92, |random| {
            let n0 = random.direction();
            let normals = [n0, random.direction_around(n0), random.direction_around(n0)];
            let n = phong_normal(normals, Barycentric::from_beta_gamma(0.3, 0.5));
            Trial::new(n.is_some_and(Vec3::is_normalized), format!("{n:?}"))
        });
        judge("the interpolated normal is a unit vector", Some(ALL_EQUAL), &trials)
            .with_right("ours is", &unit)
            .compared(
                "normals 45° to either side, looked at in the middle, e = l = z, p = 32",
                format!("‖n‖ = {slide:.3}, (h·n)³² = {:.1e}", slide.powi(32)),
                format!("‖n‖ = {right:.3}, (h·n)³² = {:.1}", right.powi(32)),
            )
    },
    pictures: Some(normals_pair),
    versions: None,
};

const ALL_EQUAL: &str = "the three vertex normals are equal";

/// A coarse ball, Phong shaded with normals as they come, and with unit normals.
fn normals_pair() -> Drawn {
    let mesh = sphere(0);
    let right = ball(&mesh, Shading::Phong, Highlight::Blinn, SIZE);
    let object = Object { mesh: &mesh, world_from_object: Mat4::IDENTITY, materials: &[glossy()] };
    let mut slide = right.image.clone();
    for (pixel, visible) in slide.pixels_mut().iter_mut().zip(&right.visible) {
        if let Some(visible) = visible {
            let facet = Facet::new(&object, visible.triangle, EYE);
            let n = slide_normal(facet.corner_normals, visible.weights);
            *pixel = lighting().color(&facet.material, facet.corners.point(visible.weights), n);
        }
    }
    let alt_slide = text(
        "A ball of 20 triangles, without any highlight; the middles of its triangles are too dark, and their edges show.",
        "Een bal van 20 driehoeken zonder glansplek; de middens van de driehoeken zijn te donker en de ribben zijn te zien.",
    );
    let alt_right = text(
        "The same ball, evenly shaded, with a round highlight.",
        "Dezelfde bal, egaal van tint, met een ronde glansplek.",
    );
    pair(Drawing::picture("slide", alt_slide, slide), Drawing::picture("right", alt_right, right.image))
}

pub(super) static CAPTION: Claim = Claim {
    number: "E18",
    name: "caption-repeated",
    quote: "… per-fragment shading. Because the triangles are large, interpolation artifacts are visible.",
    translation: "per-fragment shading: because the triangles are large, interpolation artifacts are visible",
    truth: text(
        "The caption repeats that of the figure before. With per-fragment shading the artifacts are what is gone.",
        "Het bijschrift herhaalt dat van de vorige figuur. Bij per-fragment shading zijn de artefacten juist weg.",
    ),
    expected: Verdict::Refuted,
    code: &["shading::Shading"],
    examine: caption,
    pictures: None,
    versions: Some(versions::caption),
};

fn caption() -> Examination {
    let error = |shading| mean_error(&sphere(1), shading);
    let (vertex, fragment) = (error(Shading::Gouraud), error(Shading::Phong));
    // As visible: at least half the error that per-vertex shading has.
    let numbers = format!("mean error {fragment:.4} per fragment, {vertex:.4} per vertex");
    measured(fragment > 0.5 * vertex, numbers).compared(
        "a ball of 80 triangles, the artifacts of per-fragment shading",
        format!("those of per-vertex shading: {vertex:.4}"),
        format!("{fragment:.4}"),
    )
}
