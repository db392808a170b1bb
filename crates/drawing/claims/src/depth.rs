//! How deep is it between the vertices, and do both loops see the same? (L18, L20, L21, E9, E16)

use geometry::Triangle;
use glam::{Vec3, vec3};
use raytrace::triangle::watertight;
use raytrace::viewing_ray;
use transforms::projection::perspective;
use transforms::{Pipeline, ViewVolume};
use zbuffer::depth_format::step_at;
use zbuffer::{DepthBuffer, DepthFormat, project, rasterize};

use crate::sample::{permutations, pipeline, trials};
use crate::{Claim, Examination, Trial, Verdict, judge, samples, text, versions};

pub(super) static INTERPOLATED: Claim = Claim {
    number: "L18",
    name: "depth-interpolated",
    quote: "z-waarden voor hoekpunten berekend, voor overige pixels geïnterpoleerd",
    translation: "z is computed at the vertices and interpolated over the other pixels",
    truth: text(
        "Right for canonical z, after the projection: it is affine on the screen. For camera z see E9.",
        "Klopt voor canonieke z, na de projectie: die is affien op het scherm. Voor camera-z zie E9.",
    ),
    expected: Verdict::Holds,
    code: &["zbuffer::rasterize", "transforms::Pipeline::trace"],
    examine: || {
        let pipeline = pipeline((vec3(0.0, 0.0, 6.0), Vec3::ZERO), 0.9, (-1.0, -20.0), (32, 32));
        let mut trials = Vec::new();
        for_each_fragment(&pipeline, 41, |triangle, fragment| {
            let true_z = pipeline.trace(triangle.point(fragment.weights)).canonical.map_or(f32::NAN, |p| p.z);
            // The weights are those between vertices snapped to 1/256 pixel: the slope is at most some tenths a pixel.
            let holds = (fragment.z as f32 - true_z).abs() < 1e-3;
            trials.push(Trial::new(holds, format!("z = {} at a pixel whose point has {true_z}", fragment.z)));
        });
        judge("canonical z between the vertices is that of the point seen there", None, &trials)
    },
    pictures: None,
    versions: None,
};

fn for_each_fragment(pipeline: &Pipeline, seed: u64, mut look: impl FnMut(&Triangle, &zbuffer::Fragment)) {
    let mut random = crate::sample::Sequence::new(seed);
    for _ in 0..12 {
        let triangle = random.triangle(3.0);
        for part in project(&pipeline.clip_from_world(), 32, 32, &triangle).triangles() {
            rasterize(&part, 32, 32, |fragment| look(&triangle, &fragment));
        }
    }
}

pub(super) static CAMERA_DEPTH: Claim = Claim {
    number: "E9",
    name: "camera-depth-interpolated",
    quote: "z-waarden voor hoekpunten berekend, voor overige pixels geïnterpoleerd",
    translation: "z is computed at the vertices and interpolated over the other pixels; which z is not said",
    truth: text(
        "Camera z is not affine on the screen, 1/z is: halfway on the screen between z = −2 and −50 lies z = −3.85, not −26. Interpolate z after the projection; other attributes need perspective-correct weights.",
        "Camera-z is niet affien op het scherm, 1/z wel: halverwege op het scherm tussen z = −2 en −50 ligt z = −3,85 en niet −26. Interpoleer z na de projectie; andere attributen vragen perspectief-correcte gewichten.",
    ),
    expected: Verdict::HoldsIf(ONE_DEPTH),
    code: &["transforms::projection::perspective", "zbuffer::rasterize"],
    examine: || {
        let trials = trials(100, 42, |random| {
            let (a, b) = (random.between(-60.0, -1.5), random.between(-60.0, -1.5));
            let b = if random.below(4) == 0 { a } else { b };
            let (slide, right) = (slide_halfway(a, b), halfway_on_screen(a, b));
            // Nearly equal ends are excluded by chance; the division by w costs a few roundings of 60.
            let holds = (slide - right).abs() < 1e-3;
            Trial::under(a == b, holds, format!("between z = {a:.2} and {b:.2}: {slide:.2}, not {right:.2}"))
        });
        let harmonic = crate::sample::trials(100, 42, |random| {
            let (a, b) = (random.between(-60.0, -1.5), random.between(-60.0, -1.5));
            let (found, right) = (halfway_on_screen(a, b), 2.0 / (a.recip() + b.recip()));
            // Canonical z near −1 is known to 2⁻²⁴, and a unit there is worth z² / 2 world units.
            Trial::new((found - right).abs() < 1e-2, format!("{found} instead of {right}"))
        });
        judge("camera z halfway on the screen is the mean of the ends", Some(ONE_DEPTH), &trials)
            .with_right(
                "by way of canonical z it is 2/(1/a + 1/b), as the intercept theorem has it",
                &harmonic,
            )
            .compared(
                "halfway on the screen between z = −2 and z = −50",
                format!("z = {:.2}", slide_halfway(-2.0, -50.0)),
                format!("z = {:.2}", halfway_on_screen(-2.0, -50.0)),
            )
    },
    pictures: Some(samples::floor_pair),
    versions: None,
};

const ONE_DEPTH: &str = "the vertices are equally deep";

fn slide_halfway(a: f32, b: f32) -> f32 {
    0.5 * a + 0.5 * b
}

/// Interpolates z after the perspective, and goes back.
fn halfway_on_screen(a: f32, b: f32) -> f32 {
    let p = perspective(-1.0, -100.0);
    let z = |camera_z: f32| p.project_point3(vec3(0.0, 0.0, camera_z)).z;
    p.inverse().project_point3(vec3(0.0, 0.0, 0.5 * z(a) + 0.5 * z(b))).z
}

pub(super) static NEAR_SIMILAR: Claim = Claim {
    number: "L20",
    name: "near-similar-depths",
    quote: "coplanar polygons that have near-similar or identical values in the z-buffer.",
    translation: "z-fighting: such polygons cannot be told apart; tried is which of two is drawn as the nearer",
    truth: text(
        "Surfaces are told apart for certain from two depth steps on. The step grows with the square of the distance; 24 bits make it 256 times smaller than 16.",
        "Vlakken worden zeker uit elkaar gehouden vanaf twee dieptestappen. De stap groeit met het kwadraat van de afstand; met 24 bits is hij 256 maal kleiner dan met 16.",
    ),
    expected: Verdict::HoldsIf(TWO_STEPS),
    code: &["zbuffer::depth_format::step_at", "zbuffer::DepthFormat::code"],
    examine: || {
        let volume = ViewVolume { left: -0.1, right: 0.1, bottom: -0.1, top: 0.1, near: -0.1, far: -1000.0 };
        let trials = trials(200, 43, |random| {
            let format = [DepthFormat::Bits16, DepthFormat::Bits24][random.below(2)];
            let distance = random.between(2.0, 80.0);
            let steps = if random.below(2) == 0 { 2.0 } else { random.between(0.0, 0.1) };
            let gap = f64::from(steps * step_at(format, &volume, distance));
            let code = |d: f64| format.code(canonical_z(&volume, d) as f32);
            let (near, far) = (code(f64::from(distance)), code(f64::from(distance) + gap));
            let numbers =
                format!("{} bits, {distance:.1} away, {gap:.6} apart: codes {near} and {far}", format.bits());
            // A little slack: the step is of first order, and two of them are taken a little farther out.
            Trial::under(steps >= 2.0, near > far, numbers)
        });
        let step = |distance| step_at(DepthFormat::Bits16, &volume, distance);
        judge("the nearer of two surfaces gets the larger code", Some(TWO_STEPS), &trials).noted(format!(
            "16 bits: a step of {:.4} at 10 units, {:.4} at 20, {:.4} at 40",
            step(10.0),
            step(20.0),
            step(40.0)
        ))
    },
    pictures: None,
    versions: None,
};

const TWO_STEPS: &str = "they are at least two depth steps apart";

/// (n+f)/(n−f) + 2fn/((n−f)·distance), in f64.
fn canonical_z(volume: &ViewVolume, distance: f64) -> f64 {
    let (n, f) = (f64::from(volume.near), f64::from(volume.far));
    (n + f) / (n - f) + 2.0 * f * n / ((n - f) * distance)
}

pub(super) static TWO_LOOPS: Claim = Claim {
    number: "L21",
    name: "two-loops-one-picture",
    quote: "z-buffer (“object-order” rendering) … ray tracing (“image-order” rendering)",
    translation: "object-order and image-order rendering",
    truth: text(
        "Both loops show the same polygon in every pixel, but for pixels whose centre lies on an edge to within 1/256 pixel.",
        "Beide lussen tonen in elke pixel hetzelfde polygoon, behalve in pixels met het midden tot op 1/256 pixel op een rand.",
    ),
    expected: Verdict::Holds,
    code: &["zbuffer::rasterize", "raytrace::triangle::watertight"],
    examine: || {
        let pipeline = pipeline((vec3(0.5, 1.0, 7.0), Vec3::ZERO), 0.9, (-1.0, -20.0), (40, 40));
        let (mut all, mut on_edges) = (0, 0);
        let trials = trials(6, 44, |random| {
            let triangles: Vec<Triangle> = (0..8).map(|_| random.triangle(2.5)).collect();
            let objects = object_order(&triangles, &pipeline);
            let pixels = image_order(&triangles, &pipeline, &Saved::InitializedAndUpdated);
            let differ: Vec<usize> = (0..1600).filter(|k| objects[*k] != pixels[*k]).collect();
            let unexplained = differ.iter().filter(|k| !is_on_edge(&triangles, &pipeline, **k)).count();
            (all, on_edges) = (all + 1600, on_edges + differ.len() - unexplained);
            let numbers = format!("{} of 1600 pixels differ, {unexplained} away from edges", differ.len());
            Trial::new(unexplained == 0, numbers)
        });
        judge("both loops show the same polygon in all pixels off the edges", None, &trials)
            .noted(format!("{on_edges} of {all} pixels, all on edges, show another one"))
    },
    pictures: None,
    versions: None,
};

type Winners = Vec<Option<usize>>;

/// for each object, for each pixel inside its projection: if its depth is closer than the z-buffer's …
fn object_order(triangles: &[Triangle], pipeline: &Pipeline) -> Winners {
    let mut winners = vec![None; 1600];
    let mut depth = DepthBuffer::new(40, 40, DepthFormat::F32);
    for (k, triangle) in triangles.iter().enumerate() {
        for part in project(&pipeline.clip_from_world(), 40, 40, triangle).triangles() {
            rasterize(&part, 40, 40, |f| {
                if depth.test_and_set(f.i, f.j, f.z) {
                    winners[(f.j * 40 + f.i) as usize] = Some(k);
                }
            });
        }
    }
    winners
}

/// What becomes of the saved depth of the slide's second loop.
pub(super) enum Saved {
    /// As it must be.
    InitializedAndUpdated,
    /// As printed: nobody sets it, so it is what memory holds.
    NeverSet(f32),
}

/// for each pixel, for each object: if the ray intersects it and is closer than the saved depth …
fn image_order(triangles: &[Triangle], pipeline: &Pipeline, saved: &Saved) -> Winners {
    let (t0, t1) = raytrace::visible_interval(&pipeline.volume());
    let pixel = |k: u32| {
        let ray = viewing_ray(pipeline, (k % 40) as f32, (k / 40) as f32);
        let mut depth = if let Saved::NeverSet(garbage) = saved { *garbage } else { f32::INFINITY };
        let mut winner = None;
        for (k, triangle) in triangles.iter().enumerate() {
            if let Some(hit) = watertight(&ray, triangle, t0, t1)
                && hit.t < depth
            {
                winner = Some(k);
                if let Saved::InitializedAndUpdated = saved {
                    depth = hit.t;
                }
            }
        }
        winner
    };
    (0..1600).map(pixel).collect()
}

/// Whether a centre moved by 1/64 pixel is in another triangle: snapping moves a vertex, and with it an edge, by up to 1/256.
fn is_on_edge(triangles: &[Triangle], pipeline: &Pipeline, k: usize) -> bool {
    let (t0, t1) = raytrace::visible_interval(&pipeline.volume());
    let at = |dx: f32, dy: f32| {
        let ray = viewing_ray(pipeline, (k % 40) as f32 + dx / 64.0, (k / 40) as f32 + dy / 64.0);
        triangles.iter().map(|triangle| watertight(&ray, triangle, t0, t1).is_some()).collect::<Vec<_>>()
    };
    [(1.0, 0.0), (-1.0, 0.0), (0.0, 1.0), (0.0, -1.0)].into_iter().any(|(dx, dy)| at(dx, dy) != at(0.0, 0.0))
}

pub(super) static SAVED_DEPTH: Claim = Claim {
    number: "E16",
    name: "saved-depth-never-set",
    quote: "if ray through pixel intersects object and is closer than saved depth",
    translation: "if the ray through the pixel intersects the object and is closer than the saved depth",
    truth: text(
        "The listing neither initialises nor updates the saved depth. It must be infinite before each pixel, and become the t of each nearer hit.",
        "De listing zet de bewaarde diepte nergens op een beginwaarde en werkt die niet bij. Die moet per pixel op oneindig beginnen en de t van elke dichtere treffer worden.",
    ),
    expected: Verdict::Refuted,
    code: &["raytrace::triangle::watertight", "raytrace::nearest"],
    examine: || {
        let right = eight_triangles(&Saved::InitializedAndUpdated);
        let wrong = |garbage: f32| wrong_pixels(&Saved::NeverSet(garbage)).0;
        let trials: Vec<Trial> = [0.0, 3.0, f32::INFINITY]
            .into_iter()
            .map(|garbage| {
                let count = wrong(garbage);
                Trial::new(count == 0, format!("with {garbage} in memory {count} of 1600 pixels are wrong"))
            })
            .collect();
        let seen = right.iter().filter(|winner| winner.is_some()).count();
        judge("the loop as printed shows the nearest object", None, &trials).compared(
            format!("8 triangles that cover {seen} of 1600 pixels"),
            format!("{} wrong pixels with 0 in memory, {} with ∞", wrong(0.0), wrong(f32::INFINITY)),
            "none, with ∞ first and each nearer t after that",
        )
    },
    pictures: None,
    versions: Some(versions::saved_depth),
};

/// What the second loop shows of eight triangles.
fn eight_triangles(saved: &Saved) -> Winners {
    let pipeline = pipeline((vec3(0.5, 1.0, 7.0), Vec3::ZERO), 0.9, (-1.0, -20.0), (40, 40));
    let mut random = crate::sample::Sequence::new(45);
    let triangles: Vec<Triangle> = (0..8).map(|_| random.triangle(2.5)).collect();
    image_order(&triangles, &pipeline, saved)
}

/// How many pixels show another of the eight than the loop does with a depth that is kept, and how many pixels there are.
pub(super) fn wrong_pixels(saved: &Saved) -> (usize, usize) {
    let (shown, right) = (eight_triangles(saved), eight_triangles(&Saved::InitializedAndUpdated));
    (shown.iter().zip(&right).filter(|(a, b)| a != b).count(), right.len())
}

pub(super) static SHADED_AGAIN: Claim = Claim {
    number: "E16",
    name: "shading-in-the-loop",
    quote: "update color buffer with objects shading",
    translation: "update the colour buffer with the object's shading",
    truth: text(
        "Inside the loop a colour is computed for every fragment that is nearest so far: of n layers in random order 1 + 1/2 + … + 1/n on average. Once is enough, after the loop.",
        "Binnen de lus wordt voor elk fragment dat tot dan toe het dichtstbij is een kleur berekend: bij n lagen in willekeurige volgorde gemiddeld 1 + 1/2 + … + 1/n. Eén keer is genoeg, na de lus.",
    ),
    expected: Verdict::Refuted,
    code: &["zbuffer::DepthBuffer::test_and_set", "zbuffer::draw::Work"],
    examine: shaded_again,
    pictures: None,
    versions: Some(versions::shaded_again),
};

/// The colours that the loop computes for a pixel under layers in this order; the higher its number the nearer a layer.
pub(super) fn colors_computed(order: &[usize]) -> usize {
    let mut depth = DepthBuffer::new(1, 1, DepthFormat::F32);
    order.iter().filter(|layer| depth.test_and_set(0, 0, **layer as f32 / 10.0)).count()
}

/// The pixels that show something after the loop: so many colours are needed.
pub(super) fn visible_pixels(order: &[usize]) -> usize {
    let mut depth = DepthBuffer::new(1, 1, DepthFormat::F32);
    for layer in order {
        depth.test_and_set(0, 0, *layer as f32 / 10.0);
    }
    usize::from(depth.get(0, 0).is_some())
}

fn shaded_again() -> Examination {
    const LAYERS: usize = 6;
    let orders = permutations(LAYERS);
    let shaded = colors_computed;
    let trials: Vec<Trial> = orders
        .iter()
        .map(|order| {
            let count = shaded(order);
            Trial::new(count == 1, format!("layers drawn as {order:?}: {count} colours computed"))
        })
        .collect();
    let mean = orders.iter().map(|order| shaded(order)).sum::<usize>() as f64 / orders.len() as f64;
    let harmonic: f64 = (1..=LAYERS).map(|k| 1.0 / k as f64).sum();
    judge("one colour is computed for a pixel", None, &trials).compared(
        format!("{LAYERS} layers over a pixel, all {} orders", orders.len()),
        format!("{mean:.4} colours a pixel on average (H₆ = {harmonic:.4})"),
        "1, computed once it is known what is seen",
    )
}
